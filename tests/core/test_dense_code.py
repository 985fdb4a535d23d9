"""Layers as machine code, against products of matrices."""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.core.dense_code import Packed, dense
from loomlight.core.lane_code import Code, Vectors
from loomlight.core.machine_code import MachineCode

from .lanes import WIDTHS


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
@pytest.mark.parametrize("count", [1, 48, 1000])
def test_layers_are_products_of_matrices(wide: Vectors, count: int) -> None:
    rng = np.random.default_rng(2)
    first, second = rng.normal(size=(21, 7)), rng.normal(size=(5, 21))
    biases, slope = (rng.normal(size=21), rng.normal(size=5)), 0.1
    packed = Packed(wide)
    one, other = packed.add("one", first, biases[0]), packed.add("other", second)
    code = Code("layers", wide)
    with code.blocks():
        inputs, hidden, output = (code.rows(n) for n in (7, one.rows(wide), other.rows(wide)))
        start = code.rows(other.rows(wide))
        with code.each_vector():
            for number in range(7):
                inputs[number] = code.given(number)
            for number in range(5):
                start[number] = biases[1][number]
        numbers = code.array(7 + 5)
        dense(code, numbers, one, inputs, hidden, slope=slope)
        dense(code, numbers, other, hidden, output, start=start)
        with code.each_vector():
            for number in range(5):
                code.answer(7 + number, output[number])
    given = rng.normal(size=(7, count)).astype(np.float32)
    found = np.zeros((5, count), np.float32)
    MachineCode(code).run(count, [*given], [*found], [packed.numbers()])
    between = first @ given + biases[0][:, None]
    wanted = second @ np.where(between > 0, between, slope * between) + biases[1][:, None]
    np.testing.assert_allclose(found, wanted, rtol=1e-5, atol=2e-5)


def test_blocks_share_registers() -> None:
    for wide in WIDTHS:
        # All sums of a tile, the inputs of a block and a weight.
        assert wide.sums * wide.of_block + wide.of_block + 1 <= wide.registers
        assert wide.block == wide.lanes * wide.of_block
