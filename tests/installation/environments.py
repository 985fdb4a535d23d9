"""Environments of the wheel alone and of each extra beside it, and what every command does in them.

`python -m tests.installation.environments` prints the matrix; --python names another interpreter to make them
with, which then does without `train`, as torch is borrowed from the environment that this runs in.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from importlib.metadata import PackageNotFoundError, distribution, requires
from pathlib import Path
from typing import Any

from loomlight.core.extras import EXTRAS, installing, required_packages
from tests.limits import HANG

ROOT = Path(__file__).resolve().parents[2]
_CONSTRAINTS = ROOT / "constraints.txt"
_DRIVER = Path(__file__).with_name("driver.py")
# What a checkout needs for its wheel, beside what hatch and node make.
_SOURCES = (
    "src",
    "web",
    "examples",
    "integrations",
    "pyproject.toml",
    "hatch_build.py",
    "README.md",
    "LICENSE",
)
BASE, NO_SLANGC = "base", "no slangc"

_SERVE = """
import re, subprocess, sys, urllib.request
from loomlight.core.errors import LoomlightError

command = [sys.executable, "-I", "-m", "loomlight", "view", "plain", "--no-browser", "--port", "0"]
with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as server:
    address = re.search(r"http://[^ ]+", server.stdout.readline())
    if address is None:
        raise LoomlightError(server.stderr.read().removeprefix("loomlight: ").strip())
    try:
        for place in ("", "api/session"):
            assert urllib.request.urlopen(address[0] + place).read()
    finally:
        server.terminate()  # an interruption is ignored by what a shell starts in the background
    server.communicate()
"""
_WIDGET = """
import loomlight
widget = loomlight.view("plain")
assert widget.fabric.name == "plain"
"""

_QUAD = """#usda 1.0
( metersPerUnit = 1 )
def Mesh "cloth" {
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] ( interpolation = "vertex" )
}
"""


@dataclass(frozen=True)
class Case:
    """Something that is tried in environments.

    Attributes:
        words: a command line of `loomlight`; "" for a program.
        needs: packages of extras without which it ends in a sentence.
        extra: that the sentence names, or several that it may name.
        sentence: a pattern of another one that it may end in, such as where a machine has no display.
        only: environments in which it is tried; all if empty.
        reads: a file that `train` has written: the case is left out where that was not tried.
        program: Python in place of a command line.
        module: of a checkout, with its arguments, in place of a command line.
    """

    words: str = ""
    needs: tuple[str, ...] = ()
    extra: tuple[str, ...] = ()
    sentence: str = ""
    only: tuple[str, ...] = ()
    program: str = ""
    module: str = ""
    name: str = ""
    reads: str = ""

    @property
    def label(self) -> str:
        """What it is called in the matrix."""
        return self.name or self.words or self.module

    def for_driver(self) -> dict[str, Any]:
        """The arguments of the driver's `answer`."""
        if self.program:
            return {"program": self.program}
        if self.module:
            return {"python": [str(_DRIVER), "--module", str(ROOT), *self.module.split()]}
        return {"words": self.words.split()}


