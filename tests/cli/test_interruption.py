"""Ctrl-C, to the process alone and to its whole group as a terminal does.

Covers: __main__.py
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loomlight.cli import terminal
from loomlight.cli.main import run
from loomlight.cli.terminal import note_left, report_interruption, was_interrupted
from studies.papers.chen2024 import data


def started(code: str) -> subprocess.Popen[str]:
    # Python's own handler: what a background job of a shell starts ignores SIGINT otherwise.
    heard = "import signal, sys, time\nsignal.signal(signal.SIGINT, signal.default_int_handler)"
    program = f"{heard}\nfrom loomlight.cli import terminal\n{code}"
    return subprocess.Popen(
        [sys.executable, "-c", program],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )


# Work that says it has begun, then does not listen: like a kernel that is compiled.
DEAF = """
def work():
    import signal
    signal.signal(signal.SIGINT, lambda *_: None)
    terminal.note_left("a.png holds a coarse picture.")
    print("begun", flush=True)
    while True: signal.pause()
sys.exit(terminal.supervised(work))
"""
# The command, with Python's own handler as in `started`, without lines of progress, and with all the time
# that a busy machine needs to hear.
HEARING = """
import math, signal
signal.signal(signal.SIGINT, signal.default_int_handler)
from loomlight.__main__ import main
from loomlight.cli import terminal
terminal._END = terminal.LINE_SECONDS = math.inf
main()
"""
LISTENING = """
terminal._END = float("inf")
def work():
    import signal
    try:
        print("begun", flush=True)
        while True: signal.pause()
    except KeyboardInterrupt:
        return terminal.report_interruption()
sys.exit(terminal.supervised(work))
"""


@pytest.mark.parametrize("send", [os.kill, os.killpg], ids=["process", "group"])
@pytest.mark.parametrize(
    ("code", "left"), [(DEAF, "a.png holds a coarse picture."), (LISTENING, "Nothing was written.")]
)
def test_it_ends_and_says_what_is_left(code: str, left: str, send: Callable[[int, int], None]) -> None:
    """Work that would go on for ever: that the process ends at all is by the interruption."""
    assert terminal._END < 1
    process = started(code)
    assert process.stdout is not None
    assert process.stdout.readline() == "begun\n"
    send(process.pid, signal.SIGINT)
    _, error = process.communicate()
    assert error == f"loomlight: interrupted. {left}\n"
    assert process.returncode == 130


def test_exit_codes_pass_through() -> None:
    process = started("sys.exit(terminal.supervised(lambda: 7))")
    assert process.wait() == 7


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("SIGKILL", "was ended by SIGKILL, as a system ends work that fills its memory"),
        ("SIGSEGV", "crashed (SIGSEGV) within a library"),
        ("SIGABRT", "crashed (SIGABRT) within a library"),
        ("SIGUSR1", "was ended by SIGUSR1, which another program sent"),
    ],
)
def test_work_that_was_ended_says_by_what(name: str, says: str) -> None:
    ended = f"lambda: os.kill(os.getpid(), signal.{name})"
    process = started(f"import os, signal\nsys.exit(terminal.supervised({ended}))")
    _, error = process.communicate()
    assert process.returncode == 128 + getattr(signal, name)
    assert error.startswith(f"loomlight: the work {says}")
    assert error.count("\n") == 1


def test_a_word_within_one_process(capsys: pytest.CaptureFixture[str]) -> None:
    note_left("a.png holds the picture as far as it came.")
    assert report_interruption() == 130
    note_left(None)
    assert report_interruption() == 130
    first, second = capsys.readouterr().err.splitlines()
    assert first == "loomlight: interrupted. a.png holds the picture as far as it came."
    assert second == "loomlight: interrupted. Nothing was written."


def test_work_that_goes_on_later_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("studies.papers.chen2024.dataset_store.make_store", interrupted)
    assert run(["-o", str(tmp_path / "a.zarr")], data.app) == 130
    assert "a.zarr keeps the materials that are finished" in capsys.readouterr().err


def test_an_interruption_is_found_behind_another_error() -> None:
    error = RuntimeError("what a library raised")
    assert not was_interrupted(error)
    error.__cause__ = KeyboardInterrupt()
    assert was_interrupted(error)
    assert not was_interrupted(None)


def test_an_interrupted_render_keeps_a_whole_picture(tmp_path: Path) -> None:
    picture = tmp_path / "plain.png"
    options = ["--model", "point", "--size", "640x480", "--spp", "4096"]
    process = subprocess.Popen(
        [sys.executable, "-c", HEARING, "render", "plain", "-o", str(picture), *options],
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    while not picture.exists() and process.poll() is None:
        time.sleep(0.05)
    os.killpg(process.pid, signal.SIGINT)
    _, error = process.communicate()
    assert error == f"loomlight: interrupted. {picture} holds the picture as far as it came.\n"
    assert process.returncode == 130
    assert [path.name for path in tmp_path.iterdir()] == ["plain.png"]
    with Image.open(picture) as opened:
        assert opened.size == (640, 480)
        assert np.asarray(opened).std() > 5


IMPORTING = """
import builtins, sys, types
def raises():
    import os, signal
    try:
        os.kill(os.getpid(), signal.SIGINT)
        signal.sigtimedwait([], 10)
    except KeyboardInterrupt:
        pass
    raise ImportError("half of a library")  # as extension modules make of an interruption
def work():
    from loomlight.cli.main import run
    from loomlight.cli import main
    main._invoke = lambda *_: raises()
    return run([])
sys.exit(terminal.supervised(work))
"""


def test_an_interruption_of_an_import_is_no_traceback() -> None:
    process = started(IMPORTING)
    _, said = process.communicate()
    assert process.returncode == 130
    assert said == "loomlight: interrupted. Nothing was written.\n"
