"""Distinct run words against NumPy's, and what is worked out of them against every word by itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout
from loomlight.yarn.threads import DistinctWords
from tests.helpers.layouts import even_layout


def test_distinct_words_are_those_of_numpy() -> None:
    rng = np.random.default_rng(1)
    some = rng.integers(0, 1 << 28, 90, dtype=np.uint32)
    words = some[rng.integers(0, 90, (700, 300))]
    distinct = DistinctWords.of(words)
    assert distinct is not None
    assert (distinct.values == np.unique(words)).all()
    # Cell maxima, in the last four bits, make no other word.
    assert (distinct.values[distinct.indices(words | np.uint32(7 << 28))] == words).all()
    assert DistinctWords.of(words[:50]) is None


@pytest.mark.parametrize("seed", range(4))
def test_words_and_tables_are_those_of_every_crossing_by_itself(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    end, pick = np.meshgrid(np.arange(190 + 40 * seed), np.arange(230))
    grounds = np.stack([(end + pick) % 2 == 0, (3 * end - pick) % 8 == 0, (end + pick) % (3 + seed) < 2])
    ground = (np.hypot(end - 80, pick - 120) / 19).astype(int) % 3
    drawdown = np.tile(np.take_along_axis(grounds, ground[None], axis=0)[0], (3, 3))
    drawdown[:, 3], drawdown[:, 9] = True, False
    layout = even_layout(drawdown, inclination=(24, 60, 24, 80)[seed])
    fewer = YarnGeometry(layout)
    assert any(family.distinct is not None for family in fewer.families)
    monkeypatch.setattr("loomlight.yarn.threads._are_alike", lambda *_: False)
    every = YarnGeometry(ClothLayout(drawdown.copy(), layout.warp, _nudged(layout)))
    for first, second in zip(fewer.words, every.words, strict=True):
        assert np.array_equal(first, second)
    for first, second in zip(fewer.families, every.families, strict=True):
        assert second.distinct is None
        for name in ("inclination", "arc", "edge_drop"):
            np.testing.assert_allclose(getattr(first, name), getattr(second, name), rtol=1e-9)
        assert first.highest == pytest.approx(second.highest, rel=1e-9)


def _nudged(layout: ClothLayout) -> FamilyLayout:
    """Another weft, so that no tables are shared, by less than rounding of heights notices."""
    return replace(layout.weft, spacing=layout.weft.spacing * (1 + 1e-13))