_NO_ADAPTER = "adapter"
_SHADER_LANGUAGES = ("hlsl", "glsl", "spirv", "metal", "cuda")
# Every command of `loomlight --help`, and what README's table promises for each extra. What no extra changes
# and takes seconds is tried once.
CASES = (
    Case("doctor"),
    Case("weave names"),
    Case("weave info plain"),
    Case("weave show plain -o draft.png"),
    Case("weave convert plain -o plain.wif"),
    Case("weave threading plain"),
    Case("weave print plain -o plain.pdf", ("reportlab",), ("print",)),
    Case("render plain -o flat.png --scene flat --size 32x24 --spp 1"),
    Case("swatches plain -o sheet.png --size 32 --spp 1"),
    Case("bake plain --model lobes -o lobes.loom"),
    Case("bake-maps plain -o maps.png --resolution 16"),
    Case("export plain --to slang -o slang"),
    Case("export plain --to wgsl -o wgsl", sentence="Compiling shaders needs slangc"),
    Case("view plain --export site"),
    Case("demo -o demo.png --spp 1", only=(BASE,)),
    Case("compare plain -o report --models point,lobes --scenes sphere --size 16x9 --spp 1", only=(BASE,)),
    Case("export plain --to gltf -o gltf", only=(BASE,)),
    Case("export plain --to blender-addon -o addon", only=(BASE,)),
    Case("export plain --to u3m -o u3m", only=(BASE,)),
    Case("export plain --to godot -o godot", only=(BASE,)),
    *(Case(f"export plain --to {name} -o {name}", only=(BASE,)) for name in _SHADER_LANGUAGES),
    Case("export plain --to materialx -o materialx", ("materialx",), ("materialx",)),
    Case("export plain --to usd -o usd", ("usd-core", "materialx"), ("usd,materialx",)),
    Case("render plain -o mesh.png --mesh quad.gltf --size 32x24 --spp 1", ("meshopt",), ("meshopt",)),
    Case("render plain -o stage.png --mesh quad.usda --size 32x24 --spp 1", ("usd-core",), ("usd",)),
    Case("play plain -o frame.png --size 32x24 --passes 1", ("wgpu",), ("realtime",), _NO_ADAPTER),
    Case("play plain", ("rendercanvas",), ("realtime",), "no display|no window library"),
    Case(program=_SERVE, needs=("uvicorn",), extra=("viewer",), name="view plain"),
    Case(program=_WIDGET, needs=("anywidget",), extra=("notebook",), name='loomlight.view("plain")'),
    Case("swatches plain -o a.html --size 32 --spp 1 --executor slurm:local", ("submitit",), ("fleet",)),
    Case("swatches plain -o b.html --size 32 --spp 1 --executor joblib", ("joblib",), ("fleet",)),
    Case(
        module="studies.papers.chen2024.data -o data.zarr --materials 0:1 --queries 1024",
        needs=("zarr",),
        extra=("data",),
    ),
    Case(
        "bake plain --model neumip --set steps=10 --set resolution=8 -o neumip.loom", ("torch",), ("train",)
    ),
    Case(
        "bake plain --model latent --set steps=10 --set resolution=8 -o latent.loom", ("torch",), ("train",)
    ),
    Case("bake plain --model neural -o neural.loom", ("llvmlite", "onnxruntime"), ("neural",)),
    Case("export plain --to onnx -o network", ("llvmlite", "onnxruntime"), ("neural",)),
    Case(
        "export latent.loom --to onnx -o decoder",
        ("llvmlite", "onnx"),
        ("networks", "train"),
        reads="latent.loom",
    ),
    *(
        Case(words, ("llvmlite",), ("networks",), reads=f"{name}.loom")
        for name in ("neumip", "latent")
        for words in (
            f"render {name}.loom -o loom.png --scene flat --size 32x24 --spp 1",
            f"export {name}.loom --to slang -o {name}",
        )
    ),
)


@dataclass
class Environment:
    """An environment, and what it cost.

    Attributes:
        name: an extra, or `BASE` or `NO_SLANGC`.
        python: its interpreter.
        megabytes: on disk; of an extra what it adds.
        seconds: that pip took.
        packages: of extras that it has.
        faults: what is not as it should be.
        outcomes: by case: works, or the sentence that it ended in.
    """

    name: str
    python: Path
    megabytes: float
    seconds: float
    packages: set[str]
    faults: list[str] = field(default_factory=list)
    outcomes: dict[str, str] = field(default_factory=dict)


class UnreachableError(Exception):
    """The registry of packages cannot be reached; the message is the last line of pip."""


def installations(folder: Path, python: str = sys.executable) -> Iterator[Environment]:
    """Makes environments of this checkout one after the other, and tries every case in each.

    Args:
        folder: a new one, for everything.
        python: what the environments are made with.

    Raises:
        UnreachableError: packages cannot be installed here.
    """
    from tests.mitsuba.test_gltf import write_compressed_quad

    required = required_packages()
    work = folder / "work"
    work.mkdir()
    write_compressed_quad(work)
    (work / "quad.usda").write_text(_QUAD)
    builder = _checkout_copy(folder)
    base = _venv(folder / BASE, python)
    _require_registry(base, folder)
    wheel = _build(builder, folder / "dist")
    seconds = _pip(base, str(wheel))
    alone = Environment(BASE, base, _megabytes(folder / BASE), seconds, set())
    # First the one that bakes materials, which the others read.
    for extra in ["train", BASE, *(name for name in EXTRAS if name != "train")]:
        if extra == "train" and python != sys.executable:
            continue
        if extra == BASE:
            yield tried(alone, work)
            continue
        place = folder / extra
        copy = _copied(folder / BASE, place)
        if extra == "train":
            _borrow_torch(copy)
        seconds = _pip(copy, *_requirements(extra))
        own = _megabytes(place, beside=folder / BASE)
        yield tried(Environment(extra, copy, own, seconds, set(required[extra])), work)
        shutil.rmtree(place)

    place = folder / NO_SLANGC
    copy = _copied(folder / BASE, place)
    without = _build(builder, folder / "without", shaders=False)
    seconds = _pip(copy, "--force-reinstall", "--no-deps", str(without))
    environment = tried(Environment(NO_SLANGC, copy, 0, seconds, set()), work)
    if "slangc" not in environment.outcomes["export plain --to wgsl -o wgsl"]:
        environment.faults.append("without slangc and shaders, shaders are exported")
    yield environment


