"""The 465 materials of chen2024 5.1: seven weaves, with sets of twist, inclination, roughness and height.

The paper samples 9 sets of twist ψ and inclination U for plain weave and 4 for the six others, and 9 or 16
sets of roughness α and height scale β for each: 81 + 192 + 192 materials. Its Table 2 of distributions is
missing; `PARAMETER_RANGES` stands in for it. Sets are stratified: k×k cells of (ψ, U) and of (log α, β), a
draw in each, where the weft takes the cells in another order than the warp. Any material can be made on its
own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.fields import FabricFile, YarnTable
from loomlight.fabric.resolve import Structure, structure_of
from loomlight.models.neural.weights import PARAMETER_RANGES
from studies.papers.chen2024.training.weaves import PAPER_WEAVES, paper_draft

# Cells along one side of (ψ, U) and of (log α, β).
_PLAIN_SETS = (3, 3)
_OTHER_SETS = (2, 4)


@dataclass(frozen=True)
class MaterialNumber:
    """Which of the paper's sets a material is made of.

    Attributes:
        weave: a key of `PAPER_WEAVES`.
        shape: number of the set of twist and inclination.
        appearance: number of the set of roughness and height scale.
    """

    weave: str
    shape: int
    appearance: int


def _sets(weave: str) -> tuple[int, int]:
    return _PLAIN_SETS if weave == "plain" else _OTHER_SETS


def _numbered() -> tuple[MaterialNumber, ...]:
    return tuple(
        MaterialNumber(weave, shape, appearance)
        for weave in PAPER_WEAVES
        for shape in range(_sets(weave)[0] ** 2)
        for appearance in range(_sets(weave)[1] ** 2)
    )


# By number: plain first, and materials of one shape side by side.
MATERIALS = _numbered()


def paper_material(number: int, seed: int = 0) -> Fabric:
    """Material `number` (0 to 464) of the set that `seed` draws.

    Raises:
        InputError: there is no such number.
    """
    if not 0 <= number < len(MATERIALS):
        raise InputError(f"material {number} does not exist: numbers go from 0 to {len(MATERIALS) - 1}.")
    material = MATERIALS[number]
    draft = paper_draft(material.weave)
    place = list(PAPER_WEAVES).index(material.weave)
    shapes, appearances = _sets(material.weave)
    satin = structure_of(draft.drawdown) is Structure.SATIN
    ranges = PARAMETER_RANGES
    shape = _stratified(
        np.random.default_rng([seed, place]),
        shapes,
        (ranges.twist_deg, ranges.satin_inclination_deg if satin else ranges.inclination_deg),
    )[:, material.shape]
    low, high = np.log(ranges.roughness)
    appearance = _stratified(
        np.random.default_rng([seed, place, material.shape]), appearances, ((low, high), ranges.height_scale)
    )[:, material.appearance]
    tables = [
        YarnTable(
            twist_deg=float(twist),
            inclination_deg=float(inclination),
            roughness=float(np.exp(roughness)),
            height_scale=float(height_scale),
        )
        for (twist, inclination), (roughness, height_scale) in zip(shape, appearance, strict=True)
    ]
    fields = FabricFile(
        gap=ranges.gap[0],
        diffuse_blend=ranges.diffuse_blend,
        optical_depth=ranges.optical_depth,
        interreflection=False,
        warp=tables[0],
        weft=tables[1],
    )
    return make_fabric(fields, draft, f"material {number}, {material.weave}", ".")


def _stratified(
    rng: np.random.Generator, side: int, ranges: tuple[tuple[float, float], tuple[float, float]]
) -> NDArray[np.float64]:
    """Draws of two parameters [2 families, side² sets, 2], one in each cell for either family."""
    lower, upper = np.asarray(ranges).T
    cells = np.stack(np.meshgrid(np.arange(side), np.arange(side), indexing="ij"), axis=-1).reshape(-1, 2)
    families = [(rng.permutation(cells) + rng.random(cells.shape)) / side for _ in range(2)]
    return lower + np.stack(families) * (upper - lower)
