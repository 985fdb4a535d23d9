"""Progress: a bar where a person is watching, else a line now and then."""

from __future__ import annotations

import re
import sys

import pytest

from loomlight.cli.terminal import Lines, progress


def test_short_work_writes_no_lines(capsys: pytest.CaptureFixture[str]) -> None:
    with progress("work") as report:
        report(1, 2)
        report(2, 2)
    captured = capsys.readouterr()
    assert captured.out == captured.err == ""


def test_a_log_gets_a_line_every_ten_seconds(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("loomlight.cli.terminal.LINE_SECONDS", 10.0)
    now = [0.0]
    lines = Lines("denim", lambda: now[0])
    for second, share, expected in (
        (5, 0.1, 40),
        (11, 0.25, 44),
        (15, 0.3, 45),
        (22, 0.5, None),
        (40, 1.0, 30),
        (55, 1.2, 50),
    ):
        now[0] = second
        lines.report(share, expected)
    captured = capsys.readouterr()
    assert captured.err.splitlines() == [
        "denim: 25 %, about 33 s left",
        "denim: 50 %",
        "denim: 100 %",
        "denim: longer than estimated",
    ]
    assert captured.out == ""


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
