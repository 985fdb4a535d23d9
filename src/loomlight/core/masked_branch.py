"""A branch that few lanes take."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import drjit as dr

from loomlight.core.arrays import Mask
from loomlight.core.backend import array_types

State = TypeVar("State")


def masked_branch(active: Mask, value: State, change: Callable[[State], State], label: str) -> State:
    """`change(value)` in active lanes, `value` in others, and no time where a packet of lanes has none.

    It is a loop of one turn: of Dr.Jit's branches the CPU runs both sides.

    Args:
        active: Bool.
        value: any tree of Dr.Jit arrays, each with a lane for each of `active` or for all.
        change: takes such a tree and returns one of the same kind.
        label: names the loop in kernels.
    """
    types = array_types(dr.float32_array_t(active))

    def turn(_: Mask, held: State) -> tuple[Mask, State]:
        return types.Bool(False), change(held)

    return dr.while_loop((types.Bool(active), value), lambda pending, _: pending, turn, label=label)[1]
