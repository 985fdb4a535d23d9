"""One layer of fibres: microflakes with the fibre-like SGGX distribution, scattering once.

Fibres run along the unit vector `tangent` t and have roughness α: S = I − (1 − α²) t tᵀ (chen2024 eq. 2,
with the axes of its S turned to t). `normal` is the yarn's, and all cosines here are with it. Values are
free of the albedo and hold the light's cosine. Directions and `normal` are Vector3 of unit length,
`roughness` is 0.01 to 1, `optical_depth` is Tρ > 0; each may belong to any Dr.Jit backend.
"""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Vec2, Vec3
from loomlight.core.backend import maximum, minimum
from loomlight.scattering.albedo import LayerBound
from loomlight.scattering.directions import MIN_SQUARED_LENGTH, uniform_on_sphere

# Cosines are kept above this before something is divided by them. Optical depths then reach 1e6 and their
# exponentials vanish, while every product stays far from the limits of float32.
MIN_COSINE = 1e-6
# Shorter sums light + view are rounding (each component carries 6e-8), not a half vector.
MIN_SQUARED_SUM = 1e-12
# Shares of the light that turn back and go through: at α = 0, and what α adds; least squares over random
# views and tangents at Tρ = 2.
SHARE_TURNED = (0.57, -0.17)
SHARE_THROUGH = (0.27, 0.045)
# Mean shares over cosine-weighted views of a layer whose fibres lie in its plane, back and through:
# least squares over α of 0.05 to 1 and Tρ of 0.1 to 10, largest errors 0.014 and 0.006.
MEAN_TURNED = (0.297, -0.086, -3.12)
MEAN_THROUGH = (0.579, 0.310, -2.014, 0.786)
# Optical depth per Tρ of a light direction that stands for all of them: 1/cos 45°.
TYPICAL_DEPTH = 1.4


def projected_area(direction: Vec3, tangent: Vec3, roughness: Float) -> Float:
    """σ(ω): area of the fibres seen from `direction`, per volume and density; α to 1 (chen2024 eq. 2)."""
    along = dr.dot(direction, tangent)
    # Not below α² but for rounding, so the root and its derivative stay finite.
    squared = dr.fma((roughness + 1) * (roughness - 1), along * along, 1)
    return dr.sqrt(maximum(squared, roughness * roughness))


def density(half: Vec3, tangent: Vec3, roughness: Float) -> Float:
    """D(h): density of fibre normals in direction `half`, 1/sr, both signs of h alike (chen2024 eq. 2)."""
    along = dr.dot(half, tangent)
    return _density(along * along, roughness)


def _density(squared_along: Float, roughness: Float) -> Float:
    """D of the squared cosine between half vector and tangent.

    With q = p/α², p = α² + (h·t)²(1 − α²): α³/(π p²) never forms the large 1/α² of q.
    """
    squared_roughness = roughness * roughness
    p = dr.fma(squared_along, 1 - squared_roughness, squared_roughness)
    return dr.inv_pi * squared_roughness * roughness * dr.rcp(p * p)


def _density_between(light: Vec3, view: Vec3, tangent: Vec3, roughness: Float) -> Float:
    """D at the half vector of two directions, from light + view without normalising it.

    Where light = −view the half vector is 0/0 and its limit depends on the approach; there it is taken to
    be perpendicular to the fibre, which gives the largest of the limits, 1/(πα), and a zero derivative.
    """
    total = light + view
    along = dr.dot(total, tangent)
    squared_along = along * along * dr.rcp(maximum(dr.squared_norm(total), MIN_SQUARED_SUM))
    # (h·t)² ≤ 1 but for rounding.
    return _density(minimum(squared_along, 1), roughness)


def _mean_attenuation(depth: Float) -> Float:
    """(1 − e^{−x})/x, the mean of e^{−s} over 0 < s < x, for x ≥ 0.

    The series takes over below 0.1, where the difference would lose digits; there it is off by 1e-8.
    """
    series = dr.fma(depth, dr.fma(depth, dr.fma(depth, dr.fma(depth, 1 / 120, -1 / 24), 1 / 6), -0.5), 1)
    large = maximum(depth, 0.1)
    return dr.select(depth < 0.1, series, (1 - dr.exp(-large)) * dr.rcp(large))


