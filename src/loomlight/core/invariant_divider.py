"""Integer division by a number that kernels do not depend on.

CPUs have no SIMD instruction for integer division. A multiplication and shifts give the same quotient.
"""

from __future__ import annotations

import drjit as dr

from loomlight.core.arrays import UInt
from loomlight.core.backend import ArrayTypes


class InvariantDivider:
    """An opaque divisor; exact for all 32-bit numbers (Granlund and Montgomery 1994, fig. 4.1).

    Attributes:
        divisor: ≥ 1, UInt32.
    """

    def __init__(self, divisor: int, types: ArrayTypes) -> None:
        bits = (divisor - 1).bit_length()
        factor = (2**32 * (2**bits - divisor)) // divisor + 1
        self.divisor = dr.opaque(types.UInt32, divisor)
        self._factor = dr.opaque(types.UInt32, factor)
        self._first_shift = dr.opaque(types.UInt32, min(bits, 1))
        self._second_shift = dr.opaque(types.UInt32, max(bits - 1, 0))

    def divide(self, dividend: UInt) -> tuple[UInt, UInt]:
        """Quotient, rounded down, and remainder."""
        high = dr.mul_hi(dividend, self._factor)
        quotient = (((dividend - high) >> self._first_shift) + high) >> self._second_shift
        return quotient, dividend - quotient * self.divisor
