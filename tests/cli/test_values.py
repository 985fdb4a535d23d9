"""Sizes, lists of numbers and ranges, as options give them."""

from __future__ import annotations

import contextlib
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from loomlight.cli.options import MAX_SIDE, parse_numbers, parse_size, require_within
from loomlight.core.errors import InputError


@pytest.mark.parametrize(
    ("text", "size"),
    [("960x540", (960, 540)), ("512", (512, 512)), (" 8 × 4 ", (8, 4)), ("1X16384", (1, MAX_SIDE))],
)
def test_sizes_are_read(text: str, size: tuple[int, int]) -> None:
    assert parse_size(text) == size


@pytest.mark.parametrize("text", ["", "0", "0x4", "16385", "-4", "4x", "4x4x4", "1e3", "9999999999"])
def test_what_is_no_size_is_refused(text: str) -> None:
    with pytest.raises(InputError, match="--resolution"):
        parse_size(text, "--resolution")


def test_too_many_pixels_are_refused() -> None:
    assert parse_size("8192x8192") == (8192, 8192)
    with pytest.raises(InputError, match="67 million pixels"):
        parse_size("8193x8192")


@given(st.text(max_size=20))
def test_any_text_is_a_size_or_refused(text: str) -> None:
    size = (1, 1)
    with contextlib.suppress(InputError):
        size = parse_size(text)
    assert 1 <= min(size) <= max(size) <= MAX_SIDE


def test_numbers_are_read() -> None:
    assert parse_numbers("--light-from", "-40, 35.5", 2, "0,90") == (-40.0, 35.5)


@pytest.mark.parametrize("text", ["", "1", "1,2,3", "1,a", "1,nan", "inf,1", "1;2"])
def test_what_is_no_list_of_numbers_is_refused(text: str) -> None:
    with pytest.raises(InputError, match=r"--light-from .* 2 numbers with commas, such as 0,90"):
        parse_numbers("--light-from", text, 2, "0,90")


def test_ranges_include_their_ends() -> None:
    for value in (1, 1.5, 2):
        require_within("--zoom", value, 1, 2)
    for value in (0.999, 2.001, math.nan, math.inf, 10**30):
        with pytest.raises(InputError, match=r"--zoom .* out of range: write a number from 1 to 2"):
            require_within("--zoom", value, 1, 2)
