"""Visibility tables against more and finer rays."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array3f, Bool, Float
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.models.lobes.groups import Groups, NearestGroup, find_groups, with_view_moments
from loomlight.models.lobes.hemisphere import NODES, node_directions
from loomlight.models.lobes.rays import (
    SurfaceHits,
    launch_rays,
    launch_views,
    ray_count,
    top_down_samples,
    upload_cloth,
    view_samples,
)
from loomlight.models.lobes.visibility import VIEW_SUMS, VisibilityTables, tabulate_visibility
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.rays import REFERENCE_QUALITY
from loomlight.yarn.visibility import first_hit, unoccluded
from tests.helpers.arrays import floats
from tests.helpers.fabrics import STRESSING
from tests.helpers.layouts import even_layout

from .cloths import geometry_of

PER_FAMILY = 4
RAYS = ray_count(PER_FAMILY)
BLEND = 0.7
# Rays of the independent count, a side of the repeat.
SIDE = 160


@dataclass(frozen=True, eq=False)
class _Made:
    """A geometry, its groups before and after views are counted, and its tables."""

    geometry: YarnGeometry
    clusters: Groups
    groups: Groups
    tables: VisibilityTables


@cache
def _made(name: str) -> _Made:
    return _made_of(geometry_of(name), PER_FAMILY)


def _made_of(geometry: YarnGeometry, per_family: int) -> _Made:
    cloth = upload_cloth(geometry, Float)
    top_down = top_down_samples(cloth)
    views = launch_views(cloth, per_family)
    clusters = find_groups(top_down, view_samples(views), per_family)
    tables, groups = tabulate_visibility(launch_rays(cloth, top_down, views), clusters, BLEND)
    return _Made(geometry, clusters, groups, tables)


def _places(geometry: YarnGeometry, seed: int) -> tuple[Float, Float]:
    """A random position in each of SIDE² texels of the repeat."""
    rng = np.random.default_rng(seed)
    row, column = np.divmod(np.arange(SIDE * SIDE), SIDE)
    x, y = (np.stack([column, row]) + rng.random((2, SIDE * SIDE))) / SIDE
    return floats(x * geometry.size[0]), floats(y * geometry.size[1])


def _node_near(degrees: float, azimuth: float) -> int:
    """The node nearest to a direction."""
    angle = math.radians(degrees)
    towards = [math.sin(angle) * math.cos(azimuth), math.sin(angle) * math.sin(azimuth), math.cos(angle)]
    return int((node_directions() @ towards).argmax())


def _noise(share: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bound on the difference of two fractions: 4.5 deviations of random rays; a group of one ray counts."""
    return 4.5 * np.sqrt(np.maximum(share * (1 - share), 1 / RAYS) * (1 / RAYS + 1 / SIDE**2))


@pytest.mark.parametrize(("degrees", "azimuth"), [(20.0, 0.7), (65.0, 2.5)])
@pytest.mark.parametrize("name", STRESSING)
def test_projected_area_is_what_finer_rays_hit(name: str, degrees: float, azimuth: float) -> None:
    made = _made(name)
    geometry, groups = made.geometry, made.groups
    node = _node_near(degrees, azimuth)
    view = Array3f(*node_directions()[node].tolist())
    for back in (False, True):
        x, y = _places(geometry, 1)
        hit = first_hit(geometry, x, y, view, Bool(back), True, REFERENCE_QUALITY)
        point = geometry.surface(hit.x, hit.y, Bool(back), (view, hit.height))
        nearest = NearestGroup(groups, array_types(Float))
        met = nearest.find(Bool(back), SurfaceHits.of(point, point.hole))
        met = dr.select(hit.hole, nearest.hole_index, met).numpy()
        expected = np.bincount(met, minlength=groups.count + 1) / len(met)
        assert (np.abs(made.tables.projected_area[int(back), node] - expected) < _noise(expected)).all()


