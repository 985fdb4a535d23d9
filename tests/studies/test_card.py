"""The kit for a graphics card: what runs in some minutes, how jobs go on, and that none ends another.

Covers: studies/card.py
Covers: studies/card_kit/jobs.py, studies/card_kit/machine.py, studies/card_kit/plan.py
"""

from __future__ import annotations

import importlib.util
import json
import os
import select
import signal
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest

from loomlight.core.errors import InputError, LoomlightError
from studies import card
from studies.card_kit import machine, plan
from studies.card_kit.jobs import JOBS, Job, Places
from studies.card_kit.machine import NEEDS, Has
from studies.card_kit.plan import DONE, FAILED, SKIPPED, STOPPED, WAITING, Ended, Plan
from studies.harness import command
from studies.harness.catalogue import find_study
from studies.harness.run import run_study
from studies.harness.study import REPOSITORY
from tests.helpers.graphics import require_graphics


def _job(name: str, minutes: float, **others: object) -> Job:
    job = Job(name, "what?", (name,), minutes, "a guess", (name, "small"))
    return replace(job, **others)


@dataclass
class Machine:
    """A clock, and a runner that moves it on by the minutes that jobs take."""

    takes: dict[str, float]
    ends: dict[str, Ended] = field(default_factory=dict)
    lacks: tuple[str, ...] = ()
    now: float = 0.0
    ran: list[str] = field(default_factory=list)

    def clock(self) -> float:
        return self.now

    def has(self, need: str) -> Has:
        return Has(lacks=f"No {need}.") if need in self.lacks else Has(need)

    def run(self, words: Sequence[str], log: Path, minutes: float) -> Ended:
        (name, *_) = words
        self.ran.append(name)
        taken = min(self.takes[name], minutes)
        self.takes[name] -= taken
        self.now += 60 * taken
        return Ended(None) if self.takes[name] > 0 else self.ends.get(name, Ended(0))


Spend = Callable[..., dict[str, str]]


@pytest.fixture
def spend(tmp_path: Path) -> Spend:
    """Spends minutes on jobs of a machine; returns their states."""

    def spent(jobs: Sequence[Job], on: Machine, minutes: float, rehearses: bool = False) -> dict[str, str]:
        made = Plan(jobs, Places(tmp_path, tmp_path, tmp_path), rehearses)
        made.run(minutes, on.has, on.run, on.clock)
        written = json.loads((tmp_path / "state.json").read_text())["jobs"]
        assert {name: each["state"] for name, each in written.items()} == {
            name: each.state for name, each in made.standings.items()
        }
        return {name: each.state for name, each in made.standings.items()}

    return spent


def _says(folder: Path, job: str) -> str:
    return str(json.loads((folder / "state.json").read_text())["jobs"][job]["says"])


# ---------------------------------------------------------------------------------------- what fits, and when


def test_jobs_run_in_their_order_as_long_as_they_fit(spend: Spend, tmp_path: Path) -> None:
    jobs = [_job("a", 5), _job("b", 20), _job("c", 3)]
    on = Machine({"a": 4, "b": 20, "c": 2})
    assert spend(jobs, on, 10) == {"a": DONE, "b": WAITING, "c": DONE}
    assert on.ran == ["a", "c"]
    assert _says(tmp_path, "b") == "It takes 20 minutes, and 6.0 were left."
    # The next loan goes on with what is left, and does nothing twice.
    assert spend(jobs, on, 25) == {"a": DONE, "b": DONE, "c": DONE}
    assert on.ran == ["a", "c", "b"]


