"""The identity of a source: a hash of all that a `.loom` would hold of it."""

from __future__ import annotations

import hashlib
import json
from importlib.metadata import version
from typing import Any

import numpy as np

from loomlight.assets.loom_file import SCHEMA
from loomlight.assets.sources import SOURCE_KINDS, Source, kind_of_source


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
