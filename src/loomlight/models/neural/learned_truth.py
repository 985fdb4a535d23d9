"""What the network learned from, in a few numbers: whether yarns have changed since it was trained.

The network stands for the yarns and their scattering as they were when it was trained. The numbers are the
truth over footprints of two fabrics and the maps that the encoder reads. Training writes them beside the
weights; a later version of the layers below gives others, and then the network is old: it still answers, for
the cloth of its day. Numbers are compared rather than a hash of them, as processors round differently.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.queries import fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.fabric.fabric import make_fabric
from loomlight.fabric.fields import FabricFile, YarnTable
from loomlight.models.neural.face_maps import face_maps
from loomlight.scattering.point import YarnScattering
from loomlight.weave.named import named_weave
from loomlight.yarn.geometry import YarnGeometry

# The entry of a weights file's provenance.
ENTRY = "truth"
# Differences that processors make, of the largest number of their kind.
TOLERANCE = 2e-3
_PAIRS, _FOOTPRINTS, _TEXELS = 24, 24, 8
_DIGITS = 5
# Weave, gaps of warp and weft, and inclination: dense and open, as trainings draw them.
_CLOTHS = (("twill 2/1", 0.0, 0.2, 20.0), ("satin 5/2", 0.1, 0.5, 45.0))


def truth_numbers(float_type: type) -> list[float]:
    """The numbers of this version: means of components, holes and maps.

    Args:
        float_type: the Dr.Jit Float type to compute with.
    """
    found: list[float] = []
    for number, (weave, warp, weft, inclination) in enumerate(_CLOTHS):
        tables = [
            YarnTable(inclination_deg=inclination, twist_deg=20.0, roughness=0.3, height_scale=0.7, gap=gap)
            for gap in (warp, weft)
        ]
        fields = FabricFile(warp=tables[0], weft=tables[1], interreflection=False)
        fabric = make_fabric(fields, named_weave(weave), weave, ".")
        layout = fabric.layout()
        geometry = YarnGeometry(layout)
        slices = FabricSlices(
            YarnScattering(geometry, fabric.appearance()), float_type, _TEXELS, shadows="mapped"
        )
        queries = query_set(
            fabric_scale(layout), _PAIRS, _FOOTPRINTS, seed=63, step=number, transmits=True, lights=8, views=8
        )
        truth = slices.box_means(
            queries.lights, queries.views, queries.pairs, queries.centres, queries.boxes
        ).astype(np.float64)
        same_side = queries.lights[queries.pairs[:, 0], 2] * queries.views[queries.pairs[:, 1], 2] > 0
        for chosen in (same_side, ~same_side):
            found += truth[chosen].mean((0, 1)).tolist()
        picks, ends = layout.warp_on_top.shape
        maps = face_maps(geometry, False, _TEXELS * picks, _TEXELS * ends, float_type).astype(np.float64)
        found += np.abs(maps).mean((1, 2)).tolist()
    return [float(f"{value:.{_DIGITS}g}") for value in found]


def moved_since(provenance: Mapping[str, Any], now: list[float]) -> float | None:
    """By how much the numbers have changed since a training, at most, relatively; None if they have not.

    Infinity is a training that kept none, or others.

    Args:
        provenance: of the weights.
        now: `truth_numbers`.
    """
    before = provenance.get(ENTRY)
    if not isinstance(before, list) or len(before) != len(now):
        return float("inf")
    one, other = np.array(before, np.float64), np.array(now, np.float64)
    most = float(_relative(one, other).max())
    return most if most > TOLERANCE else None


def _relative(one: NDArray[np.float64], other: NDArray[np.float64]) -> NDArray[np.float64]:
    largest = np.maximum(np.abs(one), np.abs(other))
    # What is tiny beside the rest is rounding.
    return np.abs(one - other) / np.maximum(largest, 1e-3 * largest.max())
