"""Which writer a draft's file is for."""

from __future__ import annotations

import os
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.weave.bitmaps import BITMAP_SUFFIXES, BitmapLayout, write_bitmaps
from loomlight.weave.draft import Draft
from loomlight.weave.dtx import write_dtx
from loomlight.weave.wif_writer import write_wif

SAVED_SUFFIXES = (".wif", ".dtx", *BITMAP_SUFFIXES)


def save_draft(draft: Draft, path: str | os.PathLike[str], layout: BitmapLayout | None = None) -> None:
    """Writes a draft by the suffix of `path`: .wif, .dtx, or a bitmap (.png, .bmp, .tif, .tiff).

    Args:
        layout: of a bitmap; None for black that lifts, pick 1 at the bottom, end 1 on the left.

    Raises:
        InputError: another suffix, a file that cannot be written, or a draft that the format does not hold.
    """
    suffix = Path(path).suffix.lower()
    if suffix == ".wif":
        write_wif(draft, path)
    elif suffix == ".dtx":
        write_dtx(draft, path)
    elif suffix in BITMAP_SUFFIXES:
        write_bitmaps([(path, draft.drawdown)], layout)
    else:
        raise InputError(f"{path}: drafts are written as {', '.join(SAVED_SUFFIXES)}, not {suffix or 'so'}.")
