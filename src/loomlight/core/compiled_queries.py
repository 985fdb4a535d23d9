"""Queries of Dr.Jit's arrays that machine code answers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]


def reads(float_type: Any) -> bool:
    """Whether machine code can read arrays of a type: they are floats in this machine's memory."""
    return dr.backend_v(float_type) == dr.JitBackend.LLVM and dr.type_v(float_type) == dr.VarType.Float32


def answers_now(float_type: Any, asked: Any) -> bool:
    """Whether machine code may answer queries: not within symbolic calls and loops, nor for derivatives."""
    return (
        reads(float_type)
        and dr.width(asked) > 0
        and not dr.flag(dr.JitFlag.SymbolicScope)
        and not dr.flag(dr.JitFlag.FreezingScope)
        and not dr.grad_enabled(asked)
    )


def answered(
    float_type: Any, asked: Any, answers: int, run: Callable[[Sequence[Floats], Sequence[Floats]], None]
) -> list[Any]:
    """So many Floats of what machine code answers.

    Args:
        asked: arrays of queries, in any nesting; 1 stands for what is true.
        run: is given the numbers of queries one by one and what the answers are put into.
    """
    width = dr.width(asked)
    given = _wide(_numbers(asked), width)
    found = [dr.empty(float_type, width) for _ in range(answers)]
    # Memory that was given back may still be read, and what is asked not yet be written.
    dr.sync_thread()
    queries, results = ([part.numpy() for part in parts] for parts in (given, found))
    run(queries, results)
    return found


def _numbers(asked: Any) -> list[Any]:
    """All arrays of queries one by one; 1 for what is true."""
    if isinstance(asked, list | tuple) or dr.depth_v(asked) > 1:
        return [number for part in asked for number in _numbers(part)]
    if not dr.is_mask_v(asked):
        return [asked]
    float_type: Any = dr.float32_array_t(asked)
    return [dr.select(asked, float_type(1), float_type(0))]


def _wide(numbers: list[Any], width: int) -> list[Any]:
    """Evaluated arrays of a width, of what all lanes share too."""
    found = [
        type(value)(value)
        if dr.width(value) == width
        else dr.gather(type(value), value, dr.zeros(dr.uint32_array_t(value), width))
        for value in numbers
    ]
    dr.make_opaque(found)
    return found
