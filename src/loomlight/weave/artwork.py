"""Artwork whose colours are weaves, as jacquard cloth is designed: the picture says where, its colours which.

One pixel is one end and one round of the wefts: a pick of each weft in turn, or in an order that is given.
The bottom row is the first. Weaves repeat over the whole artwork, from its lower left corner, so that areas
of one colour are in step wherever they lie. Where areas meet, floats may grow too long; `binding.py` binds
them.
"""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.images import picture_size, read_picture_rows
from loomlight.weave.binding import bind_floats
from loomlight.weave.bitmaps import order_text, weft_palette
from loomlight.weave.draft import MAXIMUM_THREADS, Draft, Threads
from loomlight.weave.structures import Structure
from loomlight.weave.textile import DEFAULT_SETT_PER_CM, longest_runs

# Colours that an artwork may have: as many as a picture with a palette of 8 bits.
MAX_COLOURS = 255
# The place of a weave for a weft that lies free on the back, under every end.
BACK = None
# Crossings that are woven at once.
_CROSSINGS_AT_ONCE = 1 << 20
# Picks and ends over which the floats of a colour's own weaves are looked at.
_OWN_THREADS = 4096
# By how much of its length a float may be longer where areas meet than anywhere within them.
_LONGER = 1 / 3


@dataclass(frozen=True)
class Artwork:
    """How a picture is woven.

    Attributes:
        weaves: by colour, "#rrggbb" in small letters, the structure of each weft, bool [m, n], True where the
            warp is on top; `BACK` for a weft that lies free on the back there.
        names: of the weaves, for messages; as `weaves`.
        order: 1-based numbers of the wefts in the order of the picks of a row; empty: one of each.
        extra_from: the regulator stands still while this weft and later ones are woven: their picks share the
            length of the others of their row, and are left out of rows in which they lie on the back all
            the way. None: every pick takes up cloth.
        longest_float: threads that a float may pass where areas meet; None: a third more than within them.
        nearest: take pixels of other colours for the nearest one that has a weave.
    """

    weaves: Mapping[str, Sequence[Structure | None]]
    names: Mapping[str, Sequence[str]]
    order: Sequence[int] = ()
    extra_from: int | None = None
    longest_float: int | None = None
    nearest: bool = False

    @property
    def cycle(self) -> list[int]:
        """0-based weft of each pick of a row."""
        return [weft - 1 for weft in self.order] or list(range(self.wefts))

    @property
    def wefts(self) -> int:
        """Number of wefts."""
        return len(next(iter(self.weaves.values())))


def weave_artwork(
    path: str | os.PathLike[str], artwork: Artwork, rows_per_cm: float = DEFAULT_SETT_PER_CM
) -> Draft:
    """The draft of a picture whose colours are weaves.

    Args:
        path: a picture of at most 16384 pixels each way, such as a PNG of few colours.
        artwork: its colours' weaves.
        rows_per_cm: picks that take up cloth per centimetre, for the spacing of a draft with a regulator.

    Returns:
        A draft of as many ends as the picture has columns, without colours if there is one weft; several have
        a colour each (`color_index` 1, 2 …), so that others can take their places.

    Raises:
        InputError: no picture, a colour without a weave, an order that is none, too many picks, or a float
            that cannot be bound.

    Warns:
        LoomlightWarning: a weave that does not divide the artwork, which is then cut where it repeats.
    """
    cycle = artwork.cycle
    _require_weavable(artwork)
    width, height = picture_size(path)
    if max(width, height * len(cycle)) > MAXIMUM_THREADS:
        raise InputError(
            f"{path} has {width} x {height} pixels, and each row is {len(cycle)} picks: that is {width} ends "
            f"and {height * len(cycle)} picks, and at most {MAXIMUM_THREADS} of each can be used."
        )
    colours = list(artwork.weaves)
    index = colour_index(path, colours, artwork.nearest)
    _warn_of_cuts(path, artwork, index.shape)
    warp_up = _woven(index, artwork)
    loose = _loose(index, artwork)
    weft = np.tile(np.asarray(cycle, np.intp), len(index))
    spacing = None
    if artwork.extra_from is not None:
        extra = weft >= artwork.extra_from - 1
        kept = np.ones(len(weft), bool) if loose is None else ~(extra & loose.all(axis=1))
        spacing = _regulated(extra, kept, len(cycle), 10 / rows_per_cm)
        warp_up, weft = warp_up[kept], weft[kept]
        loose = None if loose is None else loose[kept]
    limit = artwork.longest_float or _own_limit(artwork)
    bound = bind_floats(warp_up, limit, loose=loose)
    title = Path(path).stem
    if artwork.wefts == 1:
        return Draft(bound, weft=Threads(spacing_mm=spacing), title=title)
    palette = weft_palette(artwork.wefts)
    ends = np.zeros(width, np.intp)
    return Draft(
        bound,
        Threads(palette[ends], color_index=ends),
        Threads(palette[weft + 1], spacing, color_index=weft + 1),
        title=title,
        palette=palette,
    )


