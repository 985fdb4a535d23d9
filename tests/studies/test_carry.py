"""What is carried to a machine without a network, with an index of one made wheel, and without any.

Covers: studies/card_kit/carry.py
"""

from __future__ import annotations

import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from loomlight.core.errors import InputError
from studies import card
from studies.card_kit import carry as carrying
from studies.card_kit.carry import carry, requirements
from studies.harness.run import run_study

_METADATA = "Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n{more}"


@pytest.fixture
def checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A repository of one commit in the place of this one."""
    root = tmp_path / "checkout"
    (root / "src").mkdir(parents=True)
    (root / "src" / "code.py").write_text("x = 1\n")
    (root / ".gitignore").write_text("libraries\n")
    (root / "libraries").mkdir()
    (root / "libraries" / "a.wgsl").write_text("compiled")
    who = ["-c", "user.name=A", "-c", "user.email=a@b.c"]
    for words in (["init", "-q"], ["add", "."], [*who, "commit", "-qm", "one"]):
        subprocess.run(["git", "-C", root, *words], check=True)
    monkeypatch.setattr(carrying, "REPOSITORY", root)
    monkeypatch.setattr(carrying, "_GENERATED", ("libraries", "not made"))
    return root


@pytest.fixture
def no_network(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An index of two wheels, of which one requires the other, in the place of all others."""
    index = tmp_path / "index"
    index.mkdir()
    for name, more in (("first", "Requires-Dist: second\n"), ("second", "")):
        with zipfile.ZipFile(index / f"{name}-1.0-py3-none-any.whl", "w") as wheel:
            wheel.writestr(f"{name}-1.0.dist-info/METADATA", _METADATA.format(name=name, more=more))
            wheel.writestr(f"{name}-1.0.dist-info/WHEEL", "Wheel-Version: 1.0\nTag: py3-none-any\n")
            wheel.writestr(f"{name}-1.0.dist-info/RECORD", "")
    monkeypatch.setenv("PIP_NO_INDEX", "1")
    monkeypatch.setenv("PIP_FIND_LINKS", str(index))
    return index


def test_all_is_gathered(checkout: Path, no_network: Path, tmp_path: Path) -> None:
    runs, kit = tmp_path / "runs", tmp_path / "kit"
    for name in ("queries.zarr", "shipped/pool-1", "shipped/other"):
        (runs / "card" / name).mkdir(parents=True)
        (runs / "card" / name / "data").write_text("data")
    for _ in range(2):  # again over what is there
        found = carry(kit, runs, "3.12", wanted=["first"])
        assert (found["wheels"], found["data"]) == (2, ["queries.zarr", "shipped"])
        files = {file.relative_to(kit).as_posix() for file in kit.rglob("*") if ".git/" not in str(file)}
        assert files >= {
            "README.md",
            "wheels/first-1.0-py3-none-any.whl",
            "wheels/second-1.0-py3-none-any.whl",
            "loomlight/src/code.py",
            "loomlight/libraries/a.wgsl",
            "runs/card/queries.zarr/data",
            "runs/card/shipped/pool-1/data",
        }
        assert "runs/card/shipped/other" not in files
    readme = (kit / "README.md").read_text()
    assert "python3.12 -m venv" in readme
    assert str(tmp_path) not in readme
    # Records of the clone name the commit's sources.
    head = [
        subprocess.run(["git", "-C", place, "rev-parse", "HEAD:src"], capture_output=True, check=True).stdout
        for place in (checkout, kit / "loomlight")
    ]
    assert head[0] == head[1]


def test_without_a_network_one_sentence_says_so(checkout: Path, no_network: Path, tmp_path: Path) -> None:
    with pytest.raises(
        InputError, match=r"^Wheels for Python 3.11 cannot be downloaded, which needs a .*third"
    ):
        carry(tmp_path / "kit", tmp_path / "runs", "3.11", wanted=["third"])
    assert not (tmp_path / "kit" / "README.md").exists()


def test_changes_that_are_not_committed_are_not_carried(checkout: Path, tmp_path: Path) -> None:
    (checkout / "src" / "code.py").write_text("x = 2\n")
    with pytest.raises(InputError, match="Changes are not committed"):
        carry(tmp_path / "kit", tmp_path / "runs", "3.11", wanted=[])
    (tmp_path / "file").touch()
    with pytest.raises(InputError, match="cannot be filled"):
        carry(tmp_path / "file", tmp_path / "runs", "3.11", wanted=[])


@pytest.mark.parametrize(
    ("wheel", "says"),
    [
        ("torch-2.13.0+cpu-cp311-cp311-linux_x86_64.whl", "without CUDA"),
        ("torch-2.13.0-cp311-cp311-manylinux_2_28_x86_64.whl", "2.13.0"),
        ("torchless-1.0-py3-none-any.whl", "none"),
    ],
)
def test_a_build_without_cuda_is_said(wheel: str, says: str, tmp_path: Path) -> None:
    (tmp_path / wheel).touch()
    assert says in carrying._torch_of(tmp_path)


def test_what_jobs_import_is_required() -> None:
    names = {word.split(">")[0].split("=")[0].split("<")[0] for word in requirements()}
    assert names >= {"mitsuba", "drjit", "torch", "wgpu", "zarr", "onnx", "llvmlite", "hatchling"}


def test_the_command_carries(
    checkout: Path, no_network: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(carrying, "requirements", lambda: ["second"])
    settings = card.CardSettings(carry=tmp_path / "kit", python=f"3.{sys.version_info.minor}")
    record = run_study(card.STUDY, settings, runs=tmp_path / "runs")
    shown = card.tables(record.figures)[1]
    assert (shown.rows["wheels"], shown.rows["data"]) == ([1], ["none"])
