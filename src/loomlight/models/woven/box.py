"""The parameter box: which fabrics the universal network is trained for and judged on.

chen2024's Table 2, which gives the distributions, is missing from its text. The ranges here cover the usual
suggestions (plain 22°/16°, twill 24° with a twist of 30°, satin 60°/35°) and α and β of at least 0.2 to 0.8.
Gap, blend of the diffuse term and optical depth are the paper's, one value each, and both families are set
alike. Cloth is not: denim has hardly a gap between its ends and wide ones between its picks, organza is half
holes, a satin has two ends a pick. `LAYOUT_BOX` is the same box with such layouts in it. `TRAINING_BOX` is
wider, as what lies in a corner of what was seen is learnt worst: silk, smooth and dense, shows it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from loomlight.fabric.defaults import GAP, Structure, structure_of
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.file import FabricFile, YarnTable
from loomlight.weave.draft import Draft
from loomlight.weave.named import named_weave
from loomlight.weave.textile import DEFAULT_SETT_PER_CM

# The seven weaves of chen2024 5.1 as drafts: ends × picks of one repeat.
PAPER_WEAVES = {
    "plain": "plain",
    "twill 3×3": "twill 2/1",
    "twill 5×5": "twill 3/2",
    "twill 8×8": "twill 5/3",
    "satin 5×5": "satin 5/2",
    "satin 8×8": "satin 8/3",
    "satin 5×10": "satin 5×10",
}


@dataclass(frozen=True)
class ParameterBox:
    """Ranges of the parameters of each yarn family, drawn independently: uniformly, α in its logarithm.

    Attributes:
        inclination_deg: U of plain weaves and twills, degrees.
        satin_inclination_deg: U of satins, degrees.
        twist_deg: ψ, degrees.
        roughness: α.
        height_scale: β.
        gap: share of the spacing that is left open, of each family; small ones more often.
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


PARAMETER_BOX = ParameterBox()
LAYOUT_BOX = replace(PARAMETER_BOX, gap=(0.0, 0.7), sett_ratio=(0.4, 2.5))
TRAINING_BOX = replace(
    LAYOUT_BOX,
    inclination_deg=(5.0, 40.0),
    satin_inclination_deg=(5.0, 60.0),
    roughness=(0.07, 1.0),
    sett_ratio=(1 / 3, 3.0),
)


def paper_draft(name: str) -> Draft:
    """One of `PAPER_WEAVES` as a draft."""
    if name != "satin 5×10":
        return named_weave(PAPER_WEAVES[name])
    # Two picks a shed: the five-end satin on ten picks.
    return Draft(np.repeat(named_weave("satin 5/2").drawdown, 2, axis=0))


def random_fabric(
    rng: np.random.Generator,
    draft: Draft,
    translucency: float | None = None,
    box: ParameterBox = PARAMETER_BOX,
) -> Fabric:
    """A fabric of a draft with parameters drawn from a box.

    Args:
        translucency: of both families, 0 to 1; None is the default of fabric files.
    """
    satin = structure_of(draft.drawdown) is Structure.SATIN
    low, high = box.satin_inclination_deg if satin else box.inclination_deg
    tables = [
        YarnTable(
            inclination_deg=float(rng.uniform(low, high)),
            twist_deg=float(rng.uniform(*box.twist_deg)),
            roughness=float(np.exp(rng.uniform(*np.log(box.roughness)))),
            height_scale=float(rng.uniform(*box.height_scale)),
            translucency=translucency,
        )
        for _ in range(2)
    ]
    # Drawn last and only where there is a choice: the same yarns whatever the layouts.
    gaps = [_squared(rng, *box.gap) for _ in tables]
    ratio = math.exp(_uniform(rng, *np.log(box.sett_ratio)))
    fields = FabricFile(
        ends_per_cm=DEFAULT_SETT_PER_CM * math.sqrt(ratio),
        picks_per_cm=DEFAULT_SETT_PER_CM / math.sqrt(ratio),
        warp=tables[0].model_copy(update={"gap": gaps[0]}),
        weft=tables[1].model_copy(update={"gap": gaps[1]}),
    )
    return make_fabric(fields, draft, draft.title or "random", ".")


def _uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return float(rng.uniform(low, high)) if high > low else float(low)


def _squared(rng: np.random.Generator, low: float, high: float) -> float:
    """Between both, small values more often: the square of a uniform number."""
    return low + (high - low) * _uniform(rng, 0, 1) ** 2 if high > low else low
