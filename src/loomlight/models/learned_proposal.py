"""Directions that a small network describes, for both sides of a surface, and their exact density.

A network describes two mixtures of lobes (`scattering/lobe_mixture.py`), q towards the view's side and q'
towards the other side, mirrored, and the probability s of the first. The density of a light l is

    (1 − d − e) [s q(l) + (1 − s) q'(l mirrored)] + d s/2π + e p(l)    on the view's side, and
    (1 − d − e) [s q(l) + (1 − s) q'(l mirrored)] + d (1 − s)/2π       on the other one.

The uniform part d bounds weights, and p is the lobe of a sheen. All of it is given that light does not pass
straight through.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import drjit as dr

from loomlight.core.arrays import Float, Mask, Vec2, Vec3
from loomlight.core.backend import array_types, maximum
from loomlight.scattering.directions import uniform_on_sphere
from loomlight.scattering.lobe_mixture import TwoSidedLobes
from loomlight.scattering.sheen import sample_sheen, sheen_pdf

# Probability of uniform directions.
_UNIFORM = 0.1
_TINY = 1e-6


@dataclass
class LearnedProposal:
    """Density of directions of a footprint and a view, in the frame of the face that is seen.

    Attributes:
        null: probability of null transmission.
        lobes: given no null transmission and no uniform part.
        view: unit vector [3], z > 0.
        sheen: probability e of the sheen's lobe, given no null transmission, and its roughness; None draws
            none.
    """

    null: Float
    lobes: TwoSidedLobes
    view: Vec3
    sheen: tuple[Float, float] | None = None

    @property
    def _of_sheen(self) -> Float:
        return 0.0 if self.sheen is None else self.sheen[0]

    def density(self, light: Vec3) -> Float:
        """Density of `draw` per solid angle, without delta, 1/sr.

        Args:
            light: unit vector [3] in the frame of the face that is seen.
        """
        above, reflect = light.z > 0, self.lobes.reflect
        density = _UNIFORM * (0.5 / pi) * dr.select(above, reflect, 1 - reflect)
        density += (1 - _UNIFORM - self._of_sheen) * self.lobes.density([*light], [*self.view])
        if self.sheen is not None:
            share, roughness = self.sheen
            density += dr.select(above, share * sheen_pdf(light, self.view, roughness), 0)
        return (1 - self.null) * density

    def draw(self, choice: Float, u: Vec2) -> tuple[Vec3, Mask]:
        """A light direction [3] in the frame of the face that is seen, and whether it is null transmission.

        Args:
            choice: uniform number in [0, 1) that chooses the part.
            u: uniform numbers in [0, 1).
        """
        types = array_types(self.view.x)
        is_null = types.Bool(choice < self.null)
        rest = (choice - self.null) * dr.rcp(maximum(1 - self.null, _TINY))
        of_lobes = 1 - _UNIFORM - self._of_sheen
        # The rest chooses a side of the uniform part; what is beyond both is the sheen's.
        beyond = rest - of_lobes
        below = (beyond >= _UNIFORM * self.lobes.reflect) & (beyond < _UNIFORM)
        uniform = uniform_on_sphere(u)
        height = dr.abs(uniform.z)
        uniform = types.Vector3(uniform.x, uniform.y, dr.select(below, -height, height))
        drawn = self.lobes.sample([*self.view], rest / of_lobes, [*u])
        light = dr.select(beyond < 0, dr.normalize(types.Vector3(*drawn)), uniform)
        if self.sheen is not None:
            light = dr.select(beyond < _UNIFORM, light, sample_sheen(self.view, self.sheen[1], u))
        return dr.select(is_null, -self.view, light), is_null
