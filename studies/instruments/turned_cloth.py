"""What cloth of one yarn answers, free of colours: means over the repeat and over turns of the cloth."""

from __future__ import annotations

from dataclasses import dataclass, fields

from loomlight.evaluation.isotropic import Floats, Pairs, lobes_at
from loomlight.fabric.fabric import Fabric


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
    at, light = lobes_at(fabric, pairs.turned(turns))
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
