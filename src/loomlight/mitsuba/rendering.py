"""Rendering in passes: memory is bounded however many samples a pixel gets."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import white_balance as white_balance_gains
from loomlight.core.errors import InputError
from loomlight.mitsuba.bsdf import SceneTraits
from loomlight.mitsuba.denoising import denoised, wants_denoising
from loomlight.mitsuba.layers import layers_of
from loomlight.mitsuba.path import footprint_integrator, is_footprint_path, with_settings
from loomlight.mitsuba.pixels import has_pixel_sampler, is_plain
from loomlight.mitsuba.variants import choose_variant, in_turn

# Samples in flight at once. On two CPU cores larger wavefronts are no faster.
WAVEFRONT = {"llvm_ad_rgb": 2**23, "cuda_ad_rgb": 2**26}
# Samples of a pass: about a second on two cores, so that progress shows and an interruption is soon noticed.
# Passes a quarter as large cost up to a quarter more for starting each; nor do more than 64 show more.
PASS_SAMPLES = {"llvm_ad_rgb": 2**20, "cuda_ad_rgb": 2**24}
_MAX_PASSES = 64
# Outside of symbolic loops, where networks are evaluated, every path's state lies in memory.
_EVALUATED_SHARE = 8
# Of a pixel, of pictures that guide the denoiser: edges need no more.
_GUIDE_SAMPLES = 8

Progress = Callable[[int, int], None]
# Takes a whole picture that later ones refine.
PartialPicture = Callable[[NDArray[np.float32]], None]


@in_turn
def render(
    scene: mi.Scene,
    *,
    spp: int = 64,
    seed: int = 0,
    sensor: Any = 0,
    integrator: Any = None,
    exposure: float = 0.0,
    white_balance: float | None = None,
    denoise: str = "off",
    progress: Progress | None = None,
    partial: PartialPicture | None = None,
) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] or RGBA [height, width, 4] of what `sensor` sees, by the film's channels.

    Args:
        scene: a Mitsuba scene.
        spp: samples a pixel, ≥ 1; rendered in passes that are all alike, which may take a few more.
        seed: any 32-bit number; the same seed gives the same picture, but for the order in which threads add
            samples up.
        sensor: a sensor or its index.
        integrator: by default the scene's own if it is a `footprint_path`, otherwise a new one.
        exposure: stops; colours are multiplied by 2**exposure.
        white_balance: colour temperature of the light that is shown as white, kelvin; None leaves colours.
        denoise: "auto" or "off"; see `denoised`. Other integrators than `footprint_path`, films that
            develop neither RGB nor RGBA go without.
        progress: called with (samples done, samples in all) after every pass.
        partial: called with the picture so far after every pass but the last.

    Raises:
        InputError: spp < 1, a colour temperature out of range, or an unknown way to denoise.
    """
    # 1. What renders, and how its colours are shown.
    denoises = wants_denoising(denoise)
    gains = 2.0**exposure * (1.0 if white_balance is None else white_balance_gains(white_balance))
    if spp < 1:
        raise InputError(f"spp = {spp} is too small: a pixel needs at least 1 sample.")
    sensor = scene.sensors()[sensor] if isinstance(sensor, int) else sensor
    width, height = (int(value) for value in sensor.film().crop_size())
    integrator = integrator or footprint_integrator(scene)
    denoises = denoises and is_footprint_path(integrator) and is_plain(sensor.film())
    # 2. Passes that fit. Noise is told from what differs between two halves that share no numbers.
    halves = 2 if denoises and spp > 1 else 1
    passes = _passes(-(-spp // halves), width * height, SceneTraits.of(scene).symbolic)
    in_all = min(spp, halves * sum(passes))
    # 3. One after another; each is shown.
    totals: list[Any] = [0.0] * halves
    done = 0
    for step in range(halves * len(passes)):
        number, half = divmod(step, halves)
        own_seed = _pass_seed(seed, _MAX_PASSES) if half else seed
        with _one_of(integrator, sensor, spp, number, denoises) as alone:
            of_pass = _pass_seed(own_seed, number) if alone else own_seed
            picture = mi.render(scene, sensor=sensor, integrator=integrator, spp=passes[0], seed=of_pass)
        totals[half] = totals[half] + np.array(picture, dtype=np.float64)
        done += passes[0]
        if progress is not None:
            progress(min(in_all, done), in_all)
        if partial is not None and step + 1 < halves * len(passes):
            partial(_exposed(sum(totals) / (step + 1), gains))
    # 4. Their mean, without noise where that is asked for.
    means = [total / len(passes) for total in totals]
    if not denoises:
        return _exposed(np.mean(means, axis=0), gains)
    return _exposed(denoised(means, _seen(integrator.guides, integrator, scene, sensor, seed)), gains)


@in_turn
def render_layers(
    scene: mi.Scene, names: Sequence[str], *, seed: int = 0, integrator: Any = None
) -> dict[str, NDArray[np.float32]]:
    """Layers of what the scene's first sensor sees, [height, width, 3] or [height, width, 1] each.

    Args:
        scene: a Mitsuba scene.
        names: of `LAYERS`.
        seed: as of `render`.
        integrator: a `footprint_path`; by default the scene's own if it is one, otherwise a new one.
    """
    integrator = integrator or footprint_integrator(scene)
    return layers_of(_seen(integrator.layers, integrator, scene, scene.sensors()[0], seed), names)


def _seen(look: Any, integrator: Any, scene: mi.Scene, sensor: Any, seed: int) -> NDArray[np.float32]:
    """What a method of `footprint_path` sees without noise of light [height, width, planes]."""
    width, height = (int(value) for value in sensor.film().crop_size())
    passes = _passes(_GUIDE_SAMPLES, width * height, SceneTraits.of(scene).symbolic)
    found = []
    for number, samples in enumerate(passes):
        with _one_of(integrator, sensor, _GUIDE_SAMPLES, number, True) as alone:
            # Numbers of their own: noise that guides share with the picture would not be taken out.
            of_pass = _pass_seed(seed, 2 * _MAX_PASSES + (number if alone else 0))
            planes = look(scene, sensor, of_pass, samples, number * samples)
            found.append(np.array(planes, dtype=np.float32))
    return np.mean(found, axis=0)


def _exposed(linear: NDArray[np.float64], gains: NDArray[np.float64] | float) -> NDArray[np.float32]:
    linear = np.array(linear, dtype=np.float64)
    linear[..., :3] *= gains
    return linear.astype(np.float32)


@contextmanager
def _one_of(integrator: Any, sensor: Any, spp: int, number: int, apart: bool) -> Iterator[bool]:
    """An integrator that renders one pass of a picture, and whether that needs a seed of its own.

    Only `footprint_path` knows of passes, and only samples of `PixelSampler` are spread evenly over all.

    Args:
        apart: samples count in their own pixels alone.
    """
    alone = not (is_footprint_path(integrator) and has_pixel_sampler(sensor))
    of_pass = {"picture_samples": spp, "pass_number": 0 if alone else number}
    with with_settings(integrator, skip_film=True, apart=apart, **of_pass):
        yield alone


def _passes(spp: int, pixels: int, symbolic: bool) -> list[int]:
    """Samples of each pass: passes that fit and are short, all alike, of at least `spp` samples in all."""
    variant = choose_variant()
    wavefront = WAVEFRONT[variant] // (1 if symbolic else _EVALUATED_SHARE)
    short = max(PASS_SAMPLES[variant] // pixels, -(-spp // _MAX_PASSES))
    largest = max(1, min(wavefront // pixels, short))
    count = -(-spp // largest)
    return [-(-spp // count)] * count


def samples_rendered(scene: mi.Scene, spp: int, sensor: int = 0) -> int:
    """Samples a pixel that `render` takes where `spp` are asked for: passes are all alike."""
    width, height = (int(value) for value in scene.sensors()[sensor].film().crop_size())
    return sum(_passes(spp, width * height, SceneTraits.of(scene).symbolic))


def _pass_seed(seed: int, number: int) -> int:
    return (seed * 0x9E3779B1 + number) % 2**32
