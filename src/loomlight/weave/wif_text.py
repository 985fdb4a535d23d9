"""The text of a weaving information file: decoded, split into sections, and complained about.

The format is that of Windows .ini files. Programs write it with any line ends and encodings, with words
before the first section, with values that are empty or lack their "=": all of that is read.
"""

from __future__ import annotations

import codecs
import math
import re
import warnings
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.weave.draft import MAXIMUM_THREADS, Entries

MAXIMUM_BYTES = 64 << 20
_LINE_END = re.compile(r"\r\n|\r|\n")
_HEADER = re.compile(r"\[([^\]]*)\]")
_SHOWN = 60
# The characters that Latin-1 lacks; five bytes stand for none.
_WINDOWS_1252 = {
    byte: character for byte in range(128, 160) if (character := bytes([byte]).decode("cp1252", "ignore"))
}


@dataclass
class Section:
    """One section: its name as the file spells it, and its lines (key, and value or None) in order."""

    spelled: str
    lines: list[tuple[str, str | None]] = field(default_factory=list)

    @property
    def entries(self) -> Entries:
        """The lines, unchangeable."""
        return tuple(self.lines)


@dataclass
class WifText:
    """The sections of a file by name: capitals, single spaces.

    Attributes:
        file: what messages call the file.
        sections: by name; sections of one name are joined.
        values: by section, then by key in capitals: the key as spelled and the value, which is "" if it
            is empty or absent.
    """

    file: str
    sections: dict[str, Section]
    values: dict[str, dict[str, tuple[str, str]]]

    def value(self, section: str, key: str) -> str:
        """The value, or "" if the file does not say."""
        return self.values.get(section, {}).get(key.upper(), ("", ""))[1]

    def items(self, section: str) -> Iterator[tuple[str, str]]:
        """Keys and values of a section, empty values included."""
        yield from self.values.get(section, {}).values()

    def fault(self, section: str, key: str, value: str, what: str) -> InputError:
        """The error for a value: file, section, key, value, and `what` is wrong and would be right."""
        return InputError(f"{self.file}: {_place(section, key, value)} {what}.")

    def warn(self, section: str, key: str, value: str, what: str) -> None:
        """The same as a warning, for what can be used all the same."""
        warnings.warn(f"{self.file}: {_place(section, key, value)} {what}.", LoomlightWarning, stacklevel=2)


def _place(section: str, key: str, value: str) -> str:
    return f"[{section}] {shortened(key)}={shortened(value)}"


def shortened(text: str) -> str:
    """A value as messages show it: printable, and not long."""
    printable = "".join(character if character.isprintable() else "?" for character in text[: _SHOWN + 1])
    return printable if len(printable) <= _SHOWN else printable[:_SHOWN] + "…"


def read_wif_text(path: Path) -> WifText:
    """The sections of the file at `path`.

    Raises:
        InputError: no such file, one that is too large, or one without any section of a draft.

    Warns:
        LoomlightWarning: no section [WIF].
    """
    return parse_wif_text(decode_wif(_read_bytes(path)), str(path))


def _read_bytes(path: Path) -> bytes:
    try:
        with path.open("rb") as file:
            content = file.read(MAXIMUM_BYTES + 1)
    except FileNotFoundError as error:
        raise InputError(f"{path} does not exist.") from error
    except IsADirectoryError as error:
        raise InputError(f"{path} is a folder; give the name of a draft file.") from error
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.") from error
    except ValueError as error:
        raise InputError(f"{str(path)!r} is no file name.") from error
    if len(content) > MAXIMUM_BYTES:
        raise InputError(f"{path} is larger than {MAXIMUM_BYTES >> 20} MiB; no draft that can be used is.")
    return content


def decode_wif(content: bytes) -> str:
    """Text in UTF-16 or UTF-8 if marked or valid, otherwise in Windows-1252, which older programs write.

    NULs and marks of byte order are left out. A Ctrl-Z, which ends a text under DOS, ends it unless a section
    follows.
    """
    text = _decoded(content)
    for left_out in "\0\ufeff":
        text = text.replace(left_out, "")
    body, _, rest = text.partition("\x1a")
    return text.replace("\x1a", " ") if "[" in rest else body


def _decoded(content: bytes) -> str:
    utf16 = _utf16_of(content)
    if utf16 is not None:
        # A single byte that was added at the end, such as a Ctrl-Z, is half a character.
        return content[: len(content) & ~1].decode(utf16, errors="replace")
    # What lies behind the end of a text may be any bytes.
    body, _, rest = content.partition(b"\x1a")
    text = content if b"[" in rest else body
    try:
        return text.decode("utf-8")
    except UnicodeDecodeError:
        return text.decode("latin-1").translate(_WINDOWS_1252)


