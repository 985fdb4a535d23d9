"""Sheets of garments without uv for docs/garments.md and docs/garment-maps.md.

    LOOMLIGHT_DATA=FOLDER python -m tools.generate.garment_sheet SHEET -o FILE

SHEET is *shirt*: a shirt in three fabrics, from the front, from behind and its sleeve; *shapes*: five other
meshes of a script; or *maps*: the shirt of three fabrics, with a print and worn at the elbow. The shirt is
meshes/unisex_shirt.usd in that folder, of the package `newton`.
"""

from __future__ import annotations

import os
import tempfile
from argparse import ArgumentParser, RawDescriptionHelpFormatter
from pathlib import Path

from PIL import Image

from loomlight.core.camera_settings import CameraKeywords
from loomlight.core.images import encoded
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.mesh.writing import write_mesh
from loomlight.mitsuba.pictures import render
from studies.instruments.garment_shapes import SHAPES

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
_GAP = 6
HERRINGBONE = """
name = "Coarse herringbone"
weave = "herringbone 2/2 8"
ends_per_cm = 5
picks_per_cm = 5
yarn = "woollen"
warp.color = "#2b4a8b"
weft.color = "#d8d2c2"
"""
VIEWS: tuple[CameraKeywords, ...] = (
    {"view": "front"},
    {"view": "back"},
    {"view": "70,20", "look_at": "left sleeve"},
)


def shirt() -> str:
    """The path of the shirt."""
    return str(Path(os.environ["LOOMLIGHT_DATA"]) / "meshes" / "unisex_shirt.usd")


def of_shirt() -> Image.Image:
    """A row for each fabric."""
    fabrics: list[Fabric] = [
        load_fabric(EXAMPLES / "wool-houndstooth.toml"),
        fabric_from_text(HERRINGBONE),
        load_fabric(EXAMPLES / "denim.toml"),
    ]
    size = (340, 340)
    rows = [[render(fabric, mesh=shirt(), size=size, spp=24, **view) for view in VIEWS] for fabric in fabrics]
    return pasted([[Image.fromarray(encoded(picture)) for picture in row] for row in rows])


def of_shapes() -> Image.Image:
    """Meshes of a script, of which none has uv."""
    fabric = fabric_from_text(HERRINGBONE)
    row = []
    with tempfile.TemporaryDirectory() as folder:
        for name, make in SHAPES.items():
            path = Path(folder) / f"{name}.obj"
            write_mesh(path, [make(6000)])
            row.append(Image.fromarray(encoded(render(fabric, mesh=path, size=(260, 300), spp=24))))
    return pasted([row])


def of_maps() -> Image.Image:
    """The command of docs/garment-maps.md."""
    picture = render(
        EXAMPLES / "chino.toml",
        mesh=shirt(),
        cloths={"sleeve": EXAMPLES / "maps" / "worn-elbow.toml", "back": EXAMPLES / "linen.toml"},
        maps={
            "color": {
                "picture": EXAMPLES / "maps" / "badge.png",
                "mode": "replace",
                "side": "front",
                "width_mm": 110.0,
                "at_mm": [75.0, 130.0],
            }
        },
        view="40,15",
        size=(700, 700),
        spp=32,
    )
    return Image.fromarray(encoded(picture))


def pasted(rows: list[list[Image.Image]]) -> Image.Image:
    """Pictures beside and below each other."""
    width, height = rows[0][0].size
    columns = max(len(row) for row in rows)
    sheet = Image.new("RGB", (columns * (width + _GAP) - _GAP, len(rows) * (height + _GAP) - _GAP), "white")
    for y, row in enumerate(rows):
        for x, picture in enumerate(row):
            sheet.paste(picture, (x * (width + _GAP), y * (height + _GAP)))
    return sheet


SHEETS = {"shirt": of_shirt, "shapes": of_shapes, "maps": of_maps}


def main() -> None:
    parser = ArgumentParser(description=__doc__, formatter_class=RawDescriptionHelpFormatter)
    parser.add_argument("sheet", choices=SHEETS)
    parser.add_argument("-o", "--output", type=Path, required=True)
    options = parser.parse_args()
    SHEETS[options.sheet]().save(options.output)


if __name__ == "__main__":
    main()
