"""The draft that a fabric file names."""

from __future__ import annotations

from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.fabric.file import FabricFile
from loomlight.weave.draft import Draft
from loomlight.weave.load import load_draft
from loomlight.weave.named import named_weave


def draft_of(fields: FabricFile, folder: str) -> Draft:
    """The draft of a fabric file's `weave`, `draft` or `image`; paths are relative to `folder`.

    Raises:
        InputError: an unknown weave, or a file that is no draft.
    """
    if fields.weave is not None:
        return named_weave(fields.weave)
    name = "draft" if fields.draft is not None else "image"
    given = str(getattr(fields, name))
    path = Path(folder) / given
    try:
        require_file(path)
    except InputError as error:
        raise InputError(f'{name} = "{given[:80]}" names no draft: {error}') from error
    return load_draft(path)
