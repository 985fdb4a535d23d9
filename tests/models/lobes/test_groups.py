"""Groups: assignment of points to groups, and sums over groups."""

from __future__ import annotations

import math
from dataclasses import fields, replace

import numpy as np
import pytest
from drjit.llvm.ad import Bool, Float
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.frozen import FrozenArg
from loomlight.fabric import fabric_from_text
from loomlight.models.lobes import groups as module
from loomlight.models.lobes import tables
from loomlight.models.lobes.groups import Groups, NearestGroup, find_groups
from loomlight.models.lobes.model import LobesModel, LobesOptions
from loomlight.models.lobes.rays import (
    TOP_DOWN_SAMPLES,
    FaceSamples,
    SurfaceHits,
    TopDownSamples,
    UploadedCloth,
    launch_views,
    top_down_samples,
    upload_cloth,
    view_samples,
)
from loomlight.yarn.flanks import SurfacePoint
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.arrays import floats
from tests.helpers.fabrics import STRESSING

from .cloths import geometry_of, groups_of, prefiltered_parts, random_queries

PER_FAMILY = 8
# Texels of an independent plan, a side.
SIDE = 300


def _plan(geometry: YarnGeometry, seed: int, back: bool) -> SurfacePoint:
    """The points that show at random places, one in each of SIDE² texels of the repeat."""
    rng = np.random.default_rng(seed)
    row, column = np.divmod(np.arange(SIDE * SIDE), SIDE)
    x, y = (np.stack([column, row]) + rng.random((2, SIDE * SIDE))) / SIDE
    return geometry.surface(floats(x * geometry.size[0]), floats(y * geometry.size[1]), Bool(back))


def _features(samples: FaceSamples, chosen: NDArray[np.intp]) -> NDArray[np.float32]:
    """Half the normal, the fibre direction and twice the shown share of some samples [n, 7]."""
    return samples.features[chosen] * np.float32([0.5, 0.5, 0.5, 1, 1, 1, 2])


def _numbers(groups: Groups, point: SurfacePoint, back: bool) -> NDArray[np.int64]:
    nearest = NearestGroup(groups, array_types(Float))
    actual = nearest.find(Bool(back), SurfaceHits.of(point, point.hole))
    return actual.numpy().astype(np.int64)


@pytest.mark.parametrize("name", STRESSING)
@pytest.mark.parametrize("back", [False, True])
def test_points_belong_to_the_nearest_centre_of_their_family(name: str, back: bool) -> None:
    geometry = geometry_of(name)
    groups = groups_of(geometry, PER_FAMILY)
    point = _plan(geometry, 1, back)
    actual = _numbers(groups, point, back)
    hole, is_warp = point.hole.numpy(), point.is_warp.numpy()
    assert (actual[hole] == groups.count).all()
    parts = 0.5 * point.normal.numpy().T, point.tangent.numpy().T, 2 * point.shown_share.numpy()[:, None]
    features = np.concatenate(parts, axis=1)
    distance = np.linalg.norm(features[:, None] - groups.centroids[int(back)], axis=2)
    of_warp = int(groups.warp_count[int(back)])
    own = np.where(is_warp[:, None], np.arange(groups.count) < of_warp, np.arange(groups.count) >= of_warp)
    distance[~own] = np.inf
    chosen = np.take_along_axis(distance, np.minimum(actual, groups.count - 1)[:, None], axis=1)[:, 0]
    # Of two as near float32 may take either.
    assert (chosen[~hole] <= distance.min(axis=1)[~hole] + 1e-6).all()
    # A family's groups lie apart: one alone would serve points worse. Flanks that lean over do not show.
    shown = np.bincount(actual[~hole], minlength=groups.count)
    leans_over = groups.normal[int(back), :, 2] < 0.1
    shown[leans_over] = 1
    for family in (shown[:of_warp], shown[of_warp:]):
        if family.sum() > 1000:
            assert (family > 0).all()


@pytest.mark.parametrize("name", STRESSING)
@pytest.mark.parametrize("back", [False, True])
def test_holes_are_those_of_the_plan(name: str, back: bool) -> None:
    geometry = geometry_of(name)
    groups = groups_of(geometry, PER_FAMILY)
    hole = _plan(geometry, 2, back).hole.numpy().mean()
    # Points are even: where each of n stands for a square, some √n lie on the outlines of holes.
    assert groups.hole_fraction[int(back)] == pytest.approx(hole, abs=0.6 / math.sqrt(TOP_DOWN_SAMPLES))


def test_until_views_tell_more_fibres_lie_about_the_centre() -> None:
    groups = groups_of(geometry_of("smooth satin"), PER_FAMILY)
    np.testing.assert_allclose(groups.tangent, groups.centroids[..., 3:6])
    # Directions are unit vectors: their mean square is 1.
    square = np.square(groups.tangent).sum(axis=-1) + np.trace(groups.covariance, axis1=2, axis2=3)
    np.testing.assert_allclose(square, 1, atol=1e-6)


