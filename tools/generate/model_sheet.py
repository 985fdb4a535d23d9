"""Makes the sheet of models: four unlike fabrics on the drape, by each model beside the reference.

python -m tools.generate.model_sheet OUTPUT
"""

from __future__ import annotations

import gc
import sys
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from loomlight.core.errors import InputError
from loomlight.core.images import encoded, write_pixels
from loomlight.fabric import Fabric, load_fabric
from loomlight.mitsuba import choose_variant, render
from loomlight.mitsuba.measured_scenes import measured_scene

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
FABRICS = ("denim.toml", "silk-satin.toml", "damask.toml", "undulating-twill.wif")
SCENE = "drape near"
# Samples a pixel: enough that what differs is the model.
COLUMNS = {"point": 512, "samples": 64, "lobes": 64, "clustered": 64, "neural": 64}
SIZE, MARGIN, EXPOSURE = (288, 216), 26, 1.5


def shown(fabric: Fabric, model: str, samples: int) -> NDArray[np.uint8] | str:
    """The picture, 8-bit sRGB [height, width, 3]; the sentence of a model that does not take the fabric."""
    gc.collect()  # BSDFs that live on would be in this scene's kernel
    try:
        scene = measured_scene(SCENE, [fabric], model, SIZE)
    except InputError as refusal:
        return str(refusal)
    return encoded(EXPOSURE * render(scene.scene, spp=samples, integrator=scene.integrator))


def sheet() -> Image.Image:
    """Rows of fabrics, columns of models, with names; a sentence where a model takes no such fabric."""
    width, height = SIZE
    whole = Image.new("RGB", (len(COLUMNS) * width, MARGIN + len(FABRICS) * (height + MARGIN)), "white")
    draw, font = ImageDraw.Draw(whole), ImageFont.load_default(size=16)
    for column, (model, samples) in enumerate(COLUMNS.items()):
        title = f"{model}, {samples} samples" + (" (reference)" if model == "point" else "")
        draw.text((column * width + 6, 3), title, "black", font)
    for row, name in enumerate(FABRICS):
        fabric, top = load_fabric(EXAMPLES / name), MARGIN + row * (height + MARGIN)
        for column, (model, samples) in enumerate(COLUMNS.items()):
            found = shown(fabric, model, samples)
            if isinstance(found, str):
                # The font has no sign of multiplication.
                text = "\n".join(_wrapped(found.replace("×", "x"), draw, font, width - 24))
                draw.text((column * width + 12, top + 12), text, "#555555", font)
            else:
                whole.paste(Image.fromarray(found), (column * width, top))
        draw.text((6, top + height + 2), Path(name).stem, "black", font)
    return whole


def _wrapped(text: str, draw: ImageDraw.ImageDraw, font: Any, width: int) -> list[str]:
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if draw.textlength(longer, font) > width:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


if __name__ == "__main__":
    choose_variant()
    write_pixels(sys.argv[1], np.asarray(sheet()))