def _require_weavable(artwork: Artwork) -> None:
    """Raises InputError unless each colour binds a weft, the order names each, and not all are extra ones."""
    wefts = artwork.wefts
    for colour, weaves in artwork.weaves.items():
        if all(weave is None for weave in weaves):
            raise InputError(
                f'weaves."{colour}" leaves every weft on the back, so that nothing binds the warp: '
                "give one of them a weave."
            )
    if artwork.order and set(artwork.order) != set(range(1, wefts + 1)):
        raise InputError(
            f'artwork.order = "{order_text(artwork.order)}" does not fit {wefts} '
            f"weft{'' if wefts == 1 else 's'}: it names each of 1 to {wefts}, "
            "and no other, as weaves has one a weft."
        )
    if artwork.extra_from is not None and not 2 <= artwork.extra_from <= wefts:
        raise InputError(
            f"artwork.regulator = {artwork.extra_from} is none of the {wefts} wefts of weaves: the cloth "
            "is taken up by those before it, at least the first, and stands still for it and later ones."
        )


# --------------------------------------------------------------------------------------------------- colours


def colour_index(path: str | os.PathLike[str], colours: Sequence[str], nearest: bool) -> NDArray[np.uint8]:
    """Which of the colours each pixel has, [rows, ends], the bottom row first.

    Raises:
        InputError: pixels of other colours, if not the `nearest` is taken.
    """
    codes = np.array([int(colour[1:], 16) for colour in colours], np.uint32)
    # A table of all colours of 8 bits; pixels of others than those named are counted.
    named = np.full(1 << 24, MAX_COLOURS, np.uint8)
    named[codes] = np.arange(len(codes))
    parts, others = [], np.zeros(0, np.uint32)
    counts = np.zeros(0, np.intp)
    for part in read_picture_rows(path):
        levels = np.rint(part * 255).astype(np.uint32)
        code = (levels[..., 0] << 16) | (levels[..., 1] << 8) | levels[..., 2]
        found = named[code]
        strange = found == MAX_COLOURS
        if strange.any():
            kinds, each = np.unique(code[strange], return_counts=True)
            if nearest:
                named[kinds] = _nearest(kinds, codes)
                found = named[code]
            else:
                others, counts = np.concatenate([others, kinds]), np.concatenate([counts, each])
        parts.append(found)
    if len(others):
        raise _unnamed(path, colours, codes, others, counts)
    return np.concatenate(parts)[::-1]


def _levels(codes: NDArray[np.uint32]) -> NDArray[np.float64]:
    return np.stack([codes >> 16, (codes >> 8) & 255, codes & 255], axis=-1).astype(np.float64)


def _nearest(kinds: NDArray[np.uint32], codes: NDArray[np.uint32]) -> NDArray[np.uint8]:
    """The nearest of the colours `codes` to each of `kinds`, by distance in sRGB."""
    nearest = np.empty(len(kinds), np.uint8)
    for first in range(0, len(kinds), 1 << 14):
        part = slice(first, first + (1 << 14))
        away = ((_levels(kinds[part])[:, None] - _levels(codes)[None]) ** 2).sum(axis=2)
        nearest[part] = away.argmin(axis=1)
    return nearest


def _unnamed(
    path: str | os.PathLike[str],
    colours: Sequence[str],
    codes: NDArray[np.uint32],
    others: NDArray[np.uint32],
    counts: NDArray[np.intp],
) -> InputError:
    """A sentence about the colour without a weave that most pixels have."""
    kinds, which = np.unique(others, return_inverse=True)
    pixels = np.bincount(which.reshape(-1), weights=counts).astype(np.intp)
    most = int(pixels.argmax())
    near = colours[int(_nearest(kinds[most : most + 1], codes)[0])]
    beside = f", and {len(kinds) - 1} more colours without a weave" if len(kinds) > 1 else ""
    advice = "give it a weave, or paint them so"
    if len(kinds) > MAX_COLOURS - len(colours):
        advice = "reduce the picture to few colours without smoothing (an indexed PNG)"
    return InputError(
        f'{path} has {pixels[most]} pixels of "#{int(kinds[most]):06x}"{beside}; weaves names no such '
        f'colour, and "{near}" is nearest: {advice}, or let nearest = true in [artwork] take the nearest.'
    )


