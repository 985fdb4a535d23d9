"""The fibre layer over a group of points: closed forms of the layer of `scattering/fibre.py`.

D(h) depends on the fibre direction by x = h·t alone, and over a group x is close to uniform: yarns bend
evenly, and groups part a family without gaps. With mean m and deviation s that is [m − w, m + w], w = √3 s,
and the mean of D(x) = 1/(πα (1 + k x²)²), k = 1/α² − 1, over it is elementary:

    D̄ = 1/(2πα)·((1 − k x₀ x₁)/(q₀ q₁) + atan2(2w√k, 1 + k x₀ x₁)/(2w√k)),    q = 1 + k x²

Neighbouring groups join without a seam, which sums of wider SGGX lobes do not. σ² is linear in t tᵀ, so its
mean is exact; attenuation takes the group's mean normal, and is less in reflection by a share
of their spread.

The formulas serve Dr.Jit's arrays and machine code: `arrays` is `backend.DRJIT` or a `Code` that is being
written.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from loomlight.core.backend import DRJIT

# Narrower groups are as good as one fibre; the quotient below would lose its digits.
NARROWEST = 0.02
# √k of α = 1, where D is constant; keeps quotients finite.
SMALLEST_STEEPNESS = 1e-3
# Mean cosines are kept above this: a group that is seen at all holds normals that face the eye.
SMALLEST_COSINE = 0.02
# By how much attenuation in reflection is less, on average over a group, than that of its mean normal n̄: this
# times 1 − |n̄|² (a trial with points of silk, denim, wool and linen and random directions: 0.2 to 0.35). In
# transmission it is not.
LESS_BY_SPREAD = 0.35
# Shorter paths are as good as none; 1 − e^{−x} would lose its digits.
SMALLEST_PATH = 1e-3
# Of atan(x)/x in powers of x².
_ARC_TANGENT = (
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

    normal: Any
    tangent: Any
    xx: Any
    yy: Any
    zz: Any
    xy: Any
    xz: Any
    yz: Any
    roughness: Any

    def variance(self, direction: Any, arrays: Any = DRJIT) -> Any:
        """Variance of direction·t, ≥ 0."""
        x, y, z = direction.x, direction.y, direction.z
        # Products of the direction are the same for all groups.
        square = arrays.fma(self.xx, x * x, arrays.fma(self.yy, y * y, self.zz * (z * z)))
        mixed = arrays.fma(self.xy, x * y, arrays.fma(self.xz, x * z, self.yz * (y * z)))
        return arrays.maximum(arrays.fma(2, mixed, square), 0)


@dataclass
class _Interval:
    """[m − w, m + w] in units of 1/√k, as far as it goes without a division.

    Attributes:
        product: k x₀ x₁.
        quotient: q₀ q₁.
        span: 2 w √k.
        larger: of span and |1 + product|.
        scale: 1/(2πα).
    """

    product: Any
    quotient: Any
    span: Any
    larger: Any
    scale: Any


def _interval(half: Any, lobe: GroupLobe, arrays: Any) -> _Interval:
    roughness = lobe.roughness
    per_roughness = arrays.rcp(roughness)
    steepness = arrays.sqrt(arrays.maximum(1 - arrays.square(roughness), 0)) * per_roughness
    steepness = arrays.maximum(steepness, SMALLEST_STEEPNESS)
    narrowest = arrays.fma(roughness, NARROWEST, 1e-4)
    width = arrays.maximum(arrays.sqrt(3 * lobe.variance(half, arrays)), narrowest)
    mean = dot(half, lobe.tangent, arrays)
    first, last = steepness * (mean - width), steepness * (mean + width)
    product = first * last
    span = 2 * width * steepness
    return _Interval(
        product,
        arrays.fma(first, first, 1) * arrays.fma(last, last, 1),
        span,
        arrays.maximum(span, arrays.abs(1 + product)),
        (0.5 / math.pi) * per_roughness,
    )


def _mean_density(interval: _Interval, per_all: Any, arrays: Any) -> Any:
    """D̄ from the reciprocal of quotient · span · larger: one division for three."""
    base = 1 + interval.product
    span, larger = interval.span, interval.larger
    per_span = per_all * interval.quotient * larger
    ratio = arrays.minimum(span, arrays.abs(base)) * (per_all * interval.quotient * span)
    angle = _arc_tangent(ratio, arrays)
    angle = arrays.select(span > arrays.abs(base), 0.5 * math.pi - angle, angle)
    angle = arrays.select(base < 0, math.pi - angle, angle)
    return interval.scale * arrays.fma(1 - interval.product, per_all * span * larger, angle * per_span)


def _arc_tangent(ratio: Any, arrays: Any) -> Any:
    """atan of 0 to 1: a least-squares polynomial at Chebyshev nodes, off by 6e-7 at most."""
    square = arrays.square(ratio)
    value: Any = _ARC_TANGENT[-1]
    for coefficient in reversed(_ARC_TANGENT[:-1]):
        value = arrays.fma(value, square, coefficient)
    return ratio * value


def dot(first: Any, second: Any, arrays: Any = DRJIT) -> Any:
    """Scalar product of two vectors [3]."""
    return arrays.fma(first.x, second.x, arrays.fma(first.y, second.y, first.z * second.z))


def mean_density(half: Any, lobe: GroupLobe) -> Any:
    """D̄(h) over the group, 1/sr; `half` is a unit vector [3]."""
    interval = _interval(half, lobe, DRJIT)
    return _mean_density(interval, DRJIT.rcp(interval.quotient * interval.span * interval.larger), DRJIT)


def mean_area(direction: Any, lobe: GroupLobe, arrays: Any = DRJIT) -> Any:
    """Root of the mean σ² over the group: the fibres' projected area, α to 1."""
    mean = dot(direction, lobe.tangent, arrays)
    along = arrays.fma(mean, mean, lobe.variance(direction, arrays))
    squared = arrays.square(lobe.roughness)
    return arrays.sqrt(arrays.maximum(arrays.fma(squared - 1, along, 1), squared))


