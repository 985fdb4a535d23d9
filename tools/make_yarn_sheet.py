"""Makes docs/images/yarns.jpg: every kind of yarn in plain weave at 300 pixels a thread.

python -m tools.make_yarn_sheet
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from loomlight.core.colour import linear_to_srgb
from loomlight.fabric import fabric_from_text
from loomlight.fabric.file import YARNS
from loomlight.mitsuba import render_fabric

FILE = Path(__file__).resolve().parents[1] / "docs" / "images" / "yarns.jpg"
COLOURS = {
    "cotton": "#7d94b5",
    "mercerised cotton": "#b0435a",
    "linen": "#c9b894",
    "wool": "#5f6b52",
    "silk": "#b9975b",
    "filament polyester": "#3f7f86",
    "viscose": "#8b6aa6",
}
SIDE, CAPTION, COLUMNS = 420, 34, 4
# The flat scene shows 100 mm, and a thread is half a millimetre wide.
ZOOM = 100 / (0.5 * SIDE / 300)


def main() -> None:
    """Renders the pictures and writes the sheet."""
    rows = -(-len(YARNS) // COLUMNS)
    sheet = Image.new("RGB", (COLUMNS * SIDE, rows * (SIDE + CAPTION)), "#fbf8f1")
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(20)
    for number, yarn in enumerate(YARNS):
        colour = COLOURS[yarn]
        fabric = fabric_from_text(
            f'weave = "plain"\nyarn = "{yarn}"\n[warp]\ncolor = "{colour}"\n[weft]\ncolor = "{colour}"\n'
        )
        picture = render_fabric(fabric, "flat", spp=24, zoom=ZOOM, size=(SIDE, SIDE), inset=False)
        pixels = np.rint(linear_to_srgb(picture[..., :3]) * 255).astype(np.uint8)
        left, top = number % COLUMNS * SIDE, number // COLUMNS * (SIDE + CAPTION)
        sheet.paste(Image.fromarray(pixels), (left, top))
        draw.text((left + 10, top + SIDE + 5), yarn, "#26221b", font)
    sheet.save(FILE, quality=82)


if __name__ == "__main__":
    main()
