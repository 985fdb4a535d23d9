"""Eight fabrics from 2 m to 2 cm: a sheet to be looked at beside what such cloth looks like from there.

    python -m studies.look.distances [-o FILE.jpg] [--only NAME,…] [--tiles FOLDER] [--side N] [--spp N]

A row a fabric, a column a distance: the drape of the built-in scene in its default light, in the model of
`render`, seen by a 50 mm lens that comes closer along its own axis; at 2 m, where that shows floor, by twice
the focal length. `--tiles` keeps every tile in a folder, from which the sheet takes those that are not
rendered: `--only linen --tiles FOLDER` renders one row anew. A fabric that a version has not is stood for
by the next of its names.
"""

from __future__ import annotations

import tempfile
from argparse import ArgumentParser
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
from PIL import Image, ImageDraw, ImageFont

from loomlight.core.images import encoded
from loomlight.fabric.read import load_fabric
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf, render
from loomlight.models.registry import make_model

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
FABRICS = (
    ("selvedge-denim", "denim"),
    ("linen",),
    ("harris-tweed", "tweed"),
    ("silk-dupion", "damask"),
    ("poplin-stripe",),
    ("flannel-melange", "wool-houndstooth"),
    ("silk-satin",),
    ("organza",),
)
# From the camera to the cloth in the middle of the picture, metres, and the field of view, degrees.
DISTANCES = {"2 m": (2.0, 13.0), "50 cm": (0.5, 26.0), "10 cm": (0.1, 26.0), "2 cm": (0.02, 26.0)}
SIDE, SAMPLES = 280, 24
_BETWEEN, _ABOVE = 4, 22
_QUALITY = 84


def names() -> list[str]:
    """The fabrics that this version has, a name a row."""
    return [next(name for name in row if (EXAMPLES / f"{name}.toml").exists()) for row in FABRICS]


def render_row(name: str, folder: Path, side: int, spp: int) -> None:
    """Writes the tiles of a fabric, a PNG a distance."""
    fabric = load_fabric(EXAMPLES / f"{name}.toml")
    bsdf = material_bsdf(make_model("lobes", fabric))
    shown = build_scene("drape", bsdf, size=(side, side), edge=None)
    away = float(np.linalg.norm(shown.view.origin - shown.point))
    for label, (distance, field_of_view) in DISTANCES.items():
        lens: Any = mi.traverse(shown.scene.sensors()[0])
        lens["x_fov"] = field_of_view
        lens.update()
        shown.look_from(shown.view.closer(away / distance, shown.point))
        linear = render(shown.scene, spp=spp, integrator=shown.integrator, denoise="auto")
        Image.fromarray(encoded(linear)).save(folder / f"{name} {label}.png")


def sheet(folder: Path, rows: list[str]) -> Image.Image:
    """The tiles of all rows, labelled; a tile that is missing is left white."""
    tiles = [[folder / f"{name} {label}.png" for label in DISTANCES] for name in rows]
    side = next(Image.open(tile).width for row in tiles for tile in row if tile.exists())
    step = side + _BETWEEN
    whole = Image.new("RGB", (step * len(DISTANCES) - _BETWEEN, (step + _ABOVE) * len(rows)), "white")
    draw, font = ImageDraw.Draw(whole), ImageFont.load_default(size=14)
    for row, name in enumerate(rows):
        top = row * (step + _ABOVE)
        for column, label in enumerate(DISTANCES):
            place = (column * step, top + _ABOVE)
            draw.text((place[0] + 4, top + 3), f"{name}, {label}", font=font, fill="black")
            if tiles[row][column].exists():
                whole.paste(Image.open(tiles[row][column]), place)
    return whole


def main() -> None:
    """Renders the tiles and writes the sheet."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--output", "-o", type=Path, default=Path("distances.jpg"))
    parser.add_argument("--only", help="fabrics to render, separated by commas")
    parser.add_argument("--tiles", type=Path, help="folder that keeps the tiles")
    parser.add_argument("--side", type=int, default=SIDE, help="of a tile, pixels")
    parser.add_argument("--spp", type=int, default=SAMPLES, help="samples a pixel")
    options = parser.parse_args()
    choose_variant(None)
    rows = names()
    chosen = options.only.split(",") if options.only else rows
    if unknown := [name for name in chosen if name not in rows]:
        parser.error(f"--only {unknown[0]}: choose from {', '.join(rows)}")
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.tiles or Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for name in chosen:
            render_row(name, folder, options.side, options.spp)
            print(name, flush=True)
        sheet(folder, rows if options.tiles else chosen).save(options.output, quality=_QUALITY, optimize=True)


if __name__ == "__main__":
    main()
