"""Tables shared by geometries of one layout."""

from __future__ import annotations

import gc
import weakref

import numpy as np
import pytest
from drjit.llvm.ad import Bool, Float

from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.threads import pack_runs
from tests.helpers.layouts import TWILL, even_layout


def test_geometries_of_one_layout_share_their_tables(monkeypatch: pytest.MonkeyPatch) -> None:
    packed: list[tuple[int, ...]] = []

    def counted(on_top: np.ndarray) -> np.ndarray:
        packed.append(on_top.shape)
        return pack_runs(on_top)

    monkeypatch.setattr("loomlight.yarn.tables.pack_runs", counted)
    # Other layouts of the same threads may be in memory still.
    monkeypatch.setattr("loomlight.yarn.tables._cache", weakref.WeakKeyDictionary())
    layout = even_layout(TWILL)
    first, second = YarnGeometry(layout), YarnGeometry(layout)
    assert len(packed) == 2  # warp and weft
    first.height_scale = (0.1, 0.1)
    assert second.height_scale == (layout.warp.height_scale, layout.weft.height_scale)
    YarnGeometry(even_layout(TWILL, gap=0.4))
    assert len(packed) == 4
    del first, second
    gone = weakref.ref(layout)
    del layout
    gc.collect()
    assert gone() is None


@pytest.mark.parametrize("shape", [(7, 5), (40, 33)])
def test_words_are_found_by_whole_numbers_where_float32_does_not_tell_them_apart(
    shape: tuple[int, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    rng = np.random.default_rng(4)
    drawdown = rng.random(shape) < 0.5
    x, y = (Float(rng.uniform(-2, 3, 5000) * side) for side in even_layout(drawdown).size)
    back = Bool(rng.random(5000) < 0.5)
    points = []
    for most_exact in (1 << 24, 1):
        monkeypatch.setattr("loomlight.yarn.tables._MAX_EXACT", most_exact)
        points.append(YarnGeometry(even_layout(drawdown)).surface(x, y, back))
    for name in ("height", "is_warp", "hole", "warp_thread", "weft_thread"):
        first, second = (np.asarray(getattr(point, name)) for point in points)
        assert np.array_equal(first, second), name


def test_tables_do_not_depend_on_how_many_threads_are_packed_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    drawdown = np.random.default_rng(6).random((37, 23)) < 0.5
    whole = YarnGeometry(even_layout(drawdown))
    monkeypatch.setattr("loomlight.yarn.threads._BLOCK", 100)
    monkeypatch.setattr("loomlight.yarn.max_heights._BLOCK", 30)
    parts = YarnGeometry(even_layout(drawdown, gap=0.2 + 1e-12))
    for first, second in zip(whole.words, parts.words, strict=True):
        assert np.array_equal(first, second)