def test_a_training_takes_what_is_left_and_goes_on(spend: Spend, tmp_path: Path) -> None:
    jobs = [_job("frames", 5), _job("training", 100, resumes=True), _job("last", 1)]
    on = Machine({"frames": 5, "training": 40, "last": 1})
    states = spend(jobs, on, 30)
    assert (states["frames"], states["training"]) == (DONE, STOPPED)
    assert "goes on from there" in _says(tmp_path, "training")
    # It leaves the minutes that stopping takes, and is not begun for less than one.
    assert 24 < json.loads((tmp_path / "state.json").read_text())["jobs"]["training"]["minutes"] < 25
    assert spend(jobs, on, 0.5)["training"] == STOPPED
    assert on.ran.count("training") == 1
    assert spend(jobs, on, 30) == {"frames": DONE, "training": DONE, "last": DONE}
    assert on.ran.count("training") == 2
    assert json.loads((tmp_path / "state.json").read_text())["jobs"]["training"]["minutes"] == pytest.approx(
        40
    )


def test_a_job_that_hangs_leaves_minutes_to_others(spend: Spend) -> None:
    jobs = [_job("hangs", 2), _job("other", 5)]
    on = Machine({"hangs": 1e9, "other": 5})
    assert spend(jobs, on, 30) == {"hangs": FAILED, "other": DONE}


def test_a_job_that_fails_ends_no_other_and_is_tried_again(spend: Spend, tmp_path: Path) -> None:
    jobs = [_job("bad", 1), _job("missed", 1), _job("good", 1)]
    ends = {"bad": Ended(2, "studies: no such thing."), "missed": Ended(1, "missed: papers/x: a bar")}
    on = Machine({"bad": 1, "missed": 1, "good": 1}, ends)
    assert spend(jobs, on, 10) == {"bad": FAILED, "missed": DONE, "good": DONE}
    assert _says(tmp_path, "bad") == "studies: no such thing."
    assert _says(tmp_path, "missed") == "missed: papers/x: a bar"
    on.ends, on.takes["bad"] = {}, 1
    assert spend(jobs, on, 10)["bad"] == DONE
    assert on.ran == ["bad", "missed", "good", "bad"]


def test_jobs_are_skipped_where_the_machine_lacks_something(spend: Spend, tmp_path: Path) -> None:
    jobs = [
        _job("data", 1, needs=("disk",)),
        _job("training", 1, needs=("CUDA",)),
        _job("net", 1, after="data"),
    ]
    on = Machine({"data": 1, "training": 1, "net": 1}, lacks=("CUDA", "disk"))
    assert spend(jobs, on, 10) == {"data": SKIPPED, "training": SKIPPED, "net": SKIPPED}
    assert (on.ran, _says(tmp_path, "training")) == ([], "No CUDA.")
    assert _says(tmp_path, "net") == "It comes after data, which is not done."
    on.lacks = ("CUDA",)
    assert spend(jobs, on, 10) == {"data": DONE, "training": SKIPPED, "net": DONE}


def test_a_job_whose_command_changed_is_done_anew(spend: Spend) -> None:
    on = Machine({"a": 1})
    assert spend([_job("a", 1)], on, 10) == {"a": DONE}
    on.takes["a"] = 1
    assert spend([_job("a", 1, words=("a", "--more"))], on, 10) == {"a": DONE}
    assert on.ran == ["a", "a"]


@pytest.mark.parametrize("ends", [KeyboardInterrupt, SystemExit])
def test_an_interruption_is_kept_as_such(ends: type[BaseException], tmp_path: Path) -> None:
    def interrupted(words: Sequence[str], log: Path, minutes: float) -> Ended:
        running = json.loads((tmp_path / "state.json").read_text())["jobs"]["a"]
        assert (running["state"], running["says"]) == (STOPPED, "It was running.")
        raise ends

    made = Plan([_job("a", 1)], Places(tmp_path, tmp_path, tmp_path), False)
    with pytest.raises(ends):
        made.run(10, lambda need: Has(), interrupted)
    assert _says(tmp_path, "a") == "It was interrupted."


@pytest.mark.parametrize("text", ["", "[]", '{"jobs": 1}', '{"jobs": {"a": {"status": 1}}}'])
def test_a_damaged_state_is_refused(text: str, tmp_path: Path) -> None:
    (tmp_path / "state.json").write_text(text)
    with pytest.raises(InputError, match="does not hold the state of jobs"):
        Plan([], Places(tmp_path, tmp_path, tmp_path), False)


