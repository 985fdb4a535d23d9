"""The source or the fabric of a path or name."""

from __future__ import annotations

import os

from loomlight.assets.loom_file import is_loom, read_loom
from loomlight.assets.sources import SOURCE_KINDS, Source, kind_of_file
from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric


def load_source(path: str | os.PathLike[str], kind: str = "fabric") -> Source:
    """The source in a `.loom`, or the source that another path or a name denotes.

    Args:
        kind: of the source, where the file itself does not say another one.

    Raises:
        InputError: no such file, no source of that kind, or invalid values.
    """
    if is_loom(path):
        return read_loom(path).source
    source: Source = SOURCE_KINDS[kind_of_file(path, kind)].load(path)
    return source


def fabric_of_path(path: str | os.PathLike[str]) -> Fabric:
    """The fabric of a `.loom`, or of an argument of `load_fabric`: a fabric file, a draft, a weave's name.

    Raises:
        InputError: no such file, no fabric, or invalid values; the message names file and field.
    """
    source = load_source(path)
    if not isinstance(source, Fabric):
        raise InputError(f"{path}: it holds {source.name}, which is no fabric.")
    return source
