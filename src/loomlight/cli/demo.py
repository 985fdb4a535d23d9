"""`loomlight demo`: one picture of what loomlight does, cloth across the room and under the lens."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.progress import done, progress
from loomlight.core.files import WRITTEN_SUFFIXES
from loomlight.core.outputs import check_output

EXAMPLE = "Example: loomlight demo -o demo.png"

SIZE = (1080, 810)
EXPOSURE = 0.4  # stops


def demo(
    output: Annotated[Path, typer.Option("--output", "-o", help="The picture: .png, .jpg or .exr.")] = Path(
        "demo.png"
    ),
    samples: Annotated[int, typer.Option("--spp", min=1, max=4096, help="Samples a pixel.")] = 10,
) -> None:
    """Renders draped cloth in daylight, with a close-up in which its yarns can be counted."""
    check_output(output, WRITTEN_SUFFIXES)

    from loomlight.core.images import write_image
    from loomlight.fabric.read import load_fabric
    from loomlight.mitsuba.material_picture import render

    cloth = load_fabric(Path(__file__).with_name("demo.toml"))
    with progress(f"{cloth.name}, draped", milliseconds=True) as report:
        # The point model shows how the dye varies.
        picture = render(
            cloth,
            model="point",
            light="sunsky",
            size=SIZE,
            spp=samples,
            exposure=EXPOSURE,
            inset=True,
            progress=report,
        )
    write_image(output, picture)
    done(output)
