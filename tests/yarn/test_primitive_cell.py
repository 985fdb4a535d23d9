"""The primitive cell of a cloth, against all shifts tried one by one."""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.fabric import fabric_from_text
from loomlight.yarn.layout import ClothLayout, FamilyLayout, primitive_cell, primitive_shifts


def shifts_of(layout: ClothLayout) -> int:
    """Number of shifts within the repeat that leave drawdown, spacing and width as they are."""
    drawdown = layout.warp_on_top

    def same(family: FamilyLayout, shift: int) -> bool:
        return all(np.array_equal(np.roll(part, shift), part) for part in (family.spacing, family.width))

    picks, ends = drawdown.shape
    return sum(
        np.array_equal(np.roll(drawdown, (up, across), axis=(0, 1)), drawdown)
        for up in range(picks)
        for across in range(ends)
        if same(layout.warp, across) and same(layout.weft, up)
    )


@pytest.mark.parametrize(
    "weave", ["plain", "twill 2/1", "satin 8/3", "satin 5/2", "basket 2/2", "herringbone", "houndstooth"]
)
def test_the_cell_is_the_repeat_over_the_number_of_its_shifts(weave: str) -> None:
    layout = fabric_from_text(f'weave = "{weave}"').layout()
    width, height = layout.size
    area = abs(np.linalg.det(primitive_cell(layout)))
    np.testing.assert_allclose(area, width * height / shifts_of(layout), rtol=1e-9)
    for across, up in primitive_shifts(layout):
        assert np.array_equal(np.roll(layout.warp_on_top, (up, across), axis=(0, 1)), layout.warp_on_top)


def test_the_shifts_of_satin_are_short() -> None:
    cell = primitive_cell(
        fabric_from_text('weave = "satin 8/3"\nends_per_cm = 10\npicks_per_cm = 10').layout()
    )
    # (1, 3) and (3, 1) threads of a millimetre, or as short ones: among the others is (0, 8).
    np.testing.assert_allclose(sorted(np.linalg.norm(cell, axis=1)), [np.sqrt(8), np.sqrt(10)])


def test_an_odd_thread_is_part_of_the_structure() -> None:
    spacing = np.full(8, 0.5)
    spacing[3] = 0.7
    odd = FamilyLayout(spacing, 0.9 * spacing, 0.4, 0.0, 1.0)
    even = FamilyLayout(np.full(8, 0.5), np.full(8, 0.45), 0.4, 0.0, 1.0)
    plain = np.indices((8, 8)).sum(axis=0) % 2 == 0
    assert primitive_shifts(ClothLayout(plain, even, even)).tolist() == [[1, 1], [0, 2]]
    assert primitive_shifts(ClothLayout(plain, odd, even)).tolist() == [[8, 0], [0, 2]]


def test_an_irregular_draft_is_its_own_cell() -> None:
    drawdown = np.random.default_rng(2).random((12, 16)) < 0.5
    warp, weft = (FamilyLayout(np.full(n, 0.5), np.full(n, 0.4), 0.4, 0.0, 1.0) for n in (16, 12))
    layout = ClothLayout(drawdown, warp, weft)
    assert shifts_of(layout) == 1
    np.testing.assert_allclose(abs(np.linalg.det(primitive_cell(layout))), 8 * 6)
