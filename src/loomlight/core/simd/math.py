"""Elementary functions of SIMD kernels, under the names that drjit gives them.

A formula that takes the module drjit as an argument takes a `SimdMath` in its place and is emitted into a
kernel. Logarithm and exponential are polynomials fitted to float32 rounding.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from llvmlite import ir
from numpy.polynomial import Chebyshev, Polynomial

from loomlight.core.simd.values import FLOAT, INT32, Operand, SimdValue

if TYPE_CHECKING:
    from loomlight.core.simd.kernel_builder import KernelBuilder

# Degrees at which the error of the fit is below float32 rounding.
_LOG_DEGREE, _EXP_DEGREE = 9, 7
# ln 2 as a number of few digits and a remainder: multiples of the first are exact in float32.
_LN2_HIGH, _LN2_LOW = 0.693359375, math.log(2) - 0.693359375
_MANTISSA_BITS = 23
# exp is finite and normal in float32 within these.
_EXP_RANGE = -87.0, 88.0
# Below this number a square root is returned too small.
_MIN_SQUARE = 1e-30


class SimdMath:
    """Functions of values of one kernel."""

    def __init__(self, kernel: KernelBuilder) -> None:
        self._kernel = kernel

    def fma(self, a: Operand, b: Operand, c: Operand) -> SimdValue:
        """a b + c, rounded once."""
        return self._intrinsic("fma", a, b, c)

    def floor(self, value: Operand) -> SimdValue:
        """Largest integer that is not above a number."""
        return self._intrinsic("floor", value)

    def round(self, value: Operand) -> SimdValue:
        """Nearest integer; the even one of two."""
        return self._intrinsic("rint", value)

    def abs(self, value: Operand) -> SimdValue:
        """Magnitude."""
        return self._intrinsic("fabs", value)

    def square(self, value: Operand) -> SimdValue:
        """value²."""
        return self._kernel.varying(value) * value

    def rcp(self, value: Operand) -> SimdValue:
        """1 / value, wrong in the last two digits at most."""
        return 1.0 / self._kernel.varying(value)

    def sqrt(self, value: Operand) -> SimdValue:
        """Square root of a number ≥ 0: value · 1/√value, as there are estimates of the latter."""
        value = self._kernel.varying(value)
        return value * (1.0 / self._intrinsic("sqrt", self.maximum(value, _MIN_SQUARE)))

    def select(self, mask: SimdValue, if_true: Operand, if_false: Operand) -> SimdValue:
        """if_true where the mask is set, if_false elsewhere."""
        kernel = self._kernel
        values = kernel.constant(if_true, FLOAT), kernel.constant(if_false, FLOAT)
        return SimdValue(kernel, kernel.ir.select(mask.value, *values))

    def maximum(self, first: Operand, second: Operand) -> SimdValue:
        """The larger number; the second if either is NaN."""
        return self.select(self._kernel.varying(first) > second, first, second)

    def minimum(self, first: Operand, second: Operand) -> SimdValue:
        """The smaller number; the second if either is NaN."""
        return self.select(self._kernel.varying(first) < second, first, second)

    def clip(self, value: Operand, low: Operand, high: Operand) -> SimdValue:
        """A number limited to [low, high]; low if it is NaN."""
        return self.minimum(self.maximum(value, low), high)

    def log2(self, value: Operand) -> SimdValue:
        """Binary logarithm of a positive normal number; relative error below 4e-7 away from 1."""
        bits = self._kernel.bitcast(self._kernel.varying(value), INT32)
        # value = 2^exponent · mantissa, with a mantissa from √½ to √2.
        exponent = (bits - int(np.float32(math.sqrt(0.5)).view(np.int32))) >> _MANTISSA_BITS
        mantissa = self._kernel.bitcast(bits - (exponent << _MANTISSA_BITS), FLOAT)
        t = mantissa - 1.0
        return self.fma(t, self._polynomial(_log_coefficients(), t), self._kernel.to_float(exponent))

    def log(self, value: Operand) -> SimdValue:
        """Natural logarithm of a positive normal number."""
        return math.log(2) * self.log2(value)

    def exp(self, value: Operand) -> SimdValue:
        """Exponential of a number that is limited to [−87, 88]; relative error below 4e-7."""
        value = self.clip(value, *_EXP_RANGE)
        exponent = self.round(value * (1 / math.log(2)))
        rest = self.fma(exponent, -_LN2_LOW, self.fma(exponent, -_LN2_HIGH, value))
        mantissa = self._kernel.bitcast(self._polynomial(_exp_coefficients(), rest), INT32)
        scaled = mantissa + (self._kernel.to_int32(exponent) << _MANTISSA_BITS)
        return self._kernel.bitcast(scaled, FLOAT)

    def _polynomial(self, coefficients: tuple[float, ...], t: SimdValue) -> SimdValue:
        """Horner's scheme; lowest power first."""
        total = self._kernel.varying(coefficients[-1])
        for coefficient in reversed(coefficients[:-1]):
            total = self.fma(total, t, coefficient)
        return total

    def _intrinsic(self, name: str, *operands: Operand) -> SimdValue:
        kernel = self._kernel
        vector = kernel.vector_type(FLOAT)
        full_name = f"llvm.{name}.v{kernel.target.width}f32"
        function = kernel.module.globals.get(full_name) or ir.Function(
            kernel.module, ir.FunctionType(vector, [vector] * len(operands)), full_name
        )
        arguments = [kernel.constant(operand, FLOAT) for operand in operands]
        return SimdValue(kernel, kernel.ir.call(function, arguments))


@cache
def _log_coefficients() -> tuple[float, ...]:
    """log2(1 + t)/t on √½ ≤ 1 + t ≤ √2."""
    return _fit(lambda t: np.log1p(t) / (t * math.log(2)), math.sqrt(0.5) - 1, math.sqrt(2) - 1, _LOG_DEGREE)


@cache
def _exp_coefficients() -> tuple[float, ...]:
    """e^t on |t| ≤ 0.51 ln 2: half a power of two and a margin for rounding."""
    return _fit(np.exp, -0.51 * math.log(2), 0.51 * math.log(2), _EXP_DEGREE)


def _fit(function: Callable[[Any], Any], low: float, high: float, degree: int) -> tuple[float, ...]:
    """Coefficients of the interpolating polynomial at Chebyshev nodes of [low, high], lowest power first."""
    chebyshev: Any = Chebyshev.interpolate(function, degree, [low, high])
    return tuple(chebyshev.convert(kind=Polynomial).coef.tolist())
