"""Weaves by name: "plain", "twill 3/1 s", "satin 8/3", "houndstooth", "damask 480"; effects, tartans.

A colour-and-weave effect is a simple structure and an order of colours that together make a figure. Index 0
of an order is the dark colour, 1 the light one.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable
from dataclasses import dataclass
from math import lcm

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.core.errors import InputError
from loomlight.weave import figured, structures
from loomlight.weave.draft import Draft
from loomlight.weave.palette import from_palette, runs
from loomlight.weave.structures import MAXIMUM_NAMED_THREADS, Structure, plain, twill

CHARCOAL_AND_CREAM = ("#23262e", "#ece4d3")
INDIGO_AND_ECRU = ("#22335c", "#e6dfce")
NAVY_AND_CHALK = ("#1d2536", "#c9ccd2")
BLUE_AND_WHITE = ("#3a6ea8", "#f2f0ea")


@dataclass(frozen=True, eq=False)
class Effect:
    """A structure with colour orders; both repeat until they fit together.

    Attributes:
        structure: bool [picks, ends].
        warp_order: palette index per end; its length is the colour repeat.
        weft_order: palette index per pick.
        palette: sRGB hex of the default colours.
    """

    structure: Structure
    warp_order: NDArray[np.intp]
    weft_order: NDArray[np.intp]
    palette: tuple[str, ...] = CHARCOAL_AND_CREAM

    @property
    def repeat(self) -> tuple[int, int]:
        """Picks and ends after which structure and colours repeat together."""
        picks, ends = self.structure.shape
        return lcm(picks, self.weft_order.size), lcm(ends, self.warp_order.size)

    def draft(self, title: str) -> Draft:
        """The effect as a draft of one full repeat, in its default colours."""
        picks, ends = self.repeat
        palette = np.array([parse_colour(color, "palette") for color in self.palette])
        rows, columns = self.structure.shape
        return Draft(
            drawdown=np.tile(self.structure, (picks // rows, ends // columns)),
            warp=from_palette(ends, self.warp_order, palette),
            weft=from_palette(picks, self.weft_order, palette),
            title=title,
            palette=palette,
        )


def houndstooth(width: int) -> Effect:
    """2/2 twill with `width` dark and `width` light threads both ways; 4 makes the classic tooth."""
    order = runs((0, width), (1, width))
    return Effect(twill((2, 2)), order, order)


def hairline() -> Effect:
    """Plain weave, one dark and one light: every end covers its own colour, which gives fine lines."""
    return Effect(plain(), runs((0, 1), (1, 1)), runs((1, 1), (0, 1)), NAVY_AND_CHALK)


def log_cabin(width: int) -> Effect:
    """Plain weave of alternating dark and light, whose order flips every `width` threads."""
    alternate = np.arange(width, dtype=np.intp) % 2
    order = np.concatenate([alternate, 1 - alternate])
    return Effect(plain(), order, order)


def glen_check(groups: int) -> Effect:
    """Glen Urquhart check: 2/2 twill, `groups` of four dark and four light beside as wide a field of two
    and two."""
    order = np.concatenate([runs((0, 4), (1, 4))] * groups + [runs((0, 2), (1, 2))] * (2 * groups))
    return Effect(twill((2, 2)), order, order)


def shepherds_check(width: int) -> Effect:
    """Even checks in 2/2 twill: solid squares joined by diagonal half-tones; 8 and wider show as checks."""
    return Effect(twill((2, 2)), runs((0, width), (1, width)), runs((0, width), (1, width)))


def gingham(width: int) -> Effect:
    """Even checks in plain weave."""
    order = runs((0, width), (1, width))
    return Effect(plain(), order, order, BLUE_AND_WHITE)


def pinstripe(width: int) -> Effect:
    """2/1 twill in the dark colour with one light end in every `width`."""
    return Effect(twill((2, 1)), runs((0, width - 1), (1, 1)), runs((0, 1)), NAVY_AND_CHALK)


def denim() -> Effect:
    """3/1 twill, indigo warp, undyed weft."""
    return Effect(twill((3, 1)), runs((0, 1)), runs((1, 1)), INDIGO_AND_ECRU)


def chambray() -> Effect:
    """Plain weave, coloured warp, white weft."""
    return Effect(plain(), runs((0, 1)), runs((1, 1)), BLUE_AND_WHITE)


# ----------------------------------------------------------------------------------------------------- weaves


_NUMBERS = re.compile(r"\d+(?:/\d+)*")
# "5-end satin", "8 shaft satin"
_ENDS = re.compile(r"([0-9]) ?-? ?(?:end|shaft|harness)s?(?!\w)")
_FILLERS = {"weave", "cloth", "fabric"}
_DIRECTIONS = {"z", "s"}


@dataclass
class _Request:
    """Parser of the parameters after a weave's name."""

    text: str
    usage: str
    words: list[str]

    def fail(self, fault: str) -> InputError:
        return InputError(f'weave = "{self.text}": {fault}; write it like "{self.usage}".')

    def counts(self) -> tuple[int, ...]:
        """The next word as numbers joined by "/"; empty if it is none."""
        if not self.words or not _NUMBERS.fullmatch(self.words[0]):
            return ()
        word = self.words.pop(0)
        # Digits are counted first: int() of a million of them takes seconds.
        if any(len(digits) > 4 for digits in word.split("/")):
            raise self.fail(f"{word[:20]} is more than {MAXIMUM_NAMED_THREADS} threads")
        numbers = tuple(int(digits) for digits in word.split("/"))
        if min(numbers) < 1:
            raise self.fail(f"{word} holds a 0, where every count is at least 1")
        return numbers

    def count(self, default: int, lowest: int, highest: int = MAXIMUM_NAMED_THREADS) -> int:
        """The next word as one number."""
        numbers = self.counts() or (default,)
        if len(numbers) != 1 or not lowest <= numbers[0] <= highest:
            given = "/".join(map(str, numbers))
            raise self.fail(f"{given} is not one whole number from {lowest} to {highest}")
        return numbers[0]

    def pair(self, default: int | None = None) -> tuple[int, int]:
        """The next word as "a/b", or as "a" for a/a."""
        numbers = self.counts() or (() if default is None else (default,))
        if len(numbers) not in (1, 2):
            raise self.fail("two numbers are needed")
        self.limit(sum(numbers), sum(numbers))
        return numbers[0], numbers[-1]

    def parts(self, default: tuple[int, ...] = ()) -> tuple[int, ...]:
        """The next word as an even number of counts, "2/1" or "3/1/1/2"."""
        numbers = self.counts() or default
        if len(numbers) < 2 or len(numbers) % 2:
            raise self.fail("an even number of counts is needed, up and down in turn")
        self.limit(sum(numbers), sum(numbers))
        return numbers

    def is_z(self) -> bool:
        """The next word as a direction, Z if there is none."""
        if self.words and self.words[0] in _DIRECTIONS:
            return self.words.pop(0) == "z"
        return True

    def limit(self, ends: int, picks: int) -> None:
        """Refuses a repeat that is too large, before it is built."""
        if max(ends, picks) > MAXIMUM_NAMED_THREADS:
            raise self.fail(
                f"one repeat has {ends} ends and {picks} picks, "
                f"and at most {MAXIMUM_NAMED_THREADS} of each can be used"
            )

    def end(self) -> None:
        """Raises InputError if words are left."""
        if self.words:
            raise self.fail(f'"{" ".join(self.words)}" is not understood')


