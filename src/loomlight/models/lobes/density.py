"""The fibre layer over a group of points: closed forms of the layer of `scattering/fibre.py`.

D(h) depends on the fibre direction by x = h·t alone, and over a group x is close to uniform: yarns bend
evenly, and groups partition a family without gaps. With mean m and standard deviation s that is the interval
[m − w, m + w], w = √3 s, and the mean of D(x) = 1/(πα (1 + k x²)²), k = 1/α² − 1, over it is elementary:

    D̄ = 1/(2πα)·((1 − k x₀ x₁)/(q₀ q₁) + atan2(2w√k, 1 + k x₀ x₁)/(2w√k)),    q = 1 + k x²

Neighbouring groups join without a seam, which sums of wider SGGX lobes do not. σ² is linear in t tᵀ, so its
mean is exact. Attenuation uses the group's mean normal, and in reflection a factor for the spread of normals.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import drjit as dr

from loomlight.core.arrays import Float, Mask, Vec3
from loomlight.core.backend import maximum, minimum

# Smallest half-width w in units of α: narrower groups act as one fibre, and the quotient below would cancel.
NARROWEST = 0.02
# √k of α = 1, where D is constant; keeps quotients finite.
MIN_STEEPNESS = 1e-3
# Lower bound of mean cosines: a group that is visible has normals that face the view.
MIN_COSINE = 0.02
# Attenuation in reflection, averaged over a group, is that of its mean normal n̄ times 1 − SPREAD_LOSS·(1 −
# |n̄|²) (points of silk, denim, wool and linen in random directions: 0.2 to 0.35). In transmission the factor
# is 1.
SPREAD_LOSS = 0.35
# Shortest path x: below it, 1 − e^{−x} would cancel.
MIN_PATH = 1e-3
# Coefficients of atan(x)/x in powers of x².
ARC_TANGENT = (
    0.999999715,
    -0.33327976,
    0.198950258,
    -0.135376751,
    0.0847596977,
    -0.0377517076,
    0.00809729493,
)


@dataclass
class GroupLobe:
    """Moments of one group.

    Attributes:
        normal, tangent: means over the group [3], shorter than 1.
        xx, yy, zz, xy, xz, yz: covariance of the fibre direction.
        roughness: α of its family.
    """

    normal: Vec3
    tangent: Vec3
    xx: Float
    yy: Float
    zz: Float
    xy: Float
    xz: Float
    yz: Float
    roughness: Float

    def variance(self, direction: Vec3) -> Float:
        """Variance of direction·t, ≥ 0."""
        x, y, z = direction.x, direction.y, direction.z
        # Products of the direction are the same for all groups.
        square = dr.fma(self.xx, x * x, dr.fma(self.yy, y * y, self.zz * (z * z)))
        mixed = dr.fma(self.xy, x * y, dr.fma(self.xz, x * z, self.yz * (y * z)))
        return maximum(dr.fma(2, mixed, square), 0)


@dataclass
class _Interval:
    """[m − w, m + w] in units of 1/√k: the terms of D̄ that need no division.

    Attributes:
        product: k x₀ x₁.
        quotient: q₀ q₁.
        span: 2 w √k.
        larger: of span and |1 + product|.
        scale: 1/(2πα).
    """

    product: Float
    quotient: Float
    span: Float
    larger: Float
    scale: Float

    @property
    def denominator(self) -> Float:
        """The common denominator of D̄."""
        return self.quotient * self.span * self.larger


def _interval(half: Vec3, lobe: GroupLobe) -> _Interval:
    roughness = lobe.roughness
    per_roughness = dr.rcp(roughness)
    steepness = dr.sqrt(maximum(1 - dr.square(roughness), 0)) * per_roughness
    steepness = maximum(steepness, MIN_STEEPNESS)
    narrowest = dr.fma(roughness, NARROWEST, 1e-4)
    width = maximum(dr.sqrt(3 * lobe.variance(half)), narrowest)
    mean = dr.dot(half, lobe.tangent)
    first, last = steepness * (mean - width), steepness * (mean + width)
    product = first * last
    span = 2 * width * steepness
    return _Interval(
        product,
        dr.fma(first, first, 1) * dr.fma(last, last, 1),
        span,
        maximum(span, dr.abs(1 + product)),
        (0.5 / math.pi) * per_roughness,
    )


def _mean_density(interval: _Interval, reciprocal: Float) -> Float:
    """D̄ from the reciprocal of `denominator`: one division for three."""
    base = 1 + interval.product
    span, larger = interval.span, interval.larger
    per_span = reciprocal * interval.quotient * larger
    ratio = minimum(span, dr.abs(base)) * (reciprocal * interval.quotient * span)
    angle = _arc_tangent(ratio)
    angle = dr.select(span > dr.abs(base), 0.5 * math.pi - angle, angle)
    angle = dr.select(base < 0, math.pi - angle, angle)
    return interval.scale * dr.fma(1 - interval.product, reciprocal * span * larger, angle * per_span)


def _arc_tangent(ratio: Float) -> Float:
    """atan of 0 to 1: a least-squares polynomial at Chebyshev nodes, off by 6e-7 at most."""
    square = dr.square(ratio)
    value: Float = ARC_TANGENT[-1]
    for coefficient in reversed(ARC_TANGENT[:-1]):
        value = dr.fma(value, square, coefficient)
    return ratio * value


def mean_density(half: Vec3, lobe: GroupLobe) -> Float:
    """D̄(h) over the group, 1/sr; `half` is a unit vector [3]."""
    interval = _interval(half, lobe)
    return _mean_density(interval, dr.rcp(interval.denominator))


def mean_area(direction: Vec3, lobe: GroupLobe) -> Float:
    """Root of the mean σ² over the group: the fibres' projected area, α to 1."""
    mean = dr.dot(direction, lobe.tangent)
    along = dr.fma(mean, mean, lobe.variance(direction))
    squared = dr.square(lobe.roughness)
    return dr.sqrt(maximum(dr.fma(squared - 1, along, 1), squared))


