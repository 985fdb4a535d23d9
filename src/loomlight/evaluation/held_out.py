"""The 24 held-out fabrics of the query benchmark: drawn once by a fixed seed, in no training set.

Half are weaves that no training set holds, half the paper's seven weaves with parameters of their own. Every
second one lets light through, a quarter have threads of several colours. Parameters are drawn from the ranges
of `models/woven/parameter_ranges.py` independently for each family, but for one: the roughness of the
smoother family is drawn uniformly within its class (under 0.15, to 0.4, above), six to nine fabrics each, and
the other family's uniformly between that and the box's largest.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.file import YarnTable
from loomlight.models.woven.parameter_ranges import PARAMETER_RANGES, ParameterRanges
from loomlight.models.woven.training.random_fabrics import random_fabric
from loomlight.models.woven.training.weaves import PAPER_WEAVES, paper_draft
from loomlight.weave.named import named_weave

_SEED = 20240727
_CLASSES = ((0.0, 0.15), (0.15, 0.4), (0.4, 1.0))
_TRANSLUCENCY = (0.1, 0.5)


@dataclass(frozen=True, eq=False)
class HeldOut:
    """A held-out fabric.

    Attributes:
        name: number and weave.
        fabric: the fabric, without sheen and variation.
        unseen_weave: its weave is in no training set.
        coloured: its threads have several colours.
    """

    name: str
    fabric: Fabric
    unseen_weave: bool
    coloured: bool


@dataclass(frozen=True)
class _Plan:
    """What is not left to chance.

    Attributes:
        weave: its name.
        smooth: class of the smoother family's roughness.
        colours: how many colours warp and weft have, in thread order; None keeps one each. For weaves with
            colours of their own, as many as those.
    """

    weave: str
    smooth: int
    colours: tuple[int, int] | None = None


# Transmission is every second fabric's, so the order spreads classes, colours and transmission evenly; the
# first eight hold some of everything.
_UNSEEN = (
    _Plan("twill 4/4", 1),
    _Plan("basket 2/2", 2),
    _Plan("herringbone 2/2 8", 0),
    _Plan("houndstooth 4", 2, (2, 2)),
    _Plan("diamond figure 48", 1),
    _Plan("waffle 8", 1),
    _Plan("twill 2/2", 2, (8, 8)),
    _Plan("crepe", 0),
    _Plan("warp rib 2/2", 2),
    _Plan("satin 7/2", 0),
    _Plan("diamond 2/2 8", 2, (4, 16)),
    _Plan("twill 3/1 s", 1),
)
_PAPER = (
    _Plan("plain", 2, (8, 6)),
    _Plan("satin 5×5", 0),
    _Plan("twill 3×3", 1),
    _Plan("satin 8×8", 2),
    _Plan("twill 5×5", 1, (10, 5)),
    _Plan("satin 5×10", 1),
    _Plan("plain", 0),
    _Plan("twill 8×8", 2),
    _Plan("satin 5×5", 1, (5, 10)),
    _Plan("twill 3×3", 0),
    _Plan("satin 8×8", 1),
    _Plan("twill 5×5", 2),
)


def held_out_fabrics(count: int | None = None, box: ParameterRanges = PARAMETER_RANGES) -> list[HeldOut]:
    """The fabrics; with `count` the first so many, unseen weaves and the paper's in turn.

    Args:
        box: where parameters are drawn from; with `LAYOUT_RANGES` gaps and setts differ from cloth to cloth.

    Raises:
        InputError: `count` is not from 1 to 24.
    """
    plans = [plan for pair in zip(_PAPER, _UNSEEN, strict=True) for plan in pair]
    if count is not None and not 1 <= count <= len(plans):
        raise InputError(f"{count} held-out fabrics do not exist: choose from 1 to {len(plans)}.")
    # Fabric k is the same whatever the count: each has a generator of its own.
    return [_drawn(number, plans[number], box) for number in range(len(plans) if count is None else count)]


def _drawn(number: int, plan: _Plan, box: ParameterRanges) -> HeldOut:
    rng = np.random.default_rng([_SEED, number])
    # Pairs of the paper's and an unseen weave take turns.
    translucency = float(rng.uniform(*_TRANSLUCENCY)) if number // 2 % 2 == number % 2 else 0.0
    draft = paper_draft(plan.weave) if plan.weave in PAPER_WEAVES else named_weave(plan.weave)
    fields = random_fabric(rng, draft, translucency, box).fields
    smooth = _uniform(rng, *_CLASSES[plan.smooth])
    roughness = rng.permutation([smooth, _uniform(rng, smooth, 1.0)])
    tables: dict[str, Any] = {}
    for family, name in enumerate(("warp", "weft")):
        table = getattr(fields, name).model_dump(exclude_none=True)
        table |= {"roughness": float(roughness[family]), "specular": float(rng.uniform(0.2, 0.8))}
        table["color"] = _colours(rng, 1 if plan.colours is None else plan.colours[family])
        tables[name] = YarnTable.model_validate(table)
    name = f"{number + 1} {plan.weave}"
    weave = PAPER_WEAVES.get(plan.weave, plan.weave)
    if "×" not in weave:  # satin 5×10 has no name that a fabric file knows
        tables["weave"] = weave
    fabric = make_fabric(fields.model_copy(update=tables), draft, name, ".")
    return HeldOut(name, fabric, plan in _UNSEEN, plan.colours is not None)


def _uniform(rng: np.random.Generator, low: float, high: float) -> float:
    """A roughness between both that the box holds."""
    smallest, largest = PARAMETER_RANGES.roughness
    return float(rng.uniform(max(low, smallest), min(high, largest)))


def _colours(rng: np.random.Generator, count: int) -> list[str]:
    """sRGB colours of `count` threads: all different up to four, stripes of four colours beyond."""
    palette = rng.integers(20, 236, (min(count, 4), 3))
    number = np.arange(count) if count <= 4 else np.sort(rng.integers(0, 4, count))
    return ["#" + "".join(f"{part:02x}" for part in palette[k]) for k in number]
