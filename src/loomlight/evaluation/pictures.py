"""Errors between pictures: MSE of linear values and LDR-FLIP, over a mask of pixels."""

from __future__ import annotations

from dataclasses import dataclass

import flip_evaluator
import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb


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
