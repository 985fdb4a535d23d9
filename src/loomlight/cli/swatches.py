"""`loomlight swatches`: a labelled contact sheet of fabrics."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.fleet import ExecutorName, SlurmSettings, Workers, executor_of
from loomlight.cli.interruption import note_left
from loomlight.cli.options import FabricsArgument, Given, takes
from loomlight.cli.progress import done, progress
from loomlight.picture_settings import SwatchSettings

EXAMPLE = "Example: loomlight swatches examples/*.toml -o sheet.png"


@takes(SwatchSettings)
def swatches(
    fabrics: FabricsArgument,
    output: Annotated[
        Path,
        typer.Option("--output", "-o", help="The sheet: a .png or .jpg picture, or an .html page."),
    ],
    given: Given,
    workers: Workers = 1,
    executor: ExecutorName = "local",
    slurm: SlurmSettings = None,
) -> None:
    """Renders a labelled contact sheet: of each fabric its drawdown, a swatch, a drape and facts.

    The sheet grows as fabrics are rendered. A file that cannot be used is left out with a warning.
    """
    settings, chosen = SwatchSettings(**given), executor_of(executor, workers, slurm)
    from loomlight.mitsuba.swatches import swatches, work_folder_of

    note_left(
        f"{work_folder_of(output)} keeps the fabrics that are rendered: the same command goes on from there."
    )
    with progress("swatches") as report:
        done(swatches(fabrics, output, settings, executor=chosen, report=report))
