"""The source or the fabric of a path or name."""

from __future__ import annotations

import hashlib
import json
import os
from importlib.metadata import version
from typing import Any

import numpy as np

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.sources.kinds import SOURCE_KINDS, Source, kind_of_file, kind_of_source
from loomlight.sources.loom_file import SCHEMA, is_loom, read_loom


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


# --------------------------------------------------------------------------------------------------- identity
# The identity of a source: a hash of all that a `.loom` would hold of it.


def source_identity(source: Source, settings: dict[str, Any]) -> str:
    """A hash of a source, of settings (JSON values), of this program's version and schema, hexadecimal."""
    kind = kind_of_source(source)
    record, tensors = SOURCE_KINDS[kind].record(source)
    facts = [version("loomlight"), SCHEMA, kind, record, settings]
    digest = hashlib.sha256(json.dumps(facts, sort_keys=True, default=str).encode())
    for name, values in sorted(tensors.items()):
        array = np.ascontiguousarray(values)
        digest.update(f"{name} {array.dtype} {array.shape}".encode())
        digest.update(array.data)
    return digest.hexdigest()
