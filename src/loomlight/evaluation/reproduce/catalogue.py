"""Every figure and table that `loomlight reproduce` makes, by name."""

from __future__ import annotations

import difflib

from loomlight.core.errors import InputError
from loomlight.evaluation.reproduce import comparison
from loomlight.evaluation.reproduce.evidence import Item

_ITEMS = (
    Item("chen2024/fig4", "seven seen patterns: 1 and 3 samples, equal time, the network", comparison.seen),
    Item("chen2024/fig5", "twills that no training has seen, the same columns", comparison.unseen),
    Item("chen2024/fig6", "plain cloth against the light, with and without the BTDF", comparison.backlit),
)
CATALOGUE = {item.name: item for item in _ITEMS}


def find_item(name: str) -> Item:
    """The figure of that name.

    Raises:
        InputError: there is none.
    """
    if name not in CATALOGUE:
        near = difflib.get_close_matches(name, CATALOGUE, 1, 0.3)
        hint = f'; did you mean "{near[0]}"?' if near else "."
        raise InputError(f'"{name}" is no figure: `loomlight reproduce --list` names them all{hint}')
    return CATALOGUE[name]
