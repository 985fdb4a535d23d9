"""Threads are found where they were drawn, and what has none is refused."""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.capturing.thread_grid import blurred, find_grid, find_grids
from loomlight.core.errors import InputError
from loomlight.weave.named import named_weave
from tests.capturing.pictures import BLUE, CREAM, RED, woven

# The mean spacing of some twenty threads, each boundary known to a tenth of a thread: half a per cent.
TOLERANCE = 0.005


@pytest.mark.parametrize("weave", ["plain", "twill 3/1 s", "satin 8/3", "basket 2/2", "warp rib 2/2"])
@pytest.mark.parametrize("turn", [0.0, 0.06])
def test_setts_and_turn(weave: str, turn: float) -> None:
    """Grouped threads count one by one."""
    grid = find_grid(woven(named_weave(weave).drawdown, px=(14.0, 17.3), turn=turn))
    assert 1 / grid.warp.per_px == pytest.approx(14.0, rel=TOLERANCE)
    assert 1 / grid.weft.per_px == pytest.approx(17.3, rel=TOLERANCE)
    # A tenth of a thread across the picture is half of this angle.
    assert grid.warp.turn == pytest.approx(turn, abs=0.01)
    assert grid.weft.turn == pytest.approx(turn, abs=0.01)


def test_boundaries_lie_where_they_were_drawn() -> None:
    grid = find_grid(woven(named_weave("twill 2/1").drawdown, px=(16.0, 18.0)))
    columns, rows = np.arange(320), np.arange(320)
    drawn = columns / 16.0 + 100.3, (319 - rows) / 18.0 + 100.6
    off = grid.warp.number[160] - drawn[0], grid.weft.number[:, 160] - drawn[1]
    for each in off:
        # Whole numbers are boundaries, whichever thread is the first: to a tenth of a thread.
        assert np.abs(each - np.rint(each)).max() < 0.1


def test_colours_of_threads_are_no_threads() -> None:
    stripes = [BLUE] * 3 + [CREAM] * 2 + [RED]
    grid = find_grid(woven(named_weave("plain").drawdown, px=(16.0, 16.0), warp=stripes, weft=stripes))
    assert 1 / grid.warp.per_px == pytest.approx(16.0, rel=TOLERANCE)
    assert 1 / grid.weft.per_px == pytest.approx(16.0, rel=TOLERANCE)


@pytest.mark.parametrize("weave", ["twill 1/2 s", "sateen 8/3"])
def test_threads_are_found_among_plies_that_lie_alike(weave: str) -> None:
    """Grooves between plies slant, and outdo threads of one colour: but threads cross at right angles."""
    cloth = woven(
        named_weave(weave).drawdown,
        px=(14.5, 14.0),
        size=(300, 300),
        turn=0.03,
        warp=[BLUE],
        weft=[BLUE],
        plies=0.4,
    )
    off = [(abs(grid.warp.per_px * 14.5 - 1), abs(grid.weft.per_px * 14.0 - 1)) for grid in find_grids(cloth)]
    assert min(max(each) for each in off) < TOLERANCE


def test_the_error_covers_what_it_is_off() -> None:
    grid = find_grid(woven(named_weave("twill 2/2").drawdown, px=(12.7, 15.1), noise=0.04))
    for family, px in ((grid.warp, 12.7), (grid.weft, 15.1)):
        # Two standard errors.
        assert abs(family.per_px * px - 1) < 2 * family.error


def test_noise_has_no_threads() -> None:
    noise = np.random.default_rng(0).random((256, 256, 3))
    with pytest.raises(InputError, match="no threads that repeat"):
        find_grid(noise)


def test_threads_that_are_too_fine_are_refused() -> None:
    with pytest.raises(InputError, match="too coarse"):
        find_grid(woven(named_weave("plain").drawdown, px=(4.3, 4.3), noise=0.0))


def test_a_blur_keeps_the_mean() -> None:
    plane = np.random.default_rng(3).random((40, 50))
    assert blurred(plane, 4.0).mean() == pytest.approx(plane.mean(), abs=1e-12)
    assert blurred(plane, 4.0).std() < 0.3 * plane.std()
