"""Parts of queries on disk: a file each, or one Zarr array a field, a chunk a part.

Either is resumable: a part counts once it is whole. Files are renamed into place; a store's `done` is set
after all other chunks of a part.
"""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.extras import import_extra
from loomlight.models.neumip.btf import Queries
from loomlight.models.neumip.settings import ZARR
from loomlight.models.query_parts import PART, FileStore, QueryStore

_FIELDS = [field.name for field in fields(Queries)]
# Numbers of a query, where there are several.
_COLUMNS = {"positions": 2, "lights": 2, "views": 2, "values": 3}
_BYTES = ("faces", "is_transmission")


def query_store(kind: str, folder: Path, identity: str, total: int) -> QueryStore[Queries]:
    """The store of queries of a training.

    Args:
        kind: one of `settings.STORES`.
        identity: of what queries depend on.
        total: number of all queries.

    Raises:
        MissingDependencyError: zarr is not installed.
        InputError: a folder that cannot be written.
    """
    if kind == ZARR:
        return ZarrStore(folder / f"queries-{identity[:12]}-2.zarr", total)
    return FileStore(Queries, folder, identity)


class ZarrStore:
    """A Zarr group with an array a field, for other programs to read."""

    def __init__(self, path: Path, total: int) -> None:
        zarr = import_extra("zarr", "data", "A store of queries in Zarr")
        parts = -(-total // PART)
        try:
            self._group: Any = zarr.open_group(str(path), mode="a", zarr_format=3)
            for name in _FIELDS:
                shape = (total, _COLUMNS[name]) if name in _COLUMNS else (total,)
                self._array(name, shape, PART, np.uint8 if name in _BYTES else np.float32)
            self._done = self._array("done", (parts,), 1, np.bool_)
        except (OSError, ValueError, TypeError, KeyError) as error:
            raise InputError(f"{path} cannot be used as a store of queries: {error}.") from error

    def _array(self, name: str, shape: tuple[int, ...], chunk: int, dtype: type) -> Any:
        chunks = (min(chunk, shape[0]), *shape[1:])
        return self._group.require_array(name, shape=shape, chunks=chunks, dtype=np.dtype(dtype))

    def read(self, number: int, size: int) -> Queries | None:
        """See `QueryStore.read`."""
        if not self._done[number]:
            return None
        place = slice(number * PART, number * PART + size)
        try:
            part = Queries(*(np.asarray(self._group[name][place]) for name in _FIELDS))
        except (OSError, ValueError, RuntimeError):
            return None
        return part if len(part) == size else None

    def write(self, number: int, part: Queries) -> None:
        """See `QueryStore.write`."""
        place = slice(number * PART, number * PART + len(part))
        try:
            for name in _FIELDS:
                self._group[name][place] = getattr(part, name)
            self._done[number] = True
        except OSError as error:
            raise InputError(f"A store of queries cannot be written: {error.strerror or error}.") from error
