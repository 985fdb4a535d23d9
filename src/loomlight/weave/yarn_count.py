"""Yarn counts as mills write them, in tex."""

from __future__ import annotations

import re

from loomlight.core.errors import InputError

_WHOLE = r"([0-9]{1,12})"
_NUMBER = r"([0-9]{1,12}(?:[.,][0-9]{1,12})?)"
_FILAMENTS = rf"(?: ?(/|/? ?f) ?{_WHOLE} ?(f?))?"
_TIMES = " ?[x×] ?"
_DIRECT = re.compile(
    rf"{_NUMBER}(?:{_TIMES}{_NUMBER})?{_FILAMENTS} ?"
    rf"(dtex|tex|ktex|denier|den|d){_FILAMENTS}(?:{_TIMES}{_WHOLE})?"
)
_UNIT_FIRST = re.compile(rf"(nec|ne|nm) ?{_NUMBER}(?: ?/ ?{_WHOLE})?")
_NE_LAST = re.compile(rf"{_NUMBER}(?: ?/ ?{_WHOLE})? ?(nec|ne)")
_NM_LAST = re.compile(rf"(?:{_WHOLE} ?/ ?)?{_NUMBER} ?nm")
# The s stands with the count, so plies come before the count or after the s.
_PLIES_BEFORE_S = re.compile(rf"{_WHOLE} ?/ ?{_NUMBER} ?s")
_PLIES_AFTER_S = re.compile(rf"{_NUMBER} ?s(?: ?/ ?{_WHOLE})?")
_UNITLESS = re.compile(rf"{_NUMBER}(?: ?/ ?{_WHOLE})?")

_TEX_PER = {"tex": 1.0, "dtex": 0.1, "ktex": 1000.0, "denier": 1 / 9, "den": 1 / 9, "d": 1 / 9}
# Ne counts hanks of 840 yd a pound, Nm kilometres a kilogram.
_TEX_OF_COUNT = {"ne": 1000 * 453.59237 / (840 * 0.9144), "nm": 1000.0}
# Cords have more, but far more often the numbers were swapped.
_MAX_PLIES = 12
# So few filaments after a slash may also be plies.
_MIN_FILAMENTS = 5


def yarn_tex(count: str) -> float:
    """Linear density in tex (g/km) of a yarn count.

    Direct systems: "30 tex", "2x20 tex" (two plies), "300 dtex", "150 denier"; filaments do not change it:
    "75/36 dtex", "150D/48F". Indirect ones, unit first: "Ne 40" (cotton count), "Ne 40/2" (two plies of
    Ne 40), "Nm 28/2". Unit last, as mills write it: "40/2 Ne" (count/plies) but "2/28 Nm" (plies/count);
    "20s", "40s/2" and "2/40s" are cotton counts.

    Raises:
        InputError: none of these, more than 12 plies, or a count outside 0.1 to 100 000 tex.

    Source: ISO 1144 (tex system); ISO 2947 (conversion); ISO 1139 (designation of plies and filaments).
    """
    said = f'The yarn count "{count.strip()[:40]}"'
    text = " ".join(count.lower().split())
    tex = _direct_tex(text, said)
    if tex is None:
        tex = _indirect_tex(text, said)
    if tex is None:
        raise InputError(f"{said} {_advice(text)}")
    if not 0.1 <= tex <= 100_000:
        side = "below 0.1" if tex < 0.1 else "above 100000"
        raise InputError(f"{said} is {side} tex; yarns have 0.1 to 100000 tex.")
    return tex


def _direct_tex(text: str, said: str) -> float | None:
    """Tex of a count in tex, dtex, ktex or denier; None of another text."""
    match = _DIRECT.fullmatch(text)
    if match is None:
        return None
    first, second, slash, filaments, f, unit, *after, third = match.groups()
    if filaments is None:
        slash, filaments, f = after
    if slash == "/" and not f and 1 < int(filaments) < _MIN_FILAMENTS:
        raise InputError(
            f"{said} may mean {filaments} plies or {filaments} filaments; "
            f'write "{filaments}x{first} {unit}" or "{first}f{filaments} {unit}".'
        )
    return _number(first) * _number(second or "1") * _number(third or "1") * _TEX_PER[unit]


def _indirect_tex(text: str, said: str) -> float | None:
    """Tex of a count in Ne or Nm, in whichever order it is written; None of another text."""
    if match := _UNIT_FIRST.fullmatch(text):
        unit, single, plies = match.groups()
    elif match := _NE_LAST.fullmatch(text) or _PLIES_AFTER_S.fullmatch(text):
        (unit, single, plies) = ("ne", *match.group(1, 2))
    elif match := _NM_LAST.fullmatch(text):
        (unit, plies, single) = ("nm", *match.groups())
    elif match := _PLIES_BEFORE_S.fullmatch(text):
        (unit, plies, single) = ("ne", *match.groups())
    else:
        return None
    if _number(single) == 0:
        return None
    unit = unit[:2]
    if not 1 <= int(plies or "1") <= _MAX_PLIES:
        name = unit.capitalize()
        is_swapped = int(plies) > 0 and single.isdecimal() and int(single) <= _MAX_PLIES
        meant = (
            f'; for {single} plies of {name} {plies} write "{name} {plies}/{single}"' if is_swapped else ""
        )
        raise InputError(
            f"{said} is {plies} plies of {name} {single}; yarns have 1 to {_MAX_PLIES} plies{meant}."
        )
    return _TEX_OF_COUNT[unit] / _number(single) * int(plies or "1")


def _advice(text: str) -> str:
    """The end of the sentence about a text that is no count: what would be right."""
    if match := _UNITLESS.fullmatch(text):
        number = match.group(1)
        return f'has no unit; write "{number} tex", "{number} den", "Ne {number}" or "Nm {number}".'
    return 'is not known; write it like "30 tex", "150 den", "75/36 dtex", "20s", "Ne 40/2" or "2/28 Nm".'


def _number(text: str) -> float:
    return float(text.replace(",", "."))
