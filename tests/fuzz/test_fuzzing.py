"""The harness of fuzzers notices every kind of fault, and keeps and repeats what made it."""

from __future__ import annotations

import ast
import os
import random
import signal
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError, LoomlightWarning
from tests.fuzz import fuzzing
from tests.fuzz.fuzzing import Child, Target, outcome_of


def subject(content: bytes) -> None:
    """Does what the file says."""
    match content.decode():
        case "refuse":
            raise InputError("file.txt says no; say yes.")
        case "warn":
            warnings.warn("a line is left out", LoomlightWarning, stacklevel=1)
        case "raw":
            warnings.warn("overflow", RuntimeWarning, stacklevel=1)
        case "crash":
            raise ZeroDivisionError
        case "kill":
            os.kill(os.getpid(), signal.SIGKILL)
        case "memory":
            np.ones(2**28)
        case "hang":
            signal.pause()


def target(**more: object) -> Target:
    return Target("words", [b"read"], [fuzzing.flip_bytes], subject, **more)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("content", "kind", "says"),
    [
        (b"read", "read", ""),
        (b"warn", "read with warnings", "left out"),
        (b"refuse", "refused", "say yes"),
        (b"raw", "fault", "a raw warning: overflow"),
        (b"crash", "fault", "ZeroDivisionError"),
    ],
)
def test_outcomes_of_a_file(content: bytes, kind: str, says: str) -> None:
    outcome = outcome_of(subject, content)
    assert (outcome.kind, says in outcome.message) == (kind, True)


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_child_that_ends_or_grows_or_hangs_is_a_fault_and_the_next_file_is_taken() -> None:
    child = Child(target(max_seconds=0.1, max_mb=1000))
    for content, says in (
        (b"kill", "status -9"),
        (b"memory", "MemoryError"),
        (b"hang", "not done after 1 s"),
    ):
        outcome = child.take(content)
        assert (outcome.kind, says in outcome.message) == ("fault", True)
        assert child.take(b"read").kind == "read"
    child.close()
    assert child.peak_mb > 1


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_main_prints_counts_and_keeps_faulty_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["fuzz", "--count", "20", "--faults", str(tmp_path / "faults")])
    assert fuzzing.main("words", lambda: [target()]) == 1  # bytes above 127 are no text
    (line,) = (line for line in capsys.readouterr().out.splitlines() if line.startswith("words: "))
    figures = ast.literal_eval(line.removeprefix("words: "))
    assert figures["files"] == 20 == figures["read"] + figures["refused"] + figures["faults"]
    assert len(list((tmp_path / "faults").iterdir())) == figures["faults"] > 0
    monkeypatch.setattr(sys, "argv", ["fuzz", "--count", "20", "--only", "letters"])
    assert fuzzing.main("words", lambda: [target()]) == 2
    assert capsys.readouterr().err == 'there is no target "letters"\n'


def test_mutations_change_files_and_repeat_by_seed() -> None:
    text = b'{"a": [1, 2.5], "b": {"c": "word"}}\nline 2\nline 3\n4\n5'
    for mutation in (*fuzzing.BYTES, *fuzzing.TEXT, fuzzing.change_json):
        content = text if mutation is not fuzzing.change_json else text.split(b"\n")[0]
        made = [mutation(random.Random(seed), content) for seed in range(30)]
        assert len(set(made)) > 3
        assert made == [mutation(random.Random(seed), content) for seed in range(30)]