# --------------------------------------------------------------------------------------------------- weaving


def _woven(index: NDArray[np.uint8], artwork: Artwork) -> Structure:
    """The structures of all colours and wefts, each where it belongs, bool [picks, ends]."""
    rows, ends = index.shape
    cycle = artwork.cycle
    warp_up = np.empty((rows, len(cycle), ends), bool)
    columns = np.arange(ends)
    # Widened to all ends once, so that rows are copied whole.
    wide = [
        [None if weave is None else weave[:, columns % weave.shape[1]] for weave in weaves]
        for weaves in artwork.weaves.values()
    ]
    step = max(1, _CROSSINGS_AT_ONCE // ends)
    for first in range(0, rows, step):
        part = index[first : first + step]
        row = np.arange(first, first + len(part))
        for colour in np.flatnonzero(np.bincount(part.ravel(), minlength=len(wide))):
            here = part == colour
            for place, weft in enumerate(cycle):
                structure = wide[colour][weft]
                if structure is None:
                    tile: NDArray[np.bool_] | bool = True
                else:
                    # Of its own picks, which one this is.
                    pick = row * cycle.count(weft) + cycle[:place].count(weft)
                    tile = structure[pick % len(structure)]
                np.copyto(warp_up[first : first + step, place], tile, where=here)
    return warp_up.reshape(rows * len(cycle), ends)


def _loose(index: NDArray[np.uint8], artwork: Artwork) -> NDArray[np.bool_] | None:
    """Where wefts lie free on the back, bool [picks, ends]; None for nowhere."""
    free = np.array([[weave is None for weave in weaves] for weaves in artwork.weaves.values()])
    if not free.any():
        return None
    cycle = artwork.cycle
    return np.stack([free[index, weft] for weft in cycle], axis=1).reshape(-1, index.shape[1])


def _regulated(
    extra: NDArray[np.bool_], kept: NDArray[np.bool_], picks_a_row: int, ground_mm: float
) -> NDArray[np.float64]:
    """Spacing of the picks that are kept, millimetres: those of a row share what its ground picks take up."""
    extra_rows, kept_rows = extra.reshape(-1, picks_a_row), kept.reshape(-1, picks_a_row)
    length = ground_mm * (~extra_rows).sum(axis=1)
    each = np.broadcast_to((length / kept_rows.sum(axis=1))[:, None], kept_rows.shape)
    return np.ascontiguousarray(each[kept_rows])


def _warn_of_cuts(path: str | os.PathLike[str], artwork: Artwork, size: tuple[int, int]) -> None:
    """Warns of the first weave whose repeat does not divide the artwork."""
    rows, ends = size
    for colour, weaves in artwork.weaves.items():
        for weft, weave in enumerate(weaves):
            if weave is None:
                continue
            picks = rows * artwork.cycle.count(weft)
            for name, count, repeat in (("ends", ends, weave.shape[1]), ("picks", picks, weave.shape[0])):
                if count % repeat:
                    warnings.warn(
                        f'{path} has {count} {name}, and "{artwork.names[colour][weft]}" repeats over '
                        f"{repeat}: it is cut where the artwork repeats; {count - count % repeat} or "
                        f"{count - count % repeat + repeat} would do.",
                        LoomlightWarning,
                        stacklevel=4,
                    )
                    return


def _own_limit(artwork: Artwork) -> int:
    """A third more than the longest float within any area; floats that are never bound there do not count."""
    longest = 1
    for colour in artwork.weaves:
        alone = Artwork({colour: artwork.weaves[colour]}, artwork.names, artwork.order)
        weaves = [weave for weave in artwork.weaves[colour] if weave is not None]
        counts = [alone.cycle.count(weft) for weft in range(alone.wefts)]
        picks = [
            len(weave) // math.gcd(len(weave), count)
            for weave, count in zip(artwork.weaves[colour], counts, strict=True)
            if weave is not None
        ]
        rows = min(math.lcm(*picks), max(1, _OWN_THREADS // len(alone.cycle)))
        ends = min(math.lcm(*(weave.shape[1] for weave in weaves)), _OWN_THREADS)
        index = np.zeros((rows, ends), np.uint8)
        warp_up, loose = _woven(index, alone), _loose(index, alone)
        bound = warp_up if loose is None else warp_up[~loose[:, 0]]
        for lines in (warp_up.T, ~warp_up.T, bound, ~bound):
            runs = longest_runs(np.ascontiguousarray(lines))
            runs = runs[runs < lines.shape[1]]
            longest = max(longest, int(runs.max(initial=1)))
    return longest + math.ceil(_LONGER * longest)
