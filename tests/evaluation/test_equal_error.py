"""Samples of equal error are interpolated."""

from __future__ import annotations

import pytest

from loomlight.evaluation.metrics import samples_for


def test_samples_are_read_off_on_logarithmic_scales() -> None:
    samples = [1, 4, 16, 64]
    errors = [0.5 / count for count in samples]
    assert samples_for(0.5 / 10, samples, errors) == pytest.approx(10)
    # Beyond both ends the nearest slope goes on.
    assert samples_for(0.5 / 1000, samples, errors) == pytest.approx(1000)
    assert samples_for(2.0, samples, errors) == pytest.approx(0.25)
