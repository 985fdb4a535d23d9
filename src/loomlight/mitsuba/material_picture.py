"""A picture of a fabric in one call: what `loomlight render` does, without writing a file."""

from __future__ import annotations

import os
from typing import Unpack

import numpy as np
from numpy.typing import NDArray

from loomlight.assets.sources import Source
from loomlight.core.errors import InputError
from loomlight.mitsuba.material import material_bsdf
from loomlight.mitsuba.rendering import Progress, render
from loomlight.mitsuba.scenes import SceneOptions, build_scene
from loomlight.mitsuba.variants import choose_variant

_LARGEST_EXPOSURE = 30


def render_fabric(
    fabric: Source | str | os.PathLike[str],
    scene: str | os.PathLike[str] = "drape",
    *,
    model: str | None = None,
    spp: int = 64,
    seed: int = 0,
    exposure: float = 0.0,
    variant: str | None = None,
    progress: Progress | None = None,
    **setting: Unpack[SceneOptions],
) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] of a fabric on a piece of cloth, a mesh, or the marked shapes of a scene.

    Args:
        fabric: a fabric or another source; or the path of a fabric file, a draft or a `.loom`; or a weave's
            name, such as "twill 3/1".
        scene: flat, sphere, cylinder, drape, or the path of a Mitsuba scene, FILE.xml.
        model: "lobes", which averages over footprints and needs few samples; "point", exact at every point;
            "woven", the network that averages over footprints; by default the one that a `.loom` holds, else
            "lobes".
        spp: samples a pixel, ≥ 1.
        seed: any 32-bit number; the same seed gives the same picture, but for rounding.
        exposure: stops, −30 to 30; colours are multiplied by 2**exposure.
        variant: llvm_ad_rgb or cuda_ad_rgb; by default the one that is set, else llvm_ad_rgb.
        progress: called with (samples done, samples in all) after every pass.
        setting: mesh, metres_per_unit, environment, environment_turn, light, light_from, zoom, size,
            max_depth: see `loomlight.mitsuba.build_scene`.

    Raises:
        InputError: a fabric, file or value that cannot be used.
        MissingDependencyError: no usable LLVM library, or no usable CUDA device.
    """
    if not -_LARGEST_EXPOSURE <= exposure <= _LARGEST_EXPOSURE:
        raise InputError(
            f"exposure = {exposure:g} is out of range: it lies between -{_LARGEST_EXPOSURE} and "
            f"{_LARGEST_EXPOSURE} stops."
        )
    choose_variant(variant)
    shown = build_scene(scene, material_bsdf(fabric, model), **setting)
    return render(
        shown.scene,
        spp=spp,
        seed=seed,
        exposure=exposure,
        integrator=shown.integrator,
        progress=progress,
    )
