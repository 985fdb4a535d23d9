"""Pytree leaves of objects of this project."""

from __future__ import annotations

import drjit as dr
from drjit.llvm import Array3f, Float

from loomlight.core.footprint import Box, Footprint
from loomlight.core.frozen import is_ours, leaves, named_leaves


def footprint() -> Footprint:
    types = dr.llvm.Array2f
    return Footprint(types(1, 2), types(3, 4), types(5, 6))


def test_objects_of_this_project_are_ours() -> None:
    assert is_ours(footprint())
    assert not is_ours({})
    assert not is_ours(Float(1))


def test_leaves_are_found_however_deep_and_once() -> None:
    shared = Float(1)
    holder = Box(centre=[shared, {"a": (shared, Array3f(1, 2, 3))}], size=footprint())
    actual = leaves(holder)
    assert sum(leaf is shared for leaf in actual) == 1
    assert len(actual) == 1 + 1 + 3


def test_circles_end() -> None:
    holder = Box(centre=Float(1), size=None)
    holder.size = [holder]
    assert len(leaves(holder)) == 1


def test_names_tell_places_and_classes() -> None:
    actual = named_leaves(Box(centre=Float(1), size=[Float(2)]))
    assert list(actual) == ["Box.centre:Float", "Box.size:list.0:Float"]
    assert list(named_leaves(footprint())) == sorted(named_leaves(footprint()))


def test_an_array_in_two_places_has_two_names() -> None:
    shared = Float(1)
    assert len(named_leaves(Box(centre=shared, size=shared))) == 2
