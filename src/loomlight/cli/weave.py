"""`loomlight weave`: drafts shown, converted and measured, without a renderer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Literal

import typer

from loomlight.cli.options import WholeSentences, require_within
from loomlight.cli.terminal import done
from loomlight.core.colour import to_hex
from loomlight.core.errors import InputError
from loomlight.core.files import PIXEL_SUFFIXES, replacing
from loomlight.core.images import PICTURE_SUFFIXES
from loomlight.core.outputs import check_output, require_not_read
from loomlight.weave.bitmaps import BitmapLayout
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
LayerOption = Annotated[
    str | None,
    typer.Option(
        metavar="front|back|N", help="One of several layers alone; 1 is the front, 2 lies behind it."
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
    layer: LayerOption = None,
) -> None:
    """Draws a draft as weaving software does: drawdown, threading, tie-up, treadling, colours."""
    from loomlight.core.images import write_pixels
    from loomlight.weave.drawing import draw_draft, draw_drawdown, draw_layer
    from loomlight.weave.layer_drafts import named_layer, plain_draft

    check_output(output, PIXEL_SUFFIXES, [draft])
    shown = draft_from(draft)
    times = 1 if repeats is None else repeats
    part = None if layer is None else named_layer(shown, layer)
    alone = None if part is None else plain_draft(shown, part)
    if part is not None and alone is None:
        pixels = draw_layer(shown, part, face=face, origin=origin, cell_px=cell, repeats=times)
    elif drawdown:
        pixels = draw_drawdown(alone or shown, face=face, origin=origin, cell_px=cell, repeats=times)
    else:
        pixels = draw_draft(alone or shown, face=face, origin=origin, cell_px=cell, repeats=repeats)
    write_pixels(output, pixels)
    done(output)


@app.command(epilog='Example: loomlight weave convert "herringbone 2/2 8" -o herringbone.wif')
def convert(
    drafts: Annotated[
        list[str],
        typer.Argument(
            metavar="DRAFT...",
            help="A draft of any kind; or the bitmaps of several wefts, one each.",
        ),
    ],
    output: Annotated[
        Path,
        typer.Option(
            "--output", "-o", help="The file to write: .wif, .dtx, or a bitmap: .png, .bmp, .tif or .tiff."
        ),
    ],
    layer: LayerOption = None,
    each_weft: Annotated[
        bool, typer.Option("--each-weft", help="Write a bitmap a weft: cloth-1.bmp, cloth-2.bmp and so on.")
    ] = False,
    order: Annotated[
        str | None,
        typer.Option(
            help='The order of several wefts that are read, such as "1 1 2" or "40x1 2"; by default in turn.'
        ),
    ] = None,
    lifted: Annotated[
        Literal["black", "white"], typer.Option(help="Where a written bitmap lifts the warp.")
    ] = "black",
    first_pick: Annotated[
        Literal["bottom", "top"], typer.Option(help="Where a written bitmap has its first pick.")
    ] = "bottom",
    first_end: Annotated[
        Literal["left", "right"], typer.Option(help="Where a written bitmap has its first end.")
    ] = "left",
    read_lifted: Annotated[
        Literal["black", "white"] | None,
        typer.Option(help="Where the bitmaps that are read lift the warp: black if nothing is said."),
    ] = None,
    read_first_pick: Annotated[
        Literal["bottom", "top"] | None,
        typer.Option(help="Where they have their first pick: at the bottom if nothing is said."),
    ] = None,
    read_first_end: Annotated[
        Literal["left", "right"] | None,
        typer.Option(help="Where they have their first end: on the left if nothing is said."),
    ] = None,
) -> None:
    """Writes a draft, or a layer, as a weaving information file (WIF 1.1), a Fiberworks file or bitmaps."""
    from loomlight.weave.bitmaps import BITMAP_SUFFIXES, BitmapLayout, order_text, split_wefts, write_bitmaps
    from loomlight.weave.save import SAVED_SUFFIXES, save_draft

    check_output(output, BITMAP_SUFFIXES if each_weft else SAVED_SUFFIXES, drafts)
    layout = BitmapLayout(lifted, first_pick, first_end)
    read_as = BitmapLayout(read_lifted or "black", read_first_pick or "bottom", read_first_end or "left")
    is_bitmap = len(drafts) > 1 or order is not None or any((read_lifted, read_first_pick, read_first_end))
    draft = draft_of_bitmaps(drafts, order, read_as) if is_bitmap else _measured(drafts[0])
    if layer is not None:
        draft = _draft_of_layer(draft, layer, drafts[0])
    if not each_weft:
        save_draft(draft, output, layout)
        done(output)
        return
    wefts, cycle = split_wefts(draft)
    paths = [output.with_stem(f"{output.stem}-{number}") for number in range(1, len(wefts) + 1)]
    require_not_read(paths, drafts)
    write_bitmaps(list(zip(paths, (weft.warp_up for weft in wefts), strict=True)), layout)
    for path, weft in zip(paths, wefts, strict=True):
        colour = "" if weft.color is None else f" of {to_hex(weft.color)}"
        print(f"{path}: {len(weft.warp_up)} picks{colour}")
    if len(wefts) > 1:
        print(f"order of the wefts: {order_text(cycle)}")


def _draft_of_layer(draft: Draft, name: str, source: str) -> Draft:
    """The threads of one layer as a draft of its own.

    Raises:
        InputError: no such layer, or one in which cloths change places.
    """
    from loomlight.weave.layer_drafts import named_layer, plain_draft

    alone = plain_draft(draft, named_layer(draft, name))
    if alone is None:
        raise InputError(
            f'The layer "{name}" of {source} is no draft of its own, as cloths change places in it; '
            "`loomlight weave show --layer` draws it."
        )
    return alone


def draft_of_bitmaps(paths: list[str], order: str | None, layout: BitmapLayout) -> Draft:
    """The draft of the bitmaps of its wefts, one each.

    Raises:
        InputError: files that are no bitmaps, or do not go together.
    """
    from loomlight.weave.bitmaps import draft_of_wefts, parse_order, read_bitmap

    for path in paths:
        if Path(path).suffix.lower() not in PICTURE_SUFFIXES:
            raise InputError(
                f"{path} is no bitmap: several wefts, and the options for reading, need pictures."
            )
    wefts = [read_bitmap(path, layout) for path in paths]
    numbers = [] if order is None else parse_order(order, "--order")
    return draft_of_wefts(wefts, numbers, title=Path(paths[0]).stem)


@app.command(epilog="Example: loomlight weave info examples/denim.toml")
def info(draft: DraftArgument) -> None:
    """Says what a draft is: size, setts, floats, shafts, colours, layers; of a fabric also its weight."""
    from loomlight.weave.layer_drafts import layers_text
    from loomlight.weave.textile import summary

    if Path(draft).suffix.lower() not in FABRIC_SUFFIXES:
        shown = draft_from(draft)
        print("\n".join(filter(None, (summary(shown), layers_text(shown)))))
        return
    from loomlight.fabric.facts import facts_text
    from loomlight.sources.load import fabric_of_path

    fabric = fabric_of_path(draft)
    parts = (summary(fabric.draft, with_sett=False), layers_text(fabric.draft), facts_text(fabric))
    print("\n".join(filter(None, parts)))


EndsOption = Annotated[
    int | None, typer.Option("--ends", help="Ends of the warp, over which the draft repeats.")
]
PicksOption = Annotated[int | None, typer.Option("--picks", help="Picks, over which the draft repeats.")]
GroupOption = Annotated[int, typer.Option("--group", metavar="THREADS", help="Threads a line.")]
ListOutput = Annotated[
    Path | None,
    typer.Option("--output", "-o", help="A .txt file to write the list to, in place of the terminal."),
]


@app.command(epilog='Example: loomlight weave heddles "herringbone 2/2 8" --ends 480')
def heddles(draft: DraftArgument, ends: EndsOption = None, output: ListOutput = None) -> None:
    """Counts the heddles that each shaft needs."""
    from loomlight.weave.bench import heddle_text
    from loomlight.weave.loom import warped

    _listed(lambda: heddle_text(warped(draft_from(draft), ends)), output, draft)


@app.command(epilog='Example: loomlight weave threading "herringbone 2/2 8" --ends 480 -o threading.txt')
def threading(
    draft: DraftArgument, ends: EndsOption = None, group: GroupOption = 8, output: ListOutput = None
) -> None:
    """Lists the shaft of every end, from end 1, as a plain text to thread by."""
    from loomlight.weave.bench import threading_text
    from loomlight.weave.loom import warped

    _listed(lambda: threading_text(warped(draft_from(draft), ends), group), output, draft)


@app.command(epilog='Example: loomlight weave treadling "waffle 8" --picks 64')
def treadling(
    draft: DraftArgument, picks: PicksOption = None, group: GroupOption = 8, output: ListOutput = None
) -> None:
    """Lists the tie-up and the treadles of every pick, or the shafts that each pick lifts."""
    from loomlight.weave.bench import treadling_text
    from loomlight.weave.loom import warped

    _listed(lambda: treadling_text(warped(draft_from(draft), None, picks), group), output, draft)


def _listed(make: Callable[[], str], output: Path | None, draft: str) -> None:
    """Prints a list, or writes it to a file."""
    if output is None:
        print(make())
        return
    check_output(output, (".txt",), [draft])
    text = make()
    with replacing(output) as temporary:
        temporary.write_text(f"{text}\n", encoding="utf-8")
    done(output)


@app.command(
    "print", epilog='Example: loomlight weave print "waffle 8" --epi 20 --ends 80 --picks 80 -o waffle.pdf'
)
def print_(
    draft: DraftArgument,
    output: Annotated[Path, typer.Option("--output", "-o", help="The .pdf file to write.")],
    ends: EndsOption = None,
    picks: PicksOption = None,
    ends_per_cm: Annotated[float | None, typer.Option(help="Sett, in place of the draft's.")] = None,
    picks_per_cm: Annotated[float | None, typer.Option(help="Picks per cm, likewise.")] = None,
    epi: Annotated[float | None, typer.Option(help="Sett per inch, in place of --ends-per-cm.")] = None,
    ppi: Annotated[float | None, typer.Option(help="Picks per inch, likewise.")] = None,
    scale: Annotated[float, typer.Option(help="Times the cloth's size; 4 is easier to read.")] = 1.0,
    paper: Annotated[
        Literal["a4", "a3", "a2", "a1", "a0", "letter", "legal", "tabloid"],
        typer.Option(help="Of a sheet; a large draft goes over several."),
    ] = "a4",
    face: Annotated[Literal["front", "back"], typer.Option(help="Which side is seen.")] = "front",
    origin: Annotated[
        Literal["top-right", "top-left", "bottom-right", "bottom-left"],
        typer.Option(help="The corner of end 1 and pick 1."),
    ] = "top-right",
    drawdown: Annotated[
        bool, typer.Option("--drawdown", help="The interlacement alone, without threading and tie-up.")
    ] = False,
) -> None:
    """Draws a draft as PDF, as large as the cloth, with rulers in centimetres and inches."""
    from loomlight.weave.loom import warped
    from loomlight.weave.printed import write_draft_pdf
    from loomlight.weave.textile import with_setts

    check_output(output, (".pdf",), [draft])
    shown = with_setts(
        _measured(draft),
        _one_sett(("--ends-per-cm", ends_per_cm), ("--epi", epi)),
        _one_sett(("--picks-per-cm", picks_per_cm), ("--ppi", ppi)),
    )
    shown = warped(shown, ends, picks)
    write_draft_pdf(shown, output, scale=scale, paper=paper, face=face, origin=origin, drawdown=drawdown)
    done(output)


def _measured(argument: str) -> Draft:
    """The draft of an argument; that of a fabric with the spacings of its setts, where its file gives any."""
    if Path(argument).suffix.lower() not in FABRIC_SUFFIXES:
        return draft_from(argument)
    from loomlight.fabric.resolve import threads_per_cm
    from loomlight.sources.load import fabric_of_path

    fabric = fabric_of_path(argument)
    if all(threads_per_cm(fabric.fields, family) is None for family in ("warp", "weft")):
        return fabric.draft
    resolved = fabric.resolved
    warp, weft = resolved.draft.warp, resolved.draft.weft
    return replace(
        resolved.draft,
        warp=replace(warp, spacing_mm=resolved.warp.layout.spacing),
        weft=replace(weft, spacing_mm=resolved.weft.layout.spacing),
    )


def _one_sett(in_cm: tuple[str, float | None], in_inches: tuple[str, float | None]) -> float | None:
    """Threads/cm of two options, of which at most one is given.

    Raises:
        InputError: both, or one that is out of range.
    """
    from loomlight.weave.textile import per_cm

    (cm_option, cm), (inch_option, inches) = in_cm, in_inches
    if cm is not None and inches is not None:
        raise InputError(
            f"{cm_option} {cm:g} and {inch_option} {inches:g} say the same thing twice: keep one."
        )
    if cm is not None:
        require_within(cm_option, cm, 0.1, 1000)
    if inches is not None:
        require_within(inch_option, inches, 0.254, 2540)
        return per_cm(inches)
    return cm


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
