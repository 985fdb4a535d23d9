"""Makes pictures of kinds of yarn in docs/images, rendered in the studio.

    python -m tools.make_yarn_sheet [--pixels N] [--threads N] [--spp N] [--only NAME,…] [-o FILE.jpg]
    python -m tools.make_yarn_sheet --gaps

The first makes yarns.jpg, a close-up of every kind. The second makes yarn-gaps.jpg: six kinds at 10, 30, 100
and 300 pixels a thread, on the left with a gap of 0.2, on the right with their own.
Cloths differ as the yarns' usual ones do, in weave and colour; all else is by `yarn = "…"`.
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

IMAGES = Path(__file__).resolve().parents[1] / "docs" / "images"
FILE = IMAGES / "yarns.jpg"
GAPS_FILE = IMAGES / "yarn-gaps.jpg"
OF_GAPS = ("cotton", "linen", "wool", "silk", "filament polyester", "viscose")
PIXELS_A_THREAD = (10, 30, 100, 300)
# Pixels of a square of the sheet of gaps.
SIDE = 160
COLUMNS = 4
# The light comes from the side, so that relief shows.
EXPOSURE = 1.6
CLOTHS = {
    "smooth": ("plain", "#b9ab92", "#b9ab92"),
    "cotton": ("plain", "#ddd6c6", "#ddd6c6"),
    "mercerised cotton": ("plain", "#2c5f94", "#2c5f94"),
    "linen": ("plain", "#c9ba98", "#bfae8a"),
    "wool": ("twill 2/2", "#70757d", "#a06a41"),
    "silk": ("satin 5/2", "#93263a", "#93263a"),
    "filament polyester": ("plain", "#44627f", "#44627f"),
    "viscose": ("twill 2/1", "#4d6f4b", "#4d6f4b"),
}


def close_up(name: str, pixels: int, threads: float, spp: int, more: str = "") -> NDArray[np.uint8]:
    """A square of cloth of `threads` threads, `pixels` pixels a thread, 8-bit sRGB; `more` are fields."""
    weave, warp, weft = CLOTHS[name]
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


def gaps_sheet(spp: int) -> Image.Image:
    """Rows of kinds, with a gap of 0.2 and with their own, at 10 to 300 pixels a thread."""
    rows = []
    for name in OF_GAPS:
        tiles = [
            close_up(name, pixels, SIDE / pixels, spp, more)
            for more in ("gap = 0.2", "")
            for pixels in PIXELS_A_THREAD
        ]
        tiles[0] = np.asarray(labelled(tiles[0], name))
        rows.append(np.concatenate(tiles, axis=1))
    return Image.fromarray(np.concatenate(rows))


def main() -> None:
    """Renders the pictures and writes the sheet."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--pixels", type=int, default=300, help="of a thread")
    parser.add_argument("--threads", type=float, default=1.6, help="across a close-up")
    parser.add_argument("--spp", type=int, default=48)
    parser.add_argument("--only", help="names, separated by commas")
    parser.add_argument("--output", "-o", type=Path, default=FILE)
    parser.add_argument("--gaps", action="store_true", help="make yarn-gaps.jpg instead")
    options = parser.parse_args()
    choose_variant(None)
    if options.gaps:
        gaps_sheet(options.spp).save(GAPS_FILE, quality=84)
        return
    names = options.only.split(",") if options.only else list(CLOTHS)
    tiles = [labelled(close_up(name, options.pixels, options.threads, options.spp), name) for name in names]
    side, columns = tiles[0].width, min(COLUMNS, len(tiles))
    sheet = Image.new("RGB", (columns * side, -(-len(tiles) // columns) * side))
    for number, tile in enumerate(tiles):
        sheet.paste(tile, (number % columns * side, number // columns * side))
    sheet.save(options.output, quality=82)


if __name__ == "__main__":
    main()
