"""A sheet of the artworks of examples for docs/artwork.md: draped, close, from behind and against the light.

python -m tools.generate.artwork_sheet -o FILE
"""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path
from typing import Any

from PIL import Image, ImageDraw, ImageFont

from loomlight import load_fabric, make_model, render
from loomlight.core.images import encoded
from loomlight.core.picture_settings import Placement

# Each with where its weave lies on flat cloth, millimetres: a flower, and the rim of a sun, in the middle.
ARTWORKS = {"peonies": (-250.0, -175.0), "waves": (-5.0, -175.0)}
# Each with its scene and settings.
VIEWS: dict[str, tuple[str, dict[str, Any]]] = {
    "draped": ("drape", {"inset": False}),
    "close": ("flat", {"zoom": 4.0}),
    "from behind": ("flat", {"zoom": 4.0, "view": "back"}),
    "against the light": ("flat", {"zoom": 1.3, "light_from": (170.0, 30.0), "exposure": 1.5}),
}
_SIZE, _GAP, _LINE = (320, 240), 6, 20


def main() -> None:
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, required=True)
    output: Path = parser.parse_args().output
    width, height = _SIZE[0] + _GAP, _SIZE[1] + _LINE + _GAP
    sheet = Image.new("RGB", (len(VIEWS) * width - _GAP, len(ARTWORKS) * height - _GAP), "white")
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(13)
    for row, (artwork, shift) in enumerate(ARTWORKS.items()):
        model = make_model("lobes", load_fabric(f"examples/artwork/{artwork}.toml"))
        for column, (title, (scene, settings)) in enumerate(VIEWS.items()):
            placement = Placement(shift=shift) if scene == "flat" else Placement()
            picture = render(model, scene, size=_SIZE, spp=16, placement=placement, **settings)
            left, top = column * width, row * height
            sheet.paste(Image.fromarray(encoded(picture)), (left, top))
            draw.text((left + 4, top + _SIZE[1] + 2), f"{artwork}, {title}", "#333333", font)
    sheet.save(output)


if __name__ == "__main__":
    main()