def test_the_family_that_is_seen_most_has_most_groups() -> None:
    groups = groups_of(geometry_of("smooth satin"), PER_FAMILY)
    # Eight ends of nine show the warp in front, and the weft behind.
    assert groups.warp_count[0] > PER_FAMILY > groups.warp_count[1]
    even = groups_of(geometry_of("open plain"), PER_FAMILY)
    assert (even.warp_count == PER_FAMILY).all()
    # Six a family are no whole words: either has half of them.
    assert (groups_of(geometry_of("smooth satin"), 6).warp_count == 6).all()


def test_groups_shared_out_are_narrower_than_halves() -> None:
    cloth = upload_cloth(geometry_of("smooth satin"), Float)
    points, seen = top_down_samples(cloth), view_samples(launch_views(cloth, PER_FAMILY))

    def spread(groups: Groups) -> float:
        distances = []
        for number, chosen in enumerate(seen.by_family()):
            face, first = number // 2, groups.warp_count[number // 2]
            own = groups.centroids[face, first:] if number % 2 else groups.centroids[face, :first]
            distances.append(np.square(_features(seen, chosen)[:, None] - own).sum(axis=2).min(axis=1))
        return float(np.concatenate(distances).mean())

    shared = spread(find_groups(points, seen, PER_FAMILY))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "_best_warp_count", lambda clusters, hits, per_family: per_family)
        halves = spread(find_groups(points, seen, PER_FAMILY))
    assert shared < 0.9 * halves


@pytest.mark.parametrize("name", STRESSING)
def test_more_groups_are_narrower(name: str) -> None:
    cloth = upload_cloth(geometry_of(name), Float)
    points, seen = top_down_samples(cloth), view_samples(launch_views(cloth, PER_FAMILY))
    families = seen.by_family()
    spreads = []
    for per_family in (1, 4, 16):
        groups = find_groups(points, seen, per_family)
        centres = [
            part
            for face, first in zip(groups.centroids, groups.warp_count, strict=True)
            for part in (face[:first], face[first:])
        ]
        distances = [
            np.square(_features(seen, chosen)[:, None] - own).sum(axis=2).min(axis=1)
            for chosen, own in zip(families, centres, strict=True)
        ]
        spreads.append(np.concatenate(distances).mean())
    # Four times the groups of a set of two or three dimensions: at least half the variance.
    assert spreads[1] < 0.5 * spreads[0]
    assert spreads[2] < 0.5 * spreads[1]


@pytest.mark.slow
@pytest.mark.parametrize("per_family", [1, 8])
def test_a_family_that_a_face_never_shows_does_no_harm(
    per_family: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No draft is so dense that all weft hides: the front's weft is given points of the warp by hand."""
    fabric = fabric_from_text(
        'weave = "satin 8/3"\n[warp]\ngap = 0.02\n[weft]\ngap = 0.5\ntranslucency = 0.5'
    )
    whole = LobesModel.for_source(fabric, LobesOptions(groups=per_family))
    queries = random_queries(fabric, whole.tables.base_size, 500, seed=3)
    expected = prefiltered_parts(whole, queries)

    def without_weft(cloth: FrozenArg[UploadedCloth]) -> TopDownSamples:
        points = top_down_samples(cloth)
        shown = ~points.back & ~points.hole
        weft, warp = (np.flatnonzero(shown & (points.is_warp == expected)) for expected in (False, True))
        taken = np.arange(len(points.back))
        taken[weft] = np.resize(warp, len(weft))
        return replace(
            points,
            is_warp=points.is_warp[taken],
            features=points.features[taken],
        )

    monkeypatch.setattr(tables, "top_down_samples", without_weft)
    cloth = upload_cloth(YarnGeometry(fabric.layout()), Float)
    groups = find_groups(without_weft(cloth), view_samples(launch_views(cloth, per_family)), per_family)
    assert (groups.centroids[0, per_family:] == [0, 0, 0.5, 0, 1, 0, 0]).all()
    assert (groups.centroids[1, per_family:] != [0, 0, 0.5, 0, 1, 0, 0]).any(axis=1).all()
    for part in fields(Groups):
        assert np.isfinite(getattr(groups, part.name)).all(), part.name
    actual = prefiltered_parts(LobesModel.for_source(fabric, LobesOptions(groups=per_family)), queries)
    for name, values in actual.items():
        assert np.isfinite(values).all(), name
        assert (values >= 0).all(), name
    # Other groups, much the same cloth; what weft the plan shows after all is taken for flat.
    for name in ("diffuse_warp", "specular_warp", "hole"):
        assert actual[name].mean() == pytest.approx(expected[name].mean(), rel=0.05), name
    back = queries.views[:, 2] < 0
    np.testing.assert_allclose(actual["diffuse_weft"][back], expected["diffuse_weft"][back], rtol=1e-6)
