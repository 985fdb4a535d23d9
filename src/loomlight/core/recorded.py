"""Functions of Dr.Jit code that are traced once, and then only launched.

Tracing the physics takes Python milliseconds, whatever the number of lanes. Dr.Jit's frozen functions keep
what was launched, and launch it again on other arrays; but they look for arrays in plain containers alone,
and know objects by their identity. Here objects are known by the arrays that they hold.
"""

from __future__ import annotations

import functools
import gc
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Generic, TypeVar

import drjit as dr

from loomlight.core.held_arrays import named_arrays

# Recordings of one function: those used longest ago are dropped beyond.
_MOST_RECORDINGS = 8
# Dr.Jit warns of functions that are recorded more often; editing a weave does that.
_NEVER = 1 << 30
_Value = TypeVar("_Value")


@contextmanager
def collecting_later() -> Iterator[None]:
    """Without Python's garbage collector: BSDFs that it frees while Dr.Jit traces calls end the process."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def frozen(function: Callable[..., Any], *, enabled: bool = True) -> Any:
    """Dr.Jit's frozen function, of which so many recordings are kept."""
    return dr.freeze(function, auto_opaque=False, limit=_MOST_RECORDINGS, warn_after=_NEVER, enabled=enabled)


class Held(Generic[_Value]):
    """An object of this project as an argument of recorded functions.

    What a function reads of it has to be evaluated arrays that it holds by now, or the same for all objects
    whose arrays lie in the same places: numbers of Python's become part of the recording.
    """

    def __init__(self, value: _Value) -> None:
        self.value = value
        self.arrays = named_arrays(value)


class _Unseen:
    """What a function is traced with and not told apart by: equal to any other."""

    def __init__(self, holders: list[Held[Any] | None]) -> None:
        self.holders = holders

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Unseen)

    def __hash__(self) -> int:
        return 0


class Recorded:
    """A function that launches what it launched before where its arguments are of the same kind.

    Its arguments are `Held` objects, of which it gets the values, containers of Dr.Jit arrays, and numbers of
    Python's. It is recorded anew where such numbers are others, where objects hold arrays in other places or
    within other classes, and where other arrays are of one size, or of size 1. Sizes that Python's numbers
    decide have to be among its arguments. It returns containers of arrays, and must not read any.

    Attributes:
        traced: the function itself.
    """

    def __init__(self, function: Callable[..., Any]) -> None:
        functools.update_wrapper(self, function)
        self.traced = function

        def launched(unseen: _Unseen, inputs: list[Any]) -> Any:
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

    def __call__(self, *arguments: Any) -> Any:
        """What the function returns, evaluated.

        Raises:
            RuntimeError: an object came to hold other arrays while the function was traced: the recording
                would go on reading the ones of today.
        """
        unseen = _Unseen([given if isinstance(given, Held) else None for given in arguments])
        inputs = [given.arrays if isinstance(given, Held) else given for given in arguments]
        before = self.recordings
        try:
            with collecting_later():
                result = self._launch(unseen, inputs)
        finally:
            # Recordings keep their first arguments.
            held, unseen.holders = unseen.holders, []
        if self.recordings != before:
            for holder in held:
                if holder is not None and named_arrays(holder.value).keys() != holder.arrays.keys():
                    self._launch.clear()
                    raise RuntimeError(f"{type(holder.value).__name__} was uploaded while it was recorded.")
        return result
