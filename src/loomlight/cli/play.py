"""`loomlight play`: a window in which a fabric is seen in real time."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.options import FabricArgument, Given, takes
from loomlight.cli.progress import done, progress
from loomlight.core.files import WRITTEN_SUFFIXES
from loomlight.core.outputs import check_output
from loomlight.picture_settings import PlaySettings

EXAMPLE = "Example: loomlight play examples/denim.toml --scene drape"


@takes(PlaySettings)
def play(
    fabric: FabricArgument,
    given: Given,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Write a frame, .png, .jpg or .exr, off screen; open no window."),
    ] = None,
) -> None:
    """Opens a window of a fabric in real time: drag to orbit, turn the wheel from garment to yarn.

    Further keys: m the model, l the light, + and - the exposure, r back to the start; Shift or the right
    button moves.
    """
    settings = PlaySettings(**given)
    if output is not None:
        check_output(output, WRITTEN_SUFFIXES, [fabric, settings.mesh, settings.environment])
    from loomlight.window import play

    if output is None:
        play(fabric, settings)
        return
    with progress(output.name) as report:
        play(fabric, settings, output=output, report=report)
    done(output)
