"""Unit vectors by angles and at random."""

from __future__ import annotations

import numpy as np
import pytest

from studies.instruments.directions import above, as_vectors, by_cosine, copies, direction

COUNT = 10_000


def test_angles_are_from_the_normal_and_around_it() -> None:
    np.testing.assert_allclose(direction(0, 30), (0, 0, 1), atol=1e-15)
    np.testing.assert_allclose(direction(90, 90), (0, 1, 0), atol=1e-15)
    np.testing.assert_allclose(direction(60, 0), (np.sqrt(0.75), 0, 0.5), atol=1e-15)


@pytest.mark.parametrize(("least", "mean"), [(0.0, 0.5), (0.4, 0.7)])
def test_hemispheres_are_even_above_a_cosine(least: float, mean: float) -> None:
    vectors = above(np.random.default_rng(0), COUNT, least)
    np.testing.assert_allclose(np.linalg.norm(vectors, axis=0), 1)
    assert vectors[2].min() >= least
    # The mean of a uniform cosine; its deviation over 10⁴ is at most 0.003.
    assert abs(vectors[2].mean() - mean) < 0.012
    assert np.abs(vectors[:2].mean(axis=1)).max() < 0.03


def test_a_dome_is_denser_above() -> None:
    vectors = by_cosine(np.random.default_rng(0), COUNT)
    np.testing.assert_allclose(np.linalg.norm(vectors, axis=0), 1)
    # ∫ cos² over ∫ cos is 2/3; the deviation of the mean over 10⁴ is 0.0024.
    assert abs(vectors[2].mean() - 2 / 3) < 0.01


def test_vectors_of_dr_jit_are_columns() -> None:
    columns = by_cosine(np.random.default_rng(1), 5)
    np.testing.assert_allclose(as_vectors(columns).numpy(), columns, rtol=1e-6)
    twice = np.array([[0, 0], [0.6, 0.6], [0.8, 0.8]])
    np.testing.assert_allclose(copies((0, 3, 4), 2).numpy(), twice, rtol=1e-6)
