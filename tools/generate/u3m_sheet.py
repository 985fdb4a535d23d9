"""A sheet of denim above its U3M, as read back, for docs/u3m.md: draped, close, and from behind.

python -m tools.generate.u3m_sheet -o FILE
"""

from __future__ import annotations

import tempfile
from argparse import ArgumentParser
from pathlib import Path
from typing import Any

from PIL import Image, ImageDraw, ImageFont

from loomlight.core.images import encoded
from loomlight.exporters import export
from loomlight.mitsuba.pictures import render

FABRIC = "examples/denim.toml"
# Views by what is written below them.
VIEWS: dict[str, dict[str, Any]] = {
    "draped": {"scene": "drape", "inset": False},
    "close": {"scene": "flat", "distance": 0.05},
    "close, from behind": {"scene": "flat", "distance": 0.05, "view": "back"},
}
_SIZE, _GAP, _LINE = (300, 225), 6, 20


def main() -> None:
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, required=True)
    output: Path = parser.parse_args().output
    width, height = _SIZE[0] + _GAP, _SIZE[1] + _LINE + _GAP
    sheet = Image.new("RGB", (len(VIEWS) * width - _GAP, 2 * height - _GAP), "white")
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(13)
    with tempfile.TemporaryDirectory() as folder:
        material = export(FABRIC, "u3ma", Path(folder) / "denim.u3ma", dpi=450)
        sides: dict[str, str | Path] = {"lobes": FABRIC, "U3M": material}
        for column, (label, view) in enumerate(VIEWS.items()):
            for row, (noun, shown) in enumerate(sides.items()):
                picture = render(shown, size=_SIZE, spp=32, **view)
                left, top = column * width, row * height
                sheet.paste(Image.fromarray(encoded(picture)), (left, top))
                draw.text((left + 4, top + _SIZE[1] + 2), f"{noun}, {label}", "#333333", font)
    sheet.save(output)


if __name__ == "__main__":
    main()
