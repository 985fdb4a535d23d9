"""`loomlight doctor`: what is installed, what is missing, how to mend it."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec

import typer

from loomlight.core.errors import LoomlightError
from loomlight.core.extras import EXTRAS, installing, required_packages
from loomlight.core.llvm import MINIMUM_LLVM, advice

EXAMPLE = "Example: loomlight doctor"

# In a process of its own: an LLVM that Dr.Jit finds but cannot use ends the process.
_TRY_KERNEL = """
import sys
import drjit as dr
kind = getattr(dr, sys.argv[1]).Float
values = dr.fma(dr.minimum(kind([1, 2, 3]), 2), 2, dr.sqrt(kind([4, 4, 4])))
sys.exit(0 if list(values) == [4, 6, 6] else 1)
"""
_KERNEL_SECONDS = 120


@dataclass(frozen=True)
class Finding:
    """One line of the report.

    Attributes:
        subject: what was looked at.
        found: what was found there.
        remedy: how to mend it; None if nothing is wrong.
        needed: whether loomlight cannot render without it.
    """

    subject: str
    found: str
    remedy: str | None = None
    needed: bool = True


def doctor() -> None:
    """Reports what loomlight needs: what is installed, what is missing, and how to mend it.

    Exits with 0 if cloth can be rendered on this machine, with 1 if not.
    """
    usable = True
    for finding in findings():
        fatal = finding.remedy is not None and finding.needed
        mark = "missing" if fatal else "ok" if finding.remedy is None else "none"
        print(f"{mark:8}{finding.subject:16}{finding.found}")
        if finding.remedy is not None:
            print(f"{'':24}{finding.remedy}")
        usable = usable and not fatal
    print("loomlight is ready." if usable else "loomlight cannot render yet: mend what is missing above.")
    raise typer.Exit(0 if usable else 1)


def findings() -> Iterator[Finding]:
    """Everything that was looked at, in the order in which to mend it."""
    yield _python()
    try:
        packages = required_packages()
    except PackageNotFoundError:
        yield Finding("loomlight", "not installed: only its folder is there", "python -m pip install .")
        return
    missing = False
    for name in packages[""]:
        finding = _package(name)
        missing = missing or finding.remedy is not None
        yield finding
    for extra, purpose in EXTRAS.items():
        yield _extra(extra, packages[extra], purpose)
    if missing:
        return
    llvm = _llvm()
    yield llvm
    yield from _kernels()
    yield _cuda()
    yield _adapter()
    if llvm.remedy is None:
        yield _variant()
        yield from _network()
    yield _page()
    yield from _shaders()


def _python() -> Finding:
    found = ".".join(map(str, sys.version_info[:3]))
    remedy = None if sys.version_info >= (3, 11) else "install Python 3.11 or newer."
    return Finding("Python", found, remedy)


def _package(name: str) -> Finding:
    found = _version(name)
    if found is None:
        return Finding(name, "not installed", f"python -m pip install {name}")
    return Finding(name, found)


def _extra(extra: str, packages: list[str], purpose: str) -> Finding:
    """The packages of an extra; nothing else needs them."""
    found = {name: _version(name) for name in packages}
    present = ", ".join(f"{name} {has}" for name, has in found.items() if has is not None)
    missing = ", ".join(name for name, has in found.items() if has is None)
    if not missing:
        return Finding(f"[{extra}]", present)
    shown = f"{present}; {missing} not installed" if present else f"{missing} not installed"
    return Finding(f"[{extra}]", shown, f"for {purpose}: python -m {installing(extra)}", needed=False)


def _version(name: str) -> str | None:
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def _llvm() -> Finding:
    from loomlight.core.llvm import llvm_version

    found = llvm_version()
    if found is None:
        return Finding("LLVM", "no library found", f"{advice()}.")
    shown = ".".join(map(str, found))
    if found[0] < MINIMUM_LLVM:
        return Finding("LLVM", f"{shown}, older than {MINIMUM_LLVM}", f"{advice()}.")
    if not _kernel_runs("llvm"):
        return Finding("LLVM", f"{shown}, but a first kernel does not compile", f"{advice()}.")
    return Finding("LLVM", shown)


def _kernels() -> Iterator[Finding]:
    if find_spec("llvmlite") is None:
        return
    from loomlight.core.simd import host_target, kernels_work

    if kernels_work():
        yield Finding("SIMD kernels", f"{host_target().width} lanes")
    else:
        yield Finding("SIMD kernels", "compute wrongly", "python -m pip install --upgrade llvmlite")


def _cuda() -> Finding:
    import drjit

    if not drjit.has_backend(drjit.JitBackend.CUDA):
        remedy = "not needed; with an NVIDIA driver, --variant cuda_ad_rgb renders on its device."
        return Finding("CUDA", "no device found", remedy, needed=False)
    if not _kernel_runs("cuda"):
        found = "a device, but a first kernel does not run"
        return Finding("CUDA", found, "update its driver.", needed=False)
    return Finding("CUDA", "a device that runs kernels")


def _adapter() -> Finding:
    from loomlight.realtime.device import default_adapter

    try:
        adapter = default_adapter()
    except LoomlightError as error:
        return Finding("adapter", "none for real-time rendering", str(error), needed=False)
    return Finding("adapter", f"{adapter.name}{', software' if adapter.is_software else ''}")


def _variant() -> Finding:
    from loomlight.mitsuba.variants import DEFAULT_VARIANT, choose_variant

    try:
        return Finding("variant", choose_variant(DEFAULT_VARIANT))
    except LoomlightError as error:
        return Finding("variant", str(error), "python -m pip install --force-reinstall mitsuba")


def _network() -> Iterator[Finding]:
    if find_spec("llvmlite") is None:
        # No network runs without.
        return
    from loomlight.core.llvm import llvm_float
    from loomlight.models.neural.learned_truth import moved_since, truth_numbers
    from loomlight.models.neural.weights import shipped_weights

    change = moved_since(shipped_weights().provenance, truth_numbers(llvm_float()))
    if change is None:
        yield Finding("network", "trained on the yarns of this version")
        return
    by = "" if change == float("inf") else f", by up to {change:.0%}"
    remedy = (
        "`--model neural` shows cloth as it was then, other models as it is; in a checkout, `python -m "
        "studies.papers.chen2024.training studies/papers/chen2024/neural.toml` trains anew."
    )
    yield Finding("network", f"trained before yarns changed{by}", remedy, needed=False)


def _page() -> Finding:
    from loomlight.viewer.client import page_state

    state, remedy = page_state()
    return Finding("editor's page", state, remedy, needed=False)


def _shaders() -> Iterator[Finding]:
    from loomlight.realtime.slangc import NO_COMPILER, find_slangc, has_libraries

    slangc = find_slangc()
    if has_libraries():
        yield Finding("shader code", "compiled for every language")
    elif slangc is not None:
        yield Finding("shader code", "compiled when it is exported")
    else:
        remedy = f"for export to wgsl, hlsl, glsl, spirv, metal and cuda. {NO_COMPILER}"
        yield Finding("shader code", "not compiled, and slangc is missing", remedy, needed=False)
    if slangc is not None:
        yield Finding("slangc", str(slangc))


def _kernel_runs(backend: str) -> bool:
    command = [sys.executable, "-c", _TRY_KERNEL, backend]
    try:
        return subprocess.run(command, capture_output=True, timeout=_KERNEL_SECONDS).returncode == 0
    except (OSError, subprocess.TimeoutExpired):
        return False
