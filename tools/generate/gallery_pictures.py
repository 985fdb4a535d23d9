"""Makes the pictures of the editor's gallery: its fabrics, or those that are named, on the draped cloth.

python -m tools.generate.gallery_pictures [NAME ...]
"""

from __future__ import annotations

import sys

import numpy as np
from PIL import Image

from loomlight.core.colour import linear_to_srgb
from loomlight.mitsuba.pictures import render
from loomlight.viewer.session import gallery_files, gallery_pictures

SIDE, ZOOM, SAMPLES, QUALITY = 320, 2.5, 24, 80


def main() -> None:
    """Renders and writes a picture beside each fabric of the gallery."""
    files = gallery_files()
    for name, file in ((name, files[name]) for name in sys.argv[1:] or files):
        picture = render(file, "drape", spp=SAMPLES, zoom=ZOOM, size=(SIDE, SIDE), inset=False)
        pixels = np.rint(linear_to_srgb(picture[..., :3]) * 255).astype(np.uint8)
        Image.fromarray(pixels).save(gallery_pictures() / f"{name}.webp", quality=QUALITY)


if __name__ == "__main__":
    main()
