"""Every figure and table that `python -m studies.papers` makes, by name."""

from __future__ import annotations

import difflib

from loomlight.core.errors import InputError
from studies.papers.chen2024 import catalogue as chen2024
from studies.papers.figure import Item
from studies.papers.kuznetsov2021 import catalogue as kuznetsov2021
from studies.papers.zeltner2024 import catalogue as zeltner2024
from studies.papers.zhu2024 import catalogue as zhu2024

CATALOGUE = {
    item.name: item
    for paper in (
        chen2024,
        zhu2024,
        zeltner2024,
        kuznetsov2021,
    )
    for item in paper.ITEMS
}


def find_item(name: str) -> Item:
    """The figure of that name.

    Raises:
        InputError: there is none.
    """
    if name not in CATALOGUE:
        near = difflib.get_close_matches(name, CATALOGUE, 1, 0.3)
        hint = f'; did you mean "{near[0]}"?' if near else "."
        raise InputError(f'"{name}" is no figure: `python -m studies.papers` lists them all{hint}')
    return CATALOGUE[name]
