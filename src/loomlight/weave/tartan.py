"""Tartan by its sett, in the notation of the Scottish Register of Tartans: "B/24 W4 B24 R2 K24 G24 W/2".

Each stripe is a colour's letters and its threads. The first and last stripe are pivots, at which the order
turns back, and are written with "/" or without; "..." before or after the sett makes it repeat instead. Warp
and weft have the same order, in 2/2 twill.
"""

from __future__ import annotations

import re
from math import lcm

import numpy as np

from loomlight.weave.effects import Effect
from loomlight.weave.palette import runs
from loomlight.weave.structures import MAXIMUM_NAMED_THREADS, twill

# The register's letters in shades that are typical of it; each tartan of it states its own.
SHADES = {
    "A": "#5c8ca8", "B": "#2c2c80", "DB": "#000064", "LB": "#98c8e8", "C": "#d05054", "G": "#006818",
    "DG": "#004028", "LG": "#86c67c", "K": "#101010", "N": "#888888", "DN": "#585858", "LN": "#c8c8c8",
    "O": "#d87c00", "DO": "#b84c00", "P": "#780078", "DP": "#440044", "LP": "#b468ac", "R": "#c80000",
    "DR": "#880000", "LR": "#e87878", "T": "#603800", "DT": "#441800", "LT": "#a08858", "W": "#f8f8f8",
    "Y": "#e8c000", "DY": "#bc8c00", "LY": "#f8e38c",
}  # fmt: skip
_STRIPE = re.compile(r"([a-z]+) ?(/?) ?([0-9]+)")


def tartan(sett: str) -> tuple[Effect, str]:
    """The cloth of a sett in small letters, and its title.

    Raises:
        ValueError: it is no sett; the argument is the fault, without a full stop.
    """
    text = sett.replace("…", "...").replace(",", " ").strip()
    repeats = text.startswith("...") or text.endswith("...")
    text = text.removeprefix("...").removesuffix("...").strip()
    stripes = [(match[1].upper(), match[2], match[3]) for match in _STRIPE.finditer(text)]
    rest = _STRIPE.sub("", text).split()
    if rest or len(stripes) < 2:
        raise ValueError(f'"{rest[0][:20]}" is no stripe' if rest else "a sett has two or more stripes")
    for letters, _, count in stripes:
        if letters not in SHADES:
            raise ValueError(f"{letters[:20]} is none of the colours {', '.join(SHADES)}")
        if len(count) > 4 or not 1 <= int(count) <= MAXIMUM_NAMED_THREADS:
            raise ValueError(
                f"{letters}{count[:20]} is not a number of threads from 1 to {MAXIMUM_NAMED_THREADS}"
            )
    marked = [number for number, (_, slash, _) in enumerate(stripes) if slash]
    if any(0 < number < len(stripes) - 1 for number in marked) or (marked and repeats):
        raise ValueError('"/" marks the first and last stripe of a sett that turns back there')
    colours = list(dict.fromkeys(letters for letters, _, _ in stripes))
    order = [(colours.index(letters), int(count)) for letters, _, count in stripes]
    whole = order if repeats else [*order, *order[-2:0:-1]]
    threads = lcm(4, sum(count for _, count in whole))
    if threads > MAXIMUM_NAMED_THREADS:
        raise ValueError(f"one repeat has {threads} ends, and at most {MAXIMUM_NAMED_THREADS} can be used")
    index: np.ndarray = runs(*whole)
    mark = "..." if repeats else ""
    title = f"tartan {mark}{' '.join(f'{letters}{slash}{count}' for letters, slash, count in stripes)}{mark}"
    return Effect(twill((2, 2)), index, index, tuple(SHADES[letters] for letters in colours)), title