Maker = Callable[[_Request], structures.Structure | Effect | Draft]


@dataclass(frozen=True)
class _Weave:
    make: Maker
    usage: str


def _plain(request: _Request) -> structures.Structure:
    return structures.plain()


def _twill(request: _Request) -> structures.Structure:
    return structures.twill(request.parts(), z=request.is_z())


def _satin_counts(request: _Request) -> tuple[int, int]:
    numbers = request.counts()
    if len(numbers) not in (1, 2):
        raise request.fail("the number of ends is missing")
    ends = numbers[0]
    request.limit(ends, ends)
    valid = structures.satin_steps(ends)
    if not valid:
        raise request.fail(f"no regular satin has {ends} ends; 5, 7, 8 and more do")
    step = numbers[1] if len(numbers) == 2 else structures.spread_satin_step(ends)
    if step not in valid:
        shown = ", ".join(map(str, valid[:12])) + (" and more" if len(valid) > 12 else "")
        raise request.fail(
            f"{step} is no step for {ends} ends, since a step shares no divisor with {ends} and is neither 1 "
            f"nor {ends - 1}: {shown}"
        )
    return ends, int(step)


def _satin(request: _Request) -> structures.Structure:
    return structures.satin(*_satin_counts(request))


def _sateen(request: _Request) -> structures.Structure:
    return structures.sateen(*_satin_counts(request))


