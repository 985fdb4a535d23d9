"""Values of options that are more than one number: sizes, directions, values by name."""

from __future__ import annotations

import math
import re

from loomlight.core.errors import InputError

MAX_SIDE = 16384
# A sample takes 170 bytes while it is computed, and a pass has at least one a pixel: 11 GB.
MAX_AREA = 2**26


def parse_size(text: str, option: str = "--size") -> tuple[int, int]:
    """Width and height in pixels from the text of `option`: "960x540", or "512" for a square.

    Raises:
        InputError: anything else, a side outside 1 to 16384, or more than 2²⁶ pixels in all.
    """
    match = re.fullmatch(r"\s*(\d{1,9})(?:\s*[xX×]\s*(\d{1,9}))?\s*", text)
    width, height = (int(match[1]), int(match[2] or match[1])) if match else (0, 0)
    if not (1 <= width <= MAX_SIDE and 1 <= height <= MAX_SIDE):
        raise InputError(
            f'{option} "{text}" is no size: write WIDTHxHEIGHT in pixels from 1 to {MAX_SIDE}, '
            "such as 960x540."
        )
    if width * height > MAX_AREA:
        millions = MAX_AREA // 10**6
        raise InputError(
            f'{option} "{text}" is too large: at most {millions} million pixels in all, such as 8192x8192.'
        )
    return width, height


def parse_numbers(option: str, text: str, count: int, example: str) -> tuple[float, ...]:
    """`count` finite numbers separated by commas.

    Raises:
        InputError: anything else; the message names `option` and gives `example`.
    """
    try:
        numbers = tuple(float(part) for part in text.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) != count or not all(map(math.isfinite, numbers)):
        raise InputError(
            f'{option} "{text}" is not understood: write {count} numbers with commas, such as {example}.'
        )
    return numbers


def parse_named(option: str, texts: list[str], example: str) -> dict[str, list[str]]:
    """Values by name from texts such as "warp=#223,weft=#eee"; a name may come more than once.

    Raises:
        InputError: a part without a name or a value; the message names `option` and gives `example`.
    """
    found: dict[str, list[str]] = {}
    for text in texts:
        for part in text.split(","):
            name, _, value = (word.strip() for word in part.partition("="))
            if not name or not value:
                raise InputError(f'{option} "{text}" is not understood: write NAME=VALUE, such as {example}.')
            found.setdefault(name, []).append(value)
    return found


def require_within(option: str, value: float, low: float, high: float) -> None:
    """Raises InputError unless low ≤ value ≤ high; NaN is refused."""
    if not low <= value <= high:
        raise InputError(
            f"{option} {_shown(value)} is out of range: write a number from {_shown(low)} to {_shown(high)}."
        )


def _shown(value: float) -> str:
    return f"{value}" if isinstance(value, int) and abs(value) < 10**12 else f"{value:g}"
