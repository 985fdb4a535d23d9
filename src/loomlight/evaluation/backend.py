"""Which Dr.Jit backend evaluations run on where the caller names none."""

from __future__ import annotations

from importlib import import_module

from loomlight.core.llvm import require_llvm


def llvm_float() -> type:
    """The Float type of the LLVM backend.

    Raises:
        MissingDependencyError: no usable LLVM library.
    """
    require_llvm()
    return import_module("drjit.llvm.ad").Float
