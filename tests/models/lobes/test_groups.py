"""Groups: who belongs to which, and what they add up to."""

from __future__ import annotations

import math
from dataclasses import fields, replace

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Bool, Float, UInt32
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.frozen import FrozenArg
from loomlight.fabric import fabric_from_text
from loomlight.models.lobes import groups as module
from loomlight.models.lobes import tables
from loomlight.models.lobes.groups import (
    Cloth,
    GroupFinder,
    Groups,
    Places,
    PlanPoints,
    cloth_of,
    find_groups,
    plan_points,
)
from loomlight.models.lobes.model import LobesModel
from loomlight.models.lobes.reach import cast_rays, cast_views, seen_points
from loomlight.yarn.geometry import SurfacePoint, YarnGeometry

from .cloths import TEXTS, asked_of, floats, geometry_of, groups_of, prefiltered_parts

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
    groups = groups_of(geometry, PER_FAMILY)
    point = plan(geometry, 1, back)
    found = numbers(groups, point, back)
    hole, is_warp = point.hole.numpy(), point.is_warp.numpy()
    assert (found[hole] == groups.count).all()
    features = np.concatenate([0.5 * point.normal.numpy().T, point.tangent.numpy().T], axis=1)
    distance = np.linalg.norm(features[:, None] - groups.centres[int(back)], axis=2)
    of_warp = int(groups.of_warp[int(back)])
    own = np.where(is_warp[:, None], np.arange(groups.count) < of_warp, np.arange(groups.count) >= of_warp)
    distance[~own] = np.inf
    chosen = np.take_along_axis(distance, np.minimum(found, groups.count - 1)[:, None], axis=1)[:, 0]
    # Of two as near float32 may take either.
    assert (chosen[~hole] <= distance.min(axis=1)[~hole] + 1e-6).all()
    # A family's groups lie apart: one alone would serve points worse.
    shown = np.bincount(found[~hole], minlength=groups.count)
    for family in (shown[:of_warp], shown[of_warp:]):
        if family.sum() > 1000:
            assert (family > 0).all()


@pytest.mark.parametrize("name", TEXTS)
@pytest.mark.parametrize("back", [False, True])
def test_holes_are_those_of_the_plan(name: str, back: bool) -> None:
    geometry = geometry_of(name)
    groups = groups_of(geometry, PER_FAMILY)
    hole = plan(geometry, 2, back).hole.numpy().mean()
    # Points are even: where each of n stands for a square, some √n lie on the outlines of holes.
    assert groups.hole[int(back)] == pytest.approx(hole, abs=0.6 / math.sqrt(module._POINTS))


def test_until_views_tell_more_fibres_lie_about_the_centre() -> None:
    groups = groups_of(geometry_of("smooth satin"), PER_FAMILY)
    np.testing.assert_allclose(groups.tangent, groups.centres[..., 3:])
    # Directions are unit vectors: their mean square is 1.
    square = np.square(groups.tangent).sum(axis=-1) + np.trace(groups.spread, axis1=2, axis2=3)
    np.testing.assert_allclose(square, 1, atol=1e-6)


def test_the_family_that_is_seen_most_has_most_groups() -> None:
    groups = groups_of(geometry_of("smooth satin"), PER_FAMILY)
    # Eight ends of nine show the warp in front, and the weft behind.
    assert groups.of_warp[0] > PER_FAMILY > groups.of_warp[1]
    even = groups_of(geometry_of("open plain"), PER_FAMILY)
    assert (even.of_warp == PER_FAMILY).all()
    # Six a family are no whole words: either has half of them.
    assert (groups_of(geometry_of("smooth satin"), 6).of_warp == 6).all()


def test_groups_shared_out_are_narrower_than_halves() -> None:
    cloth = cloth_of(geometry_of("smooth satin"), Float)
    points, seen = plan_points(cloth), seen_points(cast_views(cloth, PER_FAMILY))

    def spread(groups: Groups) -> float:
        distances = []
        for number, chosen in enumerate(seen.of_families()):
            face, first = number // 2, groups.of_warp[number // 2]
            own = groups.centres[face, first:] if number % 2 else groups.centres[face, :first]
            distances.append(np.square(seen.features(chosen)[:, None] - own).sum(axis=2).min(axis=1))
        return float(np.concatenate(distances).mean())

    shared = spread(find_groups(points, seen, PER_FAMILY))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "_shared_out", lambda parting, face, often, per_family: per_family)
        halves = spread(find_groups(points, seen, PER_FAMILY))
    assert shared < 0.9 * halves


@pytest.mark.parametrize("name", TEXTS)
def test_more_groups_are_narrower(name: str) -> None:
    cloth = cloth_of(geometry_of(name), Float)
    points, seen = plan_points(cloth), seen_points(cast_views(cloth, PER_FAMILY))
    families = seen.of_families()
    spreads = []
    for per_family in (1, 4, 16):
        groups = find_groups(points, seen, per_family)
        centres = [
            part
            for face, first in zip(groups.centres, groups.of_warp, strict=True)
            for part in (face[:first], face[first:])
        ]
        distances = [
            np.square(seen.features(chosen)[:, None] - own).sum(axis=2).min(axis=1)
            for chosen, own in zip(families, centres, strict=True)
        ]
        spreads.append(np.concatenate(distances).mean())
    # Four times the groups of a set of two or three dimensions: at least half the variance.
    assert spreads[1] < 0.5 * spreads[0]
    assert spreads[2] < 0.5 * spreads[1]


