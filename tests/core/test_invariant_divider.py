"""Integer quotients from products."""

from __future__ import annotations

import numpy as np
import pytest
from drjit.llvm.ad import Float, UInt32

from loomlight.core.backend import InvariantDivider, array_types


@pytest.mark.parametrize("number", [1, 2, 3, 4, 7, 10, 256, 641, 5203, 65537, 2**31 - 1, 2**31, 2**32 - 1])
def test_quotients_are_exact(number: int) -> None:
    dividends = np.random.default_rng(number).integers(0, 2**32, 20000, dtype=np.uint64)
    near = [turns * number + offset for turns in range(50) for offset in (-1, 0, 1)]
    near = [dividend for dividend in near if 0 <= dividend < 2**32]
    dividends = np.concatenate([dividends, near, [2**32 - 1]]).astype(np.uint32)
    actual, rest = (
        part.numpy() for part in InvariantDivider(number, array_types(Float)).divide(UInt32(dividends))
    )
    np.testing.assert_array_equal(actual, dividends // number)
    np.testing.assert_array_equal(rest, dividends % number)