def tried(environment: Environment, work: Path) -> Environment:
    """The environment with the outcomes of all its cases, run in the folder `work`."""
    here = [case for case in CASES if not case.only or environment.name in case.only]
    cases = [case for case in here if not case.reads or (work / case.reads).exists()]
    listed = work.parent / f"{environment.name}.json"
    listed.write_text(json.dumps([case.for_driver() for case in cases]), encoding="utf-8")
    command = [str(environment.python), "-I", str(_DRIVER), str(listed), str(work)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=HANG, env=_variables(environment))
    if done.returncode != 0:
        environment.faults.append(done.stderr[-2000:])
        return environment
    said = json.loads(done.stdout)
    if not Path(said["file"]).is_relative_to(environment.python.parents[1]):
        environment.faults.append(f"it runs {said['file']}, which is not installed there")
    for case, answer in zip(cases, said["answers"], strict=True):
        outcome, fault = _judged(case, environment, **answer)
        environment.outcomes[case.label] = outcome
        if fault:
            environment.faults.append(f"{case.label}: {fault}")
    return environment


def _judged(
    case: Case, environment: Environment, code: int | str, out: str, err: str
) -> tuple[str, str | None]:
    """What a case came to, and what is wrong with that."""
    lines = [line for line in err.splitlines() if "warning:" not in line]
    has_all = set(case.needs) <= environment.packages
    if case.label == "doctor" and code == 0:
        return "works", _fault_of_doctor(environment, out)
    if code == 0:
        return "works", None if has_all else f"it works without {', '.join(case.needs)}"
    if code != 2 or not lines or not lines[-1].startswith("loomlight: "):
        return "fails", f"exit code {code}: {err[-2000:]}"
    sentence = lines[-1].removeprefix("loomlight: ")
    if case.sentence and re.search(case.sentence, sentence):
        return sentence, None
    if any(installing(extra) in sentence for extra in case.extra) and not has_all:
        return sentence, None
    return sentence, f"it ends in: {sentence}"


def _fault_of_doctor(environment: Environment, out: str) -> str | None:
    """What the doctor says of extras that is not so."""
    for extra, packages in required_packages().items():
        if extra in EXTRAS:
            found = re.search(rf"^(\w+) +\[{extra}\]", out, re.MULTILINE)
            mark = "ok" if set(packages) <= environment.packages else "none"
            if found is None or found[1] != mark:
                return f"of [{extra}] it should say {mark}: {out}"
    return None


def _requirements(extra: str) -> list[str]:
    """What pip is asked for: the extra, as README writes it; of `train` all but torch, which is borrowed."""
    if extra != "train":
        return [f"loomlight[{extra}]"]
    lines = [line for line in requires("loomlight") or () if re.search(r"extra == .train.", line)]
    return [line.partition(";")[0].strip() for line in lines if not line.startswith("torch")]


def _variables(environment: Environment) -> dict[str, str]:
    """The variables of this process, without those that lead to other packages, a display or a cache."""
    left_out = {"PYTHONPATH", "DISPLAY", "WAYLAND_DISPLAY", "LOOMLIGHT_SLANGC", "VIRTUAL_ENV"}
    kept = {name: value for name, value in os.environ.items() if name not in left_out}
    # What one environment has computed is not there for the next.
    kept["XDG_CACHE_HOME"] = str(environment.python.parents[1] / "cache")
    # Where slangc lies for this process is no place of the environment's.
    own = Path(sys.executable).parent
    kept["PATH"] = os.pathsep.join(
        part for part in os.get_exec_path() if Path(part) != own and not (Path(part) / "slangc").exists()
    )
    return kept


def _checkout_copy(folder: Path) -> Path:
    """A copy of what a wheel is built from, with the page and the shaders where they are built already."""
    from loomlight.viewer.client import client_folder

    client_folder()
    copy = folder / "checkout"
    copy.mkdir()
    leave = shutil.ignore_patterns("node_modules", "__pycache__", "dist", "test")
    for name in _SOURCES:
        source = ROOT / name
        if source.is_dir():
            shutil.copytree(source, copy / name, ignore=leave)
        else:
            shutil.copy2(source, copy / name)
    return copy