@pytest.mark.parametrize("azimuth", [0.4, 1.2])
def test_slanting_views_see_less_of_stitches_than_of_floats(azimuth: float) -> None:
    """Two satins side by side, warp-faced and weft-faced: what is seen of either, by groups of the whole."""
    ends, faced = 64, 8
    end, pick = np.meshgrid(np.arange(ends), np.arange(8))
    stitch = (3 * pick + end) % 8 == 0
    geometry = YarnGeometry(even_layout(np.where(end < ends // 2, ~stitch, stitch)))
    made = _made_of(geometry, faced)
    nearest = NearestGroup(made.groups, array_types(Float))
    node = _node_near(65.0, azimuth)
    view = Array3f(*node_directions()[node].tolist())
    rng = np.random.default_rng(4)
    for first in (8, 40):
        x = (first + 16 * rng.random(SIDE * SIDE)) / ends * geometry.size[0]
        x, y = floats(x), floats(rng.random(SIDE * SIDE) * geometry.size[1])
        above = geometry.surface(x, y, Bool(False))
        shown = np.bincount(
            nearest.find(Bool(False), SurfaceHits.of(above, above.hole)).numpy(), minlength=17
        )[:16]
        weight = made.tables.projected_area[0, node, :16] * shown / _coverage(geometry, nearest)
        hit = first_hit(geometry, x, y, view, Bool(False), True, REFERENCE_QUALITY)
        seen = geometry.surface(hit.x, hit.y, Bool(False)).is_warp.numpy().mean()
        of_warp = weight[: made.groups.warp_count[0]].sum() / weight.sum()
        # Views are of a few hundred rays a group; groups of both satins alike are .2 off.
        assert of_warp == pytest.approx(seen, abs=0.05)


def _coverage(geometry: YarnGeometry, nearest: NearestGroup) -> NDArray[np.int64]:
    """How many random places of the repeat show each group."""
    point = geometry.surface(*_places(geometry, 6), Bool(False))
    found = nearest.find(Bool(False), SurfaceHits.of(point, point.hole)).numpy()
    return np.maximum(np.bincount(found, minlength=17)[:16], 1)


@pytest.mark.quick("translucent twill")
@pytest.mark.parametrize("name", STRESSING)
def test_moments_are_those_of_what_finer_rays_hit(name: str) -> None:
    """Of random rays from all nodes, as many as moments are of."""
    made = _made(name)
    geometry, groups = made.geometry, made.groups
    rng = np.random.default_rng(3)
    node = np.arange(SIDE * SIDE) % NODES
    x, y = (floats(rng.random(SIDE * SIDE) * side) for side in geometry.size)
    view = Array3f(*np.ascontiguousarray(node_directions()[node].T, np.float32))
    nearest = NearestGroup(groups, array_types(Float))
    for back in (False, True):
        hit = first_hit(geometry, x, y, view, Bool(back), True, REFERENCE_QUALITY)
        point = geometry.surface(hit.x, hit.y, Bool(back), (view, hit.height))
        met = nearest.find(Bool(back), SurfaceHits.of(point, point.hole))
        met = dr.select(hit.hole, nearest.hole_index, met).numpy()
        normal, tangent = (part.numpy().T.astype(np.float64) for part in (point.normal, point.tangent))
        for group in range(groups.count):
            members = met == group
            if members.sum() < 50:
                continue
            for means, values in ((groups.normal, normal), (groups.tangent, tangent)):
                # 4.5 deviations of the difference of two means of random points, and float32.
                error = 4.5 * values[members].std(axis=0) * math.sqrt(2.5 / members.sum()) + 1e-3
                assert (np.abs(means[int(back), group] - values[members].mean(axis=0)) < error).all()
            spread, expected = (
                np.trace(groups.covariance[int(back), group]),
                np.trace(np.cov(tangent[members].T)),
            )
            assert spread == pytest.approx(expected, rel=9 / math.sqrt(members.sum()) + 0.1, abs=1e-3)


def test_groups_that_few_views_hit_keep_their_moments() -> None:
    clusters = _made("smooth satin").clusters
    some = np.random.default_rng(4).normal(size=(20, 3))
    # Twenty points of group 1 of the back, three of group 0 of the front.
    sums = np.zeros((2, clusters.count, VIEW_SUMS))
    for place, points in (((1, 1), some[:17]), ((0, 0), some[17:])):
        products = (points[:, i] * points[:, j] for i in range(3) for j in range(i, 3))
        sums[place] = [len(points), *(part.sum() for part in (*points.T, *points.T, *products))]
    moved = with_view_moments(clusters, sums)
    np.testing.assert_allclose(moved.tangent[1, 1], some[:17].mean(axis=0))
    np.testing.assert_allclose(moved.covariance[1, 1], np.cov(some[:17].T, ddof=0), atol=1e-12)
    np.testing.assert_array_equal(moved.tangent[0], clusters.tangent[0])
    np.testing.assert_array_equal(moved.covariance[0], clusters.covariance[0])


@pytest.mark.slow
@pytest.mark.parametrize(("degrees", "azimuth"), [(30.0, 4.0), (70.0, 1.0)])
@pytest.mark.parametrize("name", ["smooth satin", "translucent twill"])
def test_lit_is_what_finer_shadow_rays_say(name: str, degrees: float, azimuth: float) -> None:
    """Both sides: light on the side seen, and from the other, whose shadows are the other face's."""
    made = _made(name)
    geometry, groups, tables = made.geometry, made.groups, made.tables
    node = _node_near(degrees, azimuth)
    light = node_directions()[node]
    x, y = _places(geometry, 2)
    # Points as the views of all nodes see them.
    views = node_directions()[np.random.default_rng(5).integers(0, NODES, SIDE * SIDE)]
    view = Array3f(*np.ascontiguousarray(views.T, np.float32))
    for back in (False, True):
        hit = first_hit(geometry, x, y, view, Bool(back), True, REFERENCE_QUALITY)
        point = geometry.surface(hit.x, hit.y, Bool(back), (view, hit.height))
        nearest = NearestGroup(groups, array_types(Float))
        hole = point.hole | hit.hole
        number = nearest.find(Bool(back), SurfaceHits.of(point, hole)).numpy()
        count = np.bincount(number, minlength=groups.count + 1)[:-1]
        for side in (0, 1):
            face = Bool(back ^ bool(side))
            own = geometry.surface(point.x, point.y, face) if side else point
            towards = Array3f(*light.tolist())
            awake = ~own.hole & (dr.dot(own.normal, towards) > 0)
            free = unoccluded(
                geometry, point.x, point.y, own.height, towards, face, awake, REFERENCE_QUALITY
            ).numpy()
            normal = point.normal.numpy().astype(np.float64)
            # In the frame of the face seen light from the other side has z < 0, and lights −n.
            facing = normal.T @ (light * [-1, -1, 1]) if side else normal.T @ light
            cosine = BLEND * np.maximum(facing, 0) + (1 - BLEND) * light[2]
            for table, values in (
                (tables.light_visibility, free),
                (tables.irradiance, free * cosine / math.pi),
            ):
                sums = np.bincount(number, values, minlength=groups.count + 1)[:-1]
                expected = sums / np.maximum(count, 1)
                actual = table[int(back), side, node]
                # Rays of a group, which has `count` of all.
                several = count > 0.02 * len(number)
                error = 4.5 * np.sqrt(0.25 / (np.maximum(count, 1) / len(number) * RAYS))
                if table is tables.irradiance:
                    error /= math.pi
                assert (np.abs(actual - expected) < error)[several].all(), (back, side)
                # And all together.
                share = count[several] / count.sum()
                assert abs((share * (actual - expected)[several]).sum()) < 1 / math.sqrt(RAYS)


@pytest.mark.parametrize("name", STRESSING)
def test_ranges(name: str) -> None:
    tables = _made(name).tables
    np.testing.assert_allclose(tables.projected_area.sum(axis=-1), 1, atol=1e-12)
    assert (tables.projected_area >= 0).all()
    assert tables.light_visibility.min() >= 0
    assert tables.light_visibility.max() <= 1
    assert tables.irradiance.min() >= 0
    assert tables.irradiance.max() <= 1 / math.pi + 1e-6
    # Irradiance is bounded by visibility.
    assert (tables.irradiance <= tables.light_visibility / math.pi + 1e-6).all()


@pytest.mark.parametrize("name", STRESSING)
def test_from_the_zenith_everything_is_seen_and_lit(name: str) -> None:
    made = _made(name)
    geometry, groups, tables = made.geometry, made.groups, made.tables
    zenith = np.flatnonzero(node_directions()[:, 2] > 1 - 1e-9)
    assert len(zenith) > 0
    for face in range(2):
        # Straight down a ray meets what lies there.
        point = geometry.surface(*_places(geometry, 4), Bool(face))
        nearest = NearestGroup(groups, array_types(Float))
        there = nearest.find(Bool(face), SurfaceHits.of(point, point.hole)).numpy()
        area = np.bincount(there, minlength=groups.count + 1) / len(there)
        assert (np.abs(tables.projected_area[face, zenith] - area) < _noise(area)).all()
        # Groups are lit as all views see them, with flanks that lean over; what this view sees is more lit by
        # the ratio of joint visibility.
        lit = tables.light_visibility[face, 0][zenith] @ area[:-1] / area[:-1].sum()
        assert (lit > 0.9).all()
    # Grazing light reaches less.
    if name == "open plain":
        assert tables.projected_area[:, zenith, -1].min() > 0.1
    lowest = node_directions()[:, 2] < 0.1
    assert (
        tables.light_visibility[:, 0][:, lowest].mean()
        < 0.5 * tables.light_visibility[:, 0][:, zenith].mean()
    )
