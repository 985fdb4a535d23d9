"""Pytree leaves: Dr.Jit arrays that objects of this project hold; frozen functions must be given them."""

from __future__ import annotations

from typing import Any

import drjit as dr

from loomlight.core.arrays import Array

_OURS = "loomlight."


def is_ours(value: object) -> bool:
    """Whether an object is of a class of this project that has attributes."""
    return type(value).__module__.startswith(_OURS) and hasattr(value, "__dict__")


def leaves(holder: object) -> list[Array]:
    """Every Dr.Jit array that an object of this project holds, however deep, each once, in a fixed order."""
    found: list[Array] = []
    seen: set[int] = set()
    waiting: list[Any] = [holder]
    while waiting:
        value = waiting.pop()
        if id(value) in seen or isinstance(value, type):
            continue
        seen.add(id(value))
        if dr.is_array_v(value):
            found.append(value)
        elif isinstance(value, dict):
            waiting.extend(value.values())
        elif isinstance(value, list | tuple):
            waiting.extend(value)
        elif is_ours(value):
            waiting.extend(vars(value).values())
    return found


def named_leaves(holder: object) -> dict[str, Array]:
    """The same by where they lie, which tells the classes on the way: sorted, whenever each came to be.

    An array that lies in several places is there several times.
    """
    found: dict[str, Array] = {}
    waiting: list[tuple[str, Any]] = [(type(holder).__name__, holder)]
    while waiting:
        path, value = waiting.pop()
        if isinstance(value, type):
            continue
        if dr.is_array_v(value):
            found[path] = value
            continue
        parts: dict[Any, Any] = {}
        if isinstance(value, dict):
            parts = value
        elif isinstance(value, list | tuple):
            parts = dict(enumerate(value))
        elif is_ours(value):
            parts = vars(value)
        waiting.extend((f"{path}.{name}:{type(part).__name__}", part) for name, part in parts.items())
    return dict(sorted(found.items()))
