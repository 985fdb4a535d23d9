"""Dr.Jit array types that belong together, derived from the arrays a caller passes in.

The physics is written once for all backends: it uses the types that belong to its arguments. Below: branches
that few lanes take, and division by a number that kernels do not depend on.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from types import SimpleNamespace
from typing import Any, TypeVar

import drjit as dr
import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.core.arrays import Array, Color3, Float, FloatType, Mask, UInt


@dataclass(frozen=True)
class ArrayTypes:
    """The array types of one backend and precision; `Color3` and `Vector3` have three `Float`.

    `Vectors` and `Indices` have any number of components.
    """

    Float: Any
    UInt32: Any
    Int32: Any
    Bool: Any
    Vector2: Any
    Vector3: Any
    Vector4: Any
    Vectors: Any
    Color3: Any
    Index2: Any
    Index4: Any
    Indices: Any
    PCG32: Any


@cache
def _types_of(float_type: type) -> ArrayTypes:
    module = import_module(float_type.__module__)
    precision = "f64" if dr.type_v(float_type) == dr.VarType.Float64 else "f"
    return ArrayTypes(
        Float=float_type,
        UInt32=dr.uint32_array_t(float_type),
        Int32=dr.int32_array_t(float_type),
        Bool=dr.mask_t(float_type),
        Vector2=getattr(module, f"Array2{precision}"),
        Vector3=getattr(module, f"Array3{precision}"),
        Vector4=getattr(module, f"Array4{precision}"),
        Vectors=getattr(module, f"ArrayX{precision}"),
        Color3=getattr(module, f"Array3{precision}"),
        Index2=module.Array2u,
        Index4=module.Array4u,
        Indices=module.ArrayXu,
        PCG32=module.PCG32,
    )


def array_types(example: Array | FloatType) -> ArrayTypes:
    """The types that belong to `example`, a float array or a vector of floats of any Dr.Jit backend."""
    kind = example if isinstance(example, type) else type(example)
    while dr.depth_v(kind) > 1:
        kind = dr.value_t(kind)
    return _types_of(kind)


def maximum(first: Float, second: Float) -> Float:
    """The larger one of two Dr.Jit numbers or arrays, lane by lane; the second where either is NaN.

    `dr.maximum` propagates NaN and orders −0 before +0, for which LLVM needs five more instructions on x86: a
    tenth of the time of searches along rays, which are full of bounds.
    """
    return dr.select(first > second, first, second) if _compares(first, second) else dr.maximum(first, second)


def minimum(first: Float, second: Float) -> Float:
    """The smaller one of two Dr.Jit numbers or arrays; see `maximum`."""
    return dr.select(first < second, first, second) if _compares(first, second) else dr.minimum(first, second)


def clip(value: Float, low: Float, high: Float) -> Float:
    """A Dr.Jit number or array clipped to the range from `low` to `high`; `low` where it is NaN."""
    return minimum(maximum(value, low), high)


def _compares(first: Float, second: Float) -> bool:
    # A comparison of literals selects one of them, which would drop derivatives.
    on_cpu = dr.JitBackend.LLVM in (dr.backend_v(first), dr.backend_v(second))
    return on_cpu and not dr.grad_enabled(first, second)


# Functions of Dr.Jit arrays, for formulas that take the module of array functions as an argument.
DRJIT: Any = SimpleNamespace(**{**vars(dr), "clip": clip, "maximum": maximum, "minimum": minimum})


def channel_mean(colour: Color3) -> Float:
    """Mean of the channels of a Dr.Jit colour or spectrum: Float.

    `dr.mean` would make the number of lanes a literal, and compile kernels again for every other number.
    """
    return dr.sum(colour) * (1 / len(colour))


def opaque(kind: FloatType, numbers: ArrayLike) -> Any:
    """A number as a Dr.Jit array of type `kind` that is no constant of kernels; of nested lists lists."""
    values = np.asarray(numbers)
    return dr.opaque(kind, values.item()) if values.ndim == 0 else [opaque(kind, part) for part in values]


def upload(kind: FloatType, values: ArrayLike) -> Array:
    """Numbers as a flat Dr.Jit array of type `kind`, in row-major order.

    On the CPU Dr.Jit would use NumPy's memory: kernels would be compiled again when its alignment differs,
    and frozen functions would keep reading the memory of their recording. So numbers are copied.
    """
    flat = np.ravel(np.asarray(values))
    if dr.backend_v(kind) != dr.JitBackend.LLVM or flat.size == 0:
        return kind(np.ascontiguousarray(flat))
    array: Array = dr.empty(kind, flat.size)
    # Running kernels may still read freed memory that is reused here.
    dr.sync_thread()
    array.numpy()[:] = flat
    return array


def upload_vector(kind: Any, columns: ArrayLike) -> Any:
    """Components [size, n] as a Dr.Jit vector of type `kind`, each copied as `upload` does."""
    return kind(*(upload(dr.value_t(kind), column) for column in np.asarray(columns)))


def move(kind: FloatType, values: NDArray[Any]) -> tuple[Array, NDArray[Any]]:
    """`upload`, and the numbers again: on the CPU in the array's memory, so that they are held once."""
    array = upload(kind, values)
    if dr.backend_v(kind) != dr.JitBackend.LLVM or values.size == 0:
        return array, values
    return array, array.numpy().reshape(values.shape)


# ------------------------------------------------------------------------------- branches that few lanes take

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


# --------------------------------------------------------- division by a number that kernels do not depend on
# CPUs have no SIMD instruction for integer division. A multiplication and shifts give the same quotient.


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
