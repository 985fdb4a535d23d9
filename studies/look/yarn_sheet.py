"""Makes pictures of kinds of yarn in docs/images, rendered in the studio.

    python -m studies.look.yarn_sheet [--pixels N] [--threads N] [--spp N] [--only NAME,…] [-o FILE.jpg]
    python -m studies.look.yarn_sheet --gaps [--spp N] [-o FILE.jpg]
    python -m studies.look.yarn_sheet --fibres [--spp N] [--only NAME,…] [-o FILE.jpg]

The first makes yarns.jpg, a close-up of every kind. The second makes yarn-gaps.jpg: six kinds at 10, 30, 100
and 300 pixels a thread, on the left with a gap of 0.2, on the right with their own. The third makes
yarn-fibres.jpg: the same kinds and zooms, each beside fibres path traced in the same place and light
(`instruments/fibre_scene.py`), whose absorption shows the same colour (`ABSORPTION`).
"""

from __future__ import annotations

from argparse import ArgumentParser
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from loomlight.core.images import encoded
from loomlight.mitsuba import choose_variant, render
from studies.instruments.fibre_scene import Shown, fibre_picture
from studies.instruments.yarn_cloths import ABSORPTION, CLOTHS, OF_GAPS, cloth, flat_scene

IMAGES = Path(__file__).resolve().parents[1] / "docs" / "images"
FILE = IMAGES / "yarns.jpg"
GAPS_FILE = IMAGES / "yarn-gaps.jpg"
FIBRES_FILE = IMAGES / "yarn-fibres.jpg"
PIXELS_A_THREAD = (10, 30, 100, 300)
# Pixels of a square of the sheet of gaps.
SIDE = 160
COLUMNS = 4
SAMPLES = 48
# Of the sheet of fibres: pixels of a square, between pairs of them, of a far thread; samples; tries.
FIBRE_SIDE, RULE, FAR_PIXELS, FIBRE_SAMPLES, ATTEMPTS = 128, 4, 30, 16, 3
# The light comes from the side, so that relief shows.
EXPOSURE = 1.6


def close_up(
    name: str, pixels: int, threads: float, spp: int, more: str = "", denoise: str = "off"
) -> NDArray[np.uint8]:
    """A square of cloth of `threads` threads, `pixels` pixels a thread, 8-bit sRGB; `more` are fields."""
    shown = flat_scene(cloth(name, more), round(pixels * threads), threads)
    return encoded(EXPOSURE * render(shown.scene, spp=spp, integrator=shown.integrator, denoise=denoise))


def fibre_close_up(name: str, pixels: int, threads: float, spp: int) -> NDArray[np.uint8]:
    """The same square of fibres, 8-bit sRGB; far away fewer and thicker ones."""
    fabric = cloth(name)
    scene = flat_scene(fabric, round(pixels * threads), threads)
    across, points = (20, 8) if pixels < FAR_PIXELS else (30, 16)
    shown = Shown(threads, across, points, ABSORPTION[name])
    return encoded(EXPOSURE * fibre_picture(fabric, scene, shown, spp))


def labelled(picture: NDArray[np.uint8], name: str, size: int = 18) -> Image.Image:
    """The picture with a name in letters of `size` pixels in its lower left corner."""
    image = Image.fromarray(picture)
    draw = ImageDraw.Draw(image, "RGBA")
    font = ImageFont.load_default(size=size)
    place = size // 2 + 1, image.height - 16 * size // 9
    left, top, right, bottom = draw.textbbox(place, name, font=font)
    draw.rectangle((left - size // 3, top - 5, right + size // 3, bottom + 5), fill=(0, 0, 0, 150))
    draw.text(place, name, font=font, fill=(255, 255, 255, 255))
    return image


def gaps_sheet(spp: int) -> Image.Image:
    """Rows of kinds, with a gap of 0.2 and with their own, at 10 to 300 pixels a thread."""
    rows = []
    for name in OF_GAPS:
        tiles = [
            # What is seen through holes is lit through holes: noise, with so few samples.
            close_up(name, pixels, SIDE / pixels, spp, more, "auto")
            for more in ("gap = 0.2", "")
            for pixels in PIXELS_A_THREAD
        ]
        tiles[0] = np.asarray(labelled(tiles[0], name))
        rows.append(np.concatenate(tiles, axis=1))
    return Image.fromarray(np.concatenate(rows))


def fibres_sheet(names: Sequence[str], spp: int) -> Image.Image:
    """Rows of kinds at 10 to 300 pixels a thread, each square beside that of fibres."""
    rows = []
    for name in names:
        for attempt in range(ATTEMPTS):
            # Mitsuba crashes in some pictures of curves on CPUs: each row has a process of its own.
            with ProcessPoolExecutor(1, get_context("spawn")) as pool:
                try:
                    rows.append(pool.submit(fibres_row, name, spp).result())
                    break
                except BrokenProcessPool:
                    if attempt + 1 == ATTEMPTS:
                        raise
    return Image.fromarray(np.concatenate(rows))


def fibres_row(name: str, spp: int) -> NDArray[np.uint8]:
    """The row of a kind, 8-bit sRGB."""
    choose_variant(None)
    tiles = []
    for pixels in PIXELS_A_THREAD:
        threads = FIBRE_SIDE / pixels
        pair = close_up(name, pixels, threads, SAMPLES), fibre_close_up(name, pixels, threads, spp)
        tiles += [*pair, np.full((FIBRE_SIDE, RULE, 3), 255, np.uint8)]
    tiles[0] = np.asarray(labelled(tiles[0], name, 11))
    return np.concatenate(tiles[:-1], axis=1)


def main() -> None:
    """Renders the pictures and writes the sheet."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--pixels", type=int, default=300, help="of a thread")
    parser.add_argument("--threads", type=float, default=1.6, help="across a close-up")
    parser.add_argument("--spp", type=int, help=f"{SAMPLES}, or {FIBRE_SAMPLES} of fibres")
    parser.add_argument("--only", help="names, separated by commas")
    parser.add_argument("--output", "-o", type=Path)
    parser.add_argument("--gaps", action="store_true", help="make yarn-gaps.jpg instead")
    parser.add_argument("--fibres", action="store_true", help="make yarn-fibres.jpg instead")
    options = parser.parse_args()
    choose_variant(None)
    if options.gaps:
        gaps_sheet(options.spp or SAMPLES).save(options.output or GAPS_FILE, quality=84)
        return
    if options.fibres:
        names = options.only.split(",") if options.only else OF_GAPS
        fibres_sheet(names, options.spp or FIBRE_SAMPLES).save(options.output or FIBRES_FILE, quality=84)
        return
    names = options.only.split(",") if options.only else list(CLOTHS)
    spp = options.spp or SAMPLES
    tiles = [labelled(close_up(name, options.pixels, options.threads, spp), name) for name in names]
    side, columns = tiles[0].width, min(COLUMNS, len(tiles))
    sheet = Image.new("RGB", (columns * side, -(-len(tiles) // columns) * side))
    for number, tile in enumerate(tiles):
        sheet.paste(tile, (number % columns * side, number // columns * side))
    sheet.save(options.output or FILE, quality=82)


if __name__ == "__main__":
    main()
