"""Textile quantities: sett, yarn count and width, floats, sizes of a draft; counts as mills write them."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import to_hex
from loomlight.core.errors import InputError
from loomlight.weave.draft import Draft, Threads

CM_PER_INCH = 2.54
DEFAULT_SETT_PER_CM = 20.0
# Cotton; g/cm³. Wool 1.31, polyester 1.38, silk 1.34, linen 1.50, nylon 1.14.
COTTON_DENSITY = 1.52
# The fraction of a ring-spun yarn's cross-section that is fibre (Morton and Hearle 2008 give 0.5 to 0.65).
DEFAULT_PACKING = 0.6

# Crossings of the threads whose floats are measured at once.
_CROSSINGS_AT_ONCE = 1 << 18


def per_cm(per_inch: float) -> float:
    """Threads per centimetre of threads per inch (epi, ppi)."""
    return per_inch / CM_PER_INCH


def per_inch(per_cm: float) -> float:
    """Threads per inch of threads per centimetre."""
    return per_cm * CM_PER_INCH


def yarn_diameter_mm(
    count: str, *, density: float = COTTON_DENSITY, packing: float = DEFAULT_PACKING
) -> float:
    """Diameter in millimetres of a round yarn of that count.

    d = sqrt(4 tex / (π · 1000 · ρ · φ)): a millimetre of yarn weighs tex µg and fills π d²/4 mm³, of
    which the fraction φ is fibre.

    Args:
        count: see `yarn_tex`.
        density: of the fibre ρ, g/cm³, in (0, 25].
        packing: fraction φ of the cross-section that is fibre, in (0, 1].

    Raises:
        InputError: a count that is not known, or a density or packing out of range.

    Source: Peirce, "The geometry of cloth structure", Journal of the Textile Institute 28 (1937), T45;
    its d = 1/(28·sqrt(Ne)) inches is the case ρ·φ = 0.91 g/cm³.
    """
    if not 0 < density <= 25:
        raise InputError(f"The fibre density {density} g/cm³ is out of range; cotton has {COTTON_DENSITY}.")
    if not 0 < packing <= 1:
        raise InputError(f"The packing {packing} is out of range; it is a share above 0 and at most 1.")
    return math.sqrt(4 * yarn_tex(count) / (math.pi * 1000 * density * packing))


def tex_of_diameter(
    diameter_mm: NDArray[np.float64], *, density: float = COTTON_DENSITY, packing: float = DEFAULT_PACKING
) -> NDArray[np.float64]:
    """Linear density in tex of round yarns of these diameters, millimetres: see `yarn_diameter_mm`."""
    return diameter_mm**2 * (math.pi / 4 * 1000 * density * packing)


def longest_runs(on_top: NDArray[np.bool_]) -> NDArray[np.intp]:
    """The longest run of True in each row of bool [n, m], where rows repeat; m if all of it is True."""
    length = on_top.shape[1]
    longest = np.full(len(on_top), length, np.intp)
    step = max(1, _CROSSINGS_AT_ONCE // length)
    for first in range(0, len(on_top), step):
        row, off = np.nonzero(~on_top[first : first + step])
        starts = np.flatnonzero(np.diff(row, prepend=-1))
        # From one to the next of the row; after its last one comes its first.
        following = np.roll(off, -1)
        following[np.roll(starts, -1) - 1] = off[starts] + length
        longest[first + row[starts]] = np.maximum.reduceat(following - off - 1, starts)
    return longest


@dataclass(frozen=True)
class FloatLengths:
    """Longest floats in threads crossed, in a cloth that repeats; one that never binds counts one repeat.

    Attributes:
        warp_face: warp over weft.
        warp_back: warp under weft.
        weft_face: weft over warp.
        weft_back: weft under warp.
    """

    warp_face: int
    warp_back: int
    weft_face: int
    weft_back: int

    @property
    def longest(self) -> int:
        """The longest of all, on either face."""
        return max(self.warp_face, self.warp_back, self.weft_face, self.weft_back)


def longest_floats(draft: Draft) -> FloatLengths:
    """The longest float of each family on each face."""
    warp_up = draft.drawdown
    return FloatLengths(
        warp_face=int(longest_runs(warp_up.T).max()),
        warp_back=int(longest_runs(~warp_up.T).max()),
        weft_face=int(longest_runs(~warp_up).max()),
        weft_back=int(longest_runs(warp_up).max()),
    )


def warp_cover(draft: Draft) -> float:
    """The fraction of crossings with the warp on top: 0.5 for a balanced structure, 0.875 for satin 8."""
    return float(draft.drawdown.mean())


def unbound_threads(draft: Draft) -> tuple[list[int], list[int]]:
    """Ends and picks, 1-based, that never interlace: such cloth would fall apart there."""
    warp_up = draft.drawdown
    loose_ends = np.flatnonzero(warp_up.all(axis=0) | ~warp_up.any(axis=0)) + 1
    loose_picks = np.flatnonzero(warp_up.all(axis=1) | ~warp_up.any(axis=1)) + 1
    return loose_ends.tolist(), loose_picks.tolist()


def sett_per_cm(threads: Threads) -> float | None:
    """Mean threads per centimetre; None if the draft does not say."""
    return None if threads.spacing_mm is None else 10.0 / float(np.mean(threads.spacing_mm))


def repeat_size_cm(
    draft: Draft, ends_per_cm: float | None = None, picks_per_cm: float | None = None
) -> tuple[float, float]:
    """Width and height of one repeat in centimetres.

    Args:
        draft: any draft.
        ends_per_cm: sett that overrides the draft's; 20 if neither says.
        picks_per_cm: likewise for the picks.

    Raises:
        InputError: a sett that is not above 0.
    """

    def size(count: int, threads: Threads, name: str, given: float | None) -> float:
        if given is not None and not given > 0:
            raise InputError(f"{name} = {given} is no sett: it must be above 0.")
        return count / (given or sett_per_cm(threads) or DEFAULT_SETT_PER_CM)

    return (
        size(draft.ends, draft.warp, "ends_per_cm", ends_per_cm),
        size(draft.picks, draft.weft, "picks_per_cm", picks_per_cm),
    )


def with_setts(draft: Draft, ends_per_cm: float | None, picks_per_cm: float | None) -> Draft:
    """The draft with other setts, where one is given; spacings that differ keep their proportions.

    Args:
        ends_per_cm: mean threads per centimetre, > 0; None leaves the draft's.
        picks_per_cm: likewise.
    """
    return replace(
        draft,
        warp=_with_sett(draft.warp, draft.ends, ends_per_cm),
        weft=_with_sett(draft.weft, draft.picks, picks_per_cm),
    )


def _with_sett(threads: Threads, count: int, per_cm: float | None) -> Threads:
    if per_cm is None:
        return threads
    each = np.ones(count) if threads.spacing_mm is None else threads.spacing_mm
    return replace(threads, spacing_mm=each * (10.0 / per_cm / float(each.mean())))


def summary(draft: Draft, with_sett: bool = True) -> str:
    """A description of a draft in a few lines: size, setts, floats, loom, colours.

    Args:
        with_sett: say setts and repeat, where the draft has any.
    """
    floats = longest_floats(draft)
    lines = [f"{draft.title or 'untitled'}: {draft.ends} ends, {draft.picks} picks"]
    ends_per_cm, picks_per_cm = sett_per_cm(draft.warp), sett_per_cm(draft.weft)
    if with_sett and ends_per_cm is not None and picks_per_cm is not None:
        width, height = repeat_size_cm(draft)
        lines.append(f"sett: {ends_per_cm:.3g} ends/cm ({per_inch(ends_per_cm):.3g} epi), ")
        lines[-1] += f"{picks_per_cm:.3g} picks/cm ({per_inch(picks_per_cm):.3g} ppi)"
        lines.append(f"repeat: {width:.3g} x {height:.3g} cm")
    lines.append(
        f"longest floats: warp {floats.warp_face} on the face and {floats.warp_back} on the back, "
        f"weft {floats.weft_face} and {floats.weft_back}"
    )
    lines.append(f"warp on top at {100 * warp_cover(draft):.3g} % of the crossings")
    loose_ends, loose_picks = unbound_threads(draft)
    if loose_ends or loose_picks:
        lines.append(f"never bound: {len(loose_ends)} ends, {len(loose_picks)} picks")
    if draft.loom is not None:
        treadles = f", {draft.loom.treadles} treadles" if draft.loom.treadling is not None else ", liftplan"
        lines.append(f"loom: {draft.loom.shafts} shafts{treadles}")
    for name, threads in (("warp", draft.warp), ("weft", draft.weft)):
        if threads.colors is not None:
            lines.append(f"{name} colours: {_colours(threads.colors)}")
    return "\n".join(lines)


def _colours(colors: NDArray[np.float64]) -> str:
    """The most frequent colours, by number of threads."""
    kinds, counts = np.unique(colors, axis=0, return_counts=True)
    order = np.argsort(-counts, kind="stable")
    shown = [f"{counts[kind]} x {to_hex(kinds[kind])}" for kind in order[:6]]
    return ", ".join(shown) + (f" and {len(order) - 6} more" if len(order) > 6 else "")


# ------------------------------------------------------------------------------------------------ yarn counts
# Yarn counts as mills write them, in tex.


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
