"""Makes docs/images/yarns.jpg: a close-up of every kind of yarn, rendered in the studio.

    python -m tools.make_yarn_sheet [--pixels N] [--threads N] [--spp N] [--only NAME,…] [-o FILE.jpg]

Cloths differ as the yarns' usual ones do, in weave, sett and colour; all else is by `yarn = "…"`.
"""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from loomlight.core.images import encoded
from loomlight.fabric import fabric_from_text
from loomlight.fabric.file import YARNS
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf, render
from loomlight.models.registry import make_model

FILE = Path(__file__).resolve().parents[1] / "docs" / "images" / "yarns.jpg"
COLUMNS = 4
# The light comes from the side, so that relief shows.
EXPOSURE = 1.6
CLOTHS = {
    "smooth": ("plain", "#b9ab92", "#b9ab92", "gap = 0.12"),
    "cotton": ("plain", "#ddd6c6", "#ddd6c6", "gap = 0.12"),
    "mercerised cotton": ("plain", "#2c5f94", "#2c5f94", "gap = 0.1"),
    "linen": ("plain", "#c9ba98", "#bfae8a", "gap = 0.2"),
    "wool": ("twill 2/2", "#70757d", "#a06a41", "gap = 0.06"),
    "silk": ("satin 5/2", "#93263a", "#93263a", "gap = 0.04"),
    "filament polyester": ("plain", "#44627f", "#44627f", "gap = 0.05"),
    "viscose": ("twill 2/1", "#4d6f4b", "#4d6f4b", "gap = 0.08"),
}


def close_up(name: str, pixels: int, threads: float, spp: int) -> NDArray[np.uint8]:
    """A square of cloth of `threads` threads, `pixels` pixels a thread, 8-bit sRGB."""
    weave, warp, weft, more = CLOTHS[name]
    kind = f'yarn = "{name}"\n' if name in YARNS else ""
    fabric = fabric_from_text(
        f'weave = "{weave}"\n{kind}{more}\n[warp]\ncolor = "{warp}"\n[weft]\ncolor = "{weft}"\n'
    )
    side = round(pixels * threads)
    spacing = float(fabric.layout().warp.spacing[0])
    shown = build_scene(
        "flat",
        material_bsdf(make_model("point", fabric)),
        size=(side, side),
        # The flat scene is 100 mm wide.
        zoom=100 / (spacing * threads),
    )
    return encoded(EXPOSURE * render(shown.scene, spp=spp, integrator=shown.integrator))


def labelled(picture: NDArray[np.uint8], name: str) -> Image.Image:
    """The picture with a name in its lower left corner."""
    image = Image.fromarray(picture)
    draw = ImageDraw.Draw(image, "RGBA")
    font = ImageFont.load_default(size=18)
    left, top, right, bottom = draw.textbbox((10, image.height - 32), name, font=font)
    draw.rectangle((left - 6, top - 5, right + 6, bottom + 5), fill=(0, 0, 0, 150))
    draw.text((10, image.height - 32), name, font=font, fill=(255, 255, 255, 255))
    return image


def main() -> None:
    """Renders the pictures and writes the sheet."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--pixels", type=int, default=300, help="of a thread")
    parser.add_argument("--threads", type=float, default=1.6, help="across a close-up")
    parser.add_argument("--spp", type=int, default=48)
    parser.add_argument("--only", help="names, separated by commas")
    parser.add_argument("--output", "-o", type=Path, default=FILE)
    options = parser.parse_args()
    choose_variant(None)
    names = options.only.split(",") if options.only else list(CLOTHS)
    tiles = [labelled(close_up(name, options.pixels, options.threads, options.spp), name) for name in names]
    side, columns = tiles[0].width, min(COLUMNS, len(tiles))
    sheet = Image.new("RGB", (columns * side, -(-len(tiles) // columns) * side))
    for number, tile in enumerate(tiles):
        sheet.paste(tile, (number % columns * side, number // columns * side))
    sheet.save(options.output, quality=82)


if __name__ == "__main__":
    main()
