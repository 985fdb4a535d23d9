"""Cloth as isotropic BRDFs see it: its means over the repeat and over turns of the cloth, free of colours.

A measured isotropic BRDF is what a flat piece of cloth shows on average, under all turns.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from drjit.llvm import Array2f, Array3f
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import LobesModel, LobesOptions
from loomlight.models.separable import FilteredBsdf

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Pairs:
    """Unit vectors towards light and view, each [n, 3], all on the front."""

    light: Floats
    view: Floats

    def __len__(self) -> int:
        return len(self.light)


@dataclass(frozen=True)
class TurnedTerms:
    """What a cloth of one yarn answers for pairs [n], cosine included.

    Attributes:
        diffuse, specular: factors of its albedos, 1/sr.
        bounced: light between yarns, 1/sr.
        lit: share of the view rays that meets lit yarn or a hole, by which sheen counts.
    """

    diffuse: Floats
    specular: Floats
    bounced: Floats
    lit: Floats

    def blended(self, other: TurnedTerms, share: float) -> TurnedTerms:
        """A share of another's terms in the place of these."""
        return TurnedTerms(
            *(
                (1 - share) * getattr(self, each.name) + share * getattr(other, each.name)
                for each in fields(self)
            )
        )


def turned_terms(fabric: Fabric, pairs: Pairs, turns: int) -> TurnedTerms:
    """Means over so many turns of a cloth of one yarn in warp and weft, by `lobes`."""
    at, light = _at_turns(fabric, pairs, turns)
    evaluation = at.evaluate(light)
    parts = evaluation.components
    bounced = at.bounced_value(evaluation, light)
    terms = (
        parts.diffuse_warp + parts.diffuse_weft,
        parts.specular_warp + parts.specular_weft,
        (bounced.x + bounced.y + bounced.z) / 3,
        parts.light_visibility + evaluation.hole,
    )
    return TurnedTerms(*(term.numpy().reshape(turns, -1).mean(axis=0, dtype=float) for term in terms))


def turned_value(fabric: Fabric, pairs: Pairs, turns: int) -> Floats:
    """f·cos of a fabric, mean over so many turns [n, 3], 1/sr, by `lobes`."""
    at, light = _at_turns(fabric, pairs, turns)
    return np.asarray(at.value(light)).reshape(3, turns, -1).mean(axis=1, dtype=float).T


def _at_turns(fabric: Fabric, pairs: Pairs, turns: int) -> tuple[FilteredBsdf, Array3f]:
    model = LobesModel.for_source(fabric, LobesOptions())
    width, height = fabric.repeat_mm
    count = turns * len(pairs)
    light, view = (
        Array3f(np.ascontiguousarray(_turned(vectors, turns), np.float32))
        for vectors in (pairs.light, pairs.view)
    )
    zero = np.zeros(count, np.float32)
    # Ten repeats: a mean of all that there is.
    sides = np.full(count, 10 * width, np.float32), np.full(count, 10 * height, np.float32)
    footprint = Footprint(Array2f(zero, zero), Array2f(sides[0], zero), Array2f(zero, sides[1]))
    at = model.at(view, footprint)
    assert isinstance(at, FilteredBsdf)
    return at, light


def _turned(vectors: Floats, turns: int) -> Floats:
    """Vectors [n, 3] turned about z, [3, turns · n]."""
    # Not by whole shares of a right angle: warp and weft would be met from the same sides over and over.
    angles = (np.arange(turns)[:, None] + 0.37) * (2 * np.pi / turns)
    x, y, z = vectors.T
    cosine, sine = np.cos(angles), np.sin(angles)
    turned = cosine * x - sine * y, sine * x + cosine * y, np.broadcast_to(z, (turns, len(vectors)))
    return np.stack([part.ravel() for part in turned])
