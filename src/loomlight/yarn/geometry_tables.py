"""Tables of a layout that `geometry` reads: prepared in numpy once per layout, uploaded once per backend."""

from __future__ import annotations

from typing import Any
from weakref import WeakKeyDictionary

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float
from loomlight.core.backend import ArrayTypes, upload
from loomlight.yarn.families import upload_family
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.max_heights import pack_max_heights
from loomlight.yarn.runs import pack_runs, with_cell_maxima
from loomlight.yarn.threads import FamilyTables, prepare_family

LayoutTables = tuple[FamilyTables, FamilyTables, NDArray[np.uint32], NDArray[np.uint32]]
# Whole numbers that float32 tells apart.
_MAX_EXACT = 1 << 24
# Tables of all layouts in memory: the models of a fabric share its layout, and a draft of 4096 by 4096
# threads takes seconds. An edit of heights or twist makes another layout with the same threads.
_cache: WeakKeyDictionary[ClothLayout, LayoutTables] = WeakKeyDictionary()


def prepare_layout(layout: ClothLayout) -> LayoutTables:
    """Tables of warp and weft, words of both at each crossing [picks, ends, 2], max-height pyramid.

    Computed once for layouts that differ at most in height scales and twist.
    """
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
    warp_words = pack_runs(np.ascontiguousarray(layout.warp_on_top.T))
    weft_words = pack_runs(~layout.warp_on_top)
    warp = prepare_family(layout.warp, layout.weft, warp_words)
    weft = prepare_family(layout.weft, layout.warp, weft_words)
    words = np.empty((*weft_words.shape, 2), np.uint32)
    words[..., 0] = with_cell_maxima(warp_words, warp.cell_maxima).T
    words[..., 1] = with_cell_maxima(weft_words, weft.cell_maxima)
    del warp_words, weft_words
    return warp, weft, words, pack_max_heights(words)


class DeviceTables:
    """The tables of a layout on one backend. Numbers are opaque to Dr.Jit: all fabrics share kernels."""

    def __init__(
        self,
        warp: FamilyTables,
        weft: FamilyTables,
        words: NDArray[np.uint32],
        max_heights: NDArray[np.uint32],
        types: ArrayTypes,
    ) -> None:
        self.warp: Any = upload_family(warp, types)
        self.weft: Any = upload_family(weft, types)
        self.words = upload(types.UInt32, words)
        # Single precision, which is faster, tells the words of 4096 by 4096 crossings apart.
        exact = types.Float if words[..., 0].size <= _MAX_EXACT else types.UInt32
        self.ends: Any = dr.opaque(exact, words.shape[1])
        self.max_heights = upload(types.UInt32, max_heights)
        self.max_height_columns = dr.opaque(types.UInt32, max_heights.shape[1])
        self._float = types.Float
        self._scalars: dict[str, tuple[float, Float]] = {}

    def scalar(self, name: str, value: Float) -> Float:
        """A number of the fabric, by name, as an opaque Float; a Dr.Jit scalar as it is."""
        if not isinstance(value, int | float):
            return self._float(value)
        # By name: two equal numbers under one name would be one variable, and kernels would differ.
        if name not in self._scalars or self._scalars[name][0] != value:
            self._scalars[name] = value, dr.opaque(self._float, value)
        return self._scalars[name][1]
