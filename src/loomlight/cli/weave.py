"""`loomlight weave`: drafts shown, converted and measured, without a renderer."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from loomlight.cli.options import WholeSentences
from loomlight.cli.terminal import done
from loomlight.core.errors import InputError
from loomlight.core.files import PIXEL_SUFFIXES
from loomlight.core.outputs import check_output
from loomlight.weave.draft import Draft

app = typer.Typer(
    cls=WholeSentences,
    help="Drafts: show, convert and measure them.",
    no_args_is_help=True,
    rich_markup_mode=None,
)

# Files of fabrics, whose yarns have weights.
FABRIC_SUFFIXES = (".toml", ".loom")
DraftArgument = Annotated[
    str,
    typer.Argument(
        metavar="DRAFT",
        help="A .wif file, a picture of a drawdown, a fabric file, a .loom, or a weave's name.",
    ),
]


@app.command(epilog='Example: loomlight weave show "twill 3/1" -o draft.png')
def show(
    draft: DraftArgument,
    output: Annotated[Path, typer.Option("--output", "-o", help="The picture to write: .png or .jpg.")],
    face: Annotated[Literal["front", "back"], typer.Option(help="Which side is seen.")] = "front",
    origin: Annotated[
        Literal["top-right", "top-left", "bottom-right", "bottom-left"],
        typer.Option(help="The corner of end 1 and pick 1; rendered cloth has them at the bottom left."),
    ] = "top-right",
    cell: Annotated[
        int | None, typer.Option(metavar="PIXELS", help="Pixels a crossing; by default what suits the draft.")
    ] = None,
    repeats: Annotated[
        int | None, typer.Option(help="How often the repeat is drawn each way; by default until it shows.")
    ] = None,
    drawdown: Annotated[
        bool, typer.Option("--drawdown", help="The interlacement alone, without threading and tie-up.")
    ] = False,
) -> None:
    """Draws a draft as weaving software does: drawdown, threading, tie-up, treadling, colours."""
    from loomlight.core.images import write_pixels
    from loomlight.weave.drawing import draw_draft, draw_drawdown

    check_output(output, PIXEL_SUFFIXES, [draft])
    shown = draft_from(draft)
    if drawdown:
        times = 1 if repeats is None else repeats
        pixels = draw_drawdown(shown, face=face, origin=origin, cell_px=cell, repeats=times)
    else:
        pixels = draw_draft(shown, face=face, origin=origin, cell_px=cell, repeats=repeats)
    write_pixels(output, pixels)
    done(output)


@app.command(epilog='Example: loomlight weave convert "herringbone 2/2 8" -o herringbone.wif')
def convert(
    draft: DraftArgument,
    output: Annotated[Path, typer.Option("--output", "-o", help="The .wif file to write.")],
) -> None:
    """Writes a draft as a weaving information file (WIF 1.1)."""
    from loomlight.weave.wif_writer import write_wif

    check_output(output, (".wif",), [draft])
    write_wif(draft_from(draft), output)
    done(output)


@app.command(epilog="Example: loomlight weave info examples/denim.toml")
def info(draft: DraftArgument) -> None:
    """Says what a draft is: its size, setts, floats, shafts and colours; of a fabric also its weight."""
    from loomlight.weave.textile import summary

    if Path(draft).suffix.lower() not in FABRIC_SUFFIXES:
        print(summary(draft_from(draft)))
        return
    from loomlight.fabric.facts import facts_text
    from loomlight.sources.load import fabric_of_path

    fabric = fabric_of_path(draft)
    print(f"{summary(fabric.draft, with_sett=False)}\n{facts_text(fabric)}")


@app.command("names", epilog="Example: loomlight weave names")
def names() -> None:
    """Lists the weaves that have a name, each in the form in which to write it."""
    from loomlight.weave.named import weave_names

    print("\n".join(weave_names()))


def draft_from(argument: str) -> Draft:
    """The draft of a .wif file, a picture of a drawdown, a fabric file, a `.loom`, or a weave's name.

    Raises:
        InputError: nothing of these.
    """
    from loomlight.weave.load import DRAFT_SUFFIXES, load_draft
    from loomlight.weave.named import named_weave

    path = Path(argument)
    suffix = path.suffix.lower()
    if suffix in FABRIC_SUFFIXES:
        from loomlight.sources.load import fabric_of_path

        return fabric_of_path(path).draft
    if suffix in DRAFT_SUFFIXES:
        return load_draft(path)
    if suffix or path.is_absolute():
        raise InputError(
            f"{path} is no draft: give a .wif file, a picture, a fabric file, a .loom or a weave's name."
        )
    return named_weave(argument)
