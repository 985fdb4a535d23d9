"""Flicker of moving cloth is measured at points that are followed."""

from __future__ import annotations

from argparse import Namespace

import numpy as np
import pytest

from experiments.moving_cloth import MANY, measure, sampled


def test_colours_between_pixels() -> None:
    rows, columns = np.mgrid[0:6, 0:8]
    picture = np.stack([columns, rows, 0 * rows], axis=2).astype(float)
    place = np.array([[1.25, 3.0, 5.5], [2.0, 0.75, 4.25]])
    np.testing.assert_allclose(sampled(picture, place)[:, :2], place.T)


@pytest.mark.slow
def test_many_samples_do_not_flicker() -> None:
    figures = measure(Namespace(side=32, cases=1))
    (row,) = figures["rows"].values()
    assert row["points"] > 1000
    assert figures["missed"] == []
    # Points that were not followed would change by as much as the whole cloth varies: a third of the change
    # is far above what noise of 256 samples leaves.
    assert row[f"lobes {MANY}"]["flicker"] < row["reference"] / 3
    assert row["own"]["flicker"] < row["lobes 8, one seed"]["flicker"]
