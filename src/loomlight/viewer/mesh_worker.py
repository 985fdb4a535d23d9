"""The process that reads meshes for the server; its arguments are those of `limited_worker.serve`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from loomlight.viewer.limited_worker import serve


def _read(file: Path, told: Callable[[], list[str]]) -> bytes:
    from loomlight.mesh.garments import garment_parts
    from loomlight.viewer.mesh_message import mesh_message

    parts = garment_parts(file)
    return mesh_message(parts, told())


if __name__ == "__main__":
    serve(_read, "mesh")
