"""Colours survive the way to linear RGB and back; what is no colour is refused by name."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from loomlight.core.colour import lab_of_linear, linear_to_srgb, parse_colour, srgb_to_linear, to_hex
from loomlight.core.errors import InputError

bytes_of_colour = st.tuples(*[st.integers(0, 255)] * 3)
unit = st.floats(0, 1, allow_nan=False)


@given(bytes_of_colour)
def test_every_hex_colour_round_trips(parts: tuple[int, int, int]) -> None:
    text = "#{:02x}{:02x}{:02x}".format(*parts)
    assert to_hex(parse_colour(text, "color")) == text


@given(st.lists(unit, min_size=1, max_size=20))
def test_encoding_round_trips(values: list[float]) -> None:
    np.testing.assert_allclose(linear_to_srgb(srgb_to_linear(values)), values, atol=1e-6)


@given(unit, unit)
def test_encoding_keeps_order(first: float, second: float) -> None:
    low, high = sorted((first, second))
    assert srgb_to_linear(low) <= srgb_to_linear(high)


def test_known_values() -> None:
    # IEC 61966-2-1: middle grey of 8 bits, and the end of the linear part.
    assert srgb_to_linear(128 / 255) == pytest.approx(0.2158605, abs=1e-6)
    assert srgb_to_linear(0.04045) == pytest.approx(0.04045 / 12.92)
    assert linear_to_srgb([-1.0, 2.0]).tolist() == [0.0, pytest.approx(1.0)]


def test_short_hex_is_long_hex() -> None:
    assert to_hex(parse_colour("#fa0", "color")) == "#ffaa00"


@given(st.tuples(unit, unit, unit))
def test_a_triple_is_linear(triple: tuple[float, float, float]) -> None:
    assert parse_colour(list(triple), "color").tolist() == list(triple)


@pytest.mark.parametrize(
    "value",
    [
        "",
        "#",
        "#12",
        "#12345",
        "#1234567",
        "#ggg",
        "red",
        "20305c",
        [],
        [0.1, 0.2],
        [0.1, 0.2, 0.3, 0.4],
        [0.1, 0.2, 1.01],
        [0.1, -0.2, 0.3],
        [math.nan, 0, 0],
        [math.inf, 0, 0],
        [True, False, True],
        ["0.1", 0, 0],
        None,
        3,
        0.5,
        {"r": 1},
    ],
)
def test_what_is_no_colour_is_refused_by_name(value: object) -> None:
    with pytest.raises(InputError) as caught:
        parse_colour(value, "warp.color")
    assert str(caught.value).startswith("warp.color = ")
    assert str(caught.value).endswith(".")
    assert "\n" not in str(caught.value)


def test_lab_is_a_colour() -> None:
    linear = parse_colour("lab(52 -10 30)", "warp.color")
    assert lab_of_linear(linear) == pytest.approx([52, -10, 30])
    assert parse_colour(" LAB( 52, -10, 30 ) ", "warp.color") == pytest.approx(linear)
    for text in ("lab(52 -10)", "lab(152 0 0)", "lab(50 x 0)", "lab(50 nan 0)"):
        with pytest.raises(InputError, match=r"warp\.color"):
            parse_colour(text, "warp.color")
