"""Drawdowns as pictures: black is warp up, the bottom row is pick 1, the left column end 1."""

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


def drawdown_from_picture(path: str | os.PathLike[str]) -> Draft:
    """The draft that a picture draws, one pixel a crossing.

    Grey and coloured pictures are split at half of full brightness; what is transparent counts as white.
    Crossings drawn as squares of pixels are not recognised, since a basket weave is one too: scale such a
    picture down first.

    Args:
        path: a PNG, JPEG, TIFF, BMP or GIF of at most 16384 pixels each way.

    Raises:
        InputError: no picture, one that is too large, or one without both black and white.
    """
    width, height = picture_size(path)
    if max(width, height) > MAXIMUM_THREADS:
        raise InputError(
            f"{path} has {width} x {height} pixels; a drawdown has one pixel a crossing, "
            f"and at most {MAXIMUM_THREADS} ends and picks can be used."
        )
    dark = [part.mean(axis=2) < _THRESHOLD for part in read_picture_rows(path)]
    warp_up: NDArray[np.bool_] = np.concatenate(dark)[::-1]
    if warp_up.all() or not warp_up.any():
        present, absent = ("black", "white") if warp_up.all() else ("white", "black")
        raise InputError(
            f"{path} holds only {present} pixels and no {absent} ones; black crossings have the warp on top, "
            "white ones the weft, and cloth needs both."
        )
    return Draft(drawdown=np.ascontiguousarray(warp_up), title=Path(path).stem)
