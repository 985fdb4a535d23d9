"""Lists to weave from: heddles, threading, treadling."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.weave import Draft, load_draft, named_weave, read_wif, with_loom_plan
from loomlight.weave.bench import heddle_counts, heddle_text, threading_text, treadling_text
from loomlight.weave.draft import LoomPlan
from loomlight.weave.loom import plan_drawdown, warped


def of(*sets: set[int]) -> tuple[frozenset[int], ...]:
    return tuple(frozenset(members) for members in sets)


def test_heddles_are_counted_over_the_whole_warp(fixtures: Path) -> None:
    draft = load_draft(fixtures / "point-twill.dtx")  # threaded 1 2 3 4 3 2
    assert draft.loom is not None
    assert heddle_counts(draft.loom) == [1, 2, 2, 1]
    assert heddle_text(warped(draft, 20)).splitlines() == [
        "Point twill on four shafts: 20 ends on 4 shafts",
        "shaft 1: 4 heddles",  # three repeats, and the ends 1 2 of a fourth
        "shaft 2: 7 heddles",
        "shaft 3: 6 heddles",
        "shaft 4: 3 heddles",
        "in all: 20 heddles",
    ]


def test_an_end_may_be_on_several_shafts_or_on_none() -> None:
    plan = LoomPlan(of({1}, {1, 3}, set(), {2}), 3, liftplan=of({1}, {2, 3}))
    draft = Draft(plan_drawdown(plan), loom=plan, title="odd")
    assert heddle_counts(plan) == [2, 1, 1]
    assert heddle_text(draft).splitlines()[-2:] == ["in all: 4 heddles", "on no shaft: 1 end"]
    assert threading_text(draft).splitlines() == [
        "Threading of odd: 4 ends on 3 shafts",
        "1-4    1 1+3   -   2",
    ]
    assert treadling_text(draft).splitlines() == [
        "Lift plan of odd: 2 picks; each lifts these shafts",
        "1  1",
        "2  2 3",
    ]


def test_the_threading_is_listed_in_groups_with_its_colours() -> None:
    assert threading_text(warped(named_weave("houndstooth"), 11), 8).splitlines() == [
        "Threading of houndstooth: 11 ends on 4 shafts",
        " 1-8   1 2 3 4 1 2 3 4  4 #23262e, 4 #ece4d3",
        " 9-11  1 2 3            3 #23262e",
    ]
    with pytest.raises(InputError, match="0 ends a line are out of range: write 1 to 100"):
        threading_text(named_weave("plain"), 0)


@pytest.mark.parametrize("name", ["waffle 8", "crepe", "herringbone 2/2 8"])
@pytest.mark.parametrize("counts", [(None, None), (37, 50), (3, 2)])
def test_the_lists_weave_the_cloth(name: str, counts: tuple[int | None, int | None]) -> None:
    """What a weaver reads off the lists makes the same drawdown."""
    cloth = warped(with_loom_plan(named_weave(name)), *counts)
    threading = [int(number) for number in numbers(threading_text(cloth, 5))]
    text = treadling_text(cloth, 3)
    tied = {
        int(treadle): set(map(int, shafts.split()))
        for treadle, shafts in re.findall(r"treadle (\d+) lifts ([\d ]+)", text)
    }
    pressed = [int(number) for number in numbers(text.partition("\n\n")[2])]
    woven = [[shaft in tied[treadle] for shaft in threading] for treadle in pressed]
    assert woven == cloth.drawdown.tolist()


def numbers(text: str) -> list[str]:
    """The numbers of a list without its head, its first column and its colours."""
    lines = [re.sub(r"^ *\d+-\d+ *", "", line) for line in text.splitlines()[1:]]
    return [number for line in lines for number in re.split(r"  +\d+ #", line)[0].split()]


def test_a_sinking_shed_lowers(fixtures: Path) -> None:
    assert "each lowers these shafts" in treadling_text(read_wif(fixtures / "sinking-liftplan.wif"))


def test_a_warp_of_so_many_ends_repeats_the_draft() -> None:
    tooth = with_loom_plan(named_weave("houndstooth"))
    cloth = warped(tooth, 19, 5)
    np.testing.assert_array_equal(cloth.drawdown, np.tile(tooth.drawdown, (1, 3))[:5, :19])
    assert cloth.warp.colors is not None
    assert tooth.warp.colors is not None
    np.testing.assert_array_equal(cloth.warp.colors, np.tile(tooth.warp.colors, (3, 1))[:19])
    assert cloth.loom is not None
    np.testing.assert_array_equal(plan_drawdown(cloth.loom), cloth.drawdown)
    assert warped(replace(tooth, loom=None), 3).loom is None
    for count in (0, -1, 16385):
        with pytest.raises(InputError, match=f"{count} picks are out of range: write 1 to 16384"):
            warped(tooth, None, count)
