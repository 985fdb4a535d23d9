"""Makes height field files of five materials, of which `neumip` and its baselines are trained.

    python -m examples.makers.heightfields [FOLDER] [SIDE]

Writes FOLDER/NAME/ (by default heightfields/) with height.png of 16 bits, albedo.png, roughness.png where
roughness varies, and NAME.toml. SIDE is that of the maps in texels, 256 by default.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.colour import linear_to_srgb
from loomlight.sources.heightfield import Heightfield
from studies.papers.kuznetsov2021.materials import RECIPES, SIDE, paper_heightfield


def write_heightfield(source: Heightfield, folder: Path) -> Path:
    """Writes maps and TOML into a folder, which is made; returns the TOML's path.

    Metallic and normal maps are not written: these materials have none.
    """
    folder.mkdir(parents=True, exist_ok=True)
    name = source.name.replace(" ", "-")
    _save(65535 * source.height, np.uint16, folder / "height.png")
    _save(255 * linear_to_srgb(source.albedo), np.uint8, folder / "albedo.png")
    roughness = f"{source.roughness[0, 0]:.3g}"
    if source.roughness.size > 1:
        _save(255 * source.roughness, np.uint8, folder / "roughness.png")
        roughness = '"roughness.png"'
    size = ", ".join(f"{length:g}" for length in source.size_mm)
    file = folder / f"{name}.toml"
    file.write_text(
        f'name = "{source.name}"\nheight_map = "height.png"\nsize_mm = [{size}]\n'
        f'height_mm = {source.height_mm:g}\nalbedo = "albedo.png"\nroughness = {roughness}\n'
        f"specular = {source.specular:g}\n",
        encoding="utf-8",
    )
    return file


def _save(values: NDArray[np.floating], dtype: type, file: Path) -> None:
    # Row 0 of a map is at y = 0, the bottom of a picture.
    Image.fromarray(np.rint(values[::-1]).astype(dtype)).save(file)


def main(folder: Path, side: int = SIDE) -> None:
    """Writes all five."""
    for name in RECIPES:
        write_heightfield(paper_heightfield(name, side), folder / name.replace(" ", "-"))


if __name__ == "__main__":
    main(
        Path(sys.argv[1]) if len(sys.argv) > 1 else Path("heightfields"),
        int(sys.argv[2]) if len(sys.argv) > 2 else SIDE,
    )