def reflection(
    light: Vec3, view: Vec3, normal: Vec3, tangent: Vec3, roughness: Float, optical_depth: Float
) -> Float:
    """Light scattered once and back out of the layer: f·cos_light at albedo 1, 1/sr (chen2024 eq. 1–2).

    D G_r/(4 cos_view), in the form −expm1(−Tρ(Λ_i + Λ_o))/(σ_i cos_o + σ_o cos_i) that has no pole at
    grazing angles. Zero unless light and view are both on the side of `normal`.
    """
    cos_light, cos_view = dr.dot(light, normal), dr.dot(view, normal)
    visible = (cos_light > 0) & (cos_view > 0)
    cos_light = maximum(cos_light, MIN_COSINE)
    cos_view = maximum(cos_view, MIN_COSINE)
    area_light = projected_area(light, tangent, roughness)
    area_view = projected_area(view, tangent, roughness)
    crossed = dr.fma(area_light, cos_view, area_view * cos_light)
    depth = optical_depth * crossed * dr.rcp(cos_light * cos_view)
    scattered = depth * _mean_attenuation(depth)
    value = 0.25 * _density_between(light, view, tangent, roughness) * scattered * cos_light * dr.rcp(crossed)
    return dr.select(visible, value, 0)


def transmission(
    light: Vec3, view: Vec3, normal: Vec3, tangent: Vec3, roughness: Float, optical_depth: Float
) -> Float:
    """Light scattered once and out on the other side: f·cos_light at albedo 1, 1/sr (Wang et al. 2022).

    D G_t/(4 cos_view) with G_t = e^{−Tρ min(Λ_i, Λ_o)} (1 − e^{−Tρ|Δ|})/|Δ|, Δ = Λ_i − Λ_o. Zero unless
    view is on the side of `normal` and light on the other; cos_light = −light·normal.
    """
    cos_light, cos_view = -dr.dot(light, normal), dr.dot(view, normal)
    visible = (cos_light > 0) & (cos_view > 0)
    per_cos_view = dr.rcp(maximum(cos_view, MIN_COSINE))
    slope_light = projected_area(light, tangent, roughness) * dr.rcp(maximum(cos_light, MIN_COSINE))
    slope_view = projected_area(view, tangent, roughness) * per_cos_view
    passed = dr.exp(-optical_depth * minimum(slope_light, slope_view))
    mean = _mean_attenuation(optical_depth * abs(slope_light - slope_view))
    lengths = 0.25 * optical_depth * passed * mean * per_cos_view
    return dr.select(visible, _density_between(light, view, tangent, roughness) * lengths, 0)


def layer_albedo_estimate(
    view: Vec3, normal: Vec3, tangent: Vec3, roughness: Float, optical_depth: Float
) -> tuple[Float, Float]:
    """Rough directional albedos of the layer in reflection and in transmission, for choosing a lobe.

    Every light direction is given the depth of one at 45°, and each side its mean share. Averaged over views
    they are within a quarter of the truth. Both are positive wherever their lobe is.
    """
    cos_view = maximum(abs(dr.dot(view, normal)), MIN_COSINE)
    slope = projected_area(view, tangent, roughness) * dr.rcp(cos_view)
    turned = slope * dr.rcp(slope + TYPICAL_DEPTH) * (1 - dr.exp(-optical_depth * (slope + TYPICAL_DEPTH)))
    passed = dr.exp(-optical_depth * minimum(slope, TYPICAL_DEPTH))
    through = optical_depth * slope * passed * _mean_attenuation(optical_depth * abs(slope - TYPICAL_DEPTH))
    return (
        dr.fma(SHARE_TURNED[1], roughness, SHARE_TURNED[0]) * turned,
        dr.fma(SHARE_THROUGH[1], roughness, SHARE_THROUGH[0]) * through,
    )


def mean_layer_shares(roughness: Float, optical_depth: Float) -> tuple[Float, Float]:
    """Shares of diffuse light that a layer of albedo 1 scatters back and through: Floats, 0 to 0.3.

    Light that meets no fibre is in neither.
    """
    turned = dr.fma(MEAN_TURNED[1], roughness, MEAN_TURNED[0])
    through = dr.fma(MEAN_THROUGH[1], roughness, MEAN_THROUGH[0])
    # Tρ to a power: it is positive.
    depth = dr.exp(MEAN_THROUGH[3] * dr.log(optical_depth))
    return (
        turned * (1 - dr.exp(MEAN_TURNED[2] * optical_depth)),
        through * optical_depth * dr.exp(MEAN_THROUGH[2] * depth),
    )


