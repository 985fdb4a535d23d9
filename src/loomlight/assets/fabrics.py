"""The fabric that a path stands for, wherever one is asked for."""

from __future__ import annotations

import os

from loomlight.assets.loom_file import is_loom, read_loom
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.load import edited_fabric, fabric_from_text, load_fabric


def fabric_of_path(path: str | os.PathLike[str]) -> Fabric:
    """The fabric of a `.loom`, or of all that `load_fabric` takes: a fabric file, a draft, a weave's name.

    Raises:
        InputError: no such file, no fabric, or values that cannot be; the message names file and field.
    """
    return read_loom(path).fabric if is_loom(path) else load_fabric(path)


def fabric_of_text(text: str, folder: str | os.PathLike[str]) -> Fabric:
    """The fabric of a fabric file's text whose draft lies in `folder`, or in the `.loom` of that name.

    So `fabric_of_text(fabric.to_toml(), fabric.folder)` is the same fabric, wherever it was read from.

    Raises:
        InputError: a text that is no fabric file, or a draft that cannot be read.
    """
    return (
        edited_fabric(read_loom(folder).fabric, text) if is_loom(folder) else fabric_from_text(text, folder)
    )
