"""Errors of predictions against the truth, as sums that add over any classes of queries."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import flip_evaluator
import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.core.colour import linear_to_srgb


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


# ------------------------------------------------------------------------------------ errors between pictures
# Errors between pictures: MSE of linear values and LDR-FLIP, over a mask of pixels.


@dataclass(frozen=True, eq=False)
class PictureError:
    """Errors of one picture.

    Attributes:
        mse: mean squared error of linear RGB over the mask.
        flip: mean LDR-FLIP over the mask, 0 to 1.
        flip_map: FLIP of every pixel, 0 outside the mask [height, width].
        flip_picture: FLIP in its colour map, sRGB [height, width, 3], 8 bits.
    """

    mse: float
    flip: float
    flip_map: NDArray[np.float32]
    flip_picture: NDArray[np.uint8]


def picture_error(
    picture: NDArray[np.float32], reference: NDArray[np.float32], counted: NDArray[np.bool_]
) -> PictureError:
    """Errors of linear RGB pictures [height, width, 3], shown as they are (exposure 0) on an sRGB display.

    FLIP (Andersson et al. 2020) assumes its default viewing distance, 67 pixels a degree. Pixels outside the
    mask are replaced by the reference first, since FLIP filters neighbourhoods.

    Args:
        counted: mask of pixels [height, width]; at least one.
    """
    difference = picture[counted].astype(np.float64) - reference[counted]
    shown = np.where(counted[..., None], picture, reference)
    encoded = [_display(part) for part in (reference, shown)]
    # A second call for the colour map: FLIP's values cannot be recovered from it.
    plain, _, _ = flip_evaluator.evaluate(*encoded, "LDR", applyMagma=False, computeMeanError=False)
    coloured, _, _ = flip_evaluator.evaluate(*encoded, "LDR", applyMagma=True, computeMeanError=False)
    values = np.where(counted, np.asarray(plain, np.float32).reshape(counted.shape), 0).astype(np.float32)
    return PictureError(
        mse=float((difference**2).mean()),
        flip=float(values[counted].mean(dtype=np.float64)),
        flip_map=values,
        flip_picture=np.rint(255 * np.clip(coloured, 0, 1)).astype(np.uint8),
    )


def flip_mean(one: NDArray[np.float32], other: NDArray[np.float32], counted: NDArray[np.bool_]) -> float:
    """Mean LDR-FLIP between two linear pictures over a mask of pixels."""
    shown = [_display(np.where(counted[..., None], part, 0)) for part in (one, other)]
    values, _, _ = flip_evaluator.evaluate(*shown, "LDR", applyMagma=False, computeMeanError=False)
    return float(np.asarray(values).reshape(counted.shape)[counted].mean(dtype=np.float64))


def _display(linear: NDArray[np.float32]) -> NDArray[np.float32]:
    return np.ascontiguousarray(linear_to_srgb(np.clip(linear, 0, 1)), dtype=np.float32)


# ------------------------------------------------------------------------------------- samples to equal error
# Samples that one estimator needs for the error of another.


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
