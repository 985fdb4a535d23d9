"""Pytree leaves: the Dr.Jit arrays of an object of this project, which are inputs of frozen functions."""

from __future__ import annotations

from typing import Any

import drjit as dr

from loomlight.core.arrays import Array

_OURS = "loomlight."


def is_ours(value: object) -> bool:
    """Whether an object is of a class of this project that has attributes."""
    return type(value).__module__.startswith(_OURS) and hasattr(value, "__dict__")


def leaves(holder: object) -> list[Array]:
    """Every Dr.Jit array reachable from an object of this project, each once, in a fixed order."""
    arrays: list[Array] = []
    visited: set[int] = set()
    stack: list[Any] = [holder]
    while stack:
        value = stack.pop()
        if id(value) in visited or isinstance(value, type):
            continue
        visited.add(id(value))
        if dr.is_array_v(value):
            arrays.append(value)
        elif isinstance(value, dict):
            stack.extend(value.values())
        elif isinstance(value, list | tuple):
            stack.extend(value)
        elif is_ours(value):
            stack.extend(vars(value).values())
    return arrays


def named_leaves(holder: object) -> dict[str, Array]:
    """The arrays by their path of attributes and classes, sorted by path.

    An array with several paths occurs several times.
    """
    arrays: dict[str, Array] = {}
    stack: list[tuple[str, Any]] = [(type(holder).__name__, holder)]
    while stack:
        path, value = stack.pop()
        if isinstance(value, type):
            continue
        if dr.is_array_v(value):
            arrays[path] = value
            continue
        parts: dict[Any, Any] = {}
        if isinstance(value, dict):
            parts = value
        elif isinstance(value, list | tuple):
            parts = dict(enumerate(value))
        elif is_ours(value):
            parts = vars(value)
        stack.extend((f"{path}.{name}:{type(part).__name__}", part) for name, part in parts.items())
    return dict(sorted(arrays.items()))
