"""Thread colours: by role in a palette (dark and light), or in thread order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import lcm

import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.core.errors import InputError
from loomlight.weave.draft import MAXIMUM_THREADS, Draft, Threads

# Of threads that nobody has coloured, sRGB: a dark warp and a light weft show how they interlace.
WARP_COLOUR, WEFT_COLOUR = "#30497a", "#efe7d6"


def with_palette(draft: Draft, warp_colors: ArrayLike | None, weft_colors: ArrayLike | None) -> Draft:
    """The draft in other colours.

    Where the draft orders its colours by a `color_index` (houndstooth: dark, light), a list is that palette
    and is put in that order. Otherwise a list is in thread order and repeats; the repeat of the draft
    grows until it holds whole lists. One colour colours a whole family.

    Args:
        draft: any draft.
        warp_colors: linear RGB [k, 3] in [0, 1] for the warp; None leaves its colours.
        weft_colors: the same for the weft.

    Raises:
        InputError: a list that is empty, too short for the roles, outside [0, 1], or so long that the
            repeat would exceed 16384 threads.
    """
    warp_list = None if warp_colors is None else _checked("warp.color", warp_colors)
    weft_list = None if weft_colors is None else _checked("weft.color", weft_colors)
    draft = _repeated_for(draft, warp_list, weft_list)
    warp, weft = draft.warp, draft.weft
    if warp_list is not None:
        warp = _coloured("warp.color", warp, warp_list, draft.ends)
    if weft_list is not None:
        weft = _coloured("weft.color", weft, weft_list, draft.picks)
    return replace(draft, warp=warp, weft=weft, palette=None)


def from_palette(threads: int, color_index: NDArray[np.intp], palette: NDArray[np.float64]) -> Threads:
    """Threads whose colour is row `color_index` (repeated over so many threads) of `palette` [k, 3]."""
    index = np.resize(color_index, threads)
    return Threads(colors=palette[index], color_index=index)


def repeat_draft(draft: Draft, across: int, along: int) -> Draft:
    """The same cloth with a repeat that holds the old one `across` times in ends, `along` in picks.

    Raises:
        InputError: more than 16384 ends or picks.
    """
    if across == 1 and along == 1:
        return draft
    if max(draft.ends * across, draft.picks * along) > MAXIMUM_THREADS:
        raise InputError(
            f"The repeat would have {draft.ends * across} ends and {draft.picks * along} picks; "
            f"at most {MAXIMUM_THREADS} of each can be used."
        )
    return replace(
        draft,
        drawdown=np.tile(draft.drawdown, (along, across)),
        warp=_repeated(draft.warp, across),
        weft=_repeated(draft.weft, along),
        loom=None,
    )


def _repeated(threads: Threads, times: int) -> Threads:
    return Threads(
        colors=None if threads.colors is None else np.tile(threads.colors, (times, 1)),
        spacing_mm=None if threads.spacing_mm is None else np.tile(threads.spacing_mm, times),
        thickness_mm=None if threads.thickness_mm is None else np.tile(threads.thickness_mm, times),
        color_index=None if threads.color_index is None else np.tile(threads.color_index, times),
    )


def _repeated_for(
    draft: Draft, warp_list: NDArray[np.float64] | None, weft_list: NDArray[np.float64] | None
) -> Draft:
    def times(name: str, threads: Threads, count: int, colors: NDArray[np.float64] | None) -> int:
        if colors is None or threads.color_index is not None:
            return 1
        whole = lcm(count, len(colors))
        if whole > MAXIMUM_THREADS:
            raise InputError(
                f"{name} has {len(colors)} colours for {count} threads: together they repeat only after "
                f"{whole} threads, and at most {MAXIMUM_THREADS} can be used; give as many as divide {count}."
            )
        return whole // count

    return repeat_draft(
        draft,
        times("warp.color", draft.warp, draft.ends, warp_list),
        times("weft.color", draft.weft, draft.picks, weft_list),
    )


def _checked(name: str, colors: ArrayLike) -> NDArray[np.float64]:
    try:
        array = np.atleast_2d(np.asarray(colors, dtype=np.float64))
    except (TypeError, ValueError) as error:
        raise InputError(f"{name} is no list of linear RGB triples.") from error
    if array.ndim != 2 or array.shape[0] == 0 or array.shape[1] != 3:
        raise InputError(f"{name} has the shape {list(array.shape)}; colours are a list of RGB triples.")
    if not np.all((array >= 0) & (array <= 1)):
        raise InputError(f"{name} holds a component outside 0 to 1; linear RGB lies between them.")
    return array


def _coloured(name: str, threads: Threads, colors: NDArray[np.float64], count: int) -> Threads:
    if threads.color_index is None:
        index = np.arange(count) % len(colors)
        return replace(threads, colors=colors[index])
    if len(colors) == 1:
        return replace(threads, colors=np.repeat(colors, count, axis=0), color_index=None)
    roles = int(threads.color_index.max()) + 1
    if len(colors) < roles:
        raise InputError(
            f"{name} has {len(colors)} colours, but the colour order of this weave uses {roles}; "
            f"give {roles}, or one."
        )
    return replace(threads, colors=colors[threads.color_index])


def runs(*lengths: Sequence[int]) -> NDArray[np.intp]:
    """A colour order from (index, count) pairs: ``runs((0, 4), (1, 4))`` is four dark, four light."""
    return np.concatenate([np.full(count, index, dtype=np.intp) for index, count in lengths])


# ------------------------------------------------------------------------ colours as a table and an index


@dataclass(frozen=True, eq=False)
class ThreadPalette:
    """Colours of a draft as a table and an index per thread, as files of drafts hold them.

    Attributes:
        colors: linear RGB [k, 3]; k may be 0.
        warp: row per end, None if the warp has no colours.
        weft: row per pick.
        original: whether it is the table that the draft came with.
    """

    colors: NDArray[np.float64]
    warp: NDArray[np.intp] | None
    weft: NDArray[np.intp] | None
    original: bool


def thread_palette(draft: Draft) -> ThreadPalette:
    """The draft's own palette if its threads still have those colours, else one in order of appearance."""
    if draft.palette is not None and all(
        _follows(threads, draft.palette) for threads in (draft.warp, draft.weft)
    ):
        return ThreadPalette(draft.palette, draft.warp.color_index, draft.weft.color_index, original=True)
    rows: dict[tuple[float, ...], int] = {}

    def index_of(threads: Threads) -> NDArray[np.intp] | None:
        if threads.colors is None:
            return None
        return np.array([rows.setdefault(tuple(color), len(rows)) for color in threads.colors.tolist()])

    warp, weft = index_of(draft.warp), index_of(draft.weft)
    colors = np.array(list(rows), dtype=np.float64).reshape(-1, 3)
    return ThreadPalette(colors, warp, weft, original=False)


def _follows(threads: Threads, palette: NDArray[np.float64]) -> bool:
    if threads.color_index is None:
        return threads.colors is None
    return threads.colors is None or np.array_equal(threads.colors, palette[threads.color_index])
