"""Coverage counted by kinds of crossings against texels of all crossings."""

from __future__ import annotations

import numpy as np
import pytest
from drjit.llvm.ad import Float

from loomlight.core.backend import array_types
from loomlight.core.frozen import FrozenArg
from loomlight.fabric import fabric_from_text
from loomlight.models.lobes import coverage
from loomlight.models.lobes.coverage import CrossingKinds, count_cells
from loomlight.models.lobes.groups import NearestGroup
from loomlight.models.lobes.rays import upload_cloth
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout

from .cloths import groups_of

PER_FAMILY = 8


def _blocks_of_twill_and_satin(side: int) -> YarnGeometry:
    end, pick = np.meshgrid(np.arange(side), np.arange(side))
    ground = (end // 23 + pick // 31) % 2 == 0
    warp_on_top = np.where(ground, (3 * end - pick) % 8 == 0, (end + pick) % 4 < 2)
    like = fabric_from_text('weave = "twill 3/1"\nends_per_cm = 20\npicks_per_cm = 16\n').layout()
    warp, weft = (
        type(family)(
            np.full(side, family.spacing[0]),
            np.full(side, family.width[0]),
            family.inclination,
            family.twist,
            family.height_scale,
        )
        for family in (like.warp, like.weft)
    )
    return YarnGeometry(ClothLayout(warp_on_top, warp, weft))


def test_cells_have_the_shares_that_texels_find(monkeypatch: pytest.MonkeyPatch) -> None:
    """Cells of six by four threads, which are counted by 15 by 13 texels otherwise."""
    geometry = _blocks_of_twill_and_satin(330)
    monkeypatch.setattr(coverage, "MAX_PYRAMID_BYTES", 200_000)
    cloth = upload_cloth(geometry, Float)
    nearest = FrozenArg(NearestGroup(groups_of(geometry, PER_FAMILY), array_types(Float)))
    kinds = CrossingKinds.find(geometry)
    assert kinds is not None
    pairs = geometry.words[0].reshape(-1, 2)
    assert len(np.unique(pairs[kinds.places], axis=0)) == len(kinds.places)
    assert len(kinds.places) == len(np.unique(pairs & 0xFFFFFFF, axis=0))
    by_kinds = count_cells(cloth, nearest, PER_FAMILY)
    assert by_kinds.texels == coverage.CELL_COUNT
    monkeypatch.setattr(CrossingKinds, "find", lambda _: None)
    by_texels = count_cells(cloth, nearest, PER_FAMILY)
    first, second = (cells.counts() / cells.texels for cells in (by_kinds, by_texels))
    assert first.shape == second.shape
    assert by_texels.texels == 15 * 13
    np.testing.assert_allclose(first.sum(axis=-1), 1, atol=0.04)
    # Means of 10⁴ cells: what is left is that of 610 points a kind.
    np.testing.assert_allclose(first.mean(axis=(1, 2)), second.mean(axis=(1, 2)), atol=2e-3)
    # A share of 1/16 has a standard error of .016 from the 195 texels of a cell.
    assert np.sqrt(np.square(first - second).mean()) < 0.016


def test_crossings_that_differ_are_counted_by_texels() -> None:
    rng = np.random.default_rng(2)
    geometry = _blocks_of_twill_and_satin(60)
    layout = geometry.layout
    noise = ClothLayout(rng.random((60, 60)) < 0.5, layout.warp, layout.weft)
    assert CrossingKinds.find(YarnGeometry(noise)) is None
