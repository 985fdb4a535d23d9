"""Numbers of light between yarns as shaders read them: words in the order of `PARTS`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.realtime.word_table import WordTable
from loomlight.scattering.appearance import Appearance
from loomlight.scattering.fibre import mean_layer_shares
from loomlight.scattering.openness import POINT_TERMS, VIEW_TERMS, Openness

NO_OPENNESS = 0xFFFFFFFF
# Words that the kernel `bake_openness` writes for each ray; `bake_openness.slang` has their order.
RAY_RESULTS = 10
# Shapes by name, in order: numbers of `Openness`, 1/relief, and what fibre layers of warp and weft send back
# and let through at albedo 1.
PARTS: dict[str, tuple[int, ...]] = {
    "BY_VIEW": (2, 2, 3, VIEW_TERMS),
    "BY_POINT": (2, 2, 3, POINT_TERMS),
    "WARP_SEEN": (2, VIEW_TERMS),
    "INTERIOR": (2, 2),
    "MEETS": (2, 2, 2),
    "BLOCKS": (2, 2),
    "PER_RELIEF": (1,),
    "LAYERS": (2, 2),
}


def openness_parts(openness: Openness, appearance: Appearance) -> dict[str, NDArray[np.float64]]:
    """Numbers of a fabric by the names of `PARTS`, in their order and shapes."""
    layers = [
        [float(share) for share in mean_layer_shares(family.roughness, appearance.optical_depth)]
        for family in (appearance.warp, appearance.weft)
    ]
    parts: tuple[Any, ...] = (
        openness.by_view,
        openness.by_point,
        openness.warp_seen,
        openness.interior,
        openness.meets,
        openness.blocks,
        1 / openness.relief,
        layers,
    )
    return {
        name: np.broadcast_to(np.asarray(part, np.float64), shape)
        for (name, shape), part in zip(PARTS.items(), parts, strict=True)
    }


def pack_openness(table: WordTable, appearance: Appearance) -> int:
    """Appends the numbers of a fabric; the first word, or `NO_OPENNESS` without light between yarns."""
    if appearance.openness is None:
        return NO_OPENNESS
    parts = openness_parts(appearance.openness, appearance)
    return table.add(np.concatenate([part.ravel() for part in parts.values()]))
