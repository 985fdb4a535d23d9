"""Samples that one estimator needs for the error of another."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np


def samples_for(error: float, samples: Sequence[int], errors: Sequence[float]) -> float:
    """Samples at which errors that fall with them reach `error`; the slope of the nearest two goes on.

    Interpolated on logarithmic scales.

    Args:
        samples: ascending, at least two.
        errors: at these, descending, above 0.
    """
    x, y = np.log(samples), np.log(errors)
    first = int(np.clip(np.searchsorted(-y, -np.log(error)) - 1, 0, len(x) - 2))
    fraction = (np.log(error) - y[first]) / (y[first + 1] - y[first])
    return float(np.exp(x[first] + fraction * (x[first + 1] - x[first])))