def test_the_same_groups_every_time() -> None:
    first, second = (groups_of(geometry_of("smooth satin"), PER_FAMILY) for _ in range(2))
    for part in fields(Groups):
        assert np.array_equal(getattr(first, part.name), getattr(second, part.name)), part.name


def test_places_are_even_over_crossings_and_within_them() -> None:
    geometry = geometry_of("long rib")
    count = 4096
    lane = dr.arange(UInt32, 3 * count)
    x, y = Places(geometry, array_types(Float)).over(lane % count, lane // count)
    places = np.stack([x.numpy(), y.numpy()], axis=1).reshape(3, count, 2)
    picks, ends = geometry.layout.warp_on_top.shape
    for some in places:
        crossing = some / geometry.size * [ends, picks]
        assert (crossing >= 0).all()
        assert (crossing <= [ends, picks]).all()
        within = crossing % 1.0
        for values, cells in ((crossing, (ends, picks)), (within, (8, 8))):
            upper = (ends, picks) if values is crossing else (1, 1)
            counts = np.histogram2d(*values.T, bins=cells, range=[[0, side] for side in upper])[0]
            expected = count / counts.size
            # Random places would deviate three or four times as much in the worst of these cells.
            assert np.abs(counts - expected).max() < 2 * math.sqrt(expected)
    # Sets differ.
    assert not np.isclose(places[0], places[1]).any(axis=1).all()


@pytest.mark.parametrize("per_family", [1, 8])
def test_a_family_that_a_face_never_shows_does_no_harm(
    per_family: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No draft is so dense that all weft hides: the front's weft is given points of the warp by hand."""
    fabric = fabric_from_text(
        'weave = "satin 8/3"\n[warp]\ngap = 0.02\n[weft]\ngap = 0.5\ntranslucency = 0.5'
    )
    whole = LobesModel.for_source(fabric, per_family)
    asked = asked_of(fabric, whole.tables.size, 500, seed=3)
    wanted = prefiltered_parts(whole, asked)

    def without_weft(cloth: FrozenArg[Cloth]) -> PlanPoints:
        points = plan_points(cloth)
        shown = ~points.back & ~points.hole
        weft, warp = (np.flatnonzero(shown & (points.is_warp == wanted)) for wanted in (False, True))
        taken = np.arange(len(points.back))
        taken[weft] = np.resize(warp, len(weft))
        return replace(
            points,
            is_warp=points.is_warp[taken],
            normal=points.normal[:, taken],
            tangent=points.tangent[:, taken],
        )

    monkeypatch.setattr(tables, "plan_points", without_weft)
    cloth = cloth_of(YarnGeometry(fabric.layout()), Float)
    groups = find_groups(without_weft(cloth), seen_points(cast_views(cloth, per_family)), per_family)
    assert (groups.centres[0, per_family:] == [0, 0, 0.5, 0, 1, 0]).all()
    assert (groups.centres[1, per_family:] != [0, 0, 0.5, 0, 1, 0]).any(axis=1).all()
    for part in fields(Groups):
        assert np.isfinite(getattr(groups, part.name)).all(), part.name
    found = prefiltered_parts(LobesModel.for_source(fabric, per_family), asked)
    for name, values in found.items():
        assert np.isfinite(values).all(), name
        assert (values >= 0).all(), name
    # Other groups, much the same cloth; what weft the plan shows after all is taken for flat.
    for name in ("diffuse_warp", "specular_warp", "hole"):
        assert found[name].mean() == pytest.approx(wanted[name].mean(), rel=0.05), name
    back = asked.views[:, 2] < 0
    np.testing.assert_allclose(found["diffuse_weft"][back], wanted["diffuse_weft"][back], rtol=1e-6)


@pytest.mark.parametrize("name", TEXTS)
def test_seen_points_are_those_that_views_meet(name: str) -> None:
    """Shares of families and holes are those of the rays that tables are made of."""
    geometry = geometry_of(name)
    cloth = cloth_of(geometry, Float)
    views = cast_views(cloth, PER_FAMILY)
    seen = seen_points(views)
    rays = cast_rays(cloth, plan_points(cloth), views)
    hits = views.hits.is_warp.numpy()
    passing = np.zeros(len(hits), bool) if rays.pass_cloth is None else rays.pass_cloth.numpy()
    for back in (False, True):
        some, many = seen.back == back, (np.arange(len(hits)) >= len(hits) // 2) == back
        for found, wanted in (
            (seen.hole[some], passing[many]),
            ((seen.is_warp & ~seen.hole)[some], (hits & ~passing)[many]),
        ):
            # 4.5 deviations of random rays; these are even.
            bound = 4.5 * math.sqrt(0.25 / some.sum())
            assert abs(found.mean() - wanted.mean()) < bound
