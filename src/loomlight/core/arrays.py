"""Names of array types for signatures.

Dr.Jit's array types depend on backend and precision, which callers choose (`backend.array_types`), so a type
checker cannot check them: every alias below is `Any` to it, and documents the expected array.
"""

from __future__ import annotations

from typing import Any, TypeAlias

Float: TypeAlias = Any
"""One number a lane."""

UInt: TypeAlias = Any
"""One unsigned 32-bit integer a lane."""

Int: TypeAlias = Any
"""One signed 32-bit integer a lane."""

Mask: TypeAlias = Any
"""One truth value a lane; Python's True and False stand for all lanes."""

Vec2: TypeAlias = Any
"""Two Floats: a position or an edge on the cloth."""

Vec3: TypeAlias = Any
"""Three Floats: a direction or a position in space."""

Color3: TypeAlias = Any
"""Three Floats: linear RGB."""

Array: TypeAlias = Any
"""A Dr.Jit array of any type and shape."""

FloatType: TypeAlias = Any
"""The class of a Float, which names backend and precision."""
