"""Writes garments without uv as OBJ files, of 10,000 triangles: a skirt, trousers, a hood and more.

python -m examples.makers.garments FOLDER
"""

from __future__ import annotations

import sys
from pathlib import Path

from loomlight.mesh.writing import write_mesh
from studies.instruments.garment_shapes import SHAPES

TRIANGLES = 10_000


def main(folder: Path) -> None:
    """Writes a file for each shape into a folder, which is made."""
    folder.mkdir(parents=True, exist_ok=True)
    for shape, make in SHAPES.items():
        write_mesh(folder / f"{shape}.obj", [make(TRIANGLES)])


if __name__ == "__main__":
    main(Path(sys.argv[1]))
