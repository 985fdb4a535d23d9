"""Rendering in passes, and plugins that follow the variant.

Covers: mitsuba/plugins.py, mitsuba/variants.py
"""

from __future__ import annotations

import subprocess
import sys

import drjit as dr
import numpy as np
import pytest

from loomlight.core.errors import InputError, LoomlightError
from loomlight.mitsuba import build_scene, choose_variant, render, rendering, variants

WHITE = {"type": "twosided", "inner": {"type": "diffuse", "reflectance": 0.8}}


@pytest.mark.slow
def test_passes_are_as_good_as_one_go(monkeypatch: pytest.MonkeyPatch) -> None:
    # Deeper paths have more noise, which no grid of samples takes away.
    scene = build_scene("drape", WHITE, size=(24, 24), light="directional", max_depth=3).scene
    whole = [render(scene, spp=64, seed=seed) for seed in range(4, 8)]
    reference = render(scene, spp=4096, seed=3)
    monkeypatch.setitem(rendering.WAVEFRONT, "llvm_ad_rgb", 24 * 24 * 18)
    reports: list[tuple[int, int]] = []
    parts = render(scene, spp=64, seed=2, progress=lambda done, total: reports.append((done, total)))
    assert reports == [(16, 64), (32, 64), (48, 64), (64, 64)]
    # Two pictures of 64 samples: 24² pixels, noise of a few percent each.
    np.testing.assert_allclose(parts.mean(), whole[0].mean(), rtol=0.02)
    # Passes of seeds of their own lose what 64 samples spread together gain over four times 16.
    monkeypatch.setattr(rendering, "has_pixel_sampler", lambda _: False)
    apart = [render(scene, spp=64, seed=seed) for seed in range(4, 8)]
    monkeypatch.undo()
    monkeypatch.setitem(rendering.WAVEFRONT, "llvm_ad_rgb", 24 * 24 * 18)
    together = [render(scene, spp=64, seed=seed) for seed in range(4, 8)]

    def error(pictures: list[np.ndarray]) -> float:
        return float(np.mean([np.square(picture - reference).mean() for picture in pictures]))

    # Found: 1.0 of that of one go, and 1.14 apart: four nets of 16 points are nearly one of 64.
    assert error(together) < 1.1 * error(whole)
    assert error(apart) > 1.07 * error(together)


def test_passes_share_their_kernels(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = build_scene("flat", WHITE, size=(16, 16), light="directional").scene
    monkeypatch.setitem(rendering.WAVEFRONT, "llvm_ad_rgb", 16 * 16 * 4)
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        render(scene, spp=32, seed=1)
        kernels = [entry for entry in dr.kernel_history() if entry["type"] == dr.KernelType.JIT]
    # Eight passes of four samples launch the same few kernels.
    wide = [kernel for kernel in kernels if kernel["size"] >= 16 * 16]
    assert len(wide) >= 16
    assert len({str(kernel["hash"]) for kernel in wide}) == len(wide) // 8
    assert len({str(kernel["hash"]) for kernel in kernels}) <= len(wide) // 8 + 4


@pytest.mark.parametrize(
    ("spp", "largest", "passes"),
    [
        (1, 16, [1]),
        (64, 64, [64]),
        (64, 18, [16] * 4),
        (32, 4, [4] * 8),
        (1000, 16, [16] * 63),
        (5, 1, [1] * 5),
    ],
)
def test_passes_are_alike(monkeypatch: pytest.MonkeyPatch, spp: int, largest: int, passes: list[int]) -> None:
    monkeypatch.setitem(rendering.WAVEFRONT, "llvm_ad_rgb", 100 * largest)
    assert rendering._passes(spp, 100, True) == passes


def test_pictures_of_passes_refine(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = build_scene("flat", WHITE, size=(16, 16)).scene
    monkeypatch.setitem(rendering.PASS_SAMPLES, "llvm_ad_rgb", 16 * 16 * 4)
    seen: list[np.ndarray] = []
    reports: list[tuple[int, int]] = []
    whole = render(
        scene, spp=16, seed=1, partial=seen.append, progress=lambda *numbers: reports.append(numbers)
    )
    assert len(seen) == 3
    errors = [np.square(picture - whole).mean() for picture in seen]
    assert errors == sorted(errors, reverse=True)
    assert reports == [(4, 16), (8, 16), (12, 16), (16, 16)]


def test_passes_are_short_but_not_too_many(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(rendering.PASS_SAMPLES, "llvm_ad_rgb", 200)
    assert rendering._passes(16, 100, True) == [2] * 8
    assert rendering._passes(4096, 100, True) == [64] * 64


def test_same_seed_same_picture_and_exposure_scales() -> None:
    scene = build_scene("flat", WHITE, size=(8, 8)).scene
    first, again = (render(scene, spp=2, seed=5) for _ in range(2))
    # Threads add samples up in an order of their own, which shows in the last bits.
    np.testing.assert_allclose(first, again, rtol=1e-5)
    np.testing.assert_allclose(render(scene, spp=2, seed=5, exposure=1), 2 * first, rtol=1e-5)
    assert first.dtype == np.float32


def test_no_samples_is_a_fault() -> None:
    with pytest.raises(InputError, match="spp = 0"):
        render(build_scene("flat", WHITE, size=(4, 4)).scene, spp=0)


def test_variants_are_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    assert choose_variant() == "llvm_ad_rgb"
    with pytest.raises(InputError, match="scalar_rgb"):
        choose_variant("scalar_rgb")
    monkeypatch.setattr(variants.dr, "has_backend", lambda _backend: False)
    with pytest.raises(LoomlightError, match="GPU"):
        choose_variant("cuda_ad_rgb")


FOLLOWS = """
import mitsuba as mi
import loomlight.mitsuba
assert mi.variant() is None
for variant in ("llvm_ad_rgb", "scalar_rgb", "llvm_ad_rgb"):
    mi.set_variant(variant)
    if variant != "scalar_rgb":
        assert "FootprintPath" in str(mi.load_dict({"type": "footprint_path"}))
        assert "woven_point[" in str(mi.load_dict({"type": "woven_point"}))
"""


def test_importing_sets_no_variant_and_plugins_follow_it() -> None:
    result = subprocess.run([sys.executable, "-c", FOLLOWS], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr


OLD_LLVM = """
import drjit, mitsuba as mi
import loomlight.mitsuba
drjit.detail.llvm_version = lambda: (15, 0, 7)
try:
    mi.set_variant("llvm_ad_rgb")
except Exception as error:
    print(type(error).__name__, error)
"""


def test_old_llvm_is_refused_before_it_compiles() -> None:
    result = subprocess.run([sys.executable, "-c", OLD_LLVM], capture_output=True, text=True, check=False)
    assert "MissingDependencyError LLVM 15.0.7" in result.stdout, result.stderr
