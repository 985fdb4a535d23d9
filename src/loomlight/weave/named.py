"""Weaves by name: "plain", "twill 3/1 s", "satin 8/3", "houndstooth", "damask 480"."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable
from dataclasses import dataclass
from math import lcm

from loomlight.core.errors import InputError
from loomlight.weave import effects, figured, structures
from loomlight.weave.draft import Draft
from loomlight.weave.structures import MAXIMUM_NAMED_THREADS
from loomlight.weave.tartan import tartan

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


Maker = Callable[[_Request], structures.Structure | effects.Effect | Draft]


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


def _houndstooth(request: _Request) -> effects.Effect:
    width = request.count(default=4, lowest=1, highest=MAXIMUM_NAMED_THREADS // 4)
    request.limit(lcm(4, 2 * width), lcm(4, 2 * width))
    return effects.houndstooth(width)


def _hairline(request: _Request) -> effects.Effect:
    return effects.hairline()


def _log_cabin(request: _Request) -> effects.Effect:
    return effects.log_cabin(request.count(default=8, lowest=2, highest=MAXIMUM_NAMED_THREADS // 2))


def _glen_check(request: _Request) -> effects.Effect:
    return effects.glen_check(request.count(default=4, lowest=1, highest=128))


def _shepherds_check(request: _Request) -> effects.Effect:
    return effects.shepherds_check(request.count(default=12, lowest=2, highest=MAXIMUM_NAMED_THREADS // 4))


def _gingham(request: _Request) -> effects.Effect:
    return effects.gingham(request.count(default=16, lowest=1, highest=MAXIMUM_NAMED_THREADS // 2))


def _pinstripe(request: _Request) -> effects.Effect:
    return effects.pinstripe(request.count(default=24, lowest=2, highest=MAXIMUM_NAMED_THREADS // 3))


def _denim(request: _Request) -> effects.Effect:
    return effects.denim()


def _chambray(request: _Request) -> effects.Effect:
    return effects.chambray()


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
    if isinstance(made, effects.Effect):
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