def sample_specular(view: Vec3, tangent: Vec3, roughness: Float, u: Vec2) -> Vec3:
    """A light direction by reflection off a fibre normal visible from `view`: the whole sphere, both lobes.

    Visible normals of an ellipsoid (Heitz et al. 2015): with M = I − (1 − α) t tᵀ, so M M = S, the sphere
    that M stretches is seen along M view, its visible points p have a cosine density, and h ∝ M p. No frame
    is built: M only scales along t.

    Args:
        u: Vector2 of uniform numbers in [0, 1).
    """
    squeeze = 1 - roughness
    seen = dr.fma(-squeeze * dr.dot(view, tangent), tangent, view)
    axis = seen * dr.rsqrt(maximum(dr.squared_norm(seen), MIN_SQUARED_LENGTH))
    point = axis + uniform_on_sphere(u)
    half = dr.fma(-squeeze * dr.dot(point, tangent), tangent, point)
    # h is normalised within the reflection: light = 2 (view·h) h/|h|² − view.
    scale = 2 * dr.dot(view, half) * dr.rcp(maximum(dr.squared_norm(half), MIN_SQUARED_LENGTH))
    light = dr.fma(scale, half, -view)
    return light * dr.rsqrt(maximum(dr.squared_norm(light), MIN_SQUARED_LENGTH))


def pdf_specular(light: Vec3, view: Vec3, tangent: Vec3, roughness: Float) -> Float:
    """Density of `sample_specular` over the whole sphere, 1/sr: D(h)/(4 σ(view)) (Heitz et al. 2015)."""
    area = projected_area(view, tangent, roughness)
    return 0.25 * _density_between(light, view, tangent, roughness) * dr.rcp(area)


# ----------------------------------------------------------------------------------- the bound of whole cloth
# The energy bound of albedos: what fibre layers of whole cloth return with light between the yarns.
#
# White yarn of diffuse albedos k_d and a layer of albedos k_s returns to a view v of cloth, by eq. 1 and 2
# of `interreflection.py` with L = 1,
#
#     k_d + k_s (F(v) + (1 − D(v)) F̄),
#
# F(v) being the mean of the layer where v meets yarn, under the sky that this yarn sees, and F̄ the layer's
# mean for diffuse light (`mean_layer_shares`). Yarns lean to all sides, so the bracket hardly depends
# on the view: it is 0.8 to 1 of F̄ from above, and at most m(α, Tρ) of it up to 75° from the normal, on 70
# random cloths of all parameter ranges. Thin layers, of α near 1 above all, are brightest at grazing
# angles.


# m = DEEP_MARGIN[0] + DEEP_MARGIN[1] α + (THIN_MARGIN[0] + THIN_MARGIN[1] α) e^{−MARGIN_FADE Tρ}.
DEEP_MARGIN, THIN_MARGIN, MARGIN_FADE = (1.15, 0.05), (0.6, 1.0), 2.0


def cloth_layer_bound(roughness: float, optical_depth: float) -> LayerBound:
    """The bound for layers of roughness α and depth Tρ in cloth with light between its yarns."""
    thin = math.exp(-MARGIN_FADE * optical_depth)
    margin = (
        DEEP_MARGIN[0] + DEEP_MARGIN[1] * roughness + (THIN_MARGIN[0] + THIN_MARGIN[1] * roughness) * thin
    )
    shares = [margin * float(share) for share in mean_layer_shares(roughness, optical_depth)]
    return LayerBound(max(shares), min(shares))


def bound_in_use(bound: LayerBound, reflect: NDArray[np.float64], transmit: NDArray[np.float64]) -> float:
    """The bound as a factor of the larger of a thread's two highlights [n, 3], the largest over threads."""
    larger = np.maximum(reflect, transmit)
    # Where there is no highlight any factor serves.
    return float((bound.taken(reflect, transmit) / np.maximum(larger, 1e-9)).max(initial=bound.larger))
