"""Makes docs/images/edges.jpg: cloth without edges above, with a hem and with pinked edges below.

    python -m tools.generate.edge_pictures [--side N] [--spp N] [-o FILE]

On the left the rim of the default drape at 20 times, in the middle its front corner at 12 times, on the right
25 mm of flat cloth.
"""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.images import encoded
from loomlight.fabric.read import load_fabric
from loomlight.mitsuba import Placement, build_scene, choose_variant, material_bsdf, render, shapes
from loomlight.mitsuba.camera import View
from loomlight.mitsuba.scenes import BsdfFactory
from loomlight.models.registry import make_model

ROOT = Path(__file__).resolve().parents[2]
FILE = ROOT / "docs" / "images" / "edges.jpg"
FABRIC = ROOT / "examples" / "denim.toml"
# Vertices a side of the drape, and of them the row and column looked at, and how closely.
GRID = 200
SHOTS = (((0, 100), 20.0), ((0, 199), 12.0))


def rim(edge: str, corner: tuple[int, int], zoom: float, side: int, spp: int) -> NDArray[np.uint8]:
    """A square picture of a place of the drape's rim, 8-bit sRGB."""
    shown = build_scene("drape", _cloth(), size=(side, side), edge=edge)
    place = shapes.drape().positions.reshape(GRID, GRID, 3)[corner]
    near = shown.view.closer(zoom, place)
    shift = place - near.target
    shown.look_from(View(near.origin + shift, near.target + shift))
    return encoded(render(shown.scene, spp=spp, integrator=shown.integrator, denoise="auto"))


def swatch(edge: str, side: int, spp: int) -> NDArray[np.uint8]:
    """A square picture of a flat piece, 8-bit sRGB."""
    scale = Placement(scale=4.0)
    shown = build_scene("flat", _cloth(), size=(side, side), edge=edge, placement=scale)
    return encoded(render(shown.scene, spp=spp, integrator=shown.integrator, denoise="auto"))


def _cloth() -> BsdfFactory:
    return material_bsdf(make_model("lobes", load_fabric(FABRIC)))


def main() -> None:
    """Renders the pictures and writes the sheet."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--side", type=int, default=320, help="of each picture, pixels")
    parser.add_argument("--spp", type=int, default=16)
    parser.add_argument("--output", "-o", type=Path, default=FILE)
    options = parser.parse_args()
    choose_variant(None)
    side, spp = options.side, options.spp
    rows = []
    for hem, flat in (("raw", "raw"), ("hem", "pinked")):
        tiles = [rim(hem, corner, zoom, side, spp) for corner, zoom in SHOTS]
        rows.append(np.concatenate([*tiles, swatch(flat, side, spp)], axis=1))
    Image.fromarray(np.concatenate(rows)).save(options.output, quality=78)


if __name__ == "__main__":
    main()
