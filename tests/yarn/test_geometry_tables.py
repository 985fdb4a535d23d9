"""Tables shared by geometries of one layout."""

from __future__ import annotations

import gc
import weakref

import numpy as np
import pytest

from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.runs import pack_runs

from .layouts import TWILL, even_layout


def test_geometries_of_one_layout_share_their_tables(monkeypatch: pytest.MonkeyPatch) -> None:
    packed: list[tuple[int, ...]] = []

    def counted(on_top: np.ndarray) -> np.ndarray:
        packed.append(on_top.shape)
        return pack_runs(on_top)

    monkeypatch.setattr("loomlight.yarn.geometry_tables.pack_runs", counted)
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