def _basket(request: _Request) -> structures.Structure:
    ends, picks = request.pair(default=2)
    request.limit(2 * ends, 2 * picks)
    return structures.basket(ends, picks)


def _warp_rib(request: _Request) -> structures.Structure:
    return structures.warp_rib(*request.pair(default=2))


def _weft_rib(request: _Request) -> structures.Structure:
    return structures.weft_rib(*request.pair(default=2))


def _herringbone(request: _Request) -> structures.Structure:
    parts = request.parts(default=(2, 2))
    leg = request.count(default=2 * sum(parts), lowest=2)
    request.limit(2 * leg, sum(parts))
    return structures.herringbone(parts, leg)


def _diamond(request: _Request) -> structures.Structure:
    parts = request.parts(default=(2, 2))
    leg = request.count(default=2 * sum(parts), lowest=2)
    request.limit(2 * leg, 2 * leg)
    return structures.diamond_twill(parts, leg)


def _waffle(request: _Request) -> structures.Structure:
    cell = request.count(default=8, lowest=4, highest=64)
    if cell % 2:
        raise request.fail(f"{cell} is odd, and a cell has an even number of threads")
    return structures.waffle(cell // 2)


def _crepe(request: _Request) -> structures.Structure:
    return structures.crepe()


def _houndstooth(request: _Request) -> Effect:
    width = request.count(default=4, lowest=1, highest=MAXIMUM_NAMED_THREADS // 4)
    request.limit(lcm(4, 2 * width), lcm(4, 2 * width))
    return houndstooth(width)


def _hairline(request: _Request) -> Effect:
    return hairline()


def _log_cabin(request: _Request) -> Effect:
    return log_cabin(request.count(default=8, lowest=2, highest=MAXIMUM_NAMED_THREADS // 2))


def _glen_check(request: _Request) -> Effect:
    return glen_check(request.count(default=4, lowest=1, highest=128))


def _shepherds_check(request: _Request) -> Effect:
    return shepherds_check(request.count(default=12, lowest=2, highest=MAXIMUM_NAMED_THREADS // 4))


def _gingham(request: _Request) -> Effect:
    return gingham(request.count(default=16, lowest=1, highest=MAXIMUM_NAMED_THREADS // 2))


def _pinstripe(request: _Request) -> Effect:
    return pinstripe(request.count(default=24, lowest=2, highest=MAXIMUM_NAMED_THREADS // 3))


def _denim(request: _Request) -> Effect:
    return denim()


def _chambray(request: _Request) -> Effect:
    return chambray()


def _damask(request: _Request) -> Draft:
    return figured.damask(request.count(default=480, lowest=1))


def _argyle(request: _Request) -> Draft:
    return figured.argyle_cloth(request.count(default=64, lowest=1))


def _diamond_figure(request: _Request) -> Draft:
    return figured.diamond_figure(request.count(default=96, lowest=1))


def _tartan(request: _Request) -> Draft:
    sett, request.words = " ".join(request.words), []
    try:
        effect, title = tartan(sett)
    except ValueError as fault:
        raise request.fail(str(fault)) from fault
    return effect.draft(title)


_WEAVES = {
    "plain": _Weave(_plain, "plain"),
    "twill": _Weave(_twill, "twill 2/1 z"),
    "satin": _Weave(_satin, "satin 5/2"),
    "sateen": _Weave(_sateen, "sateen 5/2"),
    "basket": _Weave(_basket, "basket 2/2"),
    "warp rib": _Weave(_warp_rib, "warp rib 2/2"),
    "weft rib": _Weave(_weft_rib, "weft rib 2/2"),
    "herringbone": _Weave(_herringbone, "herringbone 2/2 8"),
    "diamond": _Weave(_diamond, "diamond 2/2 8"),
    "waffle": _Weave(_waffle, "waffle 8"),
    "crepe": _Weave(_crepe, "crepe"),
    "houndstooth": _Weave(_houndstooth, "houndstooth 4"),
    "hairline": _Weave(_hairline, "hairline"),
    "log cabin": _Weave(_log_cabin, "log cabin 8"),
    "glen check": _Weave(_glen_check, "glen check 4"),
    "shepherds check": _Weave(_shepherds_check, "shepherd's check 12"),
    "gingham": _Weave(_gingham, "gingham 16"),
    "pinstripe": _Weave(_pinstripe, "pinstripe 24"),
    "denim": _Weave(_denim, "denim"),
    "chambray": _Weave(_chambray, "chambray"),
    "tartan": _Weave(_tartan, "tartan B24 W4 B24 R2 K24 G24 W2"),
    "damask": _Weave(_damask, "damask 480"),
    "argyle": _Weave(_argyle, "argyle 64"),
    "diamond figure": _Weave(_diamond_figure, "diamond figure 96"),
}

# Names of cloths stand for the structure that most of them have; numbers are those that are left out.
_OTHER_NAMES = {
    "tabby": "plain",
    "calico": "plain",
    "muslin": "plain",
    "poplin": "plain",
    "taffeta": "plain",
    "voile": "plain",
    "gabardine": "twill 2/2",
    "gaberdine": "twill 2/2",
    "serge": "twill 2/2",
    "drill": "twill 3/1",
    "weft faced satin": "sateen",
    "warp faced satin": "satin",
    "oxford": "basket 2/1",
    "panama": "basket",
    "rib": "warp rib",
    "diamond twill": "diamond",
    "herringbone twill": "herringbone",
    "honeycomb": "waffle",
    "crêpe": "crepe",
    "dogtooth": "houndstooth",
    "prince of wales": "glen check",
    "shepherd check": "shepherds check",
    "hopsack": "basket",
    "ogee": "damask",
}


def weave_names() -> list[str]:
    """One example of every named weave, in the form that `named_weave` reads."""
    return [weave.usage for weave in _WEAVES.values()]


def named_weave(text: str) -> Draft:
    """The draft of a weave's name: its structure, and for colour effects its default colours.

    Case and space do not matter, and numbers may come first: "2/2 twill", "5-end satin". Counts read along
    pick 1 from end 1, warp up first: "twill 3/1" has three ends up, one down, and its diagonal rises to the
    right (Z) unless "s" follows. "satin 8/3" is warp-faced, "sateen 8/3" weft-faced, both with a step of 3
    ends a pick. `weave_names` lists all.

    Raises:
        InputError: an unknown name, or numbers that make no such weave; the message says what would.
    """
    words = _words(text)
    name, rest = _split(words)
    if name is None:
        raise _unknown(text, words)
    weave = _WEAVES[name]
    request = _Request(text.strip()[:80], weave.usage, rest)
    made = weave.make(request)
    request.end()
    title = " ".join(words)
    if isinstance(made, Draft):
        return made
    if isinstance(made, Effect):
        return made.draft(title)
    return Draft(drawdown=made, title=title)


def _words(text: str) -> list[str]:
    plain_text = _ENDS.sub(r"\1 ", re.sub(r"['’]", "", text.casefold()))
    joined = re.sub(r"\s*/\s*", "/", plain_text)
    apart = re.sub(r"(?<=[^\W\d])(?=\d)|(?<=\d)(?=[^\W\d])", " ", joined)
    return re.sub(r"(?<=[^\W\d])[-_](?=[^\W\d])", " ", apart).split()


def _split(words: list[str]) -> tuple[str | None, list[str]]:
    """The longest known name that `words` begin with, or that follows numbers, and the other words."""
    kept = [word for word in words if word not in _FILLERS]
    for start, first in enumerate(kept):
        for length in range(min(len(kept) - start, 3), 0, -1):
            said = " ".join(kept[start : start + length])
            meant = _OTHER_NAMES.get(said, said).split()
            name = " ".join(word for word in meant if not _NUMBERS.fullmatch(word))
            if name in _WEAVES:
                rest = [*sorted(kept[:start], key=_DIRECTIONS.__contains__), *kept[start + length :]]
                counted = any(_NUMBERS.fullmatch(word) for word in rest)
                return name, rest if counted else [*filter(_NUMBERS.fullmatch, meant), *rest]
        if first not in _DIRECTIONS and not _NUMBERS.fullmatch(first):
            break
    return None, words


def _unknown(text: str, words: list[str]) -> InputError:
    letters = " ".join(word for word in words if not _NUMBERS.fullmatch(word))
    known = [*_WEAVES, *_OTHER_NAMES]
    close = difflib.get_close_matches(letters[:80], known, n=1)
    advice = f'did you mean "{close[0]}"? ' if close else ""
    return InputError(
        f'weave = "{text.strip()[:80]}" is no weave that is known; {advice}the weaves are '
        f"{', '.join(_WEAVES)}, or give the file of a draft."
    )


# ----------------------------------------------------------------------------------------------------- tartan
# Tartan by its sett, in the notation of the Scottish Register of Tartans: "B/24 W4 B24 R2 K24 G24 W/2".
#
# Each stripe is a colour's letters and its threads. The first and last stripe are pivots, at which the order
# turns back, and are written with "/" or without; "..." before or after the sett makes it repeat instead.
# Warp and weft have the same order, in 2/2 twill.


# The register's letters in shades that are typical of it; each tartan of it states its own.
SHADES = {
    "A": "#5c8ca8", "B": "#2c2c80", "DB": "#000064", "LB": "#98c8e8", "C": "#d05054", "G": "#006818",
    "DG": "#004028", "LG": "#86c67c", "K": "#101010", "N": "#888888", "DN": "#585858", "LN": "#c8c8c8",
    "O": "#d87c00", "DO": "#b84c00", "P": "#780078", "DP": "#440044", "LP": "#b468ac", "R": "#c80000",
    "DR": "#880000", "LR": "#e87878", "T": "#603800", "DT": "#441800", "LT": "#a08858", "W": "#f8f8f8",
    "Y": "#e8c000", "DY": "#bc8c00", "LY": "#f8e38c",
}  # fmt: skip
_STRIPE = re.compile(r"([a-z]+) ?(/?) ?([0-9]+)")


def tartan(sett: str) -> tuple[Effect, str]:
    """The cloth of a sett in small letters, and its title.

    Raises:
        ValueError: it is no sett; the argument is the fault, without a full stop.
    """
    text = sett.replace("…", "...").replace(",", " ").strip()
    repeats = text.startswith("...") or text.endswith("...")
    text = text.removeprefix("...").removesuffix("...").strip()
    stripes = [(match[1].upper(), match[2], match[3]) for match in _STRIPE.finditer(text)]
    rest = _STRIPE.sub("", text).split()
    if rest or len(stripes) < 2:
        raise ValueError(f'"{rest[0][:20]}" is no stripe' if rest else "a sett has two or more stripes")
    for letters, _, count in stripes:
        if letters not in SHADES:
            raise ValueError(f"{letters[:20]} is none of the colours {', '.join(SHADES)}")
        if len(count) > 4 or not 1 <= int(count) <= MAXIMUM_NAMED_THREADS:
            raise ValueError(
                f"{letters}{count[:20]} is not a number of threads from 1 to {MAXIMUM_NAMED_THREADS}"
            )
    marked = [number for number, (_, slash, _) in enumerate(stripes) if slash]
    if any(0 < number < len(stripes) - 1 for number in marked) or (marked and repeats):
        raise ValueError('"/" marks the first and last stripe of a sett that turns back there')
    colours = list(dict.fromkeys(letters for letters, _, _ in stripes))
    order = [(colours.index(letters), int(count)) for letters, _, count in stripes]
    whole = order if repeats else [*order, *order[-2:0:-1]]
    threads = lcm(4, sum(count for _, count in whole))
    if threads > MAXIMUM_NAMED_THREADS:
        raise ValueError(f"one repeat has {threads} ends, and at most {MAXIMUM_NAMED_THREADS} can be used")
    index: np.ndarray = runs(*whole)
    mark = "..." if repeats else ""
    title = f"tartan {mark}{' '.join(f'{letters}{slash}{count}' for letters, slash, count in stripes)}{mark}"
    return Effect(twill((2, 2)), index, index, tuple(SHADES[letters] for letters in colours)), title