def _build(checkout: Path, folder: Path, shaders: bool = True) -> Path:
    """The wheel of a checkout's source archive.

    Args:
        shaders: whether it holds compiled shaders; without, slangc is not found while it is built.
    """
    libraries = checkout / "src" / "loomlight" / "realtime" / "shaders" / "libraries"
    variables = {**os.environ, "LOOMLIGHT_REQUIRE_PAGE": "1"}
    if shaders:
        variables["LOOMLIGHT_REQUIRE_SHADERS"] = "1"
    else:
        shutil.rmtree(libraries)
        variables["LOOMLIGHT_SLANGC"] = str(checkout / "no-slangc")
    program = "import sys; from hatchling.build import build_sdist; print(build_sdist(sys.argv[1]))"
    unpack = folder.with_name(f"{folder.name}-unpacked")
    _run([sys.executable, "-c", program, str(folder)], checkout, variables)
    (archive,) = folder.glob("*.tar.gz")
    shutil.unpack_archive(archive, unpack, filter="data")
    (source,) = unpack.iterdir()
    _run([sys.executable, "-c", program.replace("sdist", "wheel"), str(folder)], source, variables)
    (wheel,) = folder.glob("*.whl")
    return wheel


def _venv(place: Path, python: str) -> Path:
    _run([python, "-m", "venv", str(place)], place.parent)
    return place / "bin" / "python"


def _copied(environment: Path, place: Path) -> Path:
    """A copy of an environment, whose files are the same ones until pip replaces them."""
    shutil.copytree(environment, place, symlinks=True, copy_function=os.link)
    return place / "bin" / "python"


def _require_registry(python: Path, folder: Path) -> None:
    command = ["download", "--no-deps", "--no-cache-dir", "-d", str(folder / "probe"), "threadpoolctl"]
    done = subprocess.run(
        [str(python), "-m", "pip", *command], capture_output=True, text=True, timeout=HANG, check=False
    )
    if done.returncode != 0:
        raise UnreachableError((done.stderr.strip().splitlines() or ["pip says nothing"])[-1])


def _pip(python: Path, *words: str) -> float:
    """Installs into an environment what `words` name; the seconds that it took."""
    start = time.perf_counter()
    quiet = ["--quiet", "--disable-pip-version-check", "-c", str(_CONSTRAINTS)]
    _run([str(python), "-m", "pip", "install", *quiet, *words], python.parents[1])
    return time.perf_counter() - start


def _run(command: Sequence[str], folder: Path, variables: dict[str, str] | None = None) -> None:
    done = subprocess.run(
        command, cwd=folder, env=variables, capture_output=True, text=True, timeout=HANG, check=False
    )
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)} fails: {done.stderr[-3000:] or done.stdout[-3000:]}")


def _borrow_torch(python: Path) -> None:
    """Links torch and what it requires from the environment that this runs in."""
    (packages,) = (python.parents[1] / "lib").glob("python*/site-packages")
    waiting, seen = ["torch"], set()
    while waiting:
        name = waiting.pop()
        try:
            found = distribution(name)
        except PackageNotFoundError:  # of another system
            continue
        if name in seen:
            continue
        seen.add(name)
        for line in found.requires or ():
            if "extra ==" not in line:
                waiting += re.findall(r"^[\w.-]+", line)
        for top in {
            file.parts[0] for file in found.files or () if file.parts[0] not in ("..", "__pycache__")
        }:
            if not (packages / top).exists():
                (packages / top).symlink_to(Path(str(found.locate_file(top))))


def _megabytes(place: Path, beside: Path | None = None) -> float:
    """Size of the files in a folder, of a copy of `beside` those that it does not have too."""
    sizes = 0
    for file in place.rglob("*"):
        if file.is_symlink() or not file.is_file():
            continue
        other = None if beside is None else beside / file.relative_to(place)
        if other is None or not other.exists() or not other.samefile(file):
            sizes += file.stat().st_size
    return sizes / 1e6


def matrix(environments: Sequence[Environment]) -> str:
    """A table of environments in Markdown, and their sentences."""
    lines = ["| environment | MB | seconds | work | a sentence | faults |", "|---|---|---|---|---|---|"]
    for each in environments:
        works = sum(outcome == "works" for outcome in each.outcomes.values())
        cells = (f"{each.megabytes:.1f}", f"{each.seconds:.0f}", works, len(each.outcomes) - works)
        lines.append(f"| {each.name} | {' | '.join(map(str, cells))} | {len(each.faults)} |")
    for each in environments:
        lines += ["", f"{each.name}:"]
        lines += [f"- `{label}`: {outcome}" for label, outcome in each.outcomes.items()]
        lines += [f"- fault: {fault}" for fault in each.faults]
    return "\n".join(lines)


def main() -> None:
    """Prints the matrix; exits with 1 if something is not as it should be."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--python", default=sys.executable)
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        found = []
        for environment in installations(Path(folder), chosen.python):
            print(environment.name, *environment.faults, sep="\n", file=sys.stderr, flush=True)
            found.append(environment)
    print(matrix(found))
    sys.exit(any(each.faults for each in found))


if __name__ == "__main__":
    main()
