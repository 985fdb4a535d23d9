"""What differs between fabrics, scenes and views is data of kernels, not code: they are compiled once.

Covers: mitsuba/scene_props.py
"""

from __future__ import annotations

import gc
from collections.abc import Callable
from pathlib import Path

import drjit as dr
import pytest

from loomlight.mitsuba import build_scene, material_bsdf, render

EXAMPLES = Path(__file__).parents[2] / "examples"
SIZE = (12, 12)


def new_kernels(picture: Callable[[], object]) -> int:
    """Number of kernels that a picture compiles, or reads from the disk."""
    # Kernels know of all living BSDFs.
    gc.collect()
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        picture()
        kernels = [entry for entry in dr.kernel_history() if entry["type"] == dr.KernelType.JIT]
    assert kernels
    return sum(not kernel["cache_hit"] or kernel["cache_disk"] for kernel in kernels)


def shown(fabric: str, scene: str, zoom: float, model: str, seed: int = 0) -> None:
    built = build_scene(scene, material_bsdf(fabric, model), size=SIZE, zoom=zoom)
    render(built.scene, spp=2, seed=seed, integrator=built.integrator, denoise="auto")


# Of the yarns, the cloth is what differs: sett, counts of threads, twist, seed, how much by chance.
@pytest.mark.parametrize("model", ["lobes", "point"])
def test_fabrics_scenes_and_views_share_kernels(model: str) -> None:
    first, second = (str(EXAMPLES / f"{name}.toml") for name in ("chino", "gabardine"))
    material_bsdf(second, model)
    assert new_kernels(lambda: shown(first, "flat", 4.0, model)) > 0
    assert new_kernels(lambda: shown(first, "drape", 1.0, model, seed=7)) == 0
    assert new_kernels(lambda: shown(second, "sphere", 9.0, model)) == 0
