"""Whole quotients by numbers that kernels shall not depend on.

CPUs have no instruction that divides whole numbers of several lanes at once: three divisions a texel took a
quarter of the time that coverage takes. Products are what they have.
"""

from __future__ import annotations

from typing import Any

import drjit as dr

from loomlight.core.backend import ArrayTypes


class Divider:
    """A number to divide by, opaque: exact for all 32-bit numbers (Granlund and Montgomery 1994, fig. 4.1).

    Attributes:
        number: itself, ≥ 1: UInt32.
    """

    def __init__(self, number: int, types: ArrayTypes) -> None:
        bits = (number - 1).bit_length()
        factor = (2**32 * (2**bits - number)) // number + 1
        self.number = dr.opaque(types.UInt32, number)
        self._factor = dr.opaque(types.UInt32, factor)
        self._first_shift = dr.opaque(types.UInt32, min(bits, 1))
        self._second_shift = dr.opaque(types.UInt32, max(bits - 1, 0))

    def divide(self, dividend: Any) -> tuple[Any, Any]:
        """Quotient, rounded down, and remainder: UInt32 each."""
        high = dr.mul_hi(dividend, self._factor)
        quotient = (((dividend - high) >> self._first_shift) + high) >> self._second_shift
        return quotient, dividend - quotient * self.number
