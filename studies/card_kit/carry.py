"""Gathers in a folder what a bare machine without a network needs to run the kit.

A clone of this checkout at its last commit, with shaders compiled; wheels of what jobs import, for the Python
and the system of that machine; data of trainings where they were made here; and a README with the commands.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tomllib
from collections.abc import Callable, Sequence
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.files import replacing
from studies.harness.study import REPOSITORY, Figures

# Extras of pyproject.toml that jobs import, and the builder of the editable installation with what it needs.
EXTRAS = ("neural", "train", "data", "realtime")
BUILDS = ("hatchling", "editables", "pip", "setuptools", "wheel")
# What `pip` takes wheels for: Linux on x86-64 as cards are lent, by the age of its C library.
PLATFORMS = ("manylinux_2_28_x86_64", "manylinux_2_27_x86_64", "manylinux2014_x86_64", "linux_x86_64")
CHECKOUT, WHEELS, RUNS = "loomlight", "wheels", "runs"
# Generated files that git does not keep.
_GENERATED = ("src/loomlight/realtime/shaders/libraries",)

README = """# loomlight on a graphics card

Commands of this folder; none needs a network. They need Python {python}, Linux on x86-64, git, an
NVIDIA driver, and for frames Vulkan's loader (Debian, Ubuntu: libvulkan1) and the driver's manifest for it.

    python{python} -m venv venv
    venv/bin/pip install --no-index --find-links wheels -e "./loomlight[{extras}]"
    (cd loomlight && ../venv/bin/python -m studies card --minutes 28 -o ../out --runs ../runs)

The last one goes on when it runs again. Bring back `out` and `runs`: records of `out` go to
`studies/records`, and `python -m tools.generate.figures` writes them into pages. Of commit {commit}.
{data}"""


def requirements() -> list[str]:
    """What is downloaded: dependencies of the package and of `EXTRAS`, and `BUILDS`."""
    project = tomllib.loads((REPOSITORY / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = project["optional-dependencies"]
    found = [*project["dependencies"], *(each for name in EXTRAS for each in extras[name]), *BUILDS]
    return list(dict.fromkeys(found))


def carry(
    folder: Path,
    runs: Path,
    python: str,
    report: Callable[[int, int], None] = lambda done, total: None,
    wanted: Sequence[str] | None = None,
) -> Figures:
    """Gathers it all; what the folder holds already is kept, and wheels that are there are not fetched again.

    Args:
        runs: the folder of trainings, whose data are copied.
        python: version of the other machine's, such as 3.11.
        wanted: requirements; by default `requirements()`.

    Raises:
        InputError: the folder cannot be written, changes are not committed, or wheels cannot be had.
    """
    steps: list[Callable[[], object]] = [
        lambda: _clone(folder / CHECKOUT),
        lambda: _download(folder / WHEELS, python, requirements() if wanted is None else wanted),
        lambda: _copy_data(runs, folder / RUNS),
    ]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for number, step in enumerate(steps):
            step()
            report(number + 1, len(steps))
        data = sorted(each.name for each in (folder / RUNS / "card").glob("*"))
        text = README.format(
            python=python,
            extras=",".join(EXTRAS),
            commit=_git(REPOSITORY, "rev-parse", "--short=12", "HEAD"),
            data=f"\nData that are carried: {', '.join(data)}.\n" if data else "",
        )
        with replacing(folder / "README.md") as temporary:
            temporary.write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError(f"{folder} cannot be filled: {error}.") from error
    files = [file for file in folder.rglob("*") if file.is_file()]
    return {
        "commit": _git(REPOSITORY, "rev-parse", "--short=12", "HEAD"),
        "wheels": len(list((folder / WHEELS).glob("*.whl"))),
        "PyTorch": _torch_of(folder / WHEELS),
        "data": data,
        "megabytes": round(sum(file.stat().st_size for file in files) / 1e6, 1),
    }


def _clone(place: Path) -> None:
    """A clone at the last commit, so that records name their sources."""
    if _git(REPOSITORY, "status", "--porcelain", "--untracked-files=no"):
        raise InputError("Changes are not committed, and a commit is carried: commit them first.")
    if place.exists():
        shutil.rmtree(place)
    _git(REPOSITORY.parent, "clone", "--quiet", "--depth", "1", REPOSITORY.as_uri(), str(place))
    for name in _GENERATED:
        if (REPOSITORY / name).is_dir():
            shutil.copytree(REPOSITORY / name, place / name, dirs_exist_ok=True)


def _git(folder: Path, *words: str) -> str:
    done = subprocess.run(["git", "-C", str(folder), *words], capture_output=True, text=True, check=False)
    if done.returncode:
        raise InputError(f"git {words[0]} fails: {_last(done.stderr)}")
    return done.stdout.strip()


def _download(place: Path, python: str, wanted: Sequence[str]) -> None:
    """Wheels and all that they require."""
    words = [
        *(sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check"),
        *("--dest", str(place), "--find-links", str(place), "--only-binary", ":all:"),
        *("--python-version", python, "--implementation", "cp"),
        *(word for platform in PLATFORMS for word in ("--platform", platform)),
    ]
    place.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([*words, *wanted], capture_output=True, text=True, check=False)
    if done.returncode:
        raise InputError(
            f"Wheels for Python {python} cannot be downloaded, which needs a network: {_last(done.stderr)}"
        )


def _torch_of(wheels: Path) -> str:
    """The version of PyTorch among wheels, and whether it can use a card."""
    version = next((wheel.name.split("-")[1] for wheel in wheels.glob("torch-*.whl")), "none")
    if version.endswith("cpu"):
        return f"{version}, a build without CUDA: trainings on a card will be skipped; give pip another index"
    return version


def _copy_data(runs: Path, place: Path) -> None:
    """Data that trainings begin with, of this folder of trainings."""
    for source in sorted((runs / "card").glob("queries.zarr")) + sorted((runs / "card").glob("*/pool-*")):
        copy = place / source.relative_to(runs)
        shutil.copytree(source, copy, dirs_exist_ok=True)


def _last(text: str) -> str:
    """The last line that says what is wrong."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    errors = [line for line in lines if line.startswith("ERROR:")] or lines
    return errors[-1].removeprefix("ERROR: ")[:300] if errors else "it says nothing."
