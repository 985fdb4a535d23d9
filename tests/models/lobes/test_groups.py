"""Groups: who belongs to which, and what they add up to."""

from __future__ import annotations

from dataclasses import fields

import numpy as np
import pytest
from drjit.llvm.ad import Bool, Float
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.fabric import fabric_from_text
from loomlight.models.lobes import groups as module
from loomlight.models.lobes.groups import GroupFinder, Groups, evenly_spread, find_groups
from loomlight.models.lobes.model import LobesModel
from loomlight.yarn.geometry import SurfacePoint, YarnGeometry

from .cloths import TEXTS, asked_of, far_parts, floats, geometry_of

PER_FAMILY = 8
# Texels of an independent plan, a side.
SIDE = 300


def plan(geometry: YarnGeometry, seed: int, back: bool) -> SurfacePoint:
    """The points that show at random places, one in each of SIDE² texels of the repeat."""
    rng = np.random.default_rng(seed)
    row, column = np.divmod(np.arange(SIDE * SIDE), SIDE)
    x, y = (np.stack([column, row]) + rng.random((2, SIDE * SIDE))) / SIDE
    return geometry.surface(floats(x * geometry.size[0]), floats(y * geometry.size[1]), Bool(back))


def numbers(groups: Groups, point: SurfacePoint, back: bool) -> NDArray[np.int64]:
    finder = GroupFinder(groups, array_types(Float))
    found = finder.group(Bool(back), point.is_warp, point.hole, point.normal, point.tangent)
    return found.numpy().astype(np.int64)


@pytest.mark.parametrize("name", TEXTS)
@pytest.mark.parametrize("back", [False, True])
def test_points_belong_to_the_nearest_centre_of_their_family(name: str, back: bool) -> None:
    geometry = geometry_of(name)
    groups = find_groups(geometry, PER_FAMILY, Float)
    point = plan(geometry, 1, back)
    found = numbers(groups, point, back)
    hole, is_warp = point.hole.numpy(), point.is_warp.numpy()
    assert (found[hole] == groups.count).all()
    features = np.concatenate([0.5 * point.normal.numpy().T, point.tangent.numpy().T], axis=1)
    distance = np.linalg.norm(features[:, None] - groups.centres[int(back)], axis=2)
    own = np.where(
        is_warp[:, None], np.arange(groups.count) < PER_FAMILY, np.arange(groups.count) >= PER_FAMILY
    )
    distance[~own] = np.inf
    chosen = np.take_along_axis(distance, np.minimum(found, groups.count - 1)[:, None], axis=1)[:, 0]
    # Of two as near float32 may take either.
    assert (chosen[~hole] <= distance.min(axis=1)[~hole] + 1e-6).all()
    # A family's groups lie apart: one alone would serve points worse.
    shown = np.bincount(found[~hole], minlength=groups.count)
    for family in (slice(0, PER_FAMILY), slice(PER_FAMILY, None)):
        if shown[family].sum() > 1000:
            assert (shown[family] > 0).sum() == PER_FAMILY


@pytest.mark.parametrize("name", TEXTS)
@pytest.mark.parametrize("back", [False, True])
def test_areas_and_moments_are_those_of_the_plan(name: str, back: bool) -> None:
    geometry = geometry_of(name)
    groups = find_groups(geometry, PER_FAMILY, Float)
    face = int(back)
    assert groups.area[face].sum() + groups.hole[face] == pytest.approx(1, abs=1e-12)
    point = plan(geometry, 2, back)
    found = numbers(groups, point, back)
    area = np.bincount(found, minlength=groups.count + 1) / len(found)
    # 16384 even points, and an outline of a few of their spacings around each group.
    np.testing.assert_allclose(groups.area[face], area[:-1], atol=4e-3)
    assert groups.hole[face] == pytest.approx(area[-1], abs=4e-3)
    normal, tangent = (part.numpy().T.astype(np.float64) for part in (point.normal, point.tangent))
    for group in np.flatnonzero(area[:-1] > 0.01):
        own = found == group
        np.testing.assert_allclose(groups.normal[face, group], normal[own].mean(0), atol=0.02)
        np.testing.assert_allclose(groups.tangent[face, group], tangent[own].mean(0), atol=0.02)
        np.testing.assert_allclose(groups.spread[face, group], np.cov(tangent[own].T), atol=4e-3)
        # Directions are unit vectors: their mean square is 1.
        mean = groups.tangent[face, group]
        assert mean @ mean + np.trace(groups.spread[face, group]) == pytest.approx(1, abs=1e-6)


def test_more_groups_are_narrower() -> None:
    geometry = geometry_of("translucent twill")
    spreads = []
    for per_family in (1, 4, 16):
        groups = find_groups(geometry, per_family, Float)
        spreads.append((groups.area * np.trace(groups.spread, axis1=2, axis2=3)).sum())
    # Four times the groups of a set of two or three dimensions: at least half the variance.
    assert spreads[1] < 0.5 * spreads[0]
    assert spreads[2] < 0.5 * spreads[1]


def test_the_same_groups_every_time() -> None:
    first, second = (find_groups(geometry_of("smooth satin"), PER_FAMILY, Float) for _ in range(2))
    for part in fields(Groups):
        assert np.array_equal(getattr(first, part.name), getattr(second, part.name)), part.name


def test_points_fill_the_square_evenly() -> None:
    points = evenly_spread(4096)
    counts = np.histogram2d(*points.T, bins=16, range=[[0, 1], [0, 1]])[0]
    # Random points would leave 16 ± 4 a cell.
    assert counts.min() >= 13
    assert counts.max() <= 19
    np.testing.assert_array_equal(evenly_spread(10, 20), evenly_spread(30)[20:])


@pytest.mark.parametrize("per_family", [1, 8])
def test_a_family_that_a_face_never_shows_does_no_harm(
    per_family: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No draft is so dense that all weft hides: points of the front's weft are left out by hand."""
    fabric = fabric_from_text(
        'weave = "satin 8/3"\n[warp]\ngap = 0.02\n[weft]\ngap = 0.5\ntranslucency = 0.5'
    )
    original = module._points

    def without_weft(geometry: YarnGeometry, float_type: type) -> tuple[NDArray[np.float64], ...]:
        back, is_warp, hole, normal, tangent = original(geometry, float_type)
        return back, is_warp | ~back, hole, normal, tangent

    monkeypatch.setattr(module, "_points", without_weft)
    groups = find_groups(YarnGeometry(fabric.layout()), per_family, Float)
    assert not groups.area[0, per_family:].any()
    assert groups.area[0].sum() + groups.hole[0] == pytest.approx(1)
    model = LobesModel.for_fabric(fabric, per_family)
    asked = asked_of(fabric, model.tables.size, 500, seed=3)
    parts = far_parts(model, asked)
    for name, values in parts.items():
        assert np.isfinite(values).all(), name
        assert (values >= 0).all(), name
    front = asked.views[:, 2] > 0
    assert (parts["diffuse_weft"][front] == 0).all()
    assert (parts["specular_weft"][front] == 0).all()
    assert parts["diffuse_weft"][~front].max() > 0.01
    assert parts["diffuse_warp"][front].max() > 0.1


def test_fewer_different_points_than_groups() -> None:
    """Flat threads of one direction each: one point a family, eight groups of it."""
    count = 100
    features = np.tile([0, 0, 0.5, 1, 0, 0.0], (count, 1))
    centres = module._centres(features, PER_FAMILY)
    assert centres.shape == (PER_FAMILY, 6)
    np.testing.assert_allclose(centres, features[:PER_FAMILY])
