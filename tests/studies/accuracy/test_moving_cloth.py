"""Flicker of moving cloth is measured at points that are followed."""

from __future__ import annotations

import numpy as np
import pytest

from studies.accuracy.moving_cloth import MANY, MovingClothFlicker, measure, sampled
from studies.harness.study import Run


def test_colours_between_pixels() -> None:
    rows, columns = np.mgrid[0:6, 0:8]
    picture = np.stack([columns, rows, 0 * rows], axis=2).astype(float)
    place = np.array([[1.25, 3.0, 5.5], [2.0, 0.75, 4.25]])
    np.testing.assert_allclose(sampled(picture, place)[:, :2], place.T)


@pytest.mark.slow
def test_many_samples_do_not_flicker() -> None:
    figures = measure(MovingClothFlicker(side=24, cases=1, reference=128), Run()).figures
    (row,) = figures["rows"].values()
    assert row["points"] > 1000
    few, many = (row[name]["flicker"] for name in ("lobes 8, one seed", f"lobes {MANY}"))
    # Points that were not followed would change alike in all. Noise of the reference leaves two thirds.
    assert many < 0.8 * few
    assert row["own"]["flicker"] < 0.8 * few
