"""Random fabrics with parameters from the ranges of a training."""

from __future__ import annotations

import math

import numpy as np

from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.fields import FabricFile, YarnTable
from loomlight.fabric.resolve import Structure, structure_of
from loomlight.models.neural.weights import PARAMETER_RANGES, ParameterRanges
from loomlight.weave.draft import Draft
from loomlight.weave.textile import DEFAULT_SETT_PER_CM


def random_fabric(
    rng: np.random.Generator,
    draft: Draft,
    translucency: float | None = None,
    ranges: ParameterRanges = PARAMETER_RANGES,
) -> Fabric:
    """A fabric of a draft with parameters drawn from ranges, in direct light: networks learn components.

    Args:
        translucency: of both families, 0 to 1; None is the default of fabric files.
    """
    satin = structure_of(draft.drawdown) is Structure.SATIN
    low, high = ranges.satin_inclination_deg if satin else ranges.inclination_deg
    tables = [
        YarnTable(
            inclination_deg=float(rng.uniform(low, high)),
            twist_deg=float(rng.uniform(*ranges.twist_deg)),
            roughness=float(np.exp(rng.uniform(*np.log(ranges.roughness)))),
            height_scale=float(rng.uniform(*ranges.height_scale)),
            translucency=translucency,
        )
        for _ in range(2)
    ]
    # Drawn last and only where there is a choice: the same yarns whatever the layouts.
    gaps = [_squared(rng, *ranges.gap) for _ in tables]
    ratio = math.exp(_uniform(rng, *np.log(ranges.sett_ratio)))
    fields = FabricFile(
        ends_per_cm=DEFAULT_SETT_PER_CM * math.sqrt(ratio),
        picks_per_cm=DEFAULT_SETT_PER_CM / math.sqrt(ratio),
        warp=tables[0].model_copy(update={"gap": gaps[0]}),
        weft=tables[1].model_copy(update={"gap": gaps[1]}),
        interreflection=False,
    )
    return make_fabric(fields, draft, draft.title or "random", ".")


def _uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return float(rng.uniform(low, high)) if high > low else float(low)


def _squared(rng: np.random.Generator, low: float, high: float) -> float:
    """Between both, small values more often: the square of a uniform number."""
    return low + (high - low) * _uniform(rng, 0, 1) ** 2 if high > low else low
