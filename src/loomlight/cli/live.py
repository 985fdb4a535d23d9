"""The commands that show cloth live: `play` in a window, `view` in a browser."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.options import FabricArgument, Given, takes
from loomlight.cli.terminal import done, note_left, progress
from loomlight.core.errors import InputError
from loomlight.core.files import WRITTEN_SUFFIXES
from loomlight.core.outputs import check_output, require_not_read
from loomlight.core.picture_settings import PlaySettings

PLAY_EXAMPLE = "Example: loomlight play examples/denim.toml --scene drape"


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


# ------------------------------------------------------------------------------------------------------- view

VIEW_EXAMPLE = "Example: loomlight view examples/denim.toml"


def view(
    fabric: Annotated[
        str | None,
        typer.Argument(metavar="[FABRIC]", help="A fabric file, a draft, a .loom, or a weave's name."),
    ] = None,
    host: Annotated[
        str, typer.Option(help="Where it listens; elsewhere than on this machine a token is needed.")
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option(min=0, max=65535, help="0 for any that is free.")] = 8377,
    no_browser: Annotated[
        bool, typer.Option("--no-browser", help="Print the address and open nothing.")
    ] = False,
    export: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Write the editor as a folder for any web server instead, and end."),
    ] = None,
) -> None:
    """Opens the live editor in a browser: change weave, yarns and light, and see the cloth follow."""
    from loomlight.viewer.client import export_site
    from loomlight.viewer.server import serve

    if export is not None:
        if host != "127.0.0.1" or port != 8377:
            raise InputError("--export writes a folder and listens nowhere: leave out --host and --port.")
        require_not_read([export], [fabric])
        done(export_site(export, fabric))
        return
    note_left("The server has ended.")
    serve(fabric, host=host, port=port, open_browser=not no_browser, tell=_tell)


def _tell(address: str) -> None:
    print(f"The editor is at {address} (Ctrl-C ends it).", flush=True)
