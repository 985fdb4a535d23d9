"""Frozen Dr.Jit functions of objects: traced once, then replayed.

Tracing the physics takes Python milliseconds, whatever the number of lanes. `dr.freeze` records the kernels
and replays them on other arrays, but it looks for arrays in plain containers only and tells objects apart by
identity. Here an object stands for the arrays that it holds.
"""

from __future__ import annotations

import functools
import gc
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Generic, TypeVar

import drjit as dr

from loomlight.core.arrays import Array
from loomlight.core.pytree import named_leaves

# Recordings of one function: those used longest ago are dropped beyond.
_MOST_RECORDINGS = 8
# Dr.Jit warns of functions that are recorded more often; editing a weave does that.
_NEVER = 1 << 30
_Value = TypeVar("_Value")


@contextmanager
def gc_paused() -> Iterator[None]:
    """Pauses garbage collection: a BSDF that is freed while Dr.Jit traces a call ends the process."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def frozen(function: Callable[..., object], *, enabled: bool = True) -> Any:
    """Dr.Jit's frozen function, of which so many recordings are kept."""
    return dr.freeze(function, auto_opaque=False, limit=_MOST_RECORDINGS, warn_after=_NEVER, enabled=enabled)


class FrozenArg(Generic[_Value]):
    """An object of this project as the argument of a `FrozenFunction`.

    What the function reads of it must be evaluated arrays that it already holds, or be equal for all objects
    with the same pytree structure: Python numbers become part of the recording.
    """

    def __init__(self, value: _Value) -> None:
        self.value = value
        self.arrays = named_leaves(value)


class _Unseen:
    """What a function is traced with and not told apart by: equal to any other."""

    def __init__(self, holders: list[FrozenArg[object] | None]) -> None:
        self.holders = holders

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Unseen)

    def __hash__(self) -> int:
        return 0


class FrozenFunction:
    """A frozen Dr.Jit function: replays recorded kernels if the arguments' structure and sizes match.

    Arguments are `FrozenArg` objects, whose values the function gets, containers of Dr.Jit arrays, and Python
    numbers. It is traced again where Python numbers differ, where objects hold arrays at other places or in
    other classes, and where other arrays share a size or have size 1. Sizes that depend on Python numbers
    must have those numbers among the arguments. The function returns containers of arrays and reads none.

    Attributes:
        traced: the function itself.
    """

    def __init__(self, function: Callable[..., Array]) -> None:
        functools.update_wrapper(self, function)
        self.traced = function

        def launched(unseen: _Unseen, inputs: list[Array]) -> Array:
            return function(
                *(
                    given if holder is None else holder.value
                    for holder, given in zip(unseen.holders, inputs, strict=True)
                )
            )

        self._launch = frozen(launched)

    @property
    def recordings(self) -> int:
        """How often it was recorded."""
        return int(self._launch.n_recordings)

    @property
    def kept(self) -> int:
        """How many recordings are kept."""
        return int(self._launch.n_cached_recordings)

    def __call__(self, *arguments: object) -> Any:
        """What the function returns, evaluated.

        Raises:
            RuntimeError: an object came to hold other arrays while the function was traced: the recording
                would go on reading the ones of today.
        """
        unseen = _Unseen([given if isinstance(given, FrozenArg) else None for given in arguments])
        inputs = [given.arrays if isinstance(given, FrozenArg) else given for given in arguments]
        before = self.recordings
        try:
            with gc_paused():
                result = self._launch(unseen, inputs)
        finally:
            # Recordings keep their first arguments.
            held, unseen.holders = unseen.holders, []
        if self.recordings != before:
            for holder in held:
                if holder is not None and named_leaves(holder.value).keys() != holder.arrays.keys():
                    self._launch.clear()
                    raise RuntimeError(f"{type(holder.value).__name__} was uploaded while it was recorded.")
        return result