def layer_value(
    half: Vec3, light: Vec3, view: Vec3, is_transmission: Mask, lobe: GroupLobe, optical_depth: Float
) -> Float:
    """f·cos of the group's fibre layer at albedo 1, without shadows, 1/sr.

    Args:
        half: unit half vector [3] of light and view.
        light, view: unit vectors [3] in the frame of the face seen; light.z < 0 in transmission.
        is_transmission: light comes from the other side.
    """
    cos_light = dr.dot(light, lobe.normal)
    cos_light = maximum(dr.select(is_transmission, -cos_light, cos_light), MIN_COSINE)
    cos_view = maximum(dr.dot(view, lobe.normal), MIN_COSINE)
    area_light, area_view = mean_area(light, lobe), mean_area(view, lobe)
    # Divisions cost most here: reciprocals are taken of products, and multiplied back.
    per_cosines = dr.rcp(cos_view * cos_light)
    per_view = per_cosines * cos_light
    slope_light, slope_view = area_light * per_cosines * cos_view, area_view * per_view
    # Reflection is (1 − e^{−x})/x·Tρ/cos_v with x = Tρ(Λ_l + Λ_v), transmission e^{−Tρ min(Λ_l, Λ_v)} times
    # the same with x = Tρ|Λ_l − Λ_v|: one form, so that both together take two exponentials.
    path = dr.select(is_transmission, dr.abs(slope_light - slope_view), slope_light + slope_view)
    depth = optical_depth * maximum(path, MIN_PATH)
    unscattered = dr.exp(-optical_depth * dr.select(is_transmission, minimum(slope_light, slope_view), 0))
    interval = _interval(half, lobe)
    denominator = interval.denominator
    # At most 1e18, where α = 0.01 and both directions graze.
    reciprocal = dr.rcp(denominator * depth)
    attenuation = optical_depth * unscattered * (1 - dr.exp(-depth)) * (reciprocal * denominator) * per_view
    spread = 1 - dr.squared_norm(lobe.normal)
    spread_factor = dr.select(is_transmission, 1, dr.fma(-SPREAD_LOSS, spread, 1))
    return 0.25 * _mean_density(interval, reciprocal * depth) * (spread_factor * attenuation)
