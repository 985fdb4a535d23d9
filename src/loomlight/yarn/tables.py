"""Tables of a layout that geometry reads: made in numpy once a layout, uploaded once a backend."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import product
from typing import Any
from weakref import WeakKeyDictionary

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, UInt
from loomlight.core.backend import ArrayTypes, move
from loomlight.yarn.cells import upload_family
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.max_heights import pack_max_heights
from loomlight.yarn.threads import (
    FamilyTables,
    pack_runs,
    prepare_family,
)

# Whole numbers that float32 tells apart.
_MAX_EXACT = 1 << 24
# Sides of the tiles in which words are transposed.
_TILE = 64


@dataclass
class LayoutTables:
    """Tables of warp and weft, words of both at each crossing [picks, ends, 2], max-height pyramid."""

    warp: FamilyTables
    weft: FamilyTables
    words: NDArray[np.uint32]
    max_heights: NDArray[np.uint32]
    _uploaded: dict[type, tuple[UInt, UInt]] = field(default_factory=dict)

    def upload(self, types: ArrayTypes) -> tuple[UInt, UInt]:
        """Words and pyramid on a backend."""
        if types.UInt32 not in self._uploaded:
            words, self.words = move(types.UInt32, self.words)
            max_heights, self.max_heights = move(types.UInt32, self.max_heights)
            self._uploaded[types.UInt32] = words, max_heights
        return self._uploaded[types.UInt32]


# Tables of all layouts in memory: the models of a fabric share its layout, and a draft of 4096 by 4096
# threads takes seconds. An edit of heights or twist makes another layout with the same threads.
_cache: WeakKeyDictionary[ClothLayout, LayoutTables] = WeakKeyDictionary()


def prepare_layout(layout: ClothLayout) -> LayoutTables:
    """Its tables, computed once for layouts that differ at most in height scales and twist."""
    found = _cache.get(layout)
    if found is None:
        same = (tables for other, tables in list(_cache.items()) if _has_same_threads(layout, other))
        found = _cache[layout] = next(same, None) or _prepare(layout)
    return found


def _has_same_threads(first: ClothLayout, second: ClothLayout) -> bool:
    """Whether two layouts differ at most in height scales and twist."""
    families = (first.warp, second.warp), (first.weft, second.weft)
    return np.array_equal(first.warp_on_top, second.warp_on_top) and all(
        a.inclination == b.inclination
        and np.array_equal(a.spacing, b.spacing)
        and np.array_equal(a.width, b.width)
        for a, b in families
    )


def _prepare(layout: ClothLayout) -> LayoutTables:
    on_top = layout.warp_on_top
    words = np.empty((*on_top.shape, 2), np.uint32)
    of_family = pack_runs(on_top)
    warp = prepare_family(layout.warp, layout.weft, of_family)
    words[..., 0] = of_family
    of_family = pack_runs(~on_top.T)
    weft = prepare_family(layout.weft, layout.warp, of_family)
    # Square tiles: whole rows of one array are columns of the other, which caches do not hold.
    tiles = [[slice(first, first + _TILE) for first in range(0, count, _TILE)] for count in on_top.shape]
    for picks, ends in product(*tiles):
        words[picks, ends, 1] = of_family[ends, picks].T
    del of_family
    return LayoutTables(warp, weft, words, pack_max_heights(words))


class DeviceTables:
    """The tables of a layout on one backend. Numbers are opaque to Dr.Jit: all fabrics share kernels."""

    def __init__(self, layout: ClothLayout, types: ArrayTypes) -> None:
        tables = prepare_layout(layout)
        self.warp: Any = upload_family(tables.warp, types)
        self.weft: Any = upload_family(tables.weft, types)
        self.words, self.max_heights = tables.upload(types)
        # Single precision, which is faster, tells the words of 4096 by 4096 crossings apart.
        exact = types.Float if layout.warp_on_top.size <= _MAX_EXACT else types.UInt32
        self.ends: Any = dr.opaque(exact, tables.words.shape[1])
        self.max_height_columns = dr.opaque(types.UInt32, tables.max_heights.shape[1])
        self.scalar = Scalars(types)


class Scalars:
    """Numbers of a fabric by name, as opaque Floats of one backend; Dr.Jit scalars as they are."""

    def __init__(self, types: ArrayTypes) -> None:
        self._float = types.Float
        self._kept: dict[str, tuple[float, Float]] = {}

    def __call__(self, name: str, value: Float) -> Float:
        if not isinstance(value, int | float):
            return self._float(value)
        # By name: two equal numbers under one name would be one variable, and kernels would differ.
        if name not in self._kept or self._kept[name][0] != value:
            self._kept[name] = value, dr.opaque(self._float, value)
        return self._kept[name][1]
