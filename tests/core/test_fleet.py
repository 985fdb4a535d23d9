"""A map over shards: nothing is lost and nothing done twice, whoever works and whoever is killed.

Covers: core/fleet.py
"""

from __future__ import annotations

from collections import Counter
from functools import partial
from pathlib import Path

import pytest

from loomlight.core.errors import InputError, LoomlightWarning, MissingDependencyError
from loomlight.core.fleet import Executor, Outcome, Shard, parse_executor, require_results, work_map
from tests.core.work_functions import always_dies, dies_at_first, note, refuses

NAMES = ["one", "two", "victim", "four", "five", "six"]


def items(names: list[str]) -> list[tuple[Shard, str]]:
    return [(Shard(name, "1"), name) for name in names]


def done(folder: Path) -> Counter[str]:
    return Counter((folder / "log").read_text().split())


@pytest.mark.parametrize(
    "executor",
    [Executor(), Executor(workers=2), Executor("slurm", "local", 2), Executor("joblib", "loky", 2)],
    ids=["alone", "processes", "submitit", "joblib"],
)
def test_every_executor_does_everything_once(executor: Executor, tmp_path: Path) -> None:
    reports: list[tuple[int, int]] = []
    work = tmp_path / "work"
    outcomes = work_map(
        partial(note, str(tmp_path)), items(NAMES), work, executor, lambda *pair: reports.append(pair)
    )
    assert [outcome.content.decode() for outcome in outcomes] == NAMES
    assert done(tmp_path) == Counter(NAMES)
    assert reports[-1] == (6, 6)
    # A second call finds all of it.
    again = work_map(partial(note, str(tmp_path)), items(NAMES), work, executor)
    assert again == outcomes
    assert done(tmp_path) == Counter(NAMES)


def test_of_a_killed_process_nothing_is_lost_and_nothing_done_twice(tmp_path: Path) -> None:
    outcomes = work_map(
        partial(dies_at_first, str(tmp_path)), items(NAMES), tmp_path / "work", Executor(workers=2)
    )
    assert (tmp_path / "killed").exists()
    assert [outcome.content.decode() for outcome in outcomes] == NAMES
    assert done(tmp_path) == Counter(NAMES)
    assert sorted(path.name for path in (tmp_path / "work").iterdir()) == sorted(
        f"{name}.done" for name in NAMES
    )


def test_an_item_that_kills_processes_is_given_up(tmp_path: Path) -> None:
    outcomes = work_map(
        partial(always_dies, str(tmp_path)), items(NAMES), tmp_path / "work", Executor(workers=2)
    )
    named = dict(zip(NAMES, outcomes, strict=True))
    assert "its process ended 2 times" in str(named["victim"].fault)
    assert done(tmp_path) == Counter(set(NAMES) - {"victim"})
    with pytest.raises(InputError, match="victim: its process ended"):
        require_results(named)


def test_faults_and_warnings_come_back(tmp_path: Path) -> None:
    with pytest.warns(LoomlightWarning, match="good was mended"):
        outcomes = work_map(partial(refuses, str(tmp_path)), items(["bad", "good"]), tmp_path / "work")
    assert outcomes == [
        Outcome(fault="bad: it is bad."),
        Outcome(b"good", warnings=("good was mended.",)),
    ]
    with pytest.raises(RuntimeError, match="a defect"):
        work_map(partial(refuses, str(tmp_path)), items(["defect"]), tmp_path / "work")


@pytest.mark.parametrize(
    ("text", "workers", "settings", "sentence"),
    [
        ("cloud", 1, {}, '--executor "cloud" is none'),
        ("local", 0, {}, "--workers 0 is out of range"),
        ("local", 1, {"partition": "a"}, "--slurm partition needs --executor slurm"),
    ],
)
def test_bad_options_are_refused(text: str, workers: int, settings: dict[str, str], sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        parse_executor(text, workers, settings)


def test_what_cannot_run_here_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    with pytest.raises(MissingDependencyError, match="sbatch"):
        work_map(partial(note, str(tmp_path)), items(NAMES), tmp_path / "work", Executor("slurm"))
    with pytest.raises(InputError, match="no such backend"):
        work_map(partial(note, str(tmp_path)), items(NAMES), tmp_path / "work", Executor("joblib", "none"))
    wrong = parse_executor("slurm:local", 1, {"colour": "red"})
    with pytest.raises(InputError, match="does not take these settings"):
        work_map(partial(note, str(tmp_path)), items(NAMES), tmp_path / "work", wrong)
