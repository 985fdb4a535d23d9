"""A sheet of views for docs/cameras.md, each with the options that choose it.

python -m tools.generate.view_sheet -o FILE
"""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from loomlight.core.camera_settings import CameraKeywords
from loomlight.core.images import encoded
from loomlight.mitsuba.pictures import render

FABRIC = "examples/denim.toml"
_SIZE, _COLUMNS, _GAP, _LINE = (300, 225), 4, 6, 20
# Scenes, and the options by which each is seen.
VIEWS: tuple[tuple[str, CameraKeywords], ...] = (
    ("drape", {"view": "front"}),
    ("drape", {"view": "back-three-quarter"}),
    ("drape", {"view": "top"}),
    ("drape", {"target": (0.06, 0.14, 0.1), "distance": 0.3}),
    ("drape", {"view": "20,10", "focal_length": 15.0}),
    ("drape", {"view": "20,10", "focal_length": 200.0}),
    ("flat", {"view": "60,20"}),
    ("flat", {"view": "back"}),
)


def main() -> None:
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, required=True)
    output: Path = parser.parse_args().output
    width, height = _SIZE[0] + _GAP, _SIZE[1] + _LINE + _GAP
    rows = -(-len(VIEWS) // _COLUMNS)
    sheet = Image.new("RGB", (_COLUMNS * width - _GAP, rows * height - _GAP), "white")
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(13)
    for number, (scene, options) in enumerate(VIEWS):
        picture = Image.fromarray(encoded(render(FABRIC, scene, size=_SIZE, spp=32, inset=False, **options)))
        left, top = number % _COLUMNS * width, number // _COLUMNS * height
        sheet.paste(picture, (left, top))
        draw.text((left + 4, top + _SIZE[1] + 2), _written(scene, options), "#333333", font)
    sheet.save(output)


def _written(scene: str, options: CameraKeywords) -> str:
    """As the command line has them."""
    words = [] if scene == "drape" else [f"--scene {scene}"]
    for name, value in options.items():
        numbers = value if isinstance(value, tuple) else (value,)
        text = ",".join(f"{each:g}" if isinstance(each, float) else str(each) for each in numbers)
        words.append(f"--{name.replace('_', '-')} {text}")
    return " ".join(words)


if __name__ == "__main__":
    main()
