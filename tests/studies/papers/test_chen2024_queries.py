"""The paper's sampling of queries, and means of slices against the Monte Carlo reference.

Covers: studies/papers/chen2024/queries.py
"""

import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Float

from loomlight.aggregate.queries import fabric_scale
from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from studies.instruments.reference import reference
from studies.papers.chen2024.materials import paper_material
from studies.papers.chen2024.queries import (
    FULL_QUERIES,
    fabric_queries,
    material_queries,
    slice_means,
)

NUMBER = 100
FABRIC = paper_material(NUMBER)
SCALE = fabric_scale(FABRIC.layout())
FULL = material_queries(NUMBER)


def test_footprints_are_64_centres_with_20_sizes():
    assert FULL.centres.shape == (1280, 2)
    cells = np.floor(FULL.centres / SCALE.extent * 8).astype(int)
    counts = np.bincount(cells[:, 1] * 8 + cells[:, 0], minlength=64)
    assert (counts == 20).all()
    centres = FULL.centres.reshape(64, 20, 2)
    assert (centres == centres[:, :1]).all()


def test_sizes_are_stratified_below_and_above_one_repeat():
    sizes = FULL.sizes.reshape(64, 2, 10)
    low = SCALE.size_range[0]
    for half, (start, end) in enumerate(((low, SCALE.repeat), (SCALE.repeat, 5 * SCALE.repeat))):
        strata = np.floor((sizes[:, half] - start) / (end - start) * 10)
        # float32 sizes may round onto the border of a stratum.
        assert (np.abs(strata - np.arange(10)) > 0).mean() < 1e-3
    assert low == pytest.approx(SCALE.repeat / 128)


@pytest.mark.parametrize("side", ["views", "front", "back"])
def test_directions_are_one_a_cell_of_the_disc(side):
    vectors = {
        "views": FULL.views,
        "front": FULL.lights[FULL.lights[:, 2] > 0],
        "back": FULL.lights[FULL.lights[:, 2] < 0],
    }[side]
    np.testing.assert_allclose(np.linalg.norm(vectors, axis=1), 1, atol=1e-6)
    cells = np.floor((vectors[:, :2] + 1) * 4).astype(int)
    assert len(set(map(tuple, cells))) == len(vectors)
    # 64·π/4 = 50 expected; cells cut by the circle scatter by 2 to 3.
    assert 42 <= len(vectors) <= 58


def test_views_are_in_front():
    assert (FULL.views[:, 2] > 0).all()


def test_every_light_meets_every_view():
    assert len(FULL.pairs) == len(FULL.lights) * len(FULL.views)
    assert len(np.unique(FULL.pairs, axis=0)) == len(FULL.pairs)
    assert 0.4 < FULL.transmits.mean() < 0.6
    # 3.2 million queries to a side, as the number of directions goes.
    assert 0.7 * FULL_QUERIES < FULL.count < 1.35 * FULL_QUERIES


@pytest.mark.parametrize("expected", [1024, 20_000, 1_000_000])
def test_fewer_queries_keep_all_centres_and_sides(expected):
    few = material_queries(NUMBER, 0, expected)
    assert few.count == pytest.approx(expected, rel=0.1)
    assert len(np.unique(few.centres, axis=0)) == 64
    assert few.transmits.any()
    assert not few.transmits.all()
    assert few.pairs[:, 0].max() == len(few.lights) - 1
    assert few.pairs[:, 1].max() == len(few.views) - 1


def test_queries_depend_on_number_and_seed_alone():
    again = material_queries(NUMBER)
    np.testing.assert_array_equal(again.centres, FULL.centres)
    np.testing.assert_array_equal(again.lights, FULL.lights)
    assert not np.array_equal(material_queries(NUMBER, 1).sizes, FULL.sizes)
    assert not np.array_equal(material_queries(NUMBER + 1).views[:9], FULL.views[:9])


def test_too_few_queries_are_refused():
    with pytest.raises(InputError, match="at least 1024"):
        fabric_queries(FABRIC, [0], 1000)


@pytest.mark.slow
def test_means_are_the_truth():
    """Every mean is within Monte Carlo noise plus the error of mapped shadows: 1.7 % of the channel's
    mean (docs/research/aggregation.md), threefold for single queries; sums, which average it, within 1 %."""
    few = fabric_queries(FABRIC, [3], 20_000)
    actual = slice_means(FABRIC, few, Float)
    chosen = np.random.default_rng(0).choice(few.count, 192, replace=False)
    pair, box = np.divmod(chosen, len(few.sizes))
    large = few.sizes[box] > SCALE.thread
    pair, box = pair[large], box[large]
    light, view = few.pairs[pair].T
    zero = np.zeros(len(box))
    footprint = Footprint(
        Array2f(few.centres[box].T),
        Array2f(np.stack([few.sizes[box], zero])),
        Array2f(np.stack([zero, few.sizes[box]])),
    )
    model = YarnScattering(YarnGeometry(FABRIC.layout()), FABRIC.appearance())
    truth = reference(model, footprint, few.lights[light], few.views[view], 2048, seed=1)
    mean, noise = truth.mean[:, :5], np.sqrt(truth.variance[:, :5])
    error = actual[pair, box] - mean
    across = few.transmits[pair]
    for side in (across, ~across):
        assert side.sum() > 40
        channel = mean[side].mean(axis=0)
        # Of 5 × 90 normal errors one in 3000 lies beyond 4 deviations.
        assert (np.abs(error[side]) < 4.5 * noise[side] + 0.05 * channel).all()
        assert (np.abs(error[side].mean(axis=0)) < 4 * noise[side].mean(axis=0) / 6 + 0.01 * channel).all()
