"""Colours in the order of threads: a colour, a list of colours, or runs such as "20 #223355, 20 #eeeeee"."""

from __future__ import annotations

import re
from typing import Any

from loomlight.core.errors import InputError
from loomlight.weave.draft import MAXIMUM_THREADS

# Commas outside of brackets: lab(52, -10, 30) is one colour.
_COMMA = re.compile(r",(?![^(]*\))")
_RUN = re.compile(r"(?:([0-9]{1,9}) *[x×]? *)?(#[0-9a-fA-F]+|lab\([^)]*\))", re.IGNORECASE)


def is_one_colour(value: object) -> bool:
    """Whether `value` is written as one colour, not as a list of colours or as runs of threads."""
    if isinstance(value, str):
        return _runs(value) is None
    if not isinstance(value, list):
        return True
    return len(value) > 0 and all(isinstance(part, int | float) for part in value)


def colours_in_order(value: Any, field: str) -> list[Any]:
    """The colours of threads, one after the other, as `color` and `albedo` of a fabric file write them.

    Args:
        value: a colour; a list of colours and of runs; or runs with commas between them, each a number of
            threads and a colour.

    Raises:
        InputError: a run of no threads, or more threads than a repeat may have; the message names `field`.
    """
    parts = value if isinstance(value, list) and not is_one_colour(value) else [value]
    found: list[Any] = []
    for part in parts:
        runs = _runs(part) if isinstance(part, str) else None
        for count, colour in [(1, part)] if runs is None else runs:
            if count < 1:
                raise InputError(f'{field} = "{part}" holds a run of 0 threads: write 1 or more.')
            if len(found) + count > MAXIMUM_THREADS:
                raise InputError(
                    f"{field} has more than {MAXIMUM_THREADS} threads, which no repeat may have."
                )
            found.extend([colour] * count)
    return found


def _runs(text: str) -> list[tuple[int, str]] | None:
    """Threads and colour of every run; None of a text that is one colour, or no colour at all."""
    matches = [_RUN.fullmatch(part.strip()) for part in _COMMA.split(text)]
    runs = [(int(match[1] or 1), match[2]) for match in matches if match is not None]
    is_list = len(matches) > 1 or any(match is not None and match[1] for match in matches)
    return runs if is_list and len(runs) == len(matches) else None
