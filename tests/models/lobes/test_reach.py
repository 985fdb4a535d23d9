"""What views see of the groups and light reaches, against more and finer rays."""

from __future__ import annotations

import math
from functools import cache

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array3f, Bool, Float
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.models.lobes.groups import (
    SUMS,
    GroupFinder,
    Groups,
    as_met,
    cloth_of,
    find_groups,
    plan_points,
    sums_of,
)
from loomlight.models.lobes.hemisphere import NODES, node_directions, node_taps
from loomlight.models.lobes.reach import (
    Reach,
    SortedRays,
    cast_rays,
    cast_views,
    groups_met,
    measure_reach,
    rays_of,
    seen_points,
    sort_rays,
)
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.search import REFERENCE_QUALITY
from loomlight.yarn.visibility import first_hit, unoccluded

from .cloths import TEXTS, directions, floats, geometry_of

PER_FAMILY = 4
RAYS = rays_of(PER_FAMILY)
BLEND = 0.7
# Rays of the independent count, a side of the repeat.
SIDE = 160


@cache
def sorted_rays(name: str) -> tuple[YarnGeometry, SortedRays]:
    geometry = geometry_of(name)
    cloth = cloth_of(geometry, Float)
    points = plan_points(cloth)
    views = cast_views(cloth, PER_FAMILY)
    groups = find_groups(points, seen_points(views), PER_FAMILY)
    return geometry, sort_rays(cast_rays(cloth, points, views), groups, BLEND)


@cache
def made(name: str) -> tuple[YarnGeometry, Groups, Reach]:
    geometry, found = sorted_rays(name)
    return geometry, found.groups, measure_reach(found)


def places(geometry: YarnGeometry, seed: int) -> tuple[Float, Float]:
    """A random place in each of SIDE² texels of the repeat."""
    rng = np.random.default_rng(seed)
    row, column = np.divmod(np.arange(SIDE * SIDE), SIDE)
    x, y = (np.stack([column, row]) + rng.random((2, SIDE * SIDE))) / SIDE
    return floats(x * geometry.size[0]), floats(y * geometry.size[1])


def node_near(degrees: float, azimuth: float) -> int:
    """The node nearest to a direction."""
    angle = math.radians(degrees)
    towards = [math.sin(angle) * math.cos(azimuth), math.sin(angle) * math.sin(azimuth), math.cos(angle)]
    return int((node_directions() @ towards).argmax())


