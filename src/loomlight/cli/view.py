"""`loomlight view`: the live editor in a browser."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.interruption import note_left
from loomlight.cli.progress import done
from loomlight.core.errors import InputError
from loomlight.core.outputs import require_not_read

EXAMPLE = "Example: loomlight view examples/denim.toml"


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
