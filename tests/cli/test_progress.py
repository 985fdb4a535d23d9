"""A line of progress, where a person is watching."""

from __future__ import annotations

import re
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


@pytest.mark.parametrize(
    ("milliseconds", "done", "total", "says"),
    [
        (True, 0, 18_000, "about 18 s left"),
        (True, 1000, 7_201_000, "about 2.0 h left"),
        (False, 1, 1, "about 1 s left"),
        (True, 9000, 1000, "longer than estimated"),
    ],
)
def test_the_time_left_shows_from_the_first_report_on(
    milliseconds: bool,
    done: int,
    total: int,
    says: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "120")
    with progress("weaving", milliseconds=milliseconds) as report:
        report(done, total)
    text = re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", "", capsys.readouterr().err)
    assert says in text
