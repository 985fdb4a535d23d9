"""`loomlight demo`: one picture of what loomlight does, cloth across the room and under the lens."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from numpy.typing import NDArray

from loomlight.cli.outputs import check_output, done
from loomlight.cli.progress import progress

EXAMPLE = "Example: loomlight demo -o demo.png"

FABRIC = """
name = "Houndstooth"
weave = "houndstooth"
ends_per_cm = 14
picks_per_cm = 14
gap = 0.06
[warp]
color = ["#23262e", "#ece4d3"]
specular = 0.2
roughness = 0.5
[weft]
color = ["#23262e", "#ece4d3"]
specular = 0.2
roughness = 0.5
[sheen]
strength = 0.2
[variation]
colour_noise = 0.1
"""
SIZE = (1080, 810)
INSET = 290
ZOOM = 30.0
# Widths in pixels.
MARGIN = 22
FRAME = 2
MARK = 1
_PAPER = 1.0
EXPOSURE = 0.4  # stops


def demo(
    output: Annotated[Path, typer.Option("--output", "-o", help="The picture to write, a .png file.")] = Path(
        "demo.png"
    ),
    samples: Annotated[int, typer.Option("--spp", min=1, max=4096, help="Samples a pixel.")] = 20,
) -> None:
    """Renders draped cloth in daylight, with a close-up in which its yarns can be counted."""
    check_output(output, (".png",))

    from loomlight.core.images import write_image
    from loomlight.fabric.load import fabric_from_text
    from loomlight.mitsuba import build_scene, choose_variant, material_bsdf, render

    choose_variant()
    # The point model: at so many samples a pixel it is faster, and it shows how the dye varies.
    cloth = fabric_from_text(FABRIC)
    near = 2 * samples
    work = samples * SIZE[0] * SIZE[1], near * INSET * INSET
    with progress(f"{cloth.name}, draped") as report:
        far = build_scene("drape", material_bsdf(cloth, "point"), size=SIZE)
        whole = render(
            far.scene,
            spp=samples,
            exposure=EXPOSURE,
            progress=lambda done, total: report(work[0] * done // total, sum(work)),
        )
        close = build_scene("drape", material_bsdf(cloth, "point"), size=(INSET, INSET), zoom=ZOOM)
        inset = render(
            close.scene,
            spp=near,
            exposure=EXPOSURE,
            progress=lambda done, total: report(work[0] + work[1] * done // total, sum(work)),
        )
    write_image(output, compose(whole, inset))
    done(output)


def compose(whole: NDArray[np.float32], inset: NDArray[np.float32]) -> NDArray[np.float32]:
    """`whole` in a thin frame, `inset` in another in its upper left corner; linear RGB [h, w, 3].

    A small square in the middle of `whole` marks what the inset shows.
    """
    picture = whole[..., :3].copy()
    height, width = picture.shape[:2]
    side = round(min(height, width) / ZOOM)
    top, left = (height - side) // 2, (width - side) // 2
    middle = picture[top : top + side, left : left + side]
    marked = _framed(middle, MARK)
    picture[top - MARK : top + side + MARK, left - MARK : left + side + MARK] = marked
    framed = _framed(inset[..., :3], FRAME)
    picture[MARGIN : MARGIN + framed.shape[0], MARGIN : MARGIN + framed.shape[1]] = framed
    return _framed(picture, FRAME)


def _framed(picture: NDArray[np.float32], line: int) -> NDArray[np.float32]:
    return np.pad(picture, ((line, line), (line, line), (0, 0)), constant_values=_PAPER)
