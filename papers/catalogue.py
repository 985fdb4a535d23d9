"""Every figure and table that `python -m papers` makes, by name."""

from __future__ import annotations

import difflib

import papers.chen2024.catalogue
import papers.kuznetsov2021.catalogue
import papers.zeltner2024.catalogue
import papers.zhu2024.catalogue
from loomlight.core.errors import InputError
from papers.figure import Item

CATALOGUE = {
    item.name: item
    for paper in (papers.chen2024, papers.zhu2024, papers.zeltner2024, papers.kuznetsov2021)
    for item in paper.catalogue.ITEMS
}


def find_item(name: str) -> Item:
    """The figure of that name.

    Raises:
        InputError: there is none.
    """
    if name not in CATALOGUE:
        near = difflib.get_close_matches(name, CATALOGUE, 1, 0.3)
        hint = f'; did you mean "{near[0]}"?' if near else "."
        raise InputError(f'"{name}" is no figure: `python -m papers` lists them all{hint}')
    return CATALOGUE[name]
