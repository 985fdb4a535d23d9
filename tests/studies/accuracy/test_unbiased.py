"""The test of unbiasedness: it passes what is unbiased, finds what is not, and counts as Holm does.

`studies/accuracy/unbiased.py` and what `studies/speed/clustered.py` shares with it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from loomlight.models.registry import make_model
from studies.accuracy.unbiased import (
    Means,
    holm,
    model_means,
    random_cases,
    reference_means,
    scores,
)
from studies.instruments.held_out import held_out_fabrics
from studies.speed.clustered import cost_by_footprint, stored_bytes

CASES = 6


def test_holm_rejects_step_by_step() -> None:
    # p of 1e-4, 0.004 and 0.6 against 0.01/3, 0.01/2 and 0.01.
    z = np.array([3.8906, -2.8782, 0.5244])
    assert holm(z, 0.01) == 2
    assert holm(np.array([2.8782, 0.5, 0.5, 0.5]), 0.01) == 0
    assert holm(np.array([9.0]), 0.01) == 1


def test_rounding_is_an_error_of_its_own() -> None:
    one = Means(np.full((1, 3), 1.0), np.zeros((1, 3)))
    other = Means(np.full((1, 3), 1.0001), np.zeros((1, 3)))
    assert np.abs(scores(one, other)).max() < 1.01


@pytest.mark.slow
def test_sampled_points_pass_and_those_at_centres_do_not() -> None:
    held = held_out_fabrics(2)[1].fabric
    cases = random_cases(held, CASES, 1)
    assert np.allclose(np.linalg.norm(cases.views, axis=1), 1)
    truth = reference_means(held, cases, 1 << 13, 2)
    point = scores(model_means(make_model("point", held), cases, 1 << 12, 3), truth)
    assert holm(point, 0.01) == 0
    several = scores(model_means(make_model("samples", held, points=4), cases, 1 << 7, 3), truth)
    assert holm(several, 0.01) == 0
    centres = replace(cases, edges=1e-3 * cases.edges)
    assert holm(scores(model_means(make_model("point", held), centres, 16, 3), truth), 0.01) > CASES


def test_aligned_footprints_are_rectangles_along_the_threads() -> None:
    held = held_out_fabrics(1)[0].fabric
    free, aligned = (random_cases(held, CASES, 1, along) for along in (False, True))
    lengths = [np.linalg.norm(cases.edges, axis=2) for cases in (free, aligned)]
    assert np.allclose(*lengths)
    # One coordinate of each edge is 0, up to the rounding of sines and cosines.
    assert (np.abs(aligned.edges).min(axis=2) < 1e-12 * lengths[1]).all()
    assert np.allclose((aligned.edges[:, 0] * aligned.edges[:, 1]).sum(axis=1), 0)


def test_costs_of_a_model() -> None:
    model = make_model("samples", held_out_fabrics(1)[0].fabric, points=1)
    costs = cost_by_footprint(model, 1 << 10)
    assert set(costs) == {"1 texel", "1 tile", "64 tiles"}
    assert all(cost > 0 for cost in costs.values())
    # A fabric and the number of points are some thousand bytes.
    assert 500 < stored_bytes(model) < 1e5
