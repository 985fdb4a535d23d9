"""Functions of numbers that are Dr.Jit's arrays, or lanes of machine code that is being written.

Formulas that use these are written once for both. They are named as Dr.Jit has them, and cost no more there.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import drjit as dr
import numpy as np
from numpy.typing import ArrayLike

from loomlight.core import backend
from loomlight.core.backend import DRJIT
from loomlight.core.lane_code import Code
from loomlight.core.lane_values import LaneKind, Lanes, Vector, leaves_of

State = TypeVar("State")


def _code_of(values: tuple[Any, ...]) -> Code | None:
    """The code that lanes among values belong to."""
    for value in values:
        if isinstance(value, Lanes):
            return value.code
        if isinstance(value, Vector):
            return _code_of((value.x, value.y, value.z))
    return None


def _code_in(tree: Any) -> Code | None:
    return next((leaf.code for leaf in leaves_of(tree) if isinstance(leaf, Lanes)), None)


def array_types(example: Any) -> Any:
    """The types that go with an array, a vector of arrays or lanes; see `backend.array_types`."""
    code = _code_of((example,))
    return backend.array_types(example) if code is None else code.types


def _of_either(name: str) -> Callable[..., Any]:
    of_drjit = getattr(DRJIT, name)

    def function(*values: Any) -> Any:
        code = _code_of(values)
        return of_drjit(*values) if code is None else getattr(code, name)(*values)

    function.__name__ = name
    return function


asin = _of_either("asin")
clipped = _of_either("clip")
exp = _of_either("exp")
floor = _of_either("floor")
fma = _of_either("fma")
larger = _of_either("maximum")
log2 = _of_either("log2")
rcp = _of_either("rcp")
rsqrt = _of_either("rsqrt")
sincos = _of_either("sincos")
smaller = _of_either("minimum")
sqrt = _of_either("sqrt")
square = _of_either("square")


def select(condition: Any, first: Any, second: Any) -> Any:
    """The first where a condition holds, else the second; vectors too."""
    if isinstance(first, Vector) or isinstance(second, Vector):
        return _each_of(lambda a, b: select(condition, a, b), first, second)
    code = _code_of((condition, first, second))
    return dr.select(condition, first, second) if code is None else code.select(condition, first, second)


def _each_of(function: Callable[..., Any], *vectors: Any) -> Vector:
    parts = [(v.x, v.y, v.z) if isinstance(v, Vector) else (v, v, v) for v in vectors]
    return Vector(*(function(*axis) for axis in zip(*parts, strict=True)))


def dot(first: Any, second: Any) -> Any:
    """Scalar product."""
    if not isinstance(first, Vector):
        return dr.dot(first, second)
    return fma(first.x, second.x, fma(first.y, second.y, first.z * second.z))


def squared_norm(vector: Any) -> Any:
    """Scalar product with itself."""
    return dot(vector, vector) if isinstance(vector, Vector) else dr.squared_norm(vector)


def normalize(vector: Any) -> Any:
    """The unit vector of the same direction."""
    return vector * rsqrt(squared_norm(vector)) if isinstance(vector, Vector) else dr.normalize(vector)


def lerp(first: Any, second: Any, share: Any) -> Any:
    """first + share (second − first)."""
    if _code_of((first, second, share)) is None:
        return dr.lerp(first, second, share)
    return fma(share, second - first, first)


def detached(tree: State) -> State:
    """Without derivatives, which lanes do not have."""
    return tree if _code_in(tree) is not None else dr.detach(tree)


def opaque(kind: Any, number: float) -> Any:
    """A number of the fabric at hand: it is not part of the code."""
    if isinstance(kind, LaneKind):
        return kind(kind.code.shared_number(number))
    return dr.opaque(kind, number)


def uploaded(kind: Any, values: ArrayLike) -> Any:
    """A table of such a kind of numbers, for `gather`."""
    if isinstance(kind, LaneKind):
        return kind.code.shared_table(np.asarray(values), kind.element)
    return backend.uploaded(kind, values)


def gather(kind: Any, table: Any, index: Any) -> Any:
    """Elements of a table, or as many neighbours as a kind has."""
    if isinstance(kind, LaneKind):
        return kind.code.gather(kind, table, index)
    return dr.gather(kind, table, index)


def gather_one(kind: Any, table: Any, row: Any, first: Any, second: Any) -> Any:
    """Of rows of four the number that two Bools tell, the first of which counts 1 and the second 2."""
    if isinstance(kind, LaneKind):
        number = select(first, kind(1), 0) + select(second, kind(2), 0)
        return gather(kind, table, row * 4 + number)
    # All four at once: Dr.Jit fetches 16 bytes in a row sooner than 4 by themselves.
    four = dr.gather(backend.array_types(dr.float32_array_t(kind)).Index4, table, row)
    return select(second, select(first, four[3], four[2]), select(first, four[1], four[0]))


def while_loop(state: Any, condition: Callable[..., Any], body: Callable[..., Any], label: str) -> Any:
    """State, a tuple, changed by `body` as long as a condition of it holds, lane by lane."""
    code = _code_in(state)
    if code is None:
        return dr.while_loop(state, condition, body, label=label)
    return code.while_loop(state, condition, body)
