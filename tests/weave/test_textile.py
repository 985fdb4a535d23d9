"""Textile units against the textbook, floats against a plain count."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as numpy_strategies

from loomlight.core.errors import InputError
from loomlight.weave import (
    Draft,
    Threads,
    longest_floats,
    named_weave,
    per_cm,
    per_inch,
    repeat_size_cm,
    summary,
    unbound_threads,
    yarn_diameter_mm,
)


@given(st.floats(1, 120))
@settings(deadline=None)
def test_diameter_is_peirces_for_his_density(count: float) -> None:
    # Peirce 1937: d = 1/(28 sqrt(Ne)) inch, for yarn of 1.1 cm³/g.
    diameter = yarn_diameter_mm(f"Ne {count:.4f}", density=1 / 1.1, packing=1)
    assert diameter == pytest.approx(25.4 / (28 * math.sqrt(count)), rel=5e-3)


def test_looser_and_lighter_yarn_is_thicker() -> None:
    reference = yarn_diameter_mm("30 tex", density=1.5, packing=0.8)
    assert yarn_diameter_mm("30 tex", density=1.5, packing=0.2) == pytest.approx(2 * reference)
    assert yarn_diameter_mm("30 tex", density=6.0, packing=0.8) == pytest.approx(reference / 2)


def test_diameter_refuses_impossible_fibres() -> None:
    with pytest.raises(InputError, match="packing 0"):
        yarn_diameter_mm("30 tex", packing=0)
    with pytest.raises(InputError, match="density -1"):
        yarn_diameter_mm("30 tex", density=-1)


def test_setts_and_repeat_size() -> None:
    assert per_cm(per_inch(17.0)) == pytest.approx(17.0)
    assert per_inch(10) == pytest.approx(25.4)
    draft = Draft(
        np.eye(4, dtype=bool),
        Threads(spacing_mm=np.array([0.5, 0.5, 1.0, 1.0])),
        Threads(spacing_mm=np.full(4, 2.0)),
    )
    assert repeat_size_cm(draft) == pytest.approx((0.3, 0.8))
    assert repeat_size_cm(draft, ends_per_cm=40, picks_per_cm=10) == pytest.approx((0.1, 0.4))
    assert repeat_size_cm(Draft(np.eye(4, dtype=bool))) == pytest.approx((0.2, 0.2))
    with pytest.raises(InputError, match="ends_per_cm = 0"):
        repeat_size_cm(draft, ends_per_cm=0)


def counted(lines: np.ndarray) -> int:
    """The longest run of True, by walking twice around."""
    longest = 0
    for line in lines:
        run = 0
        for up in [*line, *line]:
            run = run + 1 if up else 0
            longest = max(longest, min(run, len(line)))
    return longest


@given(numpy_strategies.arrays(bool, st.tuples(st.integers(1, 9), st.integers(1, 9))))
def test_floats_are_periodic(drawdown: np.ndarray) -> None:
    floats = longest_floats(Draft(drawdown))
    assert floats.warp_face == counted(drawdown.T)
    assert floats.warp_back == counted(~drawdown.T)
    assert floats.weft_face == counted(~drawdown)
    assert floats.weft_back == counted(drawdown)


def test_unbound_threads_are_numbered_from_one() -> None:
    drawdown = np.array([[True, False, True], [True, True, False]])
    assert unbound_threads(Draft(drawdown)) == ([1], [])


def test_summary_says_what_a_weaver_asks() -> None:
    text = summary(named_weave("houndstooth"))
    assert "8 ends, 8 picks" in text
    assert "warp 2 on the face" in text
    assert "4 x #23262e, 4 x #ece4d3" in text
