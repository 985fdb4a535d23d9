"""Rendering in passes: memory is bounded however many samples a pixel gets."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.mitsuba.integrator import footprint_integrator, has_networks
from loomlight.mitsuba.variants import choose_variant

# Samples in flight at once. On two CPU cores larger wavefronts are no faster.
WAVEFRONT = {"llvm_ad_rgb": 2**23, "cuda_ad_rgb": 2**26}
# Networks are evaluated outside of symbolic loops, which keeps every path's state in memory.
_NETWORK_SHARE = 8

Progress = Callable[[int, int], None]


def render(
    scene: Any,
    *,
    spp: int = 64,
    seed: int = 0,
    sensor: Any = 0,
    integrator: Any = None,
    exposure: float = 0.0,
    progress: Progress | None = None,
) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] or RGBA [height, width, 4] of what `sensor` sees, by the film's channels.

    Args:
        scene: a Mitsuba scene.
        spp: samples a pixel, ≥ 1; rendered in passes of different seeds. Each pass takes as many as fill a
            grid (see `filling_grid`), so a few more may be taken.
        seed: any 32-bit number; the same seed gives the same picture, but for the order in which threads add
            samples up.
        sensor: a sensor or its index.
        integrator: by default the scene's own if it is a `footprint_path`, otherwise a new one.
        exposure: stops; colours are multiplied by 2**exposure.
        progress: called with (samples done, samples in all) after every pass.

    Raises:
        InputError: spp < 1.
    """
    if spp < 1:
        raise InputError(f"spp = {spp} is too small: a pixel needs at least 1 sample.")
    sensor = scene.sensors()[sensor] if isinstance(sensor, int) else sensor
    width, height = (int(value) for value in sensor.film().crop_size())
    integrator = integrator or footprint_integrator(scene)
    previous = getattr(integrator, "footprint_samples", None)
    if previous is not None:
        integrator.footprint_samples = spp
    total: NDArray[np.float64] | float = 0.0
    done = 0
    try:
        for number, samples in enumerate(_passes(spp, width * height, has_networks(scene))):
            picture = mi.render(
                scene, sensor=sensor, integrator=integrator, spp=samples, seed=_pass_seed(seed, number)
            )
            total = total + samples * np.array(picture, dtype=np.float64)
            done += samples
            if progress is not None:
                progress(min(spp, done), spp)
    finally:
        if previous is not None:
            integrator.footprint_samples = previous
    linear = np.asarray(total, dtype=np.float64) / done
    linear[..., :3] *= 2.0**exposure
    return linear.astype(np.float32)


def _passes(spp: int, pixels: int, networks: bool) -> list[int]:
    """Samples of each pass: as few passes as fit, as equal as they can be, at least `spp` in all."""
    wavefront = WAVEFRONT[choose_variant()] // (_NETWORK_SHARE if networks else 1)
    largest = max(1, wavefront // pixels)
    count = -(-spp // largest)
    return [filling_grid(spp // count + (index < spp % count)) for index in range(count)]


def filling_grid(samples: int) -> int:
    """The smallest count ≥ `samples` that Mitsuba's multijitter sampler can lay out as a grid."""
    rows = math.isqrt(samples)
    return rows * -(-samples // rows)


def _pass_seed(seed: int, number: int) -> int:
    return (seed * 0x9E3779B1 + number) % 2**32
