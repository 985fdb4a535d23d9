"""Writes the draped cloth that the editor's page shows: the mesh of the scene "drape", on a coarser grid.

    python -m tools.generate.web_drape

The file holds int16 x, y, z of SIDE² vertices, row by row, little-endian, in units of 1/65534 metre; uv
follows from a vertex's place in the grid, and the page computes normals.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.ndimage import map_coordinates

ROOT = Path(__file__).parents[2]
SOURCE = ROOT / "src" / "loomlight" / "mitsuba" / "data" / "drape.ply"
TARGET = ROOT / "web" / "editor" / "src" / "assets" / "drape.bin"
SIDE = 128
UNITS_PER_METRE = 65534


def main() -> None:
    """Reads the mesh, interpolates its grid by cubic splines and writes the file."""
    content = SOURCE.read_bytes()
    start = content.index(b"end_header\n") + len(b"end_header\n")
    vertices = np.frombuffer(content, np.float32, count=200 * 200 * 8, offset=start).reshape(200, 200, 8)
    lines = np.linspace(0, 199, SIDE)
    places = np.meshgrid(lines, lines, indexing="ij")
    grid = np.stack([map_coordinates(vertices[..., axis], places, order=3) for axis in range(3)], axis=-1)
    TARGET.write_bytes(np.rint(grid * UNITS_PER_METRE).astype("<i2").tobytes())


if __name__ == "__main__":
    main()
