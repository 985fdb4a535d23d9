"""Errors caused by a user's input, file or machine, as opposed to defects of this project.

Every message is one sentence that names the file, the field, the value and what would be right.
The command line prints it and exits with 2; nothing else is caught there.
"""

from __future__ import annotations

MAX_MESSAGE = 600


class LoomlightError(Exception):
    """A user's input, machine or file is at fault; ``str(error)`` is one sentence for a person.

    A sentence is one printable line of at most `MAX_MESSAGE` characters, whatever values it repeats.
    """

    def __init__(self, sentence: object = "") -> None:
        super().__init__(_short(str(sentence)))


class InputError(LoomlightError):
    """A value or file from a user cannot be used."""


class MissingDependencyError(LoomlightError):
    """Something outside the package is missing or too old (a system library, a device)."""


class LoomlightWarning(UserWarning):
    """Input that is used all the same, after a change that the message names."""

    def __init__(self, sentence: object = "") -> None:
        super().__init__(_short(str(sentence)))


def _short(text: str) -> str:
    """`text` as one line; of a long one the middle is left out, as the end says what would be right."""
    if not text.isprintable():
        spaced = " ".join(text.split())
        text = "".join(char if char.isprintable() else "\N{REPLACEMENT CHARACTER}" for char in spaced)
    if len(text) <= MAX_MESSAGE:
        return text
    return f"{text[: MAX_MESSAGE * 2 // 3 - 1]}…{text[-MAX_MESSAGE // 3 :]}"
