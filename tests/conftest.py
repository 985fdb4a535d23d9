"""Caches of their own for all tests, short trainings, and the number of slow tests left out."""

from __future__ import annotations

import ctypes
import gc
import math
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, settings

from loomlight.core.llvm import compile_quickly

# Before torch is loaded: MKL's sums otherwise depend on where arrays lie, and trainings repeat bit for bit.
os.environ.setdefault("MKL_CBWR", "AUTO,STRICT")

# Mesa's software driver takes most of the time of shader tests to compile them. What it compiled stays where
# it does for any program, so that all workers, subprocesses and later runs share it.
os.environ.setdefault(
    "MESA_SHADER_CACHE_DIR", os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
)

# Seconds that an example takes say how busy a machine is, not what is wrong.
settings.register_profile("busy machines", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("busy machines")

LEFT_OUT = pytest.StashKey[int]()


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: Sequence[pytest.Item]) -> None:
    """Cases that a mark `quick` does not name are slow; it names cases that there are."""
    unseen: dict[str, set[str]] = {}
    for item in items:
        mark = item.get_closest_marker("quick")
        if mark is None:
            continue
        name, _, case = item.nodeid.removesuffix("]").partition("[")
        unseen.setdefault(name, set(mark.args)).discard(case)
        if case not in mark.args:
            item.add_marker(pytest.mark.slow)
    wrong = {name: cases for name, cases in unseen.items() if cases}
    if wrong and not any("::" in each for each in config.args):
        raise pytest.UsageError(f"the mark quick names cases that there are not: {wrong}")


@pytest.hookimpl(trylast=True)
def pytest_collection_finish() -> None:
    """Modules and tests stay to the end: Python's collector need not look through them time and again."""
    gc.collect()
    gc.freeze()


def pytest_deselected(items: Sequence[pytest.Item]) -> None:
    config = items[0].config
    if "not slow" in config.option.markexpr:
        config.stash[LEFT_OUT] = sum(item.get_closest_marker("slow") is not None for item in items)


def pytest_sessionfinish(session: pytest.Session) -> None:
    """A worker of pytest-xdist tells the first process, as it alone knows."""
    gc.unfreeze()
    if hasattr(session.config, "workeroutput"):
        session.config.workeroutput["left_out"] = session.config.stash.get(LEFT_OUT, 0)


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    node.config.stash[LEFT_OUT] = getattr(node, "workeroutput", {}).get("left_out", 0)


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    if left_out := config.stash.get(LEFT_OUT, 0):
        terminalreporter.write_line(f"Slow tests left out: {left_out}; make test-all runs them.")


@pytest.fixture(scope="session", autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Nothing is read from the user's cache, and nothing is left there."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        yield


@pytest.fixture(scope="session", autouse=True)
def quick_kernels() -> None:
    """For tests of what Dr.Jit computes without a function of ours that asks for LLVM."""
    compile_quickly()


@pytest.fixture(scope="module", autouse=True)
def returned_memory() -> Iterator[None]:
    """What a module needs no more goes back to the system, which two workers and a browser share."""
    yield
    if "drjit" in sys.modules:
        sys.modules["drjit"].flush_malloc_cache()
    with suppress(OSError, AttributeError):  # glibc alone has it
        ctypes.CDLL("libc.so.6").malloc_trim(0)


@pytest.fixture(scope="session", autouse=True)
def short_training() -> Iterator[None]:
    """Trainings of `neumip` and `latent` take a second instead of minutes: enough to know what it is of."""
    from loomlight.models.texture.settings import LATENT_QUALITIES, NEUMIP_QUALITIES

    short = replace(NEUMIP_QUALITIES["preview"], resolution=16, queries=100 << 9, steps=200, batch=1 << 10)
    latent = replace(
        LATENT_QUALITIES["preview"],
        resolution=8,
        queries=1 << 13,
        samples=2,
        steps=60,
        batch=1 << 10,
        sampler_steps=30,
        sampler_batch=128,
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(NEUMIP_QUALITIES, "preview", short)
        patch.setitem(LATENT_QUALITIES, "preview", latent)
        yield


@pytest.fixture(autouse=True)
def no_lines_of_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    """Commands write no lines of progress: how many there are is a matter of the machine's load."""
    monkeypatch.setattr("loomlight.cli.terminal.LINE_SECONDS", math.inf)


@pytest.fixture
def refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Callable[..., str]:
    """Runs a command in an empty folder. It ends with code 2, in one sentence, which is returned, and leaves
    all files as they are; `leaves` is a new folder that it may leave empty.
    """
    from loomlight.cli.main import run

    def files() -> dict[Path, bytes | None]:
        return {path: path.read_bytes() if path.is_file() else None for path in tmp_path.rglob("*")}

    def refused(
        arguments: Sequence[str], command: Callable[[Sequence[str]], int] = run, leaves: str | None = None
    ) -> str:
        before = files()
        capsys.readouterr()
        assert command(list(arguments)) == 2
        captured = capsys.readouterr()
        assert captured.out == ""
        assert len(captured.err.splitlines()) == 1, captured.err
        allowed = before | ({} if leaves is None else {tmp_path / leaves: None})
        assert before.items() <= files().items() <= allowed.items()
        return captured.err

    monkeypatch.chdir(tmp_path)
    return refused
