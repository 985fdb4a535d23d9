"""Values in a weaving information file: numbers, lists, yes and no, lengths, each with its complaint."""

from __future__ import annotations

import math
import re
from contextlib import suppress
from functools import cache

from loomlight.weave.draft import MAXIMUM_THREADS
from loomlight.weave.wif_text import WifText

_TRUE = {"true", "yes", "on", "1", "t", "y"}
_FALSE = {"false", "no", "off", "0", "f", "n"}
_INTEGER = re.compile(r"[+-]?[0-9]{1,9}")
_NUMBER = re.compile(r"[+-]?([0-9]+[.,]?[0-9]*|[.,][0-9]+)([eE][+-]?[0-9]+)?")

# Millimetres; the specification's decipoint is a tenth of 1/72 inch.
UNIT_MM = {"decipoints": 25.4 / 720, "inches": 25.4, "centimeters": 10.0, "millimeters": 1.0}
_UNIT_SPELLINGS = {
    "decipoint": "decipoints",
    "inch": "inches",
    "in": "inches",
    "centimeter": "centimeters",
    "centimetre": "centimeters",
    "centimetres": "centimeters",
    "cm": "centimeters",
    "millimeter": "millimeters",
    "millimetre": "millimeters",
    "millimetres": "millimeters",
    "mm": "millimeters",
}
# Beyond these a thread is no thread; rounding of lengths stays harmless between them.
MIN_LENGTH_MM = 1e-4
MAX_LENGTH_MM = 1000.0


def without_comment(value: str) -> str:
    """A value up to a comment on its line."""
    return value.partition(";")[0].strip()


def is_integer(digits: str) -> bool:
    """Whether a text is a whole number of at most nine digits."""
    return _INTEGER.fullmatch(digits) is not None


def integer(text: WifText, section: str, key: str, value: str, lowest: int, highest: int, what: str) -> int:
    """The value as a whole number from `lowest` to `highest`; `what` names what it counts.

    Raises:
        InputError: it is none, or out of that range.
    """
    digits = without_comment(value)
    if _INTEGER.fullmatch(digits) and int(digits) > highest:
        raise text.fault(section, key, value, f"is above {highest}, and at most so many can be used")
    if not _INTEGER.fullmatch(digits) or not lowest <= int(digits) <= highest:
        raise text.fault(
            section, key, value, f"is not {what}: it must be a whole number, {lowest} to {highest}"
        )
    return int(digits)


def thread_number(text: WifText, section: str, key: str, value: str, what: str) -> int:
    """The key as a 1-based number of a thread, a treadle or a colour.

    Raises:
        InputError: it is none, or above 16384.
    """
    if _INTEGER.fullmatch(key) and int(key) > MAXIMUM_THREADS:
        raise text.fault(
            section, key, value, f"is {what} above {MAXIMUM_THREADS}, the highest that can be used"
        )
    if not _INTEGER.fullmatch(key) or not 1 <= int(key) <= MAXIMUM_THREADS:
        raise text.fault(
            section, key, value, f"does not begin with {what}, a whole number from 1 to {MAXIMUM_THREADS}"
        )
    return int(key)


def number_set(text: WifText, section: str, key: str, value: str, what: str) -> frozenset[int]:
    """A list such as "1,3,4"; 0 and nothing stand for none.

    Raises:
        InputError: an entry is no whole number from 0 to 16384.
    """
    parts = without_comment(value).split(",")
    # Liftplans are megabytes of plain numbers, found here many times faster than they are checked.
    with suppress(KeyError):
        plain = frozenset(map(_plain_numbers().__getitem__, parts))
        return plain - {0} if 0 in plain else plain
    numbers = []
    for part in filter(None, map(str.strip, parts)):
        if not _INTEGER.fullmatch(part) or not 0 <= int(part) <= MAXIMUM_THREADS:
            raise text.fault(
                section,
                key,
                value,
                f"is no list of {what}: whole numbers from 0 to {MAXIMUM_THREADS} with commas",
            )
        numbers.append(int(part))
    return frozenset(numbers) - {0}


@cache
def _plain_numbers() -> dict[str, int]:
    """Every number that a list may have, by its usual spelling."""
    return {str(number): number for number in range(MAXIMUM_THREADS + 1)}


def integers(
    text: WifText, section: str, key: str, value: str, counts: tuple[int, ...], what: str
) -> list[int]:
    """A list of as many whole numbers as one of `counts`; `what` says what it is and how it is written.

    Raises:
        InputError: another number of them, or no numbers.
    """
    parts = [part.strip() for part in without_comment(value).split(",")]
    if len(parts) not in counts or not all(_INTEGER.fullmatch(part) for part in parts):
        raise text.fault(section, key, value, f"is not {what}")
    return [int(part) for part in parts]


def yes_or_no(text: WifText, section: str, key: str, default: bool) -> bool:
    """The value as a truth value, `default` if the file does not say.

    Raises:
        InputError: it is none.
    """
    value = text.value(section, key)
    word = without_comment(value).lower()
    if not word:
        return default
    if word not in _TRUE | _FALSE:
        raise text.fault(section, key, value, 'is neither "true" nor "false"')
    return word in _TRUE


def unit_name(spelled: str) -> str:
    """A unit's name as `UNIT_MM` has it; unknown names stay as they are, in lower case."""
    name = spelled.strip().lower()
    return _UNIT_SPELLINGS.get(name, name)


def unit_mm(text: WifText, section: str) -> float | None:
    """Millimetres in the section's Units; None if it names none.

    Raises:
        InputError: an unknown unit.
    """
    value = text.value(section, "Units")
    name = unit_name(without_comment(value))
    if not name:
        return None
    if name not in UNIT_MM:
        raise text.fault(section, "Units", value, "is no known unit: write Decipoints, Inches or Centimeters")
    return UNIT_MM[name]


def length_mm(text: WifText, section: str, key: str, value: str, unit: float) -> float | None:
    """The value in millimetres; None if it is empty or 0, which programs write for "not said".

    Raises:
        InputError: it is no number, or no length that a thread can have.
    """
    digits = without_comment(value)
    if not digits:
        return None
    if not _NUMBER.fullmatch(digits) or len(digits) > 40:
        raise text.fault(section, key, value, "is no length: write a decimal number such as 0.05")
    length = float(digits.replace(",", ".")) * unit
    if length == 0 and not re.search("[1-9]", digits.lower().partition("e")[0]):
        text.warn(section, key, value, "is no length and is passed over; a thread takes up more than 0")
        return None
    if not (math.isfinite(length) and MIN_LENGTH_MM <= length <= MAX_LENGTH_MM):
        raise text.fault(
            section,
            key,
            value,
            f"is {length:.4g} mm, and a thread measures between {MIN_LENGTH_MM} and {MAX_LENGTH_MM:g} mm",
        )
    return length
