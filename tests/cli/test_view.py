"""`loomlight view`, as a command."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from loomlight.cli.main import run
from loomlight.viewer import client, server


def test_options_reach_the_server(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    asked: dict[str, Any] = {}

    def serve(fabric: str | None, **options: Any) -> None:
        options["tell"]("http://localhost:1/")
        asked.update(options, fabric=fabric)

    monkeypatch.setattr(server, "serve", serve)
    assert run(["view", "twill 3/1", "--port", "1", "--no-browser"]) == 0
    assert (asked["fabric"], asked["port"], asked["open_browser"]) == ("twill 3/1", 1, False)
    assert capsys.readouterr().out == "The editor is at http://localhost:1/ (Ctrl-C ends it).\n"


def test_export_prints_its_folder(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setattr(client, "export_site", lambda folder, fabric: folder)
    assert run(["view", "--export", str(tmp_path / "site")]) == 0
    assert capsys.readouterr().out == f"{tmp_path / 'site'}\n"
    assert run(["view", "--export", "site", "--port", "80"]) == 2
    assert "listens nowhere" in capsys.readouterr().err
    assert run(["view", "--port", "99999"]) == 2
