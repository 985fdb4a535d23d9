"""`loomlight swatches`: a labelled contact sheet of fabrics."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.outputs import check_output, done
from loomlight.cli.progress import progress
from loomlight.cli.values import require_within
from loomlight.core.errors import InputError, LoomlightWarning

EXAMPLE = "Example: loomlight swatches examples/*.toml -o sheet.png"


def swatches(
    fabrics: Annotated[
        list[str],
        typer.Argument(metavar="FABRIC...", help="Fabric files, drafts, .loom files, or weaves' names."),
    ],
    output: Annotated[
        Path, typer.Option("--output", "-o", help="The sheet to write: a .png picture or an .html page.")
    ],
    model: Annotated[str, typer.Option(help="One of the models below.")] = "lobes",
    side: Annotated[int, typer.Option("--size", metavar="PIXELS", help="Side of each picture.")] = 240,
    samples: Annotated[int, typer.Option("--spp", help="Samples a pixel.")] = 9,
    title: Annotated[str, typer.Option(help="Heading of a page.")] = "Fabrics",
    variant: Annotated[str | None, typer.Option(help="llvm_ad_rgb (default) or cuda_ad_rgb.")] = None,
) -> None:
    """Renders a labelled contact sheet: of each fabric its drawdown, a swatch, a drape and facts.

    A file that cannot be used is left out with a warning.
    """
    check_output(output, (".png", ".html"))
    require_within("--size", side, 32, 2048)
    require_within("--spp", samples, 1, 100_000)
    from loomlight.core.contact_sheet import Card, sheet_page, sheet_picture
    from loomlight.core.files import replacing
    from loomlight.core.images import write_png
    from loomlight.mitsuba import choose_variant
    from loomlight.mitsuba.swatches import fabric_card
    from loomlight.models.registry import require_model_name

    require_model_name(model)
    choose_variant(variant)
    cards: list[Card] = []
    with progress("swatches") as report:
        for number, fabric in enumerate(fabrics):
            try:
                cards.append(fabric_card(fabric, side, model=model, spp=samples))
            except InputError as error:
                if len(fabrics) == 1:
                    raise
                warnings.warn(f"{error} It is left out.", LoomlightWarning, stacklevel=1)
            report(number + 1, len(fabrics))
    if not cards:
        raise InputError(f"None of the {len(fabrics)} fabrics can be used.")
    if output.suffix.lower() == ".html":
        with replacing(output) as temporary:
            temporary.write_text(sheet_page(cards, title), encoding="utf-8")
    else:
        write_png(output, sheet_picture(cards))
    done(output)