def noise(share: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bound on the difference of two shares: 4.5 deviations of random rays; a group of one ray counts."""
    return 4.5 * np.sqrt(np.maximum(share * (1 - share), 1 / RAYS) * (1 / RAYS + 1 / SIDE**2))


@pytest.mark.parametrize(("degrees", "azimuth"), [(20.0, 0.7), (65.0, 2.5)])
@pytest.mark.parametrize("name", TEXTS)
def test_seen_is_what_finer_rays_meet(name: str, degrees: float, azimuth: float) -> None:
    geometry, groups, reach = made(name)
    node = node_near(degrees, azimuth)
    view = Array3f(*node_directions()[node].tolist())
    for back in (False, True):
        x, y = places(geometry, 1)
        hit = first_hit(geometry, x, y, view, Bool(back), True, REFERENCE_QUALITY)
        point = geometry.surface(hit.x, hit.y, Bool(back))
        finder = GroupFinder(groups, array_types(Float))
        met = finder.group(Bool(back), point.is_warp, point.hole, point.normal, point.tangent)
        met = dr.select(hit.hole, finder.holes, met).numpy()
        wanted = np.bincount(met, minlength=groups.count + 1) / len(met)
        assert (np.abs(reach.seen[int(back), node] - wanted) < noise(wanted)).all()


@pytest.mark.parametrize("name", TEXTS)
def test_moments_are_those_of_what_finer_rays_meet(name: str) -> None:
    """Of random rays from all nodes, as many as moments are of."""
    geometry, found = sorted_rays(name)
    groups = groups_met(found)
    rng = np.random.default_rng(3)
    node = np.arange(SIDE * SIDE) % NODES
    x, y = (floats(rng.random(SIDE * SIDE) * side) for side in geometry.size)
    view = Array3f(*np.ascontiguousarray(node_directions()[node].T, np.float32))
    finder = GroupFinder(groups, array_types(Float))
    for back in (False, True):
        hit = first_hit(geometry, x, y, view, Bool(back), True, REFERENCE_QUALITY)
        point = geometry.surface(hit.x, hit.y, Bool(back))
        met = finder.group(Bool(back), point.is_warp, point.hole, point.normal, point.tangent)
        met = dr.select(hit.hole, finder.holes, met).numpy()
        normal, tangent = (part.numpy().T.astype(np.float64) for part in (point.normal, point.tangent))
        for group in range(groups.count):
            members = met == group
            if members.sum() < 50:
                continue
            for means, values in ((groups.normal, normal), (groups.tangent, tangent)):
                # 4.5 deviations of the difference of two means of random points, and float32.
                error = 4.5 * values[members].std(axis=0) * math.sqrt(2.5 / members.sum()) + 1e-3
                assert (np.abs(means[int(back), group] - values[members].mean(axis=0)) < error).all()
            spread, wanted = np.trace(groups.spread[int(back), group]), np.trace(np.cov(tangent[members].T))
            assert spread == pytest.approx(wanted, rel=9 / math.sqrt(members.sum()) + 0.1, abs=1e-3)


def test_groups_that_few_views_meet_keep_the_moments_of_the_plan() -> None:
    plan = sorted_rays("smooth satin")[1].groups
    some = np.random.default_rng(4).normal(size=(20, 3))
    # Twenty points of group 1 of the back, three of group 0 of the front.
    sums = np.zeros((2, plan.count, SUMS))
    for place, points in (((1, 1), some[:17]), ((0, 0), some[17:])):
        sums[place] = [len(points), *(np.sum(part) for part in sums_of(points.T, points.T))]
    moved = as_met(plan, sums)
    np.testing.assert_allclose(moved.tangent[1, 1], some[:17].mean(axis=0))
    np.testing.assert_allclose(moved.spread[1, 1], np.cov(some[:17].T, ddof=0), atol=1e-12)
    np.testing.assert_array_equal(moved.tangent[0], plan.tangent[0])
    np.testing.assert_array_equal(moved.spread[0], plan.spread[0])


@pytest.mark.parametrize(("degrees", "azimuth"), [(30.0, 4.0), (70.0, 1.0)])
@pytest.mark.parametrize("name", ["smooth satin", "translucent twill"])
def test_lit_is_what_finer_shadow_rays_say(name: str, degrees: float, azimuth: float) -> None:
    """Both sides: light on the side seen, and from the other, whose shadows are the other face's."""
    geometry, groups, reach = made(name)
    node = node_near(degrees, azimuth)
    light = node_directions()[node]
    x, y = places(geometry, 2)
    for back in (False, True):
        point = geometry.surface(x, y, Bool(back))
        finder = GroupFinder(groups, array_types(Float))
        number = finder.group(Bool(back), point.is_warp, point.hole, point.normal, point.tangent).numpy()
        count = np.bincount(number, minlength=groups.count + 1)[:-1]
        for side in (0, 1):
            face = Bool(back ^ bool(side))
            own = geometry.surface(x, y, face)
            towards = Array3f(*light.tolist())
            awake = ~own.hole & (dr.dot(own.normal, towards) > 0)
            free = unoccluded(geometry, x, y, own.height, towards, face, awake, REFERENCE_QUALITY).numpy()
            normal = point.normal.numpy().astype(np.float64)
            # In the frame of the face seen light from the other side has z < 0, and lights −n.
            facing = normal.T @ (light * [-1, -1, 1]) if side else normal.T @ light
            cosine = BLEND * np.maximum(facing, 0) + (1 - BLEND) * light[2]
            for table, values in ((reach.reached, free), (reach.irradiance, free * cosine / math.pi)):
                sums = np.bincount(number, values, minlength=groups.count + 1)[:-1]
                wanted = sums / np.maximum(count, 1)
                found = table[int(back), side, node]
                # Rays of a group, which has `count` of all.
                several = count > 0.02 * len(number)
                error = 4.5 * np.sqrt(0.25 / (np.maximum(count, 1) / len(number) * RAYS))
                if table is reach.irradiance:
                    error /= math.pi
                assert (np.abs(found - wanted) < error)[several].all(), (back, side)
                # And all together.
                share = count[several] / count.sum()
                assert abs((share * (found - wanted)[several]).sum()) < 1 / math.sqrt(RAYS)


@pytest.mark.parametrize("name", TEXTS)
def test_ranges(name: str) -> None:
    reach = made(name)[2]
    np.testing.assert_allclose(reach.seen.sum(axis=-1), 1, atol=1e-12)
    assert (reach.seen >= 0).all()
    assert reach.reached.min() >= 0
    assert reach.reached.max() <= 1
    assert reach.irradiance.min() >= 0
    assert reach.irradiance.max() <= 1 / math.pi + 1e-6
    # Nothing is lit that is not reached.
    assert (reach.irradiance <= reach.reached / math.pi + 1e-6).all()


@pytest.mark.parametrize("name", TEXTS)
def test_from_the_zenith_everything_is_seen_and_lit(name: str) -> None:
    geometry, groups, reach = made(name)
    zenith = np.flatnonzero(node_directions()[:, 2] > 1 - 1e-9)
    assert len(zenith) > 0
    for face in range(2):
        # Straight down a ray meets what lies there.
        point = geometry.surface(*places(geometry, 4), Bool(face))
        finder = GroupFinder(groups, array_types(Float))
        there = finder.group(Bool(face), point.is_warp, point.hole, point.normal, point.tangent).numpy()
        area = np.bincount(there, minlength=groups.count + 1) / len(there)
        assert (np.abs(reach.seen[face, zenith] - area) < noise(area)).all()
        assert (reach.reached[face, 0][zenith][:, area[:-1] > 0.02] > 0.99).all()
    # Grazing light reaches less.
    if name == "open plain":
        assert reach.seen[:, zenith, -1].min() > 0.1
    lowest = node_directions()[:, 2] < 0.1
    assert reach.reached[:, 0][:, lowest].mean() < 0.5 * reach.reached[:, 0][:, zenith].mean()


def test_nodes_and_their_shares() -> None:
    nodes = node_directions()
    assert nodes.shape == (NODES, 3)
    np.testing.assert_allclose(np.linalg.norm(nodes, axis=1), 1, atol=1e-12)
    # A node has itself alone, on both sides.
    for sign in (1, -1):
        taps = node_taps(Array3f(*np.ascontiguousarray((nodes * [1, 1, sign]).T, np.float32)))
        table = np.eye(NODES)
        weights = np.stack([part.numpy() for part in taps.weights._units], axis=1)
        numbers = np.stack([part.numpy() for part in taps.nodes], axis=1)
        found = np.einsum("nt,ntk->nk", weights / weights.sum(axis=1, keepdims=True), table[numbers])
        # At the zenith azimuths do not matter.
        low = nodes[:, 2] < 1 - 1e-9
        np.testing.assert_allclose(found[low], table[low], atol=0.01)


def test_directions_lie_between_their_nodes() -> None:
    nodes = node_directions()
    asked = directions(np.random.default_rng(3), 2000, 0.05)
    taps = node_taps(Array3f(*np.ascontiguousarray(asked.T, np.float32)))
    units = np.stack([part.numpy() for part in taps.weights._units], axis=1).astype(np.float64)
    numbers = np.stack([part.numpy() for part in taps.nodes], axis=1)
    mean = np.einsum("nt,ntk->nk", units / units.sum(axis=1, keepdims=True), nodes[numbers])
    mean /= np.linalg.norm(mean, axis=1, keepdims=True)
    upright = asked * np.column_stack([np.ones((len(asked), 2)), np.sign(asked[:, 2])])
    # Interpolated nodes point close to where was asked: rings and azimuths are some 20° apart.
    assert ((mean * upright).sum(axis=1) > math.cos(math.radians(5))).all()
