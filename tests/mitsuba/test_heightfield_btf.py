"""Paths through height fields whose light is known."""

from __future__ import annotations

import math
from dataclasses import replace

import mitsuba as mi
import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.llvm import require_llvm
from loomlight.mitsuba.traced_btf import HeightfieldBtf
from loomlight.mitsuba.variants import choose_variant
from loomlight.sources.heightfield import Heightfield

require_llvm()
choose_variant("llvm_ad_rgb")

COUNT = 4000


def flat(**changes: object) -> Heightfield:
    """A plane of one colour, 3 × 2 mm."""
    one = np.ones((1, 1), np.float32)
    plane = Heightfield(
        "plane", (3.0, 2.0), 0.0, 0.0, np.zeros((4, 4), np.float32), one[..., None] * [[[0.8, 0.4, 0.2]]],
        0.5 * one, 0 * one,
    )  # fmt: skip
    return replace(plane, **changes)


def values(source: Heightfield, light: list[float], view: list[float], seed: int = 0) -> NDArray[np.float64]:
    rng = np.random.default_rng(seed)
    positions = rng.uniform(-3, 3, (COUNT, 2)).astype(np.float32)
    directions = [
        np.tile(np.array(v, np.float32) / np.float32(np.linalg.norm(v)), (COUNT, 1)) for v in (light, view)
    ]
    found = HeightfieldBtf(source).values(positions, *directions, (seed,))
    return np.concatenate([positions, found], axis=1, dtype=np.float64)


@pytest.mark.parametrize("view", [[0.0, 0.0, 1.0], [0.9, 0.3, 0.1]])
def test_a_plane_has_the_value_of_its_bsdf(view: list[float]) -> None:
    """Unit irradiance across the light: f·cos, as Mitsuba's BSDF gives it."""
    light = [0.5, -0.2, 0.8]
    found = values(flat(), light, view)[:, 2:].mean(axis=0)
    bsdf = mi.load_dict(
        {
            "type": "principled",
            "base_color": {"type": "rgb", "value": [0.8, 0.4, 0.2]},
            "roughness": 0.5,
            "specular": 0.0,
        }
    )
    si = mi.SurfaceInteraction3f()
    si.wi = mi.Vector3f(np.array(view) / np.linalg.norm(view))
    si.sh_frame = mi.Frame3f(mi.Normal3f(0, 0, 1))
    wanted = bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(np.array(light) / np.linalg.norm(light)))
    # The light's cone is 2.9° wide.
    np.testing.assert_allclose(found, np.array(wanted).ravel(), rtol=0.02)


def test_maps_lie_where_they_are_said_to() -> None:
    """The albedo of one corner, 0 ≤ x < 1.5 mm and 1 ≤ y < 2 mm, in every repeat."""
    albedo = np.zeros((2, 2, 3), np.float32)
    albedo[1, 0] = 1
    # Nearest texels cannot be asked for: interpolation, so only what lies in the middle of texels counts.
    x, y, *colour = values(flat(albedo=albedo), [0, 0.1, 1], [0.1, 0, 1]).T
    u, v = (x / 3) % 1, (y / 2) % 1
    near = np.hypot((u - 0.25) * 3, (v - 0.75) * 2) < 0.1
    far = np.hypot((u - 0.75) * 3, (v - 0.25) * 2) < 0.1
    assert colour[0][near].min() > 3 * max(colour[0][far].max(), 1e-3)


def test_ridges_shadow_and_hide_each_other_at_any_distance() -> None:
    """Ridges along y: from +x at a low angle only one flank is lit, and only from there it is seen."""
    x = (np.arange(64) + 0.5) / 64
    ridges = np.tile(1 - np.abs(2 * x - 1), (64, 1)).astype(np.float32)
    source = flat(height=ridges, height_mm=3.0, size_mm=(2.0, 2.0))
    low, opposite = [1.0, 0.0, 0.15], [-1.0, 0.0, 0.15]
    same = values(source, low, low)[:, 2:].mean()
    against = values(source, low, opposite)[:, 2:].mean()
    assert same > 5 * against
    # Light bounces into the valley: less than the light that falls in, and not nothing.
    up = values(source, [0.0, 0.0, 1.0], [0.0, 0.0, 1.0])[:, 2].mean()
    plane = values(flat(), [0.0, 0.0, 1.0], [0.0, 0.0, 1.0])[:, 2].mean()
    assert 0.1 * plane < up < plane


def test_no_more_light_leaves_than_arrives() -> None:
    """A white relief, by cosine-weighted views: f·cos over the cosine of the light has an albedo as mean."""
    rng = np.random.default_rng(4)
    height = rng.random((16, 16)).astype(np.float32)
    white = flat(height=height, height_mm=0.3, albedo=np.ones((1, 1, 3), np.float32))
    light = np.tile(np.float32([0.6, 0.0, 0.8]), (COUNT, 1))
    u, angle = rng.random(COUNT), 2 * math.pi * rng.random(COUNT)
    views = np.stack([np.sqrt(u) * np.cos(angle), np.sqrt(u) * np.sin(angle), np.sqrt(1 - u)], axis=1)
    positions = rng.uniform(0, 3, (COUNT, 2)).astype(np.float32)
    found = HeightfieldBtf(white).values(positions, light, views.astype(np.float32), (0,))
    albedo = math.pi * found[:, 0].mean() / 0.8
    error = math.pi * found[:, 0].std() / 0.8 / math.sqrt(COUNT)
    assert 0.5 < albedo < 1 + 4 * error


def test_the_same_seed_is_the_same_light() -> None:
    first, again, other = (values(flat(), [0, 0.3, 1], [0.2, 0, 1], seed)[:, 2:] for seed in (1, 1, 2))
    assert np.array_equal(first, again)
    assert not np.array_equal(first, other)
