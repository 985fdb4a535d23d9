"""The rise of highlights towards grazing: fibres reflect little from above and nearly all at grazing.

The albedo of every highlight in reflection gains g (1 − o·h)⁵, white (Schlick 1994), h being the half vector
of light and view and g a number of the cloth. No normal enters, so that a whole footprint has one factor, and
every model the same. What is reflected does not enter the yarn: diffuse light, and that between yarns, loses
a share q(α) g (1 − |cos θ|)⁴ for the view and for the light, so that values stay reciprocal where they were.

q bounds what a layer of fibres reflects of the rise, over (1 − cos θ)⁴, of tangents in the plane of the cloth
and views to 85°, at Tρ = 2.
"""

from __future__ import annotations

from dataclasses import dataclass

import drjit as dr

from loomlight.core.arrays import Float, Vec3
from loomlight.core.backend import clip, maximum

# q = RISE_LOSS[0] (1 − α)³ + RISE_LOSS[1].
RISE_LOSS = (0.25, 0.04)
# Squared cosines of half vectors stay above this: the root has a derivative where light = −view.
MIN_SQUARED_HALF = 1e-8


@dataclass(frozen=True)
class Grazing:
    """How highlights of one cloth rise.

    Attributes:
        gain: g, what their albedos gain at grazing, 0 to 4; 0 is no rise.
        loss: q g, what diffuse light loses at grazing, 0 to 1; a number or a Dr.Jit scalar.
    """

    gain: float = 0.0
    loss: float | Float = 0.0

    @classmethod
    def of(cls, gain: float, roughness: float) -> Grazing:
        """Of cloth whose fibres have the roughness α."""
        share = RISE_LOSS[0] * (1 - roughness) ** 3 + RISE_LOSS[1]
        return cls(gain, min(share * gain, 1.0))

    def rise(self, light: Vec3, view: Vec3) -> Float:
        """What albedos of highlights gain for unit vectors [3] on one side: 0 to g."""
        squared = dr.fma(0.5, dr.dot(light, view), 0.5)
        return self.gain * _fifth_power(1 - dr.sqrt(clip(squared, MIN_SQUARED_HALF, 1)))

    def rise_towards(self, view: Vec3) -> Float:
        """The rise in the mirror's direction of the cloth, for choosing a lobe."""
        return self.gain * _fifth_power(1 - abs(view.z))

    def kept(self, light: Vec3, view: Vec3) -> Float:
        """Share of the diffuse light that is left for unit vectors [3] in the frame of the cloth, 0 to 1."""
        of_light, of_view = (dr.square(dr.square(maximum(1 - abs(each.z), 0))) for each in (light, view))
        return dr.fma(-self.loss, of_light, 1) * dr.fma(-self.loss, of_view, 1)


NO_RISE = Grazing()


def _fifth_power(value: Float) -> Float:
    squared = value * value
    return squared * squared * value
