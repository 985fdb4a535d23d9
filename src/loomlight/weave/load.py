"""Drafts from files: which reader a file is for."""

from __future__ import annotations

import os
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.weave.draft import Draft
from loomlight.weave.other_programs import OTHER_SUFFIXES, read_other_program
from loomlight.weave.picture import drawdown_from_picture
from loomlight.weave.wif_reader import read_wif

PICTURE_SUFFIXES = (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".gif")
DRAFT_SUFFIXES = (".wif", *OTHER_SUFFIXES, *PICTURE_SUFFIXES)


def load_draft(path: str | os.PathLike[str]) -> Draft:
    """The draft in a file: .wif, .dtx, .wpo, .twa, or a picture of a drawdown.

    Raises:
        InputError: another kind of file, or one that cannot be read or used.
    """
    suffix = Path(path).suffix.lower()
    if suffix in DRAFT_SUFFIXES:
        require_file(path)
    if suffix == ".wif":
        return read_wif(path)
    if suffix in PICTURE_SUFFIXES:
        return drawdown_from_picture(path)
    if suffix in OTHER_SUFFIXES:
        return read_other_program(path)
    given = f'"{suffix}"' if suffix else "no suffix"
    raise InputError(f"{path}: a draft is a file or picture in {', '.join(DRAFT_SUFFIXES)}, not {given}.")
