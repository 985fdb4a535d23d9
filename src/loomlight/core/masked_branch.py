"""A branch that few lanes take."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import drjit as dr

from loomlight.core.arrays import Mask
from loomlight.core.backend import array_types

State = TypeVar("State")


def masked_branch(active: Mask, value: State, change: Callable[[State], State], label: str) -> State:
    """`change(value)` in active lanes, `value` in others; packets without active lanes skip the branch.

    It is a loop of one iteration: of a Dr.Jit conditional the CPU runs both sides. With derivatives it is a
    selection.

    Args:
        active: Bool.
        value: any pytree of Dr.Jit arrays, of the width of `active` or of width 1.
        change: takes such a pytree and returns one of the same structure.
        label: names the loop in kernels.
    """
    types = array_types(dr.float32_array_t(active))
    if dr.grad_enabled(value):
        # Derivatives do not pass backward through loops: all lanes compute both sides.
        return dr.select(active, change(value), value)

    def iteration(_: Mask, values: State) -> tuple[Mask, State]:
        return types.Bool(False), change(values)

    return dr.while_loop((types.Bool(active), value), lambda pending, _: pending, iteration, label=label)[1]
