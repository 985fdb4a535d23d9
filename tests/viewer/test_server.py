"""`serve`: where it listens, and what it says where it cannot."""

from __future__ import annotations

import re
import socket
from pathlib import Path
from typing import Any

import pytest
import uvicorn

from loomlight.core.errors import InputError
from loomlight.viewer import server
from loomlight.viewer.server import serve


@pytest.fixture(autouse=True)
def listens_only(page: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Ends where requests would be answered; test_app.py has a server that answers."""
    monkeypatch.setattr(server, "client_folder", lambda: page)

    def run(self: uvicorn.Server, sockets: Any = None) -> None:
        assert sockets[0].getsockname()[1] > 0

    monkeypatch.setattr(uvicorn.Server, "run", run)


def test_address_is_told() -> None:
    told: list[str] = []
    serve("twill 3/1", port=0, tell=told.append)
    assert re.fullmatch(r"http://127\.0\.0\.1:\d+/", told[0])


def test_elsewhere_a_token_is_part_of_the_address() -> None:
    told: list[str] = []
    serve("twill 3/1", host="0.0.0.0", port=0, tell=told.append)
    assert re.fullmatch(rf"http://{re.escape(socket.gethostname())}:\d+/\?token=[\w-]{{43}}", told[0])


def test_port_in_use_is_one_sentence() -> None:
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        with pytest.raises(InputError, match=rf"^--port {port} is in use.*--port {port + 1}"):
            serve("twill 3/1", port=port)


def test_address_of_another_machine_is_one_sentence() -> None:
    with pytest.raises(InputError, match=r"--host 203\.0\.113\.1 .*cannot be listened at"):
        serve("twill 3/1", host="203.0.113.1", port=0)


def test_bad_fabric_is_told_before_listening() -> None:
    with pytest.raises(InputError, match="does not exist"):
        serve("missing.toml", port=0)
