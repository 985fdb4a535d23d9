"""Plain loops compiled by Numba: one thread, without Python's lock, kept on disk.

Importing Numba and loading kernels takes some 0.3 s: modules with kernels are imported where they are used.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from numba import config, njit

from loomlight.core.files import cache_folder

_Function = TypeVar("_Function", bound=Callable[..., object])


def numba_kernel(*, any_sum_order: bool = False) -> Callable[[_Function], _Function]:
    """Decorates a function of arrays and numbers that Numba compiles at its first call.

    Kernels are kept in this project's cache folder ($NUMBA_CACHE_DIR takes precedence); where nothing can be
    written, each process compiles them anew. They call kernels of their own file only: Numba does not see
    changes in others.

    Args:
        any_sum_order: terms of a sum may be added in any order, so that LLVM vectorizes sums. On one machine
            the order is the same every time.
    """
    fastmath = {"contract", "reassoc", "nsz"} if any_sum_order else {"contract"}

    def decorate(function: _Function) -> _Function:
        kernel = njit(nogil=True, fastmath=fastmath)(function)
        users_folder = config.CACHE_DIR
        config.CACHE_DIR = users_folder or str(cache_folder("numba"))
        try:
            kernel.enable_caching()
        except RuntimeError:  # no folder that can be written
            pass
        finally:
            config.CACHE_DIR = users_folder
        return kernel

    return decorate
