"""The LLVM library that Dr.Jit compiles with: its version is checked before the first kernel.

Dr.Jit accepts LLVM 14 to 16, but aborts the process on ordinary kernels; reading the version is safe. As a
script, this module prints the version, and exits with 1 if kernels cannot be compiled.
"""

from __future__ import annotations

import ctypes
import os
import platform
import sys
from functools import cache
from importlib import import_module
from pathlib import Path

from loomlight.core.errors import InputError, LoomlightError, MissingDependencyError

MINIMUM_LLVM = 17
# How to install it, by system, and on Linux by the identifier of a distribution or of one that it is like.
# Tried on Debian alone; the others are what their packages are called.
_REMEDIES = {
    "debian": "`apt-get install libllvm19`",
    "fedora": "`dnf install llvm-libs`",
    "arch": "`pacman -S llvm-libs`",
    "suse": "`zypper install libLLVM19`",
    "Linux": "your distribution's package of the library libLLVM",
    "Darwin": "`brew install llvm`",
    "Windows": "`winget install LLVM.LLVM`",
}
# The library's file, where Dr.Jit does not find it by itself.
_FILES = {
    "Darwin": '"$(brew --prefix llvm)/lib/libLLVM.dylib"',
    "Windows": r"C:\Program Files\LLVM\bin\LLVM-C.dll",
}
# How kernels are compiled: quickly, or with all passes as Dr.Jit asks for them, should a library need that.
_VARIABLE = "LOOMLIGHT_COMPILE"
_WAYS = ("quick", "full")
# Versions that are known to take the options below: one that does not would end the process.
_QUICK = range(19, 23)
# Functions that are not to be optimised skip every pass that need not run.
_OPTIONS = (b"loomlight", b"-force-attribute=optnone", b"-force-attribute=noinline")


def advice() -> str:
    """How to install an LLVM library on this system, the end of a sentence."""
    system = platform.system()
    remedy = _REMEDIES.get(_distribution() or system, _REMEDIES["Linux"])
    named = f", such as {_FILES[system]}" if system in _FILES else ""
    return f"install it with {remedy}, or name one in the variable DRJIT_LIBLLVM_PATH{named}"


def _distribution() -> str | None:
    """The one of `_REMEDIES` that this Linux is, or is made from; None for others and other systems."""
    if platform.system() != "Linux":
        return None
    try:
        release = platform.freedesktop_os_release()
    except OSError:
        return None
    names = [release.get("ID", ""), *release.get("ID_LIKE", "").split()]
    return next((name for name in names if name in _REMEDIES), None)


def llvm_version() -> tuple[int, int, int] | None:
    """Version of the LLVM library that Dr.Jit found; None without one."""
    import drjit

    if not drjit.has_backend(drjit.JitBackend.LLVM):
        return None
    major, minor, patch = drjit.detail.llvm_version()
    return (major, minor, patch) if major > 0 else None


def require_llvm() -> None:
    """Raises MissingDependencyError unless there is an LLVM library of version 17 or newer.

    From then on it compiles kernels quickly, unless the variable `LOOMLIGHT_COMPILE` is "full".

    Raises:
        InputError: the variable is neither "quick" nor "full".
    """
    version = llvm_version()
    if version is None:
        named = os.environ.get("DRJIT_LIBLLVM_PATH")
        found = f"DRJIT_LIBLLVM_PATH names {named}, which cannot be used" if named else "none was found"
        raise MissingDependencyError(f"LLVM {MINIMUM_LLVM} or newer is needed and {found}: {advice()}.")
    if version[0] < MINIMUM_LLVM:
        found = ".".join(map(str, version))
        raise MissingDependencyError(
            f"LLVM {found} was found, but {MINIMUM_LLVM} or newer is needed: {advice()}."
        )
    way = os.environ.get(_VARIABLE, _WAYS[0])
    if way not in _WAYS:
        raise InputError(f'{_VARIABLE} = "{way}" is no way to compile: use {" or ".join(_WAYS)}.')
    if way == "quick":
        compile_quickly()


@cache
def compile_quickly() -> bool:
    """Leaves out passes that only make kernels faster, on Linux with LLVM 19 to 22; returns whether so.

    Dr.Jit has simplified kernels before LLVM sees them: compiling takes a third of the time, results are the
    same bit for bit, and kernels are as fast with AVX-512; with AVX2 long loops take up to a fifth longer. It
    holds for all that this process compiles from now on.
    """
    version = llvm_version()
    if platform.system() != "Linux" or version is None or version[0] not in _QUICK:
        return False
    library = _loaded_library(version)
    if library is None:
        return False
    count = len(_OPTIONS)
    library.LLVMParseCommandLineOptions(count, (ctypes.c_char_p * count)(*_OPTIONS), None)
    return True


def _loaded_library(version: tuple[int, int, int]) -> ctypes.CDLL | None:
    """The LLVM library of that version in this process, where Mesa may have loaded another one."""
    lines = Path("/proc/self/maps").read_text(encoding="utf-8", errors="replace").splitlines()
    files = {line.split(maxsplit=5)[-1] for line in lines if "libLLVM" in line}
    numbers = [ctypes.c_uint() for _ in version]
    for file in sorted(files):
        try:
            library = ctypes.CDLL(file, mode=os.RTLD_NOLOAD)
            library.LLVMGetVersion(*map(ctypes.byref, numbers))
        except (OSError, AttributeError):  # removed since, or older than version 16
            continue
        if tuple(number.value for number in numbers) == version:
            return library
    return None


def llvm_float() -> type:
    """The Float type of the LLVM backend.

    Raises:
        MissingDependencyError: no usable LLVM library.
    """
    require_llvm()
    float_type: type = import_module("drjit.llvm.ad").Float
    return float_type


if __name__ == "__main__":
    try:
        require_llvm()
    except LoomlightError as error:
        sys.exit(f"loomlight: {error}")
    print("LLVM", ".".join(map(str, llvm_version() or ())))
