"""The LLVM library that Dr.Jit compiles with: its version is checked before the first kernel.

Dr.Jit accepts LLVM 14 to 16, but aborts the process on ordinary kernels; reading the version is safe. As a
script, this module prints the version, and exits with 1 if kernels cannot be compiled.
"""

from __future__ import annotations

import os
import platform
import sys
from importlib import import_module

from loomlight.core.errors import LoomlightError, MissingDependencyError

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
    """Raises MissingDependencyError unless there is an LLVM library of version 17 or newer."""
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
