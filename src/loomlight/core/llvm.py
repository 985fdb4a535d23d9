"""The LLVM library that Dr.Jit compiles with: its version is checked before the first kernel.

Dr.Jit accepts LLVM 14 to 16, but aborts the process on ordinary kernels; reading the version is safe. As a
script, this module prints the version, and exits with 1 if kernels cannot be compiled.
"""

from __future__ import annotations

import os
import sys
from importlib import import_module

from loomlight.core.errors import LoomlightError, MissingDependencyError

MINIMUM_LLVM = 17
ADVICE = "install it with `apt-get install libllvm19`, or name one in the variable DRJIT_LIBLLVM_PATH"


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
        raise MissingDependencyError(f"LLVM {MINIMUM_LLVM} or newer is needed and {found}: {ADVICE}.")
    if version[0] < MINIMUM_LLVM:
        found = ".".join(map(str, version))
        raise MissingDependencyError(
            f"LLVM {found} was found, but {MINIMUM_LLVM} or newer is needed: {ADVICE}."
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
