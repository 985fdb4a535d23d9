"""Fibres of yarns: they follow the weave, stay in their yarns, and go on in the next repeat."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba.traced_btf import TileBtf
from loomlight.sources.load import load_source
from loomlight.sources.tile import TileScene
from studies.instruments.fibre_curves import FibreSettings, fibre_curves
from studies.instruments.fibre_tile import write_fibre_tile

require_llvm()

TWILL = fabric_from_text(
    'weave = "twill 2/1"\ngap = 0.2\n[warp]\ntwist_deg = 25\n'
    'color = ["#c02020", "#2040c0", "#2040c0"]\n[weft]\ntwist_deg = -20'
)
SMALL = FibreSettings(plies=2, fibres=5)


def test_fibres_lie_in_their_yarns_and_cross_as_the_draft_says() -> None:
    layout = TWILL.layout()
    curves = fibre_curves(layout, SMALL)
    assert [(one.is_warp, one.thread) for one in curves] == [(w, k) for w in (True, False) for k in range(3)]
    x, y = (np.cumsum(f.spacing) - 0.5 * f.spacing for f in (layout.warp, layout.weft))
    heights = {}
    for one in curves:
        family, middle, along = (layout.warp, x, 1) if one.is_warp else (layout.weft, y, 0)
        across = one.points[..., 1 - along] - middle[one.thread]
        assert one.points.shape[0] == 10
        assert np.abs(across).max() + one.radius < 0.5 * family.width[one.thread] + 1e-9
        for other, place in enumerate(y if one.is_warp else x):
            near = np.abs(one.points[..., along] - place).argmin(axis=1)[0]
            crossing = (other, one.thread) if one.is_warp else (one.thread, other)
            heights[one.is_warp, crossing] = one.points[:, near, 2].mean()
    for (pick, end), warp_on_top in np.ndenumerate(layout.warp_on_top):
        assert (heights[True, (pick, end)] > heights[False, (pick, end)]) == warp_on_top


def test_fibres_go_on_in_the_next_repeat() -> None:
    """Three control points at the end are those of the beginning, a repeat on: so are splines and slopes."""
    repeat = TWILL.repeat_mm
    for one in fibre_curves(TWILL.layout(), SMALL):
        step = np.array([0, repeat[1], 0]) if one.is_warp else np.array([repeat[0], 0, 0])
        np.testing.assert_allclose(one.points[:, -3:], one.points[:, :3] + step, atol=1e-9)


def test_both_families_twist_alike() -> None:
    """Seen along either yarn's own direction, +y of the warp and -x of the weft, fibres turn the same way."""
    fabric = fabric_from_text(
        'weave = "twill 4/4"\ngap = 0.2\n[warp]\ntwist_deg = 30\n[weft]\ntwist_deg = 30\n'
    )
    for one in fibre_curves(fabric.layout(), FibreSettings(plies=1, fibres=20)):
        across = one.points[..., 0 if one.is_warp else 1]
        across = across - across.mean()
        up = one.points[..., 2] - one.points[..., 2].mean(axis=0)
        turn = across[:, :-1] * np.diff(up) - up[:, :-1] * np.diff(across)
        assert turn.sum() * (1 if one.is_warp else -1) > 0


@pytest.mark.slow
def test_a_tile_is_written_and_traced(tmp_path: Path) -> None:
    """Red warps reflect red, from both sides; holes are between the yarns."""
    source = load_source(write_fibre_tile(TWILL, tmp_path / "tile", SMALL))
    assert source.repeat_mm == TWILL.repeat_mm
    assert isinstance(source, TileScene)
    # Compiled in half the time of sixteen; three vertices have no colour yet.
    btf = TileBtf(replace(source, bounces=8))
    assert btf.has_holes
    count, rng = 4000, np.random.default_rng(0)
    positions = (rng.random((count, 2)) * source.repeat_mm).astype(np.float32)
    for side in (1, -1):
        light, view = (np.tile(np.float32([x, 0, side * 0.8]), (count, 1)) for x in (0.6, -0.6))
        values = btf.values(positions, light, view, (1,))
        # Warps lie in columns, one colour each.
        column = (positions[:, 0] / source.repeat_mm[0] * 3).astype(int)
        red = values[column == 0].mean(axis=0)
        blue = values[column == 2].mean(axis=0)
        assert red[0] / red[2] > 1.2 * blue[0] / blue[2]
    upright = np.tile(np.float32([0, 0, 1]), (count, 1))
    assert 0.02 < btf.holes(positions, upright).mean() < 0.6


def test_settings_that_cannot_be_are_refused() -> None:
    with pytest.raises(InputError, match="plies = 9 is wrong: give a number from 1 to 8"):
        FibreSettings(plies=9)
