"""Buffers of a material as files, and their description."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from loomlight.exporters.kernels import library_records, size_of
from loomlight.models.registry import REALTIME_MODELS
from loomlight.realtime.materials import Material, look_of, tables_for
from loomlight.realtime.records import BUFFERS, RECORDS, Fields
from loomlight.realtime.words import pack_fabrics


def write_buffers(
    folder: Path, material: Material, model: str, repeat_mm: tuple[float, float]
) -> list[dict[str, Any]]:
    """Writes a file NAME.bin, little-endian, of each buffer of a library, and returns their description.

    Raises:
        InputError: the model does not take the material.
    """
    packed = pack_fabrics([look_of(material, model)], [repeat_mm], [tables_for(material, model)])
    described = []
    for binding, (name, (kind, _)) in enumerate(BUFFERS.items()):
        if name in REALTIME_MODELS[model].buffers:
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
    return {name: _described(RECORDS[name]) for name in library_records()}


def _described(fields: Fields) -> list[dict[str, Any]]:
    rows = []
    offset = 0
    for name, kind, meaning in fields:
        rows.append({"name": name, "type": kind, "offset": offset, "meaning": meaning})
        offset += size_of(kind)
    return rows
