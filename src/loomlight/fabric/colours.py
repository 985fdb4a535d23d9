"""The colour of every thread: what the file says, in the order that the draft has."""

from __future__ import annotations

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
    return with_palette(
        draft,
        _colours(fields.warp, "warp", draft.warp),
        _colours(fields.weft, "weft", draft.weft),
    )


def _colours(table: YarnTable, name: str, threads: Threads) -> NDArray[np.float64] | None:
    """The list of colours [k, 3] to apply; None leaves the draft's own."""
    given = table.color
    if given is None:
        if threads.colors is not None:
            return None
        given = COLOUR
    listed = [given] if is_one_colour(given) else given
    return np.array([parse_colour(colour, f"{name}.color") for colour in listed])
