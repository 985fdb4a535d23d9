"""The draft that a fabric file, a path or a name stands for."""

from __future__ import annotations

from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.fabric.file import FabricFile
from loomlight.weave.draft import Draft
from loomlight.weave.named import named_weave

WIF_SUFFIX = ".wif"
PICTURE_SUFFIXES = (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".gif")


def draft_of(fields: FabricFile, folder: str) -> Draft:
    """The draft of a fabric file's `weave`, `draft` or `image`; paths are relative to `folder`.

    Raises:
        InputError: an unknown weave, or a file that is no draft.
    """
    if fields.weave is not None:
        return named_weave(fields.weave)
    raise InputError(f"{Path(folder) / str(fields.draft or fields.image)} cannot be read yet.")
