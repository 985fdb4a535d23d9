"""Radiance pictures (.hdr): three mantissas with one exponent a pixel (Ward 1991), often run-length coded.

Their components are RGB, or CIE XYZ where the line FORMAT says "xyze".
"""

from __future__ import annotations

import os
import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError

_SIZE = re.compile(rb"-Y (\d+) \+X (\d+)\n")
_FORMAT = re.compile(rb"^FORMAT=(\S+)", re.MULTILINE)
_RGB, _XYZ = b"32-bit_rle_rgbe", b"32-bit_rle_xyze"
# Chromaticities x, y of Radiance's primaries; its white is that of equal energy, so that X = Y = Z is grey
# (Ward, Radiance file formats, "color.h").
_PRIMARIES = np.array([[0.640, 0.330], [0.290, 0.600], [0.150, 0.060]])
# Widths between these are run-length coded, row by row.
_MIN_CODED, _MAX_CODED = 8, 32767


def read_rgbe(path: str | os.PathLike[str]) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] of a Radiance picture.

    Raises:
        InputError: no Radiance picture, one that ends early, or one of a FORMAT that is neither RGB nor XYZ.
    """
    data = Path(path).read_bytes()
    size = _SIZE.search(data, 0, 4096)
    if not data.startswith(b"#?") or size is None:
        raise InputError(f"{path} is no Radiance picture (.hdr) with rows from the top.")
    height, width = int(size[1]), int(size[2])
    # A row takes at least four bytes, so a damaged size cannot ask for much more than the file has.
    if width == 0 or height == 0 or height > len(data):
        raise InputError(f"{path} has {width} x {height} pixels, which its data do not hold.")
    pixels = np.zeros((height, width, 4), np.uint8)
    try:
        _read_rows(data, size.end(), pixels)
    except (IndexError, ValueError) as error:
        raise InputError(f"{path} is damaged: its data end early.") from error
    # A pixel is mantissa · 2^(exponent − 136); an exponent of 0 is black.
    scale = np.where(pixels[..., 3:] > 0, np.exp2(np.float32(pixels[..., 3:]) - 136), 0)
    values = (pixels[..., :3] * scale).astype(np.float32)
    form = _FORMAT.search(data, 0, size.start())
    if form is None or form[1] == _RGB:
        return values
    if form[1] == _XYZ:
        return values @ np.linalg.inv(_rgb_to_xyz()).T.astype(np.float32)
    shown = form[1][:40].decode("ascii", "replace")
    raise InputError(f"{path} has FORMAT={shown}; {_RGB.decode()} and {_XYZ.decode()} are read.")


def _rgb_to_xyz() -> NDArray[np.float64]:
    """The matrix [3, 3] of Radiance's primaries, scaled so that RGB of 1, 1, 1 is XYZ of 1, 1, 1."""
    columns = np.column_stack([_PRIMARIES, 1 - _PRIMARIES.sum(axis=1)]).T
    return columns * np.linalg.solve(columns, np.ones(3))


def _read_rows(data: bytes, at: int, pixels: NDArray[np.uint8]) -> None:
    width = pixels.shape[1]
    for row in pixels:
        coded = _MIN_CODED <= width <= _MAX_CODED and data[at : at + 2] == b"\x02\x02"
        if not coded:
            row[:] = np.frombuffer(data, np.uint8, 4 * width, at).reshape(width, 4)
            at += 4 * width
            continue
        at += 4
        for channel in range(4):
            at = _read_runs(data, at, row[:, channel])


def _read_runs(data: bytes, at: int, values: NDArray[np.uint8]) -> int:
    """Fills one channel of a row; where its code ends."""
    place = 0
    while place < len(values):
        count = data[at]
        if count > 128:  # so many times one value
            count -= 128
            values[place : place + count] = data[at + 1]
            at += 2
        else:
            values[place : place + count] = np.frombuffer(data, np.uint8, count, at + 1)
            at += 1 + count
        if count == 0:
            raise ValueError("a run of no pixels")
        place += count
    return at
