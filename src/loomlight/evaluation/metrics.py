"""Errors of predictions against the truth, as sums that add over any classes of queries."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True)
class ErrorSums:
    """Sums over values p predicted for t; adding two is the sums over both.

    Attributes:
        count: number of values.
        truth: Σ t.
        absolute: Σ |p − t|.
        squared: Σ (p − t)².
        signed: Σ (p − t).
    """

    count: float = 0.0
    truth: float = 0.0
    absolute: float = 0.0
    squared: float = 0.0
    signed: float = 0.0

    def __add__(self, other: ErrorSums) -> ErrorSums:
        return ErrorSums(*(getattr(self, f.name) + getattr(other, f.name) for f in fields(self)))

    @property
    def nmae(self) -> float:
        """Mean absolute error over the mean of the truth; NaN without light."""
        return self.absolute / self.truth if self.truth > 0 else float("nan")

    @property
    def mse(self) -> float:
        """Mean squared error, 1/sr²."""
        return self.squared / self.count if self.count else float("nan")

    @property
    def bias(self) -> float:
        """Mean signed error over the mean of the truth; NaN without light."""
        return self.signed / self.truth if self.truth > 0 else float("nan")

    def values(self) -> dict[str, float]:
        """Every metric by name, and the number of values."""
        return {name: float(getattr(self, name)) for name in ("nmae", "mse", "bias", "count")}


def error_sums(predicted: ArrayLike, truth: ArrayLike) -> ErrorSums:
    """The sums over arrays of the same shape; NaN or infinity in `predicted` makes every metric NaN."""
    p, t = (np.asarray(values, np.float64).ravel() for values in (predicted, truth))
    if p.shape != t.shape:
        raise ValueError(f"{p.size} predictions of {t.size} values")
    difference = p - t
    return ErrorSums(
        count=float(t.size),
        truth=float(t.sum()),
        absolute=float(np.abs(difference).sum()),
        squared=float((difference**2).sum()),
        signed=float(difference.sum()),
    )


@dataclass(frozen=True, eq=False)
class Classes:
    """A partition of queries into classes.

    Attributes:
        names: of the classes.
        codes: index into `names` for every query, any shape.
    """

    names: tuple[str, ...]
    codes: NDArray[np.intp]


OVERALL = "overall"


def sums_by_class(predicted: ArrayLike, truth: ArrayLike, parts: list[Classes]) -> dict[str, ErrorSums]:
    """Sums overall and for every class of every partition; the values' first axes are those of the codes."""
    p, t = np.asarray(predicted), np.asarray(truth)
    sums = {OVERALL: error_sums(p, t)}
    for part in parts:
        for code, name in enumerate(part.names):
            chosen = part.codes == code
            sums[name] = error_sums(p[chosen], t[chosen])
    return sums
