"""The colour of every thread: colours of the file, in the order of the draft."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.fabric.file import FabricFile, YarnTable
from loomlight.fabric.thread_order import colours_in_order
from loomlight.weave.draft import Draft, Threads
from loomlight.weave.palette import WARP_COLOUR, WEFT_COLOUR, with_palette


def coloured_draft(draft: Draft, fields: FabricFile) -> Draft:
    """`draft` with a colour for every thread: the file's, else its own, else a dark warp and a light weft.

    Where a family of the draft has two or more colours in an order of its own, a list of as many replaces
    them, in the order of the draft's palette. A longer list, and any list where there is no such order, is in
    thread order and repeats.

    Raises:
        InputError: a list that is shorter than the draft's order, or that makes too long a repeat.
    """
    warp = _colours(fields.warp, "warp", draft.warp)
    weft = _colours(fields.weft, "weft", draft.weft)
    by_role = replace(draft, warp=_with_roles(draft.warp, warp), weft=_with_roles(draft.weft, weft))
    return with_palette(by_role, warp, weft)


def _with_roles(threads: Threads, listed: NDArray[np.float64] | None) -> Threads:
    """`threads` whose `color_index` counts the colours that this family uses; None for thread order."""
    if threads.color_index is None or listed is None:
        return threads
    used, role = np.unique(threads.color_index, return_inverse=True)
    in_thread_order = len(used) == 1 or len(listed) > len(used)
    return replace(threads, color_index=None if in_thread_order else role.reshape(-1))


def _colours(table: YarnTable, name: str, threads: Threads) -> NDArray[np.float64] | None:
    """The list of colours [k, 3] to apply; None leaves the draft's own."""
    given = table.albedo if table.color is None else table.color
    if given is None:
        if threads.colors is not None:
            return None
        given = WARP_COLOUR if name == "warp" else WEFT_COLOUR
    field = f"{name}.{'albedo' if table.color is None else 'color'}"
    return np.array([parse_colour(colour, field) for colour in colours_in_order(given, field)])
