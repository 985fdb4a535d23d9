"""Directions that a small network describes, for both sides of a surface, and their exact density.

A network describes two mixtures of lobes (`scattering/two_sided_lobes.py`), q towards the view's side and q'
towards the other side, mirrored, and the probability s of the first. The density of a light l is

    (1 − d − e) [s q(l) + (1 − s) q'(l mirrored)] + d s/2π + e/2π    on the view's side, and
    (1 − d − e) [s q(l) + (1 − s) q'(l mirrored)] + d (1 − s)/2π     on the other one.

The uniform part d bounds weights; e is for what no lobe describes, such as sheen. All of it is given that
light does not pass straight through.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import drjit as dr

from loomlight.core.arrays import Float, Mask, Vec2, Vec3
from loomlight.core.backend import array_types, maximum
from loomlight.scattering.directions import uniform_on_sphere
from loomlight.scattering.two_sided_lobes import TwoSidedLobes

# Probability of uniform directions.
_UNIFORM = 0.1
_TINY = 1e-6


@dataclass
class LearnedProposal:
    """What directions of a footprint and a view are drawn from, in the frame of the face that is seen.

    Attributes:
        null: probability of null transmission.
        lobes: given no null transmission and no uniform part.
        further: probability of uniform directions on the view's side, e, given no null transmission.
        view: unit vector [3], z > 0.
    """

    null: Float
    lobes: TwoSidedLobes
    further: Float
    view: Vec3

    def density(self, light: Vec3) -> Float:
        """Density of `draw` per solid angle, without delta, 1/sr.

        Args:
            light: unit vector [3] in the frame of the face that is seen.
        """
        above, reflect = light.z > 0, self.lobes.reflect
        uniform = _UNIFORM * dr.select(above, reflect, 1 - reflect) + dr.select(above, self.further, 0)
        lobes = self.lobes.density([*light], [*self.view])
        return (1 - self.null) * ((1 - _UNIFORM - self.further) * lobes + uniform * (0.5 / pi))

    def draw(self, choice: Float, u: Vec2) -> tuple[Vec3, Mask]:
        """A light direction [3] in the frame of the face that is seen, and whether it is null transmission.

        Args:
            choice: uniform number in [0, 1) that chooses the part.
            u: uniform numbers in [0, 1).
        """
        types = array_types(self.view.x)
        is_null = types.Bool(choice < self.null)
        rest = (choice - self.null) * dr.rcp(maximum(1 - self.null, _TINY))
        of_lobes = 1 - _UNIFORM - self.further
        # The rest chooses a side of the uniform part; what is beyond both is e.
        beyond = rest - of_lobes
        below = (beyond >= _UNIFORM * self.lobes.reflect) & (beyond < _UNIFORM)
        uniform = uniform_on_sphere(u)
        height = dr.abs(uniform.z)
        uniform = types.Vector3(uniform.x, uniform.y, dr.select(below, -height, height))
        drawn = self.lobes.sample([*self.view], rest / of_lobes, [*u])
        light = dr.select(beyond < 0, dr.normalize(types.Vector3(*drawn)), uniform)
        return dr.select(is_null, -self.view, light), is_null
