"""Dr.Jit array types that belong together, derived from the arrays a caller passes in.

The physics is written once: it never names a backend, it asks for the types that go with its arguments.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from importlib import import_module
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import ArrayLike

# Bytes of the widest vector that Dr.Jit loads at once: 16 numbers of double precision.
_ALIGNMENT = 128


@dataclass(frozen=True)
class ArrayTypes:
    """The array types of one backend and precision; `Color3` and `Vector3` hold three `Float`."""

    Float: Any
    UInt32: Any
    Int32: Any
    Bool: Any
    Vector2: Any
    Vector3: Any
    Vector4: Any
    Color3: Any
    Index2: Any
    Index4: Any
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
        Color3=getattr(module, f"Array3{precision}"),
        Index2=module.Array2u,
        Index4=module.Array4u,
        PCG32=module.PCG32,
    )


def array_types(example: Any) -> ArrayTypes:
    """The types that go with `example`, a float array or a vector of floats of any Dr.Jit backend."""
    kind = example if isinstance(example, type) else type(example)
    while dr.depth_v(kind) > 1:
        kind = dr.value_t(kind)
    return _types_of(kind)


def uploaded(kind: Any, values: ArrayLike) -> Any:
    """Numbers as a flat Dr.Jit array of type `kind`, in row-major order.

    On the CPU Dr.Jit uses numpy's memory as it is, and compiles kernels anew when its alignment differs. Here
    all arrays are aligned alike.
    """
    flat = np.ravel(np.asarray(values))
    memory = np.empty(flat.nbytes + _ALIGNMENT, np.uint8)
    start = -memory.ctypes.data % _ALIGNMENT
    copy = memory[start : start + flat.nbytes].view(flat.dtype)
    copy[:] = flat
    return kind(copy)
