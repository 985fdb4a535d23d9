"""Frozen functions: replayed for objects with the same pytree structure, traced again for all others."""

from __future__ import annotations

import gc
from typing import Any

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Float

from loomlight.core.frozen import FrozenArg, FrozenFunction, gc_paused, named_leaves
from loomlight.core.llvm import require_llvm

require_llvm()


class Line:
    """y = slope·x + rise; an object of this project, as its module says."""

    def __init__(self, slope: float, rise: float) -> None:
        self.slope, self.rise = (dr.opaque(Float, number) for number in (slope, rise))

    def at(self, x: Any) -> Any:
        return self.slope * x + self.rise


class Parabola(Line):
    def at(self, x: Any) -> Any:
        return super().at(x) * x


class Late(Line):
    """Uploads a number at first use."""

    offset: Any = None

    def at(self, x: Any) -> Any:
        if self.offset is None:
            self.offset = dr.opaque(Float, 1)
        return super().at(x) + self.offset


for kind in (Line, Parabola, Late):
    kind.__module__ = "loomlight.tests"


def recorded() -> FrozenFunction:
    return FrozenFunction(lambda line, x, power: line.at(x) ** power)


X = np.arange(1, 6, dtype=np.float32)


def values(function: FrozenFunction, line: Line, power: int, x: Any = X) -> list[float]:
    return list(function(FrozenArg(line), Float(x), power).numpy())


def test_other_numbers_in_the_same_places_need_no_trace() -> None:
    function = recorded()
    for slope, rise in ((1, 2), (3, 4), (0, 1), (1, 2)):
        assert values(function, Line(slope, rise), 1) == list(slope * X + rise)
    assert function.recordings == 1


def test_what_is_traced_with_python_is_traced_anew() -> None:
    function = recorded()
    assert values(function, Line(1, 2), 1) == list(X + 2)
    # Numbers of Python's, classes, and what holds one number where others hold several.
    assert values(function, Line(1, 2), 2) == list((X + 2) ** 2)
    assert values(function, Parabola(1, 2), 1) == list((X + 2) * X)
    assert values(function, Line(1, 2), 1, X[:1]) == [3]
    assert function.recordings == 4
    assert values(function, Parabola(2, 1), 1) == list((2 * X + 1) * X)
    assert values(function, Line(2, 1), 2) == list((2 * X + 1) ** 2)
    assert function.recordings == 4


def test_so_many_recordings_are_kept() -> None:
    function = recorded()
    for power in (*range(1, 20), 1):
        assert values(function, Line(1, 0), power) == pytest.approx(list(X**power))
    assert 1 < function.kept <= 8


def test_what_is_uploaded_too_late_is_refused() -> None:
    """The recording would go on reading the first object's number."""
    function = recorded()
    line = Late(1, 2)
    with pytest.raises(RuntimeError, match="Late was uploaded while it was recorded"):
        function(FrozenArg(line), Float(X), 1)
    assert function.kept == 0
    assert values(function, line, 1) == list(X + 3)


def test_recordings_keep_no_object() -> None:
    function = recorded()
    line = Line(1, 2)
    values(function, line, 1)
    assert not [holder for holder in gc.get_referrers(line) if isinstance(holder, FrozenArg)]


def test_names_tell_places_and_classes_in_whatever_order_arrays_came() -> None:
    first, second = Line(1, 2), Line(1, 2)
    second.slope = second.__dict__.pop("slope")
    assert list(named_leaves(first)) == list(named_leaves(second)) == ["Line.rise:Float", "Line.slope:Float"]
    assert not named_leaves(Parabola(1, 2)).keys() & named_leaves(first).keys()


def test_collecting_is_put_off_and_taken_up_again() -> None:
    def fail() -> None:
        with gc_paused():
            assert not gc.isenabled()
            raise KeyError

    assert gc.isenabled()
    with pytest.raises(KeyError):
        fail()
    assert gc.isenabled()