def _utf16_of(content: bytes) -> str | None:
    """The byte order of UTF-16, by its mark or by NULs in one half of the bytes; None of other text."""
    if content.startswith(codecs.BOM_UTF16_LE):
        return "utf-16-le"
    if content.startswith(codecs.BOM_UTF16_BE):
        return "utf-16-be"
    # NULs that fill up the end lie in both halves.
    text = content.rstrip(b"\0\x1a")
    even, odd = text[::2].count(0), text[1::2].count(0)
    if max(even, odd) < max(len(text) / 16, 1.5 * min(even, odd)) or not text:
        return None
    return "utf-16-le" if odd > even else "utf-16-be"


def parse_wif_text(text: str, file: str) -> WifText:
    """The sections of `text`; `file` is what messages call it.

    Text before the first section of a draft is passed over. Some programs leave out the line [WIF] alone: the
    keys of that section, which then come first, are read all the same.

    Raises:
        InputError: no section of a draft.

    Warns:
        LoomlightWarning: no section [WIF].
    """
    sections: dict[str, Section] = {}
    headless = Section("WIF")
    current: Section | None = None
    for line in map(str.strip, _LINE_END.split(text)):
        header = _HEADER.match(line)
        if header and (current is not None or section_name(header.group(1)) in _KNOWN_SECTIONS):
            name = section_name(header.group(1))
            current = sections.setdefault(name, Section(header.group(1).strip()))
        elif line and not _is_comment(line, current):
            key, equals, value = line.partition("=")
            entry = key.strip(), value.strip() if equals else None
            if current is not None:
                current.lines.append(entry)
            elif entry[0].upper() in _WIF_KEYS and equals:
                headless.lines.append(entry)
    if not sections:
        raise InputError(
            f"{file} is no weaving information file: it has none of the sections of one, "
            "such as [WIF], [THREADING] or [LIFTPLAN]."
        )
    if "WIF" not in sections:
        warnings.warn(
            f"{file} has no section [WIF], which every weaving information file begins with; "
            "its other sections are read.",
            LoomlightWarning,
            stacklevel=2,
        )
        sections = {"WIF": headless, **sections} if headless.lines else sections
    return WifText(file, sections, _by_key(file, sections))


def section_name(spelled: str) -> str:
    """A section's name in capitals with single spaces."""
    return " ".join(spelled.replace("_", " ").upper().split())


def is_private(name: str) -> bool:
    """Whether a section belongs to one program."""
    return name.startswith("PRIVATE")


def _is_comment(line: str, section: Section | None) -> bool:
    return line[0] == ";" or (line[0] == "#" and not (section and is_private(section_name(section.spelled))))


def _by_key(file: str, sections: dict[str, Section]) -> dict[str, dict[str, tuple[str, str]]]:
    values: dict[str, dict[str, tuple[str, str]]] = {}
    for name, section in sections.items():
        table = values.setdefault(name, {})
        several: dict[str, list[str]] = {}
        for key, value in section.lines:
            folded = _folded_key(key)
            if folded in table and table[folded][1] != (value or "") and name in _DRAFT_SECTIONS:
                several.setdefault(folded, [table[folded][1]]).append(value or "")
            table[folded] = (key, value or "")
        for folded, found in several.items() if name in _SECTIONS_OF_SETS else ():
            table[folded] = table[folded][0], ",".join(value.partition(";")[0] for value in found)
        for folded, found in list(several.items())[:1]:
            place = f"[{name}] {shortened(table[folded][0])}"
            times = "twice" if len(found) == 2 else f"{len(found)} times"
            others = f", and {len(several) - 1} other keys are too" if len(several) > 1 else ""
            used = "all of them are" if name in _SECTIONS_OF_SETS else "the latter is"
            warnings.warn(
                f"{file}: {place} is there {times}, as '{shortened(found[0])}' and as "
                f"'{shortened(found[-1])}'{others}; {used} used.",
                LoomlightWarning,
                stacklevel=2,
            )
    return values


def _folded_key(key: str) -> str:
    """Capitals; numbers without leading zeros, so that "07" and "7" are one thread."""
    folded = key.upper()
    return folded.lstrip("0") or "0" if folded.isdigit() and folded.isascii() else folded


# Sections whose values are sets: programs that write one member a line repeat the key.
_SECTIONS_OF_SETS = {"THREADING", "TIEUP", "TREADLING", "LIFTPLAN"}
_DRAFT_SECTIONS = {
    *_SECTIONS_OF_SETS,
    "WEAVING",
    "WARP",
    "WEFT",
    "COLOR PALETTE",
    "COLOR TABLE",
    *(f"{family} {what}" for family in ("WARP", "WEFT") for what in ("COLORS", "SPACING", "THICKNESS")),
}
# Sections of the specification, one of which begins a draft.
_KNOWN_SECTIONS = {"WIF", "CONTENTS", "TEXT", "NOTES", *_DRAFT_SECTIONS}
_WIF_KEYS = {"VERSION", "DATE", "DEVELOPERS", "SOURCE PROGRAM", "SOURCE VERSION"}


# ----------------------------------------------------------------------------------------------------- values
# Values in a weaving information file: numbers, lists, yes and no, lengths, each with its complaint.


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
