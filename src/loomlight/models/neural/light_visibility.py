"""Light visibility of a footprint from its diffuse component, for the sheen: the network does not know it.

The diffuse term of a yarn point that light reaches is (1 − w) cos θ_l + w n_p·l, over π, that of others is 0.
The mean of n_p·l over the points of a footprint that the view sees and light reaches is close to

    (a + b cos θ_l) (1 + c sin θ_v cos Δφ)

with Δφ between the azimuths of light and view: lit points face the light, the more so the lower it is, and
views from its side see them better. The diffuse component over that is the fraction of the points. Constants
are fitted to slices by `tools/fits/light_visibility.py`.
"""

from __future__ import annotations

import drjit as dr

from loomlight.core.arrays import Float, Vec3
from loomlight.core.backend import maximum

# a, b, c.
FACING = 0.166, 0.597, 0.216
# Cosines of light and view with the cloth's normal are kept above this.
FACING_MIN_COSINE = 1e-3


def light_visibility_of(diffuse: Float, light: Vec3, view: Vec3, blend: float) -> Float:
    """Fraction of view rays that meet yarn which the light reaches; ≥ 0, about 1 at most.

    Args:
        diffuse: mean diffuse component of both families over the footprint, 1/sr.
        light, view: unit vectors [3].
        blend: w, the weight of the yarn normal in the diffuse term, 0 to 1.
    """
    constant, by_cosine, by_azimuth = FACING
    cos_light = maximum(dr.abs(light.z), FACING_MIN_COSINE)
    # sin θ_v cos Δφ; a light along the normal has no azimuth.
    together = dr.fma(light.x, view.x, light.y * view.y)
    together *= dr.rsqrt(maximum(dr.fma(light.x, light.x, light.y * light.y), 1e-6))
    facing = dr.fma(by_cosine, cos_light, constant) * dr.fma(by_azimuth, together, 1)
    return dr.pi * maximum(diffuse, 0) * dr.rcp(dr.lerp(cos_light, facing, blend))
