"""The figures of kuznetsov2021."""

from __future__ import annotations

from studies.papers.figure import Item
from studies.papers.kuznetsov2021 import equal_cost, figures, tables
from studies.papers.setting import NEUMIP

ITEMS = (
    Item(
        "kuznetsov2021/table2",
        "five height fields at equal cost: ours, without offset, by the published recipe, and Rainer et al.",
        equal_cost.comparison,
        64,
        NEUMIP,
    ),
    Item(
        "kuznetsov2021/table3", "the error of ours over eight levels of detail", tables.by_level, 64, NEUMIP
    ),
    Item(
        "kuznetsov2021/table4",
        "weights of the networks and channels of the textures",
        tables.sizes,
        1,
        NEUMIP,
    ),
    Item(
        "kuznetsov2021/fig5", "learned offsets of the turtle shell for four views", figures.offsets, 1, NEUMIP
    ),
    Item(
        "kuznetsov2021/fig10",
        "ablation: channels of the textures, layers of the networks",
        figures.ablation,
        64,
        NEUMIP,
    ),
    Item(
        "kuznetsov2021/fig11",
        "five height fields at eight levels of detail, over the reference",
        tables.zooms,
        64,
        NEUMIP,
    ),
)
