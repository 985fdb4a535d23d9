"""A fabric's buffers as files, and their description."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from loomlight.export.kernels import size_of
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import DEFAULT_GROUPS, tables_of
from loomlight.realtime.layout import BUFFERS, QUERY, RECORDS, Fields
from loomlight.realtime.tables import pack_fabrics

# Buffers that `cloth_value` reads; their binding is their place in `layout.BUFFERS`.
LIBRARY_BUFFERS = ("fabrics", "families", "words")


def write_buffers(folder: Path, fabric: Fabric, model: str) -> list[dict[str, Any]]:
    """Writes fabrics.bin, families.bin and words.bin, little-endian, and returns their description.

    Raises:
        InputError: the model does not take the fabric.
    """
    baked = tables_of(fabric, DEFAULT_GROUPS) if model == "lobes" else None
    layout = fabric.layout()
    width, height = layout.size
    packed = pack_fabrics([(layout, fabric.appearance())], [(float(width), float(height))], [baked])
    described = []
    for binding, (name, (kind, _)) in enumerate(BUFFERS.items()):
        if name in LIBRARY_BUFFERS:
            content = packed.buffers()[name].tobytes()
            (folder / f"{name}.bin").write_bytes(content)
            described.append(
                {
                    "name": name,
                    "file": f"{name}.bin",
                    "binding": binding,
                    "element": kind,
                    "stride": size_of(kind),
                    "bytes": len(content),
                }
            )
    return described


def described_records() -> dict[str, Any]:
    """Fields of every record: name, type, offset in bytes, meaning."""
    names = ("Fabric", "Lobes", "Woven", "Neumip", "Family")
    return {name: _described(RECORDS[name]) for name in names} | {"Query": _described(QUERY)}


def _described(fields: Fields) -> list[dict[str, Any]]:
    rows = []
    offset = 0
    for name, kind, meaning in fields:
        rows.append({"name": name, "type": kind, "offset": offset, "meaning": meaning})
        offset += size_of(kind)
    return rows
