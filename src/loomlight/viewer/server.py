"""`serve`: the editor's application behind uvicorn."""

from __future__ import annotations

import errno
import os
import socket
import webbrowser
from collections.abc import Callable
from threading import Timer

from loomlight.core.errors import InputError
from loomlight.core.extras import import_extra
from loomlight.fabric.fabric import Fabric
from loomlight.viewer.client import client_folder

DEFAULT_PORT = 8377
# After Ctrl-C, a request that still runs is given up.
_GRACE_SECONDS = 1


def serve(
    fabric: Fabric | str | os.PathLike[str] | None = None,
    *,
    host: str = "127.0.0.1",
    port: int = DEFAULT_PORT,
    open_browser: bool = False,
    tell: Callable[[str], None] = print,
) -> None:
    """Serves the editor until it is interrupted.

    Args:
        fabric: what the editor shows first; see `fabric_of_path`. None for a fabric of its gallery.
        host: where it listens; unless that is a loopback address, requests need a token.
        port: 0 for any that is free.
        open_browser: opens the page in the user's browser.
        tell: called with the page's address.

    Raises:
        InputError: no such fabric, or an address that cannot be listened at.
        MissingDependencyError: starlette or uvicorn is missing, or the page is not built and cannot be.
    """
    uvicorn = import_extra("uvicorn", "viewer", "The editor's server")
    import_extra("starlette", "viewer", "The editor's server")
    from loomlight.viewer.app import Access, editor_app

    access = Access.for_host(host)
    name = os.fspath(fabric) if isinstance(fabric, str | os.PathLike) else fabric
    config = uvicorn.Config(
        editor_app(client_folder(), name, access),
        host=host,
        port=port,
        log_level="critical",
        access_log=False,
        server_header=False,
        timeout_graceful_shutdown=_GRACE_SECONDS,
    )
    try:
        listening = config.bind_socket()
    except SystemExit as stop:  # how uvicorn ends when it cannot listen
        raise InputError(_unavailable(host, port, stop.__context__)) from stop
    with listening:
        listening.listen()  # whoever is told the address may ask at once
        address = _address(host, listening.getsockname()[1], access.token)
        tell(address)
        if open_browser:
            Timer(0.5, webbrowser.open, [address]).start()
        uvicorn.Server(config).run(sockets=[listening])


def edit(fabric: Fabric | str | os.PathLike[str] | None = None) -> None:
    """Opens the editor in a browser, and serves it until it is interrupted; see `serve`."""
    serve(fabric, port=0, open_browser=True)


def _address(host: str, port: int, token: str | None) -> str:
    shown = socket.gethostname() if host in ("0.0.0.0", "::") else host
    return f"http://{f'[{shown}]' if ':' in shown else shown}:{port}/" + (f"?token={token}" if token else "")


def _unavailable(host: str, port: int, cause: BaseException | None) -> str:
    number = getattr(cause, "errno", None)
    if number == errno.EADDRINUSE:
        return (
            f"--port {port} is in use, perhaps by another loomlight view: name another one, "
            f"such as --port {port + 1 if port < 65535 else port - 1}, or --port 0 for any that is free."
        )
    if number == errno.EACCES:
        return f"--port {port} may not be used by this user: name one from 1024 to 65535."
    reason = getattr(cause, "strerror", None) or cause
    return f"--host {host} --port {port} cannot be listened at: {reason}."
