"""`loomlight demo`: one picture of what loomlight does, cloth across the room and under the lens."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from loomlight.cli.outputs import check_output, done
from loomlight.cli.progress import progress

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

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
MARGIN = 22  # pixels
EXPOSURE = 0.4  # stops


def demo(
    output: Annotated[Path, typer.Option("--output", "-o", help="The picture to write, a .png file.")] = Path(
        "demo.png"
    ),
    samples: Annotated[int, typer.Option("--spp", min=1, max=4096, help="Samples a pixel.")] = 10,
) -> None:
    """Renders draped cloth in daylight, with a close-up in which its yarns can be counted."""
    check_output(output, (".png",))

    from loomlight.core.images import write_image
    from loomlight.fabric.load import fabric_from_text
    from loomlight.mitsuba import build_scene, choose_variant, material_bsdf, render

    choose_variant()
    # The point model shows how the dye varies.
    cloth = fabric_from_text(FABRIC)
    near = 2 * samples
    work = samples * SIZE[0] * SIZE[1], near * INSET * INSET
    with progress(f"{cloth.name}, draped") as report:
        far = build_scene("drape", material_bsdf(cloth, "point"), size=SIZE, light="sunsky")
        whole = render(
            far.scene,
            spp=samples,
            exposure=EXPOSURE,
            denoise="auto",
            progress=lambda done, total: report(work[0] * done // total, sum(work)),
        )
        close = build_scene(
            "drape", material_bsdf(cloth, "point"), size=(INSET, INSET), zoom=ZOOM, light="sunsky"
        )
        inset = render(
            close.scene,
            spp=near,
            exposure=EXPOSURE,
            denoise="auto",
            progress=lambda done, total: report(work[0] + work[1] * done // total, sum(work)),
        )
    write_image(output, compose(whole, inset))
    done(output)


def compose(whole: NDArray[np.float32], inset: NDArray[np.float32]) -> NDArray[np.float32]:
    """`whole` in a thin frame, with `inset` and a mark of what that shows; linear RGB [h, w, 3]."""
    from loomlight.mitsuba.inset import FRAME, composed, framed

    return framed(composed(whole, inset, ZOOM * INSET / min(SIZE), MARGIN), FRAME)