# ------------------------------------------------------------------------------------------------- processes

_MINUTES = 10.0
_COUNTS = """
import signal, sys, time
from pathlib import Path
if Path("count").exists():
    sys.exit("studies: done before.")
Path("count").touch()
{ignores}
open("ready", "w").close()
while True:
    time.sleep(60)
"""


@pytest.mark.parametrize(
    ("ignores", "asks"),
    [
        # What runs in a shell's background ignores interruptions from the start.
        ("signal.signal(signal.SIGINT, signal.default_int_handler)", [(signal.SIGINT, 60.0)]),
        ("signal.signal(signal.SIGINT, signal.SIG_IGN)", [(signal.SIGINT, 0.0), (signal.SIGTERM, 60.0)]),
    ],
    ids=["hears", "does not hear"],
)
def test_a_command_is_stopped_and_its_last_line_kept(
    ignores: str, asks: list[tuple[signal.Signals, float]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "counts.py").write_text(_COUNTS.format(ignores=ignores))
    os.mkfifo(tmp_path / "ready")
    monkeypatch.setattr(plan, "_ASKS", asks)
    waited: list[float | None] = []

    class Process(subprocess.Popen):  # type: ignore[type-arg]
        """Whose minutes are over as soon as it is ready."""

        def wait(self, timeout: float | None = None) -> int:
            waited.append(timeout)
            if len(waited) > 1:
                return super().wait(timeout)
            (tmp_path / "ready").read_bytes()
            raise subprocess.TimeoutExpired("counts", timeout or 0)

    monkeypatch.setattr(plan.subprocess, "Popen", Process)
    assert plan.run_words(["counts"], tmp_path / "log", _MINUTES, tmp_path).code is None
    assert waited[0] == 60 * _MINUTES
    ended = plan.run_words(["counts"], tmp_path / "log", _MINUTES, tmp_path)
    assert ended == Ended(1, "studies: done before.")


def test_a_job_ends_with_the_kit(tmp_path: Path) -> None:
    """Who ends the kit, as a machine that is taken away, ends what it runs."""
    (tmp_path / "counts.py").write_text(_COUNTS.format(ignores="import os; print(os.getpid(), flush=True)"))
    os.mkfifo(tmp_path / "ready")
    words = [["counts"], str(tmp_path / "log"), _MINUTES, str(tmp_path)]
    kit = (
        "import json, sys; from pathlib import Path; from studies.card_kit.plan import run_words;"
        "words, log, minutes, work = json.loads(sys.argv[1]);"
        "run_words(words, Path(log), minutes, Path(work))"
    )
    process = subprocess.Popen([sys.executable, "-c", kit, json.dumps(words)], cwd=REPOSITORY)
    (tmp_path / "ready").read_bytes()
    (job,) = (int(word) for word in (tmp_path / "log").read_text().split())
    watched = os.pidfd_open(job)
    process.terminate()
    assert process.wait(60) == 128 + signal.SIGTERM
    # Readable when the job has ended.
    assert select.select([watched], [], [], 60)[0] == [watched]
    os.close(watched)


# --------------------------------------------------------------------------------------------- the kit's jobs


@pytest.mark.parametrize("job", JOBS, ids=lambda job: job.name)
def test_jobs_are_commands_that_there_are(job: Job, tmp_path: Path) -> None:
    """Studies take their settings, recipes have the lines that the rehearsal changes, and needs are known."""
    places = Places(tmp_path / "records", tmp_path / "runs", tmp_path)
    for rehearses in (False, True):
        words = job.command(places, rehearses)
        assert not any("{" in word for word in words)
        if words[0] == "studies":
            study = find_study(words[1])
            options = command._parser([study]).parse_args(words[2:])
            command._settings(study, options, [study])
        else:
            assert importlib.util.find_spec(words[0]) is not None
    assert set(job.needs) <= set(NEEDS)
    earlier = [other.name for other in JOBS[: list(JOBS).index(job)]]
    assert not job.after or job.after in earlier
    assert job.minutes > 0
    if job.recipe is not None:
        assert job.small_recipe() != job.recipe.read_text(encoding="utf-8")


def test_the_plan_is_shown_without_minutes(capsys: pytest.CaptureFixture[str]) -> None:
    assert command.main(["card"]) == 0
    shown = capsys.readouterr().out
    assert all(f"| {job.name} | {job.minutes:g} |" in shown for job in JOBS)
    assert "state" not in shown


@pytest.mark.slow
def test_a_rehearsal_does_every_job(tmp_path: Path) -> None:
    """On whatever driver there is, by the processes that a card would run, at tiny sizes."""
    require_graphics()
    settings = card.CardSettings(rehearse=True, minutes=600)
    record = run_study(card.STUDY, settings, tmp_path / "out", tmp_path / "runs")
    states = {name: (each["state"], each["says"]) for name, each in record.figures["jobs"].items()}
    assert states == {job.name: (DONE, "") for job in JOBS}
    made = {file.stem for file in (tmp_path / "runs" / "small" / "records").rglob("*.json")}
    assert made == {"frames", "backends", "table2", "tables1-4"}


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["card", "--minutes", "20"], "--minutes 20 needs -o DIR, a folder for records."),
        (["card", "--jobs", "frames of cats"], "names with commas, of "),
    ],
    ids=["no folder", "no job"],
)
def test_faults(arguments: list[str], sentence: str, refused: Callable[..., str]) -> None:
    assert sentence in refused(arguments, command.main)


