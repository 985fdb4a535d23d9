"""`loomlight swatches`: a labelled contact sheet of fabrics."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.fleet import ExecutorName, SlurmSettings, Workers, executor_of
from loomlight.cli.interruption import note_left
from loomlight.cli.outputs import check_output, done
from loomlight.cli.progress import progress
from loomlight.cli.render_options import (
    DenoiseOption,
    FabricsArgument,
    SamplesOption,
    VariantOption,
    WhiteBalanceOption,
)
from loomlight.cli.values import require_within
from loomlight.core.files import PIXEL_SUFFIXES

EXAMPLE = "Example: loomlight swatches examples/*.toml -o sheet.png"


def swatches(
    fabrics: FabricsArgument,
    output: Annotated[
        Path,
        typer.Option("--output", "-o", help="The sheet: a .png or .jpg picture, or an .html page."),
    ],
    model: Annotated[str, typer.Option(help="One of the models below.")] = "lobes",
    side: Annotated[int, typer.Option("--size", metavar="PIXELS", help="Side of each picture.")] = 240,
    samples: SamplesOption = 8,
    title: Annotated[str, typer.Option(help="Heading of a page.")] = "Fabrics",
    white_balance: WhiteBalanceOption = None,
    denoise: DenoiseOption = "auto",
    variant: VariantOption = None,
    workers: Workers = 1,
    executor: ExecutorName = "local",
    slurm: SlurmSettings = None,
) -> None:
    """Renders a labelled contact sheet: of each fabric its drawdown, a swatch, a drape and facts.

    The sheet grows as fabrics are rendered. A file that cannot be used is left out with a warning.
    """
    check_output(output, (*PIXEL_SUFFIXES, ".html"), fabrics)
    require_within("--size", side, 32, 2048)
    require_within("--spp", samples, 1, 100_000)
    require_within("--white-balance", 6500 if white_balance is None else white_balance, 1667, 25000)
    chosen = executor_of(executor, workers, slurm)
    from loomlight.core.contact_sheet import Card, sheet_page, sheet_picture
    from loomlight.core.files import discarding_empty, replacing
    from loomlight.core.images import write_pixels
    from loomlight.mitsuba import choose_variant
    from loomlight.mitsuba.denoising import require_denoising
    from loomlight.mitsuba.swatches import CardSettings, fabric_cards, work_folder_of
    from loomlight.models.registry import require_model_name

    require_model_name(model)
    require_denoising(denoise)
    settings = CardSettings(side, model, samples, choose_variant(variant), white_balance, denoise)
    parts = work_folder_of(output)
    note_left(f"{parts} keeps the fabrics that are rendered: the same command goes on from there.")

    def write(cards: list[Card]) -> None:
        if output.suffix.lower() == ".html":
            with replacing(output) as temporary:
                temporary.write_text(sheet_page(cards, title), encoding="utf-8")
        else:
            write_pixels(output, sheet_picture(cards))

    with discarding_empty(parts), progress("swatches") as report:
        write(fabric_cards(fabrics, settings, parts, chosen, report, write))
    shutil.rmtree(parts, ignore_errors=True)
    done(output)
