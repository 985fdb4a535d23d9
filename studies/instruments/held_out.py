"""The 24 held-out fabrics of the query benchmark: drawn once by a fixed seed, in no training set.

Half are weaves that are in no training set, half the paper's seven weaves with random parameters. Every
second one transmits light, a quarter have threads of several colours. Parameters are drawn from the ranges of
`models/neural/weights.py` independently for each family, except roughness: that of the smoother
family is uniform within its class (under 0.15, to 0.4, above), six to nine fabrics each, and the other
family's is uniform between that and the largest of the range.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from loomlight.core.errors import InputError
from loomlight.evaluation.query_benchmark import HeldOut
from loomlight.fabric.fabric import make_fabric
from loomlight.fabric.fields import YarnTable
from loomlight.models.neural.weights import LAYOUT_RANGES, PARAMETER_RANGES, ParameterRanges
from loomlight.weave.draft import Draft
from loomlight.weave.named import named_weave
from studies.papers.chen2024.training.random_fabrics import random_fabric
from studies.papers.chen2024.training.weaves import PAPER_WEAVES, paper_draft

_SEED = 20240727
_CLASSES = ((0.0, 0.15), (0.15, 0.4), (0.4, 1.0))
_TRANSLUCENCY = (0.1, 0.5)


@dataclass(frozen=True)
class _Spec:
    """The parameters of a fabric that are not random.

    Attributes:
        weave: its name.
        smooth: class of the smoother family's roughness.
        colours: number of colours of warp and weft, in thread order; None is one each. Weaves with colour
            patterns have as many as those.
    """

    weave: str
    smooth: int
    colours: tuple[int, int] | None = None


# Every second fabric transmits, so the order spreads classes, colours and transmission evenly; the first
# eight have some of each.
_UNSEEN = (
    _Spec("twill 4/4", 1),
    _Spec("basket 2/2", 2),
    _Spec("herringbone 2/2 8", 0),
    _Spec("houndstooth 4", 2, (2, 2)),
    _Spec("diamond figure 48", 1),
    _Spec("waffle 8", 1),
    _Spec("twill 2/2", 2, (8, 8)),
    _Spec("crepe", 0),
    _Spec("warp rib 2/2", 2),
    _Spec("satin 7/2", 0),
    _Spec("diamond 2/2 8", 2, (4, 16)),
    _Spec("twill 3/1 s", 1),
)
_PAPER = (
    _Spec("plain", 2, (8, 6)),
    _Spec("satin 5×5", 0),
    _Spec("twill 3×3", 1),
    _Spec("satin 8×8", 2),
    _Spec("twill 5×5", 1, (10, 5)),
    _Spec("satin 5×10", 1),
    _Spec("plain", 0),
    _Spec("twill 8×8", 2),
    _Spec("satin 5×5", 1, (5, 10)),
    _Spec("twill 3×3", 0),
    _Spec("satin 8×8", 1),
    _Spec("twill 5×5", 2),
)


def held_out_fabrics(count: int | None = None, ranges: ParameterRanges = PARAMETER_RANGES) -> list[HeldOut]:
    """The first `count` fabrics, or all 24; the paper's weaves and unseen ones alternate.

    Args:
        ranges: of the random parameters; with `LAYOUT_RANGES` gaps and setts differ between fabrics.

    Raises:
        InputError: `count` is not from 1 to 24.
    """
    specs = [spec for pair in zip(_PAPER, _UNSEEN, strict=True) for spec in pair]
    if count is not None and not 1 <= count <= len(specs):
        raise InputError(f"{count} held-out fabrics do not exist: choose from 1 to {len(specs)}.")
    # Fabric k does not depend on the count: each has its own generator.
    return [_drawn(number, spec, ranges) for number, spec in enumerate(specs[:count])]


def _drawn(number: int, spec: _Spec, ranges: ParameterRanges) -> HeldOut:
    rng = np.random.default_rng([_SEED, number])
    # Every second fabric of either kind transmits.
    translucency = float(rng.uniform(*_TRANSLUCENCY)) if number // 2 % 2 == number % 2 else 0.0
    draft = paper_draft(spec.weave) if spec.weave in PAPER_WEAVES else named_weave(spec.weave)
    fields = random_fabric(rng, draft, translucency, ranges).fields
    smooth = _uniform(rng, *_CLASSES[spec.smooth])
    roughness = rng.permutation([smooth, _uniform(rng, smooth, 1.0)])
    tables: dict[str, Any] = {}
    for family, name in enumerate(("warp", "weft")):
        table = getattr(fields, name).model_dump(exclude_none=True)
        table |= {"roughness": float(roughness[family]), "specular": float(rng.uniform(0.2, 0.8))}
        table["color"] = _colours(rng, 1 if spec.colours is None else spec.colours[family])
        tables[name] = YarnTable.model_validate(table)
    name = f"{number + 1} {spec.weave}"
    weave = PAPER_WEAVES.get(spec.weave, spec.weave)
    if "×" not in weave:  # satin 5×10 has no name that a fabric file knows
        tables["weave"] = weave
    fabric = make_fabric(fields.model_copy(update=tables), draft, name, ".")
    return HeldOut(name, fabric, spec in _UNSEEN, spec.colours is not None)


def _uniform(rng: np.random.Generator, low: float, high: float) -> float:
    """A random roughness between both, within `PARAMETER_RANGES`."""
    smallest, largest = PARAMETER_RANGES.roughness
    return float(rng.uniform(max(low, smallest), min(high, largest)))


def _colours(rng: np.random.Generator, count: int) -> list[str]:
    """sRGB colours of `count` threads: all different up to four, stripes of four colours beyond."""
    palette = rng.integers(20, 236, (min(count, 4), 3))
    number = np.arange(count) if count <= 4 else np.sort(rng.integers(0, 4, count))
    return ["#" + "".join(f"{part:02x}" for part in palette[k]) for k in number]


# Odd fabrics: an irregular draft, or a name, with gaps and setts of `LAYOUT_RANGES`.
_ODD_SIDES, _ODD_WEAVES = (12, 12, 24, 24), ("crepe", "waffle 8")


def odd_fabrics() -> list[HeldOut]:
    """Six fabrics of irregular weaves and layouts: four random drafts of 12 and 24 threads, crepe, waffle."""
    drafts = [irregular_draft(seed, side) for seed, side in enumerate(_ODD_SIDES)]
    drafts += [named_weave(name) for name in _ODD_WEAVES]
    found = []
    for number, draft in enumerate(drafts):
        fabric = random_fabric(np.random.default_rng([_SEED, 100 + number]), draft, 0.3, LAYOUT_RANGES)
        found.append(HeldOut(f"odd {number + 1} {draft.title}", fabric, True, False))
    return found


def irregular_draft(seed: int, side: int) -> Draft:
    """Random crossings of so many ends and picks; every thread interlaces."""
    rng = np.random.default_rng(seed)
    while True:
        drawdown = rng.random((side, side)) < 0.5
        if all(0 < mean < 1 for axis in (0, 1) for mean in drawdown.mean(axis=axis)):
            return Draft(drawdown, title=f"irregular {seed}")