def test_what_ran_is_a_record_that_pages_show(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """On a machine without a card all that needs one is skipped, with the sentence, and the rest runs."""
    monkeypatch.setattr(card, "look_for", lambda need, rehearses: Has(lacks=f"No {need}."))
    ran: list[Sequence[str]] = []

    def run(words: Sequence[str], log: Path, minutes: float, work: Path) -> Ended:
        ran.append(words)
        return Ended(2, f"studies: {work}/queries.zarr is full.")

    monkeypatch.setattr(card, "run_words", run)
    settings = card.CardSettings(minutes=1000)
    record = run_study(card.STUDY, settings, tmp_path / "out", tmp_path / "runs")
    states = {name: each["state"] for name, each in record.figures["jobs"].items()}
    assert [words[0] for words in ran] == ["studies.papers.chen2024.data"]
    assert states["queries of chen2024"] == FAILED
    assert {states[job.name] for job in JOBS if job.needs} == {SKIPPED}
    assert str(tmp_path) not in json.dumps(record.figures)
    page = (tmp_path / "out" / "card.md").read_text()
    assert "| studies: runs/card/queries.zarr is full. |" in page


def test_a_rehearsal_takes_a_software_driver_and_a_run_does_not(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(machine, "in_own_process", lambda ask: ("llvmpipe", "", True))
    assert machine.look_for("graphics card", True) == Has("llvmpipe")
    assert "llvmpipe is a software driver" in machine.look_for("graphics card", False).lacks
    assert machine.look_for("CUDA for PyTorch", True).lacks == ""


def test_a_driver_that_crashes_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    def crashes(ask: Callable[[], object]) -> None:
        raise LoomlightError("adapter failed: Segmentation fault")

    monkeypatch.setattr(machine, "in_own_process", crashes)
    assert machine.look_for("graphics card", False) == Has(lacks="adapter failed: Segmentation fault")


@pytest.mark.parametrize("need", ["CUDA for Dr.Jit", "CUDA for PyTorch"])
def test_what_this_machine_lacks_is_a_sentence(need: str) -> None:
    name, lacks, is_software = NEEDS[need]()
    assert bool(name) != bool(lacks)
    assert not is_software
