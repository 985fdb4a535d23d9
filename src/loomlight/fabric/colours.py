"""The colour of every thread: what the file says, in the order that the draft has."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.fabric.defaults import COLOUR
from loomlight.fabric.file import FabricFile, YarnTable, is_one_colour
from loomlight.weave.draft import Draft, Threads
from loomlight.weave.palette import with_palette


def coloured_draft(draft: Draft, fields: FabricFile) -> Draft:
    """`draft` with a colour for every thread: the file's, else its own, else undyed cotton.

    Raises:
        InputError: a list of colours that does not fit the draft.
    """
    coloured = with_palette(draft, _colours(fields.warp, "warp"), _colours(fields.weft, "weft"))
    return replace(
        coloured,
        warp=_with_default(coloured.warp, coloured.ends),
        weft=_with_default(coloured.weft, coloured.picks),
    )


def _colours(table: YarnTable, name: str) -> NDArray[np.float64] | None:
    if table.color is None:
        return None
    listed = [table.color] if is_one_colour(table.color) else table.color
    return np.array([parse_colour(colour, f"{name}.color") for colour in listed])


def _with_default(threads: Threads, count: int) -> Threads:
    if threads.colors is not None:
        return threads
    return replace(threads, colors=np.tile(parse_colour(COLOUR, "color"), (count, 1)))
