"""A branch that few lanes take."""

from __future__ import annotations

import drjit as dr
import numpy as np
import pytest
from drjit.llvm import Array2f, Bool, Float
from drjit.llvm.ad import Bool as BoolAD
from drjit.llvm.ad import Float as FloatAD

from loomlight.core.backend import masked_branch


def test_active_lanes_change_and_others_stay() -> None:
    values = dr.arange(Float, 100)
    actual = masked_branch(values > 90, values, lambda value: -value, "negate")
    np.testing.assert_array_equal(actual.numpy(), [*range(91), *range(-91, -100, -1)])


def test_trees_of_arrays_go_through() -> None:
    state = (Array2f(dr.arange(Float, 8), 1), dr.zeros(Float, 8))
    place, steps = masked_branch(
        dr.arange(Float, 8) < 2, state, lambda held: (held[0] + 10, held[1] + 1), "move"
    )
    np.testing.assert_array_equal(place.x.numpy(), [10, 11, 2, 3, 4, 5, 6, 7])
    np.testing.assert_array_equal(place.y.numpy(), [11, 11, 1, 1, 1, 1, 1, 1])
    np.testing.assert_array_equal(steps.numpy(), [1, 1, 0, 0, 0, 0, 0, 0])


@pytest.mark.parametrize("taken", [True, False])
def test_no_lane_or_all_of_them(taken: bool) -> None:
    actual = masked_branch(dr.full(Bool, taken, 5), dr.zeros(Float, 5), lambda value: value + 1, "count")
    np.testing.assert_array_equal(actual.numpy(), [float(taken)] * 5)


def test_derivatives_of_active_lanes_are_those_of_the_branch() -> None:
    values = dr.arange(FloatAD, 4) + 1
    dr.enable_grad(values)
    active = BoolAD([True, False, True, False])
    actual = masked_branch(active, values, lambda value: 3 * value, "triple")
    dr.forward(values)
    np.testing.assert_array_equal(dr.grad(actual).numpy(), [3, 1, 3, 1])
