"""What code of `lane_code` works with: numbers for each lane, vectors of them, and what all queries share."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, is_dataclass
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

if TYPE_CHECKING:
    from loomlight.core.lane_code import Code

FLOAT, BYTE, WHOLE, INDEX, TRUTH = ir.FloatType(), *(ir.IntType(bits) for bits in (8, 32, 64, 1))

# What LLVM may do: fuse a product and a sum; for a quotient of finite numbers, take an estimate of the
# reciprocal and one step of Newton's, off by a few last digits, where a division takes five times as long.
_FREEDOMS = {"fdiv": ["arcp", "ninf"]}


class Lanes:
    """A number for each lane, or a whole one, or what is true in which. Divisors must not be 0.

    Whole numbers have 32 bits. They have a sign where they become floats; comparisons and shifts know none.
    Numbers of Python's become of the kind of what they meet.
    """

    __slots__ = ("_value", "code")

    def __init__(self, code: Code, value: Any) -> None:
        self.code, self._value = code, value

    @property
    def value(self) -> ir.Value:
        """What LLVM has it as."""
        return self._value

    @property
    def kind(self) -> ir.Type:
        """FLOAT, WHOLE or TRUTH."""
        return self.value.type.element

    def _with(self, other: Any, operations: dict[ir.Type, str], turned: bool = False) -> Lanes:
        own = self.value
        kind = own.type.element
        pair = own, self.code.constant(other, kind)
        first, second = reversed(pair) if turned else pair
        operation = operations[kind]
        write = getattr(self.code.builder, operation)
        if kind != FLOAT:
            return Lanes(self.code, write(first, second))
        return Lanes(self.code, write(first, second, flags=_FREEDOMS.get(operation, ["contract"])))

    def __add__(self, other: Any) -> Lanes:
        return self._with(other, {FLOAT: "fadd", WHOLE: "add"})

    __radd__ = __add__

    def __sub__(self, other: Any) -> Lanes:
        return self._with(other, {FLOAT: "fsub", WHOLE: "sub"})

    def __rsub__(self, other: Any) -> Lanes:
        return self._with(other, {FLOAT: "fsub", WHOLE: "sub"}, turned=True)

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, Vector):
            return other * self
        return self._with(other, {FLOAT: "fmul", WHOLE: "mul"})

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Lanes:
        return self._with(other, {FLOAT: "fdiv"})

    def __rtruediv__(self, other: Any) -> Lanes:
        return self._with(other, {FLOAT: "fdiv"}, turned=True)

    def __floordiv__(self, other: Any) -> Lanes:
        return self._with(other, {WHOLE: "udiv"})

    def __neg__(self) -> Lanes:
        return Lanes(self.code, self.code.builder.fneg(self.value)) if self.kind == FLOAT else 0 - self

    def __abs__(self) -> Lanes:
        return self.code.abs(self)

    def _compared(self, relation: str, other: Any) -> Lanes:
        own, builder = self.value, self.code.builder
        second = self.code.constant(other, own.type.element)
        if own.type.element == FLOAT:
            return Lanes(self.code, builder.fcmp_ordered(relation, own, second))
        # What is below 0, or comes of no number at all, is larger than what bounds indices.
        return Lanes(self.code, builder.icmp_unsigned(relation, own, second))

    def __lt__(self, other: Any) -> Lanes:
        return self._compared("<", other)

    def __le__(self, other: Any) -> Lanes:
        return self._compared("<=", other)

    def __gt__(self, other: Any) -> Lanes:
        return self._compared(">", other)

    def __ge__(self, other: Any) -> Lanes:
        return self._compared(">=", other)

    def __eq__(self, other: Any) -> Any:
        return self._compared("==", other)

    # Lanes that are equal in some places are not one key of a dictionary.
    __hash__ = None  # type: ignore[assignment]  # Python's own way to say so, which mypy does not know

    def _bits(self, other: Any, operation: str) -> Lanes:
        return self._with(other, {WHOLE: operation, TRUTH: operation})

    def __and__(self, other: Any) -> Lanes:
        return self._bits(other, "and_")

    def __or__(self, other: Any) -> Lanes:
        return self._bits(other, "or_")

    def __xor__(self, other: Any) -> Lanes:
        return self._bits(other, "xor")

    __rand__, __ror__, __rxor__ = __and__, __or__, __xor__

    def __invert__(self) -> Lanes:
        return self ^ (True if self.kind == TRUTH else -1)

    def __rshift__(self, other: Any) -> Lanes:
        return self._with(other, {WHOLE: "lshr"})

    def __lshift__(self, other: Any) -> Lanes:
        return self._with(other, {WHOLE: "shl"})


class SharedNumber(Lanes):
    """A number that all queries share, read where it is used: instructions take it from memory as it is."""

    __slots__ = ()

    @property
    def value(self) -> ir.Value:
        return self.code.shared(self.code.array(self._value[0]), self._value[1]).value


@dataclass
class Table:
    """Numbers that all queries share and look up.

    Attributes:
        kind: FLOAT or WHOLE.
        array: which of the code's arrays they are.
    """

    kind: ir.Type
    array: int


@dataclass
class Vector:
    """A vector of space, or of a plane with z = 0."""

    x: Any
    y: Any
    z: Any = 0.0

    def __add__(self, other: Vector) -> Vector:
        return Vector(self.x + other.x, self.y + other.y, self.z + other.z)

    def __sub__(self, other: Vector) -> Vector:
        return Vector(self.x - other.x, self.y - other.y, self.z - other.z)

    def __neg__(self) -> Vector:
        return Vector(-self.x, -self.y, -self.z)

    def __mul__(self, factor: Any) -> Vector:
        return Vector(self.x * factor, self.y * factor, self.z * factor)

    __rmul__ = __mul__


@dataclass(frozen=True)
class LaneKind:
    """Makes lanes of a kind, and says what `Code.gather` looks up: so many neighbours at once."""

    code: SharedByQueries
    element: ir.Type
    count: int = 1

    def __call__(self, value: Any) -> Any:
        return self.code.converted(value, self.element)


class SharedByQueries(Protocol):
    """What takes numbers and tables that all queries share, in the order in which they are put there."""

    def gather(self, kind: LaneKind, table: Any, index: Any) -> Any:
        """Elements of a table."""

    def shared_number(self, number: float) -> Any:
        """The next number."""

    def shared_table(self, values: NDArray[Any], kind: ir.Type) -> Any:
        """The next table."""

    def converted(self, value: Any, kind: ir.Type) -> Any:
        """Lanes of a kind."""


class LaneTypes:
    """The kinds of lanes of some code, by the names that `core.backend.ArrayTypes` has for arrays."""

    def __init__(self, code: SharedByQueries) -> None:
        self.code = code
        self.Float, self.Bool = LaneKind(code, FLOAT), LaneKind(code, TRUTH)
        self.UInt32 = self.Int32 = LaneKind(code, WHOLE)
        self.Vector4 = LaneKind(code, FLOAT, 4)
        self.Index2, self.Index4 = LaneKind(code, WHOLE, 2), LaneKind(code, WHOLE, 4)
        self.Vector2 = self.Vector3 = Vector


class SharedNumbers:
    """Numbers and tables that code reads, of one fabric: collected as the code was written."""

    def __init__(self) -> None:
        self.types = LaneTypes(self)
        self._numbers: list[float] = []
        self._tables: list[NDArray[np.float32]] = []

    def shared_number(self, number: float) -> None:
        """Takes the next number."""
        self._numbers.append(number)

    def shared_table(self, values: NDArray[Any], kind: ir.Type) -> None:
        """Takes the next table."""
        dtype = np.float32 if kind == FLOAT else np.uint32
        self._tables.append(np.ascontiguousarray(values.ravel(), dtype).view(np.float32))

    def converted(self, value: Any, kind: ir.Type) -> Any:
        """There are no lanes here."""

    def gather(self, kind: LaneKind, table: Any, index: Any) -> Any:
        """There are no lanes here."""

    def arrays(self) -> list[NDArray[np.float32]]:
        """What code finds from its first shared array on."""
        return [np.array(self._numbers, np.float32), *self._tables]


def leaves_of(tree: Any) -> list[Any]:
    """The lanes, and numbers of Python's, of a tree of tuples, lists and dataclasses, one after another."""
    if isinstance(tree, tuple | list):
        return [leaf for part in tree for leaf in leaves_of(part)]
    if is_dataclass(tree):
        return [leaf for field in fields(tree) for leaf in leaves_of(getattr(tree, field.name))]
    return [tree]


def with_leaves(tree: Any, leaves: Iterator[Any]) -> Any:
    """A tree like another one, of other lanes."""
    if isinstance(tree, tuple | list):
        return type(tree)(with_leaves(part, leaves) for part in tree)
    if is_dataclass(tree):
        kind: Any = type(tree)
        return kind(*(with_leaves(getattr(tree, field.name), leaves) for field in fields(tree)))
    return next(leaves)
