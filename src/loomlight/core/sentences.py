"""Parts of sentences about faults: values as a file writes them, and advice about unknown words."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping


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
