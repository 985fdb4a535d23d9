"""Figured cloth: a motif in one structure on a ground in another, as a jacquard loom weaves damask."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.core.errors import InputError
from loomlight.weave.draft import Draft
from loomlight.weave.motifs import OGEE_ASPECT, Mask, argyle, lozenges, ogee_damask
from loomlight.weave.palette import from_palette
from loomlight.weave.structures import MAXIMUM_NAMED_THREADS, Structure, sateen, satin, twill
from loomlight.weave.textile import longest_runs

_IVORY_AND_GOLD = ("#e9dfc6", "#8c6a2f")
_SLATE_AND_CREAM = ("#39465c", "#e8e0cf")
_WINE_AND_ROSE = ("#5d1f2e", "#d9a9a0")


def figured_structure(mask: Mask, figure: Structure, ground: Structure, *, float_limit: int) -> Structure:
    """`figure` where `mask` is True and `ground` elsewhere, with floats bound where the two meet.

    Args:
        mask: bool [picks, ends], row 0 is pick 1; both structures must divide it.
        figure: bool [m, n].
        ground: bool [m, n].
        float_limit: the longest float that is left, in threads; at least the structures' own.

    Raises:
        InputError: a structure that does not divide the mask, or a limit that cannot be kept.
    """
    picks, ends = mask.shape
    for name, structure in (("figure", figure), ("ground", ground)):
        if picks % structure.shape[0] or ends % structure.shape[1]:
            raise InputError(
                f"The {name} structure has {structure.shape[1]} ends and {structure.shape[0]} picks, "
                f"which do not divide a motif of {ends} ends and {picks} picks."
            )
    tiled = [
        np.tile(structure, (picks // structure.shape[0], ends // structure.shape[1]))
        for structure in (figure, ground)
    ]
    warp_up = np.where(mask, *tiled)
    return bind_floats(warp_up, float_limit)


def bind_floats(warp_up: Structure, limit: int) -> Structure:
    """The structure with extra binding points in the floats longer than `limit`, on either face.

    Each is put as near the middle of its float as it can be without making a float of the other family
    too long.

    Raises:
        InputError: a float that no binding point can shorten.
    """
    bound = warp_up.copy()
    for _ in range(_ROUNDS):
        long_ends = _long_rows(bound.T, limit)
        for end in long_ends:
            _bind_thread(bound[:, end], bound, limit, along_warp=True, thread=int(end))
        long_picks = _long_rows(bound, limit)
        for pick in long_picks:
            _bind_thread(bound[pick], bound, limit, along_warp=False, thread=int(pick))
        if not long_ends.size and not long_picks.size:
            return bound
    raise InputError(f"No binding keeps every float of the figure to {limit} threads; allow longer ones.")


_ROUNDS = 8


def _long_rows(rows: NDArray[np.bool_], limit: int) -> NDArray[np.intp]:
    return np.flatnonzero(np.maximum(longest_runs(rows), longest_runs(~rows)) > limit)


def _bind_thread(
    row: NDArray[np.bool_], cloth: Structure, limit: int, *, along_warp: bool, thread: int
) -> None:
    """Flips one crossing in each long float of a thread; `row` is a view of `cloth`."""
    for start, length in _runs(row):
        if length <= limit:
            continue
        middle = start + length // 2
        by_distance = sorted(range(start + 1, start + length - 1), key=lambda at: abs(at - middle))
        for at in by_distance:
            crossing = at % row.size
            row[crossing] = not row[crossing]
            across = cloth[crossing] if along_warp else cloth[:, crossing]
            if _run_through(across, thread) <= limit:
                break
            row[crossing] = not row[crossing]


def _runs(row: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Start and length of each run of equal values in a row that repeats."""
    starts = np.flatnonzero(row != np.roll(row, 1))
    if not starts.size:
        return [(0, int(row.size))]
    lengths = np.diff(np.append(starts, starts[0] + row.size))
    return list(zip(starts.tolist(), lengths.tolist(), strict=True))


def _run_through(row: NDArray[np.bool_], at: int) -> int:
    """The length of the run that holds position `at` in a row that repeats."""
    turned = np.roll(row, -at)
    different = np.flatnonzero(turned != turned[0])
    if not different.size:
        return int(row.size)
    return int(different[0] + row.size - 1 - different[-1])


def damask(ends: int) -> Draft:
    """The ogee damask on so many ends (a multiple of 16 from 160): satin 8/3 on sateen 8/3.

    Raises:
        InputError: another number of ends.
    """
    picks = round(ends * OGEE_ASPECT)
    _check("damask", ends, picks, multiple=16, lowest=160)
    structure = figured_structure(ogee_damask(ends, picks), satin(8, 3), sateen(8, 3), float_limit=10)
    return _two_coloured(structure, f"damask {ends}", _IVORY_AND_GOLD)


def argyle_cloth(ends: int) -> Draft:
    """Argyle diamonds on so many ends (a multiple of 8 from 32): 3/1 twill on 1/3 twill.

    Raises:
        InputError: another number of ends.
    """
    picks = ends * 3 // 2
    _check("argyle", ends, picks, multiple=8, lowest=32)
    structure = figured_structure(argyle(ends, picks), twill((3, 1)), twill((1, 3)), float_limit=5)
    return _two_coloured(structure, f"argyle {ends}", _SLATE_AND_CREAM)


def diamond_figure(ends: int) -> Draft:
    """Diamonds within diamonds on so many ends (a multiple of 16 from 48): satin 8/3 on sateen 8/3.

    Raises:
        InputError: another number of ends.
    """
    _check("diamond figure", ends, ends, multiple=16, lowest=48)
    structure = figured_structure(lozenges(ends, ends), satin(8, 3), sateen(8, 3), float_limit=10)
    return _two_coloured(structure, f"diamond figure {ends}", _WINE_AND_ROSE)


def _check(name: str, ends: int, picks: int, multiple: int, lowest: int) -> None:
    if ends % multiple or ends < lowest or max(ends, picks) > MAXIMUM_NAMED_THREADS:
        nearest = max(
            lowest,
            min(round(ends / multiple) * multiple, MAXIMUM_NAMED_THREADS * ends // max(ends, picks, 1)),
        )
        nearest -= nearest % multiple
        raise InputError(
            f'"{name} {ends}" cannot be woven: its ends must be a multiple of {multiple}, at least {lowest}, '
            f"with at most {MAXIMUM_NAMED_THREADS} ends and picks; {nearest} would do."
        )


def _two_coloured(structure: Structure, title: str, colors: tuple[str, str]) -> Draft:
    picks, ends = structure.shape
    palette = np.array([parse_colour(color, "palette") for color in colors])
    return Draft(
        drawdown=structure,
        warp=from_palette(ends, np.array([0]), palette),
        weft=from_palette(picks, np.array([1]), palette),
        title=title,
        palette=palette,
    )
