"""Compiles the loops of baking in a process of its own, while another one does something else.

On a fresh installation Numba compiles the loops of `lobes` for some seconds. `compile_ahead` begins that
early; `wait_for_loops` waits until they lie on disk, from where every process loads them.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from loomlight.core.files import cache_folder

# Models whose baking has loops.
_WITH_LOOPS = ("lobes",)
# Far beyond what any machine takes: then the caller compiles them itself.
_MAX_WAIT = 120.0


def loops_are_compiled() -> bool:
    """Whether an earlier process has left compiled loops on disk."""
    folder = Path(os.environ.get("NUMBA_CACHE_DIR") or cache_folder("numba"))
    return any(folder.rglob("*.nbc"))


def compile_ahead(model: str) -> subprocess.Popen[bytes] | None:
    """Begins to compile the loops of a model in another process, unless they are compiled or it has none."""
    if model not in _WITH_LOOPS or loops_are_compiled():
        return None
    try:
        return subprocess.Popen(
            [sys.executable, "-m", __name__, model],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
    except OSError:
        return None


def wait_for_loops(process: subprocess.Popen[bytes] | None) -> None:
    """Waits until a process of `compile_ahead` has ended; what it left undone, baking compiles."""
    if process is None:
        return
    try:
        process.wait(_MAX_WAIT)
    except subprocess.TimeoutExpired:
        process.kill()


def main() -> None:
    """Bakes the smallest fabric, which compiles every loop of a model's baking."""
    from loomlight.core.llvm import require_llvm
    from loomlight.fabric.load import fabric_from_text
    from loomlight.models.registry import make_model

    require_llvm()
    make_model(sys.argv[1], fabric_from_text("plain"))


if __name__ == "__main__":
    main()
