"""Code that is written lane by lane and run at once, and the widths that this processor can run."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from loomlight.core.lane_code import Code, Vectors
from loomlight.core.machine_code import MachineCode, vectors

# Of other processors: LLVM splits vectors that are too long, and code is right with few registers too.
WIDTHS = [vectors(), Vectors(4, 16), Vectors(8, 16), Vectors(16, 32)]


def computed(
    write: Callable[[Code, Sequence[Any]], Sequence[Any]], *arrays: np.ndarray, wide: Vectors | None = None
) -> list[np.ndarray]:
    """What code makes of arrays, vector by vector."""
    code, count = Code("computed", wide or vectors()), 0
    with code.blocks(), code.each_vector():
        answers = write(code, [code.given(number) for number in range(len(arrays))])
        count = len(answers)
        for number, answer in enumerate(answers):
            code.answer(len(arrays) + number, answer)
    given = [np.ascontiguousarray(array, np.float32) for array in arrays]
    found = [np.full(len(given[0]), np.nan, np.float32) for _ in range(count)]
    MachineCode(code).run(len(given[0]), given, found, [])
    return found


def as_floats(wholes: np.ndarray) -> np.ndarray:
    return np.ascontiguousarray(wholes, np.uint32).view(np.float32)


def truth(code: Code, value: Any) -> Any:
    """1 for what is true."""
    return code.select(value, 1.0, 0.0)
