"""Drafts from files: which reader a file is for."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.core.images import PICTURE_SUFFIXES
from loomlight.weave.draft import Draft
from loomlight.weave.other_programs import OTHER_SUFFIXES, read_other_program
from loomlight.weave.picture import drawdown_from_picture
from loomlight.weave.wif_reader import read_wif

_PICTURES = (*PICTURE_SUFFIXES, ".webp")
DRAFT_SUFFIXES = (".wif", *OTHER_SUFFIXES, *_PICTURES)
_READERS: dict[str, Callable[[str | os.PathLike[str]], Draft]] = {
    ".wif": read_wif,
    **dict.fromkeys(OTHER_SUFFIXES, read_other_program),
    **dict.fromkeys(_PICTURES, drawdown_from_picture),
}


def load_draft(path: str | os.PathLike[str]) -> Draft:
    """The draft in a file: .wif, .dtx, .wpo, .twa, or a picture of a drawdown; untitled ones get its name.

    Raises:
        InputError: another kind of file, or one that cannot be read or used.
    """
    suffix = Path(path).suffix.lower()
    if suffix in DRAFT_SUFFIXES:
        require_file(path)
    read = _READERS.get(suffix)
    if read is not None:
        draft = read(path)
        return draft if draft.title.strip() else replace(draft, title=Path(path).stem)
    given = f'"{suffix}"' if suffix else "no suffix"
    raise InputError(f"{path}: a draft is a file or picture in {', '.join(DRAFT_SUFFIXES)}, not {given}.")
