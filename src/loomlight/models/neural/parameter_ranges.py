"""Ranges of parameters: the fabrics that the universal network is trained for and evaluated on.

chen2024's Table 2, which gives the distributions, is missing from its text. The ranges here cover the usual
suggestions (plain 22°/16°, twill 24° with a twist of 30°, satin 60°/35°) and α and β of at least 0.2 to 0.8.
Gap, blend of the diffuse term and optical depth are the paper's, one value each, and both families are set
alike. Cloth is not: denim has hardly a gap between its ends and wide ones between its picks, organza is half
holes, a satin has two ends a pick. `LAYOUT_RANGES` are the same with such layouts. `TRAINING_RANGES` are
wider, as a network errs most at the ends of its ranges: silk, smooth and dense, shows it.
"""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import LoomlightWarning
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.resolve import Structure, structure_of
from loomlight.fabric.yarns import GAP
from loomlight.models.neural.weights import Weights

# Relative to a range: of values that a file gives in other units, or that are computed.
_ROUNDING = 1e-3


@dataclass(frozen=True)
class ParameterRanges:
    """Ranges of the parameters of each yarn family, drawn independently: uniformly, α in its logarithm.

    Attributes:
        inclination_deg: U of plain weaves and twills, degrees.
        satin_inclination_deg: U of satins, degrees.
        twist_deg: ψ, degrees.
        roughness: α.
        height_scale: β.
        gap: fraction of the spacing left open, of each family, below 0.02 as 0.02; small ones more often.
        sett_ratio: ends per pick of the same length; drawn in its logarithm.
        diffuse_blend: w.
        optical_depth: Tρ.
    """

    inclination_deg: tuple[float, float] = (10.0, 40.0)
    satin_inclination_deg: tuple[float, float] = (10.0, 60.0)
    twist_deg: tuple[float, float] = (-45.0, 45.0)
    roughness: tuple[float, float] = (0.1, 1.0)
    height_scale: tuple[float, float] = (0.2, 1.0)
    gap: tuple[float, float] = (GAP, GAP)
    sett_ratio: tuple[float, float] = (1.0, 1.0)
    diffuse_blend: float = 0.5
    optical_depth: float = 2.0


PARAMETER_RANGES = ParameterRanges()
LAYOUT_RANGES = replace(PARAMETER_RANGES, gap=(0.0, 0.7), sett_ratio=(0.4, 2.5))
TRAINING_RANGES = replace(
    LAYOUT_RANGES,
    inclination_deg=(5.0, 40.0),
    satin_inclination_deg=(5.0, 60.0),
    roughness=(0.07, 1.0),
    sett_ratio=(1 / 3, 3.0),
)


def trained_ranges(weights: Weights) -> ParameterRanges:
    """The ranges that the network was trained for."""
    varied = weights.recipe.get("data", {}).get("layouts") == "varied"
    return TRAINING_RANGES if varied else PARAMETER_RANGES


def warn_outside_ranges(fabric: Fabric, ranges: ParameterRanges) -> None:
    """Warns of a fabric outside the ranges that the network was trained for, and names the fields."""
    layout, appearance = fabric.layout(), fabric.appearance()
    satin = structure_of(fabric.draft.drawdown) is Structure.SATIN
    fields: list[tuple[str, float, tuple[float, float]]] = [
        ("diffuse_blend", appearance.diffuse_blend, (ranges.diffuse_blend,) * 2),
        ("optical_depth", appearance.optical_depth, (ranges.optical_depth,) * 2),
    ]
    for family in ("warp", "weft"):
        yarn, lobes = getattr(layout, family), getattr(appearance, family)
        gaps = 1 - yarn.width / yarn.spacing
        fields += [
            (f"{family}.roughness", lobes.roughness, ranges.roughness),
            (f"{family}.height_scale", yarn.height_scale, ranges.height_scale),
            (
                f"{family}.inclination_deg",
                math.degrees(yarn.inclination),
                ranges.satin_inclination_deg if satin else ranges.inclination_deg,
            ),
            (f"{family}.twist_deg", math.degrees(yarn.twist), ranges.twist_deg),
            (f"{family}.gap", _farthest(gaps, ranges.gap), ranges.gap),
        ]
    ratio = float(np.mean(layout.weft.spacing) / np.mean(layout.warp.spacing))
    fields.append(("ends per pick", ratio, ranges.sett_ratio))
    outside = [
        f"{name} = {value:.4g} ({low:g}{f' to {high:g}' if high > low else ''})"
        for name, value, (low, high) in fields
        if not low - _ROUNDING <= value <= high + _ROUNDING
    ]
    if outside:
        warnings.warn(
            f"{fabric.name}: {', '.join(outside)}: the model neural was trained on what stands in brackets, "
            "so it may be off here.",
            LoomlightWarning,
            stacklevel=3,
        )


def _farthest(values: NDArray[np.float64], bounds: tuple[float, float]) -> float:
    """The value that lies farthest outside, or deepest inside."""
    return float(values[np.abs(values - np.mean(bounds)).argmax()])
