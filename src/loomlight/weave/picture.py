"""Drawdowns as pictures: dark is warp up, the bottom row is pick 1, the left column end 1."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.images import picture_size, read_picture_rows
from loomlight.weave.draft import MAXIMUM_THREADS, Draft

# Mean of the encoded components: half of what an eye calls white, and what painting programs threshold at.
_THRESHOLD = 0.5
# Rec. 709: how bright an eye finds each component.
_LUMA = np.array([0.2126, 0.7152, 0.0722])
# Distances in RGB: of colours that count as two, and, as a share of theirs, of pixels that count as one.
_DISTINCT, _ALIKE = 0.1, 0.25


def drawdown_from_picture(path: str | os.PathLike[str]) -> Draft:
    """The draft that a picture draws, one pixel a crossing.

    Pictures are split at half of full brightness; what is transparent counts as white. Where all is darker
    than that, or lighter, and of two colours, the darker one to the eye is the warp.
    Crossings drawn as squares of pixels are not recognised, since a basket weave is one too: scale such a
    picture down first.

    Args:
        path: a PNG, JPEG, WebP, TIFF, BMP or GIF of at most 16384 pixels each way.

    Raises:
        InputError: no picture, one that is too large, or colours that cannot be told apart.
    """
    width, height = picture_size(path)
    if max(width, height) > MAXIMUM_THREADS:
        raise InputError(
            f"{path} has {width} x {height} pixels; a drawdown has one pixel a crossing, "
            f"and at most {MAXIMUM_THREADS} ends and picks can be used."
        )
    dark = [part[..., 0] + part[..., 1] + part[..., 2] < 3 * _THRESHOLD for part in read_picture_rows(path)]
    warp_up: NDArray[np.bool_] = np.concatenate(dark)
    if warp_up.all() or not warp_up.any():
        corner, distance = next(read_picture_rows(path))[0, 0].copy(), -1.0
        far = corner
        for part in read_picture_rows(path):
            away = _squared(part, corner)
            if away.max() > distance:
                distance, far = float(away.max()), part.reshape(-1, 3)[away.argmax()].copy()
        if distance < _DISTINCT**2:
            raise _refusal(path, "only pixels of one colour")
        pair = sorted((corner, far), key=lambda colour: float(colour @ _LUMA))
        dark = []
        for part in read_picture_rows(path):
            warp, weft = (_squared(part, colour) for colour in pair)
            if (np.minimum(warp, weft) > _ALIKE**2 * distance).any():
                side = "darker" if warp_up.all() else "lighter"
                raise _refusal(path, f"more than two colours, all {side} than half of full brightness")
            dark.append(warp < weft)
        warp_up = np.concatenate(dark)
    return Draft(drawdown=np.ascontiguousarray(warp_up[::-1]), title=Path(path).stem)


def _squared(pixels: NDArray[np.float64], colour: NDArray[np.float64]) -> NDArray[np.float64]:
    """Squared distances [rows, width] of pixels from a colour."""
    away: NDArray[np.float64] = ((pixels - colour) ** 2).sum(axis=2)
    return away


def _refusal(path: str | os.PathLike[str], held: str) -> InputError:
    return InputError(
        f"{path} holds {held}; cloth needs dark crossings, where the warp is on top, and light ones, "
        "where the weft is."
    )
