"""A line of progress, where a person is watching."""

from __future__ import annotations

import sys

import pytest

from loomlight.cli.progress import progress


def test_nothing_is_written_where_nobody_watches(capsys: pytest.CaptureFixture[str]) -> None:
    with progress("work") as report:
        report(1, 2)
        report(2, 2)
    captured = capsys.readouterr()
    assert captured.out == captured.err == ""


def test_a_terminal_shows_a_bar_on_stderr(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("TERM", "xterm")
    with progress("weaving") as report:
        report(1, 2)
    captured = capsys.readouterr()
    assert "weaving" in captured.err
    assert captured.out == ""
