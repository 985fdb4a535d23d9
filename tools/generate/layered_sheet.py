"""A sheet of layered cloths for docs/layers.md, front above back.

python -m tools.generate.layered_sheet -o FILE
"""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from loomlight.core.images import encoded
from loomlight.mitsuba.pictures import render

DRAFTS = ("pattern-double-weave", "pocket", "extra-weft-figure", "stitched-double-cloth", "matelasse")
_SIZE, _GAP, _LINE = (300, 225), 6, 20


def main() -> None:
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, required=True)
    output: Path = parser.parse_args().output
    width, height = _SIZE[0] + _GAP, _SIZE[1] + _LINE + _GAP
    sheet = Image.new("RGB", (len(DRAFTS) * width - _GAP, 2 * height - _GAP), "white")
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(13)
    for number, draft in enumerate(DRAFTS):
        for row, view in enumerate(("front", "back")):
            picture = render(
                f"examples/layered/{draft}.wif",
                "flat",
                model="point",
                view=view,
                distance=0.04,
                size=_SIZE,
                spp=48,
                inset=False,
            )
            left, top = number * width, row * height
            sheet.paste(Image.fromarray(encoded(picture)), (left, top))
            draw.text((left + 4, top + _SIZE[1] + 2), f"{draft}, {view}", "#333333", font)
    sheet.save(output)


if __name__ == "__main__":
    main()
