"""Loom plans: derived plans weave what they were derived from."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as numpy_strategies

from loomlight.core.errors import InputError
from loomlight.weave import (
    Draft,
    LoomPlan,
    derive_loom_plan,
    loom,
    named_weave,
    plan_drawdown,
    with_loom_plan,
)

drawdowns = numpy_strategies.arrays(bool, st.tuples(st.integers(1, 24), st.integers(1, 24)))


@given(drawdowns)
@settings(deadline=None)
def test_derived_plans_weave_the_drawdown(drawdown: np.ndarray) -> None:
    plan = derive_loom_plan(Draft(drawdown))
    assert np.array_equal(plan_drawdown(plan), drawdown)
    assert plan.shafts == len({column.tobytes() for column in drawdown.T})
    if plan.tieup is not None:
        assert plan.treadles == len({row.tobytes() for row in drawdown})
        lifts = tuple(plan.tieup[min(pressed) - 1] for pressed in plan.treadling or ())
        liftplan = replace(plan, tieup=None, treadling=None, liftplan=lifts)
        assert np.array_equal(plan_drawdown(liftplan), drawdown)


def test_straight_draw_is_found() -> None:
    plan = derive_loom_plan(named_weave("twill 2/2"))
    assert [min(shafts) for shafts in plan.threading] == [1, 2, 3, 4]
    assert plan.tieup == (frozenset({1, 2}), frozenset({2, 3}), frozenset({3, 4}), frozenset({1, 4}))


def test_two_shafts_an_end_on_either_shed() -> None:
    plan = LoomPlan(
        threading=(frozenset({1}), frozenset({1, 2}), frozenset()),
        shafts=2,
        liftplan=(frozenset({2}), frozenset()),
    )
    assert plan_drawdown(plan).tolist() == [[False, True, False], [False, False, False]]
    assert plan_drawdown(replace(plan, rising_shed=False)).tolist() == [
        [True, False, True],
        [True, True, True],
    ]


def test_shaft_limit_is_kept() -> None:
    with pytest.raises(InputError, match=r"needs 8 shafts.*at most 4"):
        derive_loom_plan(named_weave("satin 8/3"), shaft_limit=4)
    assert with_loom_plan(named_weave("plain")).loom is not None


def test_a_plan_that_no_file_holds_is_refused_with_its_size(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(loom, "MAX_LIFTS", 700)
    with pytest.raises(InputError, match=r"needs 40 shafts and a plan of 0 million .*keep it as a picture"):
        derive_loom_plan(Draft(np.random.default_rng(0).random((60, 40)) < 0.5))
    # Few sheds, in whatever number of picks, have a short plan.
    derive_loom_plan(Draft(np.tile(named_weave("satin 8/3").drawdown, (500, 500))))


def test_large_products_are_made_by_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    plan = derive_loom_plan(Draft(np.random.default_rng(1).random((50, 30)) < 0.5))
    two_shafts = replace(plan, threading=tuple(shafts | {1} for shafts in plan.threading))
    whole = plan_drawdown(two_shafts)
    monkeypatch.setattr(loom, "_ROWS_AT_ONCE", 7)
    assert np.array_equal(plan_drawdown(two_shafts), whole)
