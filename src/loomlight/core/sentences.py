"""Sentences about faults: the file that they name, values as it writes them, advice about unknown words."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager

from loomlight.core.errors import InputError


@contextmanager
def speaking_of(source: str) -> Iterator[None]:
    """Names `source` (a file) at the start of every InputError raised inside that does not name it."""
    try:
        yield
    except InputError as error:
        text = one_line(str(error))
        raise InputError(text if not source or source in text else f"{source}: {text}") from error


def one_line(text: str) -> str:
    """`text` as one printable line: what a user's file holds must not steer a terminal."""
    spaced = " ".join(text.split())
    return "".join(char if char.isprintable() else "\N{REPLACEMENT CHARACTER}" for char in spaced)


def closest(word: str, known: Iterable[str]) -> str:
    """Advice about an unknown `word`: the closest of the `known` ones, or all of them."""
    choices = list(known)
    matches = difflib.get_close_matches(word.lower(), choices, n=1, cutoff=0.6)
    if matches:
        return f"did you mean {matches[0]}?"
    return "known are " + ", ".join(choices) + "."


def shown(value: object, most: int = 60) -> str:
    """`value` as a file writes it, shortened to at most `most` characters."""
    try:
        text = f'"{value}"' if isinstance(value, str) else _plain(value)
    except ValueError:  # an integer with more digits than Python is willing to print
        text = "a number of thousands of digits"
    text = " ".join(text.split())
    return text if len(text) <= most else text[: most - 1] + "…"


def _plain(value: object) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        return "a table" if value else "an empty table"
    return str(value)
