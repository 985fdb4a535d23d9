"""`loomlight capture`: a fabric file from a photograph."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from loomlight.cli.options import require_within
from loomlight.cli.terminal import done, note_left, progress
from loomlight.core.errors import InputError
from loomlight.core.files import PIXEL_SUFFIXES
from loomlight.core.outputs import check_output

if TYPE_CHECKING:
    from loomlight.capturing.captured import Captured

EXAMPLE = "Example: loomlight capture photo.jpg --width-mm 20 -o fabric.toml"


def capture(
    photo: Annotated[
        str, typer.Argument(metavar="PHOTO", help="A picture of flat cloth from above, its warp upright.")
    ],
    width_mm: Annotated[
        float, typer.Option("--width-mm", metavar="MM", help="Millimetres of cloth that it is wide.")
    ],
    output: Annotated[Path, typer.Option("--output", "-o", help="The fabric file to write (.toml).")],
    weave: Annotated[
        str | None, typer.Option(metavar="NAME", help='The weave, if it is known: "twill 2/1".')
    ] = None,
    draft: Annotated[
        str | None, typer.Option(metavar="DRAFT", help="The draft, if it is known: a .wif or .dtx file.")
    ] = None,
    back: Annotated[
        str | None, typer.Option(metavar="PHOTO", help="The cloth from behind, as wide, turned like a page.")
    ] = None,
    light: Annotated[
        str, typer.Option(metavar="LIGHT", help="flash, at the camera, or window, from a side.")
    ] = "flash",
    white: Annotated[
        str | None, typer.Option(metavar="#RRGGBB", help="What white paper looks like in the photo.")
    ] = None,
    grey_card: Annotated[
        str | None, typer.Option(metavar="#RRGGBB", help="What a grey card of 18 % looks like in it.")
    ] = None,
    sheet: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Photo, render, difference and draft; default: *-sheet.png."),
    ] = None,
) -> None:
    """Makes a fabric file from a photograph of flat cloth; see docs/capture.md.

    The file holds what is known as soon as the weave is found, and is refined until the command ends: Ctrl-C
    keeps it as far as it came.
    """
    require_within("--width-mm", width_mm, 1, 2000)
    reads = [photo, draft, back]
    check_output(output, (".toml",), reads)
    drawn = output.with_name(f"{output.stem}-sheet.png") if sheet is None else sheet
    check_output(drawn, PIXEL_SUFFIXES, reads)
    if drawn == output:
        raise InputError(f"{drawn} is the fabric file: give another name for the sheet.")

    from loomlight.capturing.capture import capture as run

    def kept(found: Captured) -> None:
        note_left(f"{output} holds {found.weave or 'a draft'} as far as it is fitted.")

    with progress(Path(photo).name) as report:
        found = run(
            photo,
            output,
            width_mm=width_mm,
            weave=weave,
            draft=draft,
            back=back,
            light=light,
            white=white,
            grey_card=grey_card,
            sheet=drawn,
            report=report,
            kept=kept,
        )
    for path in found.files(output):
        done(path)
    done(drawn, found.summary)
