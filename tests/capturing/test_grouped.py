"""Threads that lie together are taken for one, and one for several, in the same place of the cloth."""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.capturing.crossings import find_crossings
from loomlight.capturing.grouped import core_of, grouped, groupings
from loomlight.capturing.thread_grid import find_grid
from loomlight.capturing.weave_match import candidate_name, fit_structure
from loomlight.weave.named import named_weave
from tests.capturing.pictures import BLUE, CREAM, woven


@pytest.mark.parametrize(
    ("weave", "times"), [("basket 2/2", (2, 2)), ("warp rib 3/3", (3, 1)), ("plain", (1, 1))]
)
def test_groups_of_a_weave_are_threads_of_plain_and_back(weave: str, times: tuple[int, int]) -> None:
    picture = woven(named_weave(weave).drawdown, px=(13.0, 12.0), size=(260, 260))
    grid = find_grid(picture)
    crossings = find_crossings(picture, grid)
    fit = fit_structure(weave, named_weave(weave).drawdown, [crossings])
    core = core_of(picture, fit, grid, crossings)
    assert (core.fit.name, core.times) == ("plain", times)
    # A pick, and an end, of the core is as wide as its group.
    assert core.grid.weft.per_px * times[0] == pytest.approx(grid.weft.per_px)
    assert core.grid.warp.per_px * times[1] == pytest.approx(grid.warp.per_px)
    # What lies on top has the colour that it was drawn with, on the coarse grid and on the fine one.
    for each in (core, grouped(picture, core, times)):
        up = each.fit.table(each.crossings.shape)
        assert each.crossings.colour[up].mean(axis=0) == pytest.approx(BLUE, abs=0.08)
        assert each.crossings.colour[~up].mean(axis=0) == pytest.approx(CREAM, abs=0.12)
    assert candidate_name(grouped(picture, core, times).fit.structure) == weave


def test_stripes_of_groups_are_those_of_their_threads() -> None:
    picture = woven(named_weave("plain").drawdown, px=(24.0, 26.0), warp=[BLUE] * 2 + [CREAM], weft=[CREAM])
    grid = find_grid(picture)
    crossings = find_crossings(picture, grid)
    fit = fit_structure("plain", named_weave("plain").drawdown, [crossings])
    core = core_of(picture, fit, grid, crossings)
    pairs = grouped(picture, core, (2, 2))
    single, double = core.orders[0], pairs.orders[0]
    ends = pairs.crossings.shape[1]
    # Each end of the finer table lies in one of the coarser.
    of_core = (np.arange(ends) + pairs.crossings.first[0]) // 2 - core.crossings.first[0]
    wanted = single.order[(of_core + single.first) % len(single.order)]
    assert double.of_threads(ends).tolist() == wanted.tolist()


def test_groups_make_named_weaves_of_threads_that_are_wide_enough() -> None:
    picture = woven(named_weave("plain").drawdown, px=(8.0, 26.0), size=(260, 260))
    grid = find_grid(picture)
    crossings = find_crossings(picture, grid)
    core = core_of(
        picture, fit_structure("plain", named_weave("plain").drawdown, [crossings]), grid, crossings
    )
    # Three pixels of a pair, six of more threads: two ends of 8, four picks of 26.
    found = set(groupings(core, (26.0, 8.0), 4))
    assert {(1, 1), (2, 1), (1, 2), (2, 2), (4, 1)} <= found
    assert all(ends <= 2 for _, ends in found)
