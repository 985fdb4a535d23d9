"""The daybed of docs/engines.md: by `loomlight render`, and as glTF and USD in three.js.

python -m tools.generate.export_sheet -o FILE
"""

from __future__ import annotations

import tempfile
from argparse import ArgumentParser
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import loomlight
from loomlight.core.images import encoded
from loomlight.core.picture_settings import GarmentKeywords
from loomlight.mitsuba.pictures import render
from studies.instruments.three_page import three_page

FABRIC, ROOM = "examples/harris-tweed.toml", Path("examples/room.exr")
WORN: GarmentKeywords = {
    "mesh": "examples/daybed.usdc",
    "cloths": {
        "front": "examples/wool-houndstooth.toml",
        "linen": "examples/linen.toml",
        "bolster": "examples/denim.toml",
    },
}
_TARGET, _AZIMUTH, _ELEVATION, _DISTANCE, _LENS = (0.0, 0.24, 0.0), -16.0, 20.0, 2.4, 50.0
_SIDE, _GAP, _LINE, _SECONDS = 460, 6, 22, 120.0
# The shorter side of 35 mm film.
_FILM = 24.0


def main() -> None:
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, required=True)
    output: Path = parser.parse_args().output
    shown = render(
        FABRIC,
        environment=ROOM,
        edge="raw",
        size=(_SIDE, _SIDE),
        spp=32,
        view=(_AZIMUTH, _ELEVATION),
        target=_TARGET,
        distance=_DISTANCE,
        focal_length=_LENS,
        **WORN,
    )
    pictures = {"loomlight render": encoded(shown)}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        loomlight.export(FABRIC, "gltf", folder / "gltf", distance=_DISTANCE, **WORN)
        loomlight.export(FABRIC, "usdz", folder / "daybed.usdz", distance=_DISTANCE, **WORN)
        azimuth, elevation = np.radians([_AZIMUTH, _ELEVATION])
        towards = [
            np.cos(elevation) * np.sin(azimuth),
            np.sin(elevation),
            np.cos(elevation) * np.cos(azimuth),
        ]
        eye = (np.array(_TARGET) + _DISTANCE * np.array(towards)).tolist()
        degrees = float(2 * np.degrees(np.arctan(_FILM / 2 / _LENS)))
        with three_page(folder, _SECONDS, ROOM) as page:
            for label, file in (("glTF", "gltf/cloth.glb"), ("USD", "daybed.usdz")):
                _, drawn = page.draw(file, eye, _TARGET, degrees=degrees, side=_SIDE)
                pictures[f"{label} in three.js"] = drawn
    sheet = Image.new("RGB", (len(pictures) * (_SIDE + _GAP) - _GAP, _SIDE + _LINE), "white")
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(14)
    for number, (label, picture) in enumerate(pictures.items()):
        left = number * (_SIDE + _GAP)
        sheet.paste(Image.fromarray(picture), (left, 0))
        draw.text((left + 4, _SIDE + 3), label, "#333333", font)
    sheet.save(output)


if __name__ == "__main__":
    main()
