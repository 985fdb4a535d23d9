"""Operands of SIMD kernels: varying values, uniforms, and buffers of uniforms.

The terms are ISPC's: a varying value holds one number per lane (one lane is one query), a uniform is the same
in all lanes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from llvmlite import ir

if TYPE_CHECKING:
    from loomlight.core.simd.kernel_builder import KernelBuilder

FLOAT, INT32, INDEX, MASK = ir.FloatType(), *(ir.IntType(bits) for bits in (32, 64, 1))

Operand: TypeAlias = "SimdValue | float"
"""A varying value, or a Python number that stands for the same number in all lanes."""

Index: TypeAlias = "ir.Value | int"
"""A 64-bit scalar of the kernel (type INDEX), or a Python integer."""

# "contract" lets LLVM fuse a product and a sum. "arcp" and "ninf" let it divide by a reciprocal estimate and
# one Newton step, which is wrong in the last two digits and takes a fifth of the time of a division.
_FAST_MATH = {"fdiv": ("arcp", "ninf")}
_ARITHMETIC = {
    "+": {FLOAT: "fadd", INT32: "add"},
    "-": {FLOAT: "fsub", INT32: "sub"},
    "*": {FLOAT: "fmul"},
    "/": {FLOAT: "fdiv"},
    "<<": {INT32: "shl"},
    ">>": {INT32: "ashr"},
    "&": {MASK: "and_"},
    "|": {MASK: "or_"},
}


class SimdValue:
    """One FLOAT, signed INT32 or MASK (truth value) per lane.

    Operators are those of the table above; comparisons and unary minus are of FLOAT. A Python number is
    converted to the element type of the value that it is combined with. Divisors must not be 0. Comparisons
    with NaN are false.
    """

    __slots__ = ("_value", "kernel")

    def __init__(self, kernel: KernelBuilder, value: ir.Value | None) -> None:
        self.kernel, self._value = kernel, value

    @property
    def value(self) -> ir.Value:
        """The LLVM vector."""
        return self._value

    @property
    def element(self) -> ir.Type:
        """FLOAT, INT32 or MASK."""
        return self.value.type.element

    def _binary(self, operator: str, other: Operand, reverse: bool = False) -> SimdValue:
        left = self.value
        element = left.type.element
        right = self.kernel.constant(other, element)
        if reverse:
            left, right = right, left
        name = _ARITHMETIC[operator][element]
        instruction = getattr(self.kernel.ir, name)
        if element != FLOAT:
            return SimdValue(self.kernel, instruction(left, right))
        return SimdValue(self.kernel, instruction(left, right, flags=_FAST_MATH.get(name, ("contract",))))

    def __add__(self, other: Operand) -> SimdValue:
        return self._binary("+", other)

    __radd__ = __add__

    def __sub__(self, other: Operand) -> SimdValue:
        return self._binary("-", other)

    def __rsub__(self, other: Operand) -> SimdValue:
        return self._binary("-", other, reverse=True)

    def __mul__(self, other: Operand) -> SimdValue:
        return self._binary("*", other)

    __rmul__ = __mul__

    def __truediv__(self, other: Operand) -> SimdValue:
        return self._binary("/", other)

    def __rtruediv__(self, other: Operand) -> SimdValue:
        return self._binary("/", other, reverse=True)

    def __lshift__(self, other: Operand) -> SimdValue:
        return self._binary("<<", other)

    def __rshift__(self, other: Operand) -> SimdValue:
        return self._binary(">>", other)

    def __and__(self, other: Operand) -> SimdValue:
        return self._binary("&", other)

    def __or__(self, other: Operand) -> SimdValue:
        return self._binary("|", other)

    def __invert__(self) -> SimdValue:
        return SimdValue(self.kernel, self.kernel.ir.not_(self.value))

    def __neg__(self) -> SimdValue:
        return SimdValue(self.kernel, self.kernel.ir.fneg(self.value))

    def _compare(self, relation: str, other: Operand) -> SimdValue:
        pair = self.value, self.kernel.constant(other, FLOAT)
        return SimdValue(self.kernel, self.kernel.ir.fcmp_ordered(relation, *pair))

    def __lt__(self, other: Operand) -> SimdValue:
        return self._compare("<", other)

    def __le__(self, other: Operand) -> SimdValue:
        return self._compare("<=", other)

    def __gt__(self, other: Operand) -> SimdValue:
        return self._compare(">", other)

    def __ge__(self, other: Operand) -> SimdValue:
        return self._compare(">=", other)


class Uniform(SimdValue):
    """An element of a buffer, the same in all lanes.

    It is loaded at each use, so that LLVM folds it into a memory operand instead of keeping a register.
    """

    __slots__ = ("_buffer", "_index")

    def __init__(self, buffer: UniformBuffer, index: Index) -> None:
        super().__init__(buffer.kernel, None)
        self._buffer, self._index = buffer, index

    @property
    def value(self) -> ir.Value:
        return self.kernel.load_broadcast(self._buffer.pointer, self._index).value


@dataclass(frozen=True)
class UniformBuffer:
    """A float32 array that all queries read: weights, tables, parameters.

    Attributes:
        number: its place among the uniform buffers of the kernel.
    """

    kernel: KernelBuilder
    number: int

    @property
    def pointer(self) -> ir.Value:
        """Address of the first element."""
        return self.kernel.uniform_pointer(self.number)

    def __getitem__(self, index: Index) -> Uniform:
        return Uniform(self, index)

    def load(self, index: Index) -> SimdValue:
        """An element that is loaded once, here, for all its uses."""
        return self.kernel.load_broadcast(self.pointer, index)
