"""Frozen Dr.Jit functions of objects: traced once, then replayed.

Tracing the physics takes Python milliseconds, whatever the number of lanes. `dr.freeze` records the kernels
and replays them on other arrays, but it finds arrays in plain containers only and compares objects by
identity. Here an object is passed as its pytree leaves.
"""

from __future__ import annotations

import functools
import gc
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import SimpleNamespace
from typing import Any, Generic, TypeVar

import drjit as dr

from loomlight.core.arrays import Array

# Most recordings of one function; the least recently used are dropped.
_MAX_RECORDINGS = 8
# Disables Dr.Jit's warning of functions that are recorded often, as edits of a weave do.
_NEVER = 1 << 30
_Value = TypeVar("_Value")


@contextmanager
def gc_paused() -> Iterator[None]:
    """Pauses garbage collection: freeing a BSDF while Dr.Jit traces a call crashes the process."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def frozen(function: Callable[..., object], *, enabled: bool = True) -> Any:
    """A function frozen by `dr.freeze`, with at most `_MAX_RECORDINGS` recordings."""
    return dr.freeze(function, auto_opaque=False, limit=_MAX_RECORDINGS, warn_after=_NEVER, enabled=enabled)


class FrozenArg(Generic[_Value]):
    """An object of this project as the argument of a `FrozenFunction`.

    Attributes that the function reads must be evaluated arrays, or equal for all objects with the same pytree
    structure: Python numbers become constants of the recording.
    """

    def __init__(self, value: _Value) -> None:
        self.value = value
        self.arrays = named_leaves(value)


class _UntracedArgs:
    """Arguments for tracing that Dr.Jit does not compare: equal to any other."""

    def __init__(self, holders: list[FrozenArg[object] | None]) -> None:
        self.holders = holders

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _UntracedArgs)

    def __hash__(self) -> int:
        return 0


class FrozenFunction:
    """A frozen Dr.Jit function: replays recorded kernels if the arguments' structure and sizes match.

    Arguments are `FrozenArg` objects, whose values are passed on, containers of Dr.Jit arrays, and Python
    numbers. The function is traced again if Python numbers differ, if objects have arrays at other paths or
    in other classes, and if other arrays share a size or have size 1. Python numbers that sizes depend on
    must be arguments. The function returns containers of arrays, and must not read arrays on the host.

    Attributes:
        traced: the function itself.
    """

    def __init__(self, function: Callable[..., Array]) -> None:
        functools.update_wrapper(self, function)
        self.traced = function

        def launch(untraced: _UntracedArgs, inputs: list[Array]) -> Array:
            return function(
                *(
                    argument if holder is None else holder.value
                    for holder, argument in zip(untraced.holders, inputs, strict=True)
                )
            )

        self._launch = frozen(launch)

    @property
    def recordings(self) -> int:
        """Number of recordings made."""
        return int(self._launch.n_recordings)

    @property
    def kept(self) -> int:
        """Number of recordings in memory."""
        return int(self._launch.n_cached_recordings)

    def __call__(self, *arguments: object) -> Any:
        """Calls the function and evaluates its result.

        Raises:
            RuntimeError: an object got other arrays while the function was traced: the recording would keep
                reading the present ones.
        """
        untraced = _UntracedArgs(
            [argument if isinstance(argument, FrozenArg) else None for argument in arguments]
        )
        inputs = [argument.arrays if isinstance(argument, FrozenArg) else argument for argument in arguments]
        before = self.recordings
        try:
            with gc_paused():
                result = self._launch(untraced, inputs)
        finally:
            # Recordings keep their first arguments.
            holders, untraced.holders = untraced.holders, []
        if self.recordings != before:
            for holder in holders:
                if holder is not None and named_leaves(holder.value).keys() != holder.arrays.keys():
                    self._launch.clear()
                    raise RuntimeError(f"{type(holder.value).__name__} was uploaded while it was recorded.")
        return result


# ---------------------------------------------------------------------------------------------- pytree leaves
# Pytree leaves: the Dr.Jit arrays of an object of this project, which are inputs of frozen functions.


_OURS = "loomlight."


def is_ours(value: object) -> bool:
    """Whether an object is of a class of this project that has attributes, or holds tables of a device."""
    ours = type(value).__module__.startswith(_OURS) and hasattr(value, "__dict__")
    # `Tables.upload` returns one.
    return ours or isinstance(value, SimpleNamespace)


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