def layer_value(
    half: Any,
    light: Any,
    view: Any,
    beyond: Any,
    lobe: GroupLobe,
    optical_depth: Any,
    arrays: Any = DRJIT,
) -> Any:
    """f·cos of the group's fibre layer at albedo 1, without shadows: Float, 1/sr.

    Args:
        light, view: unit vectors [3] in the frame of the face seen; light.z < 0 where `beyond`.
        half: their half vector, unit [3].
        beyond: Bool, light comes from the other side.
    """
    cos_light = dot(light, lobe.normal, arrays)
    cos_light = arrays.maximum(arrays.select(beyond, -cos_light, cos_light), SMALLEST_COSINE)
    cos_view = arrays.maximum(dot(view, lobe.normal, arrays), SMALLEST_COSINE)
    area_light, area_view = mean_area(light, lobe, arrays), mean_area(view, lobe, arrays)
    # Divisions cost most here: reciprocals are taken of products, and multiplied back.
    per_cosines = arrays.rcp(cos_view * cos_light)
    per_view = per_cosines * cos_light
    slope_light, slope_view = area_light * per_cosines * cos_view, area_view * per_view
    # Reflection is (1 − e^{−x})/x·Tρ/cos_v with x = Tρ(Λ_l + Λ_v), transmission e^{−Tρ min(Λ_l, Λ_v)} times
    # the same with x = Tρ|Λ_l − Λ_v|: one form, so that both together take two exponentials.
    path = arrays.select(beyond, arrays.abs(slope_light - slope_view), slope_light + slope_view)
    depth = optical_depth * arrays.maximum(path, SMALLEST_PATH)
    passed = arrays.exp(-optical_depth * arrays.select(beyond, arrays.minimum(slope_light, slope_view), 0))
    interval = _interval(half, lobe, arrays)
    denominator = interval.quotient * interval.span * interval.larger
    # At most 1e18, where α = 0.01 and both directions graze.
    per_all = arrays.rcp(denominator * depth)
    attenuation = optical_depth * passed * (1 - arrays.exp(-depth)) * (per_all * denominator) * per_view
    spread = 1 - dot(lobe.normal, lobe.normal, arrays)
    less = arrays.select(beyond, 1, arrays.fma(-LESS_BY_SPREAD, spread, 1))
    return 0.25 * _mean_density(interval, per_all * depth, arrays) * (less * attenuation)
