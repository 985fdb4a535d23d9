"""Makes textures of examples/materials, or copies of these materials with textures of another size.

    python -m examples.makers.materials [FOLDER] [SIDE]

SIDE is that of the textures in texels: 128 in the repository, where they take 300 kB; 512 shows every ridge.
"""

from __future__ import annotations

import sys
from pathlib import Path

from studies.papers.zeltner2024.layered_materials import LAYERED, SIZE_MM, layered_parts

SIDE = 128


def main(folder: Path, side: int = SIDE) -> None:
    """Writes a folder for each material: an XML, its PNGs, and a TOML that names the XML and its size."""
    for name in LAYERED:
        target = folder / name
        target.mkdir(parents=True, exist_ok=True)
        xml, pictures = layered_parts(name, side)
        (target / f"{name}.xml").write_text(xml, encoding="utf-8")
        size = ", ".join(f"{length:g}" for length in SIZE_MM)
        (target / f"{name}.toml").write_text(f'material = "{name}.xml"\nsize_mm = [{size}]\n')
        for file, content in pictures.items():
            (target / file).write_bytes(content.tobytes())


if __name__ == "__main__":
    main(
        Path(sys.argv[1]) if len(sys.argv) > 1 else Path("examples/materials"),
        int(sys.argv[2]) if len(sys.argv) > 2 else SIDE,
    )
