"""A truth whose noise is in no error."""

from __future__ import annotations

import numpy as np
import pytest

from studies.instruments.halved_truth import HalvedTruth


def test_the_truths_noise_is_in_no_error() -> None:
    rng = np.random.default_rng(0)
    shape, noise = (200, 200, 3), 0.1
    truth = np.full(shape, 0.5)
    halves = tuple((truth + rng.normal(0, noise, shape)).astype(np.float32) for _ in range(2))
    halved = HalvedTruth((halves[0], halves[1]))
    counted = np.ones(shape[:2], bool)
    counted[0] = False
    picture = (truth + rng.normal(0, 0.02, shape)).astype(np.float32)
    # The plain error holds half the noise's variance, 5e-3; the standard error of the product is 4e-5.
    assert ((picture - halved.picture) ** 2).mean() > 4e-3
    assert halved.squared_error(picture, counted) == pytest.approx(0.02**2, abs=2e-4)
