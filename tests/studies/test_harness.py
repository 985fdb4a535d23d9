"""The harness of studies: what it lists, runs, keeps, resumes and refuses, and what it finds to be old.

Covers: studies/harness/study.py, studies/harness/parts.py, studies/harness/record.py
Covers: studies/harness/catalogue.py, studies/harness/changes.py
Covers: studies/harness/run.py, studies/harness/page.py, studies/harness/probes.py, studies/harness/stale.py
Covers: studies/harness/command.py, studies/__main__.py
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from studies.harness import catalogue as catalogues
from studies.harness import command, probes
from studies.harness import stale as staleness
from studies.harness.catalogue import Declared, catalogue, find_study
from studies.harness.changes import changes, changes_text
from studies.harness.command import main
from studies.harness.parts import Parts
from studies.harness.record import REPOSITORY, read_record
from studies.harness.run import run_study
from studies.harness.stale import stale
from studies.harness.study import Figures, Found, Run, Study, listed, listed_numbers, names

NAME = "accuracy/thirds"


@dataclass(frozen=True, kw_only=True)
class Thirds(Settings):
    """Settings of every kind."""

    counts: str = names("one,two", "Which.", ("one", "two", "three"))
    scale: float = setting(1.0, "Factor.", low=0, high=10)
    size: tuple[int, int] = setting((4, 3), "Pixels.")
    whole: bool = setting(False, "Whole numbers alone.")
    file: os.PathLike[str] | None = setting(None, "A file.")


class Counted:
    """A study that counts how often each part is made, and can be interrupted before one."""

    def __init__(self) -> None:
        self.made: list[str] = []
        self.stops_before = ""

    def measure(self, settings: Thirds, run: Run) -> Found:
        def part(name: str) -> Callable[[], float]:
            def make() -> float:
                if name == self.stops_before:
                    raise KeyboardInterrupt
                self.made.append(name)
                return settings.scale / 3

            return make

        found = run.each({name: part(name) for name in listed(settings.counts)})
        picture = np.zeros((*settings.size, 3), np.uint8)
        missed = ["more than two"] if settings.scale > 2 else []
        return Found({"thirds": found, "missed": missed}, picture, {"Over × far": picture})


def tables(figures: Figures) -> list[Table]:
    return [Table("Thirds", ["value"], {name: [value] for name, value in figures["thirds"].items()})]


@pytest.fixture
def counted() -> Counted:
    return Counted()


@pytest.fixture
def study(counted: Counted, monkeypatch: pytest.MonkeyPatch) -> Study[Thirds]:
    """A study that is in the catalogue, and stands on one probe, `now`."""
    made = Study(
        NAME,
        "thirds of numbers",
        Thirds(),
        counted.measure,
        tables,
        stands_on=("now",),
        small={"counts": "one"},
    )
    now = probes.Probe("what there is now", lambda: np.array([1.0, 2.0]))
    monkeypatch.setitem(probes.PROBES, "now", now)
    outputs = {"now": [1.0, 2.0]}
    for module in ("studies.harness.run.probed", "studies.harness.stale.probed"):
        monkeypatch.setattr(module, lambda asked: {name: outputs[name] for name in asked})
    known = {NAME: Declared(NAME, "thirds of numbers", __name__)}
    for place in (command, staleness):
        monkeypatch.setattr(place, "catalogue", lambda: known)
        monkeypatch.setattr(place, "find_study", lambda name: made)
    return made


# ----------------------------------------------------------------------------------------------- what is kept


def test_the_record_the_page_and_the_pictures_are_written(study: Study[Thirds], tmp_path: Path) -> None:
    folder = tmp_path / "new"
    run_study(study, Thirds(scale=2.0), folder)
    record = read_record(folder / f"{NAME}.json")
    assert record.figures == {"thirds": {"one": 0.666667, "two": 0.666667}, "missed": []}
    assert record.command == "python -m studies accuracy/thirds --scale 2.0"
    assert record.settings == {"scale": 2.0}
    assert record.stands_on == {"now": [1, 2]}
    assert record.processor_seconds is not None
    assert record.sources
    assert record.machine
    page = (folder / f"{NAME}.md").read_text()
    assert "| one | 0.667 |" in page
    assert "(thirds/over-x-far.png)" in page
    assert record.command in page
    assert (__doc__ or "").strip() in page
    left = {file.relative_to(folder / "accuracy").as_posix() for file in folder.rglob("*") if file.is_file()}
    assert left == {"thirds.json", "thirds.md", "thirds.png", "thirds/over-x-far.png"}


def test_commands_name_no_folder_of_the_machine(study: Study[Thirds], tmp_path: Path) -> None:
    (tmp_path / "a draft.wif").touch()
    for file, word in (
        (tmp_path / "a draft.wif", "'a draft.wif'"),
        (REPOSITORY / "examples" / "denim.toml", "examples/denim.toml"),
    ):
        record = run_study(study, Thirds(file=file, size=(2, 8), whole=True))
        assert record.command.endswith(f"--size 2x8 --whole true --file {word}")


def test_an_interrupted_run_goes_on_where_it_stopped(
    study: Study[Thirds], counted: Counted, tmp_path: Path
) -> None:
    counted.stops_before = "two"
    with pytest.raises(KeyboardInterrupt):
        run_study(study, Thirds(), tmp_path)
    counted.stops_before = ""
    # Other settings find nothing made; their parts take the place of the former.
    run_study(replace(study, name="accuracy/other"), Thirds(scale=2), tmp_path)
    assert counted.made == ["one", "one", "two"]
    record = run_study(study, Thirds(), tmp_path)
    assert counted.made == ["one", "one", "two", "two"]
    assert record.figures["thirds"] == {"one": 1 / 3, "two": 1 / 3}
    assert not list(tmp_path.rglob("*.parts"))


def test_parts_of_another_run_are_not_taken(tmp_path: Path) -> None:
    file = tmp_path / "a.parts"
    Parts(file, {"scale": 1}).kept("one", lambda: np.float32(0.5))
    assert len(Parts(file, {"scale": 1})) == 1
    assert len(Parts(file, {"scale": 2})) == 0
    assert Parts(file, {"scale": 1}).kept("one", lambda: pytest.fail("made anew")) == 0.5
    for broken in ("", "[]", "{", '{"of": {"scale": 1}, "parts": 3}'):
        file.write_text(broken)
        assert len(Parts(file, {"scale": 1})) == 0


def test_a_folder_that_cannot_be_written_is_left_as_it_is(study: Study[Thirds], tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.touch()
    with pytest.raises(InputError, match="cannot be made a folder"):
        run_study(study, Thirds(), file)


# --------------------------------------------------------------------------------------------- what is listed


def test_a_list_names_every_study_and_loads_none(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 0
    lines = capsys.readouterr().out.splitlines()
    names = [line.split()[0] for line in lines]
    assert names == list(catalogue())
    assert names.index("papers/kuznetsov2021/fig5") < names.index("papers/kuznetsov2021/fig10")
    loaded = (
        "import sys, studies.harness.command as c; c.main([]);"
        "sys.exit(bool({'drjit', 'mitsuba', 'torch'} & {*sys.modules}))"
    )
    assert subprocess.run([sys.executable, "-c", loaded], cwd=REPOSITORY, check=False).returncode == 0


@pytest.mark.parametrize("name", list(catalogue()))
def test_names_are_those_of_folders(name: str) -> None:
    """`accuracy/brightness` is declared below studies/accuracy."""
    module = catalogue()[name].module.removeprefix("studies.").replace(".", "/")
    assert name.rpartition("/")[0] == module.rpartition("/")[0]


def test_a_study_that_no_name_of_its_module_holds_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(catalogues, "catalogue", lambda: {NAME: Declared(NAME, "", __name__)})
    with pytest.raises(ValueError, match="no name of the module holds it"):
        find_study(NAME)


# ------------------------------------------------------------------------------------------- the command line


def test_the_command_changes_settings(
    study: Study[Thirds], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["--scale", "2", "--size", "3x2", "--whole", "--file", "a.toml", "--counts", "three"]
    assert main([NAME, "-o", str(tmp_path), *words]) == 0
    shown = capsys.readouterr().out
    assert "| three | 0.667 |" in shown
    assert shown.endswith(f"{tmp_path / NAME}.json\n")
    written = json.loads((tmp_path / f"{NAME}.json").read_text())
    assert written["settings"] == {
        "counts": "three",
        "scale": 2.0,
        "size": [3, 2],
        "whole": True,
        "file": "a.toml",
    }


def test_small_runs_are_small(study: Study[Thirds], counted: Counted) -> None:
    assert main([NAME, "--small", "--scale", "2"]) == 0
    assert counted.made == ["one"]


def test_missed_bars_end_with_1_after_the_record_is_written(
    study: Study[Thirds], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([NAME, "--scale", "3", "-o", str(tmp_path)]) == 1
    assert capsys.readouterr().err == "missed: accuracy/thirds: more than two\n"
    assert (tmp_path / f"{NAME}.json").is_file()


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["accuracy/none"], '"accuracy/none" is no study: '),
        (["accuracy/irregularity", "--colour", "1"], "unrecognized arguments: --colour 1"),
        (["accuracy/irregularity", "--parts", "some"], "give names with commas, of statistics"),
        (["accuracy/irregularity", "-o", "a/b/table.json"], "cannot be made a folder"),
        (["accuracy/irregularity", "--small", "-o"], "expected one argument"),
        (["--stale", "-o", "a"], "a/broken.json holds no record of a study"),
        (["--stale", "-o", "moved"], "must lie at accuracy/thirds.json"),
    ],
    ids=["no study", "no setting", "no choice", "no folder", "no value", "no record", "moved record"],
)
def test_faults(
    arguments: list[str],
    sentence: str,
    refused: Callable[..., str],
    study: Study[Thirds],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for place in (command, staleness):
        monkeypatch.setattr(place, "catalogue", catalogue)
        monkeypatch.setattr(place, "find_study", find_study)
    monkeypatch.setattr("studies.harness.run.probed", lambda asked: {})
    for folder in ("a", "moved"):
        Path(folder).mkdir()
    Path("a/b").touch()
    Path("a/broken.json").write_text("{}")
    run_study(study, folder=Path("moved"))
    Path("moved/accuracy/thirds.json").rename("moved/thirds.json")
    assert sentence in refused(arguments, main)


def test_a_package_that_is_not_installed_is_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def imports(name: str) -> None:
        raise ModuleNotFoundError(f"No module named {name}", name="torch")

    monkeypatch.setattr(command, "find_study", imports)
    assert main(["accuracy/irregularity"]) == 2
    assert capsys.readouterr().err.startswith("studies: torch is needed and not installed; `pip install")


# ------------------------------------------------------------------------------------------------ what is old


def test_records_are_old_when_what_they_stand_on_has_moved(
    study: Study[Thirds], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    run_study(study, folder=tmp_path)
    assert stale(tmp_path) == {}
    # Rounding is no change, and a twentieth is.
    monkeypatch.setattr(staleness, "probed", lambda asked: {"now": [1.0, 2.0001]})
    assert stale(tmp_path) == {}
    monkeypatch.setattr(staleness, "probed", lambda asked: {"now": [1.0, 2.1]})
    assert stale(tmp_path) == {NAME: "what there is now changed, by up to 4.8 %"}
    # The command says so and fails nothing.
    assert main(["--stale", "-o", str(tmp_path)]) == 0
    line, count = capsys.readouterr().out.splitlines()
    assert line.split() == [NAME, *stale(tmp_path)[NAME].split()]
    assert count == "1 of 1 records are older than what they stand on."


def test_records_without_outputs_of_probes_are_old(study: Study[Thirds], tmp_path: Path) -> None:
    record = run_study(study, folder=tmp_path)
    replace(record, stands_on={}).write(tmp_path)
    assert stale(tmp_path) == {NAME: "made before records kept now"}
    replace(record, study="accuracy/gone").write(tmp_path)
    assert stale(tmp_path)["accuracy/gone"] == "no study has this name"


def test_probes_that_are_gone_or_hashes_that_differ_are_changes(monkeypatch: pytest.MonkeyPatch) -> None:
    assert probes.moved("gone", [1.0], [1.0]) == float("inf")
    assert probes.moved("network", [5.0], [6.0]) == float("inf")
    assert probes.moved("network", [5.0], [5.0]) is None
    assert probes.moved("lobes", [1.0], [1.0, 2.0]) == float("inf")
    # What is small beside the rest may round.
    assert probes.moved("lobes", [1.0, 1e-6], [1.0, 2e-6]) is None


@pytest.mark.parametrize("name", ["point", "mesh", "network"])
def test_probes_give_the_same_numbers_again(name: str) -> None:
    """In two processes; the others take seconds each."""
    one, other = (probes.probed([name])[name] for _ in range(2))
    assert probes.moved(name, one, other) is None
    assert len(one) > 0


# ------------------------------------------------------------------------------------------- what has changed


def test_a_run_is_compared_with_a_record(
    study: Study[Thirds], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run_study(study, Thirds(counts="three"), tmp_path)
    assert main([NAME, "--counts", "three", "--against", str(tmp_path)]) == 0
    assert "None of 1 figures differs by more than 1 %." in capsys.readouterr().out
    assert main([NAME, "--counts", "one", "--against", str(tmp_path)]) == 2
    sentence = (
        "was made with other settings, by python -m studies accuracy/thirds --counts three; give the same."
    )
    assert sentence in capsys.readouterr().err


def test_changes_are_named_by_their_places_the_largest_first() -> None:
    before = {"rows": [{"error": 0.5, "name": "a"}, {"error": 1.0}], "gone": 1, "same": 2.0}
    now = {"rows": [{"error": 0.52, "name": "b"}, {"error": 2.0}], "same": 2.001}
    assert [str(change) for change in changes(before, now)] == [
        "rows.0.name: a → b",
        "gone: 1 → nothing",
        "rows.1.error: 1 → 2 (+100 %)",
        "rows.0.error: 0.5 → 0.52 (+4 %)",
    ]
    text = changes_text({"of": [1.0] * 30}, {"of": [2.0] * 30})
    assert text.startswith("30 of 30 figures differ by more than 1 %:")
    assert text.endswith("… and 10 more")


def test_lists_with_commas() -> None:
    assert listed(" a, b,,") == ["a", "b"]
    assert listed_numbers("--side", "1, 2.5") == [1, 2.5]
    with pytest.raises(InputError, match="--side"):
        listed_numbers("--side", "1,b")
