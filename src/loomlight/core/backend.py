"""Dr.Jit array types that belong together, derived from the arrays a caller passes in.

The physics is written once for all backends: it uses the types that belong to its arguments.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from importlib import import_module
from types import SimpleNamespace
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.core.arrays import Array, Color3, Float, FloatType


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


def move(kind: FloatType, values: NDArray[Any]) -> tuple[Array, NDArray[Any]]:
    """`upload`, and the numbers again: on the CPU in the array's memory, so that they are held once."""
    array = upload(kind, values)
    if dr.backend_v(kind) != dr.JitBackend.LLVM or values.size == 0:
        return array, values
    return array, array.numpy().reshape(values.shape)
