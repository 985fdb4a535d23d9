"""What differs between fabrics, scenes and views is data of kernels, not code: they are compiled once.

Covers: mitsuba/shapes.py, mitsuba/pixels.py
"""

from __future__ import annotations

import gc
from collections.abc import Callable
from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.mitsuba import build_scene, material_bsdf, render
from loomlight.mitsuba.pixels import PixelSampler

EXAMPLES = Path(__file__).parents[2] / "examples"
SIZE = (12, 12)


# Operations of kernels that take no time to compile: films, means over pixels.
SMALL = 1000


def new_kernels(picture: Callable[[], object]) -> int:
    """Number of large kernels that a picture compiles, or reads from the disk."""
    # Kernels know of all living BSDFs.
    gc.collect()
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        picture()
        kernels = [entry for entry in dr.kernel_history() if entry["type"] == dr.KernelType.JIT]
    assert kernels
    large = [kernel for kernel in kernels if kernel["operation_count"] > SMALL]
    return sum(not kernel["cache_hit"] or kernel["cache_disk"] for kernel in large)


@pytest.fixture(autouse=True)
def no_kernels_of_other_tests() -> None:
    dr.flush_kernel_cache()


def shown(fabric: str, scene: str, zoom: float, model: str, seed: int = 0) -> None:
    built = build_scene(scene, material_bsdf(fabric, model), size=SIZE, zoom=zoom)
    render(built.scene, spp=2, seed=seed, integrator=built.integrator, denoise="auto")


# Of the yarns, the cloth is what differs: sett, counts of threads, twist, seed, how much by chance.
@pytest.mark.slow
@pytest.mark.parametrize("model", ["lobes", "point"])
def test_fabrics_scenes_and_views_share_kernels(model: str) -> None:
    first, second = (str(EXAMPLES / f"{name}.toml") for name in ("chino", "gabardine"))
    material_bsdf(second, model)
    assert new_kernels(lambda: shown(first, "flat", 4.0, model)) > 0
    assert new_kernels(lambda: shown(first, "drape", 1.0, model, seed=7)) == 0
    assert new_kernels(lambda: shown(second, "sphere", 9.0, model)) == 0


@pytest.mark.slow
def test_views_share_kernels() -> None:
    def seen(scene: str, **camera: Any) -> None:
        built = build_scene(scene, material_bsdf("plain", "point"), size=SIZE, **camera)
        render(built.scene, spp=2, integrator=built.integrator, denoise="auto")

    assert new_kernels(lambda: seen("drape", view="front")) > 0
    assert new_kernels(lambda: seen("drape", view="top", focal_length=20.0, roll=10)) == 0
    assert new_kernels(lambda: seen("flat", view="back", target=(0, 0, 0), distance=0.3)) == 0


@pytest.mark.slow
@pytest.mark.parametrize("denoise", ["auto", "off"])
def test_samples_size_and_depth_are_data(denoise: str) -> None:
    def picture(size: tuple[int, int], spp: int, max_depth: int = 8) -> None:
        built = build_scene("drape", material_bsdf("plain", "point"), size=size, max_depth=max_depth)
        render(built.scene, spp=spp, integrator=built.integrator, denoise=denoise, exposure=spp / 4)

    assert new_kernels(lambda: picture((12, 10), 2)) > 0
    assert new_kernels(lambda: picture((12, 10), 6)) == 0
    assert new_kernels(lambda: picture((9, 15), 16)) == 0
    assert new_kernels(lambda: picture((12, 10), 2, max_depth=3)) == 0


def test_samples_of_pixels_are_stratified_over_all_passes() -> None:
    pixels, half = 500, 8
    index = dr.arange(mi.UInt32, pixels * half)
    passes = [PixelSampler.of(index // half, index % half + first, 3, half) for first in (0, half)]
    before = np.random.default_rng(0).random((pixels, 2 * half))
    for _ in range(4):
        pairs = [np.array(sampler.next_2d()).reshape(2, pixels, half) for sampler in passes]
        x, y = np.concatenate(pairs, axis=2)
        single = [np.array(sampler.next_1d()).reshape(pixels, half) for sampler in passes]
        numbers = np.concatenate(single, axis=1)
        # Every cell of sixteen has one point of each pixel: strips, squares, strips of numbers.
        for cells in (16 * x, 16 * y, 4 * np.floor(4 * x) + 4 * y, 16 * numbers):
            assert (np.sort(np.floor(cells), axis=1) == np.arange(16)).all()
        for other in (y, numbers, before):
            # Of 8000 pairs: four standard deviations.
            assert abs(np.corrcoef(x.ravel(), other.ravel())[0, 1]) < 4 * 8000**-0.5
        before = x
