"""Sheen: light scattered several times by fly-away fibres that stand on the cloth (zhu2024 3.3).

The lobe is a linearly transformed cosine (Zeltner, Burley and Chiang 2022) with M⁻¹ = [[a, 0, b], [0, a, 0],
[0, 0, 1]] in the frame about n_s = (0, 0, 1) where the view has azimuth 0. Its a, b and reflectance R come
from a closed form of the sheen roughness and cos θ_view, fitted by `tools/fits/sheen.py`. Strength C and
roughness lie in 0 to 1. Light and view are both above the cloth, else the lobe is zero.
"""

from __future__ import annotations

from collections.abc import Sequence

import drjit as dr

from loomlight.core.arrays import Float, Vec2, Vec3
from loomlight.core.backend import array_types, clip, maximum
from loomlight.scattering.directions import MIN_SQUARED_LENGTH, cosine_about
from loomlight.scattering.sheen_coefficients import CEILING, REFLECTANCE, SCALE, SHEAR

# The published tables hold 0.01 in the place of 0 on both axes; roots of 0 would have no derivative.
MIN = 0.01
# A wider lobe than any the tables hold; keeps a² and 1/a finite.
MIN_SCALE = 0.01
# The tables' b lies between −0.18 and 0; here too where they say nothing.
MAX_SHEAR = -0.25


def _powers(base: Float, largest: int) -> list[Float]:
    powers = [base]
    while len(powers) < largest:
        powers.append(powers[-1] * base)
    return powers


def _polynomial(coefficients: Sequence[Sequence[float]], x: Float, y_powers: Sequence[Float]) -> Float:
    """Horner in x of polynomials in y: the latter cost nothing where the roughness is one literal."""
    value: Float = 0
    for row in reversed(coefficients):
        term: Float = row[0]
        for coefficient, power in zip(row[1:], y_powers, strict=False):
            term = dr.fma(coefficient, power, term)
        value = dr.fma(value, x, term)
    return value


def sheen_lobe(cos_view: Float, roughness: Float) -> tuple[Float, Float, Float]:
    """(a, b, R) of the lobe: a in 0.01 to 1, b in −0.25 to 0, R in 0 to 0.8; Floats."""
    types = array_types(cos_view)
    cos_view = clip(cos_view, MIN, 1)
    x = dr.fma(2, dr.sqrt(cos_view), -1)
    y = dr.fma(3, dr.sqrt(dr.sqrt(clip(types.Float(roughness), MIN, 1))), -2)
    y_powers = _powers(y, 5)
    scale = clip(_polynomial(SCALE, x, y_powers), MIN_SCALE, 1)
    shear = clip((1 - cos_view) * _polynomial(SHEAR, x, y_powers), MAX_SHEAR, 0)
    # Beyond ±60 the logistic is 0 or 1 in float32, and e^60 is still finite.
    exponent = clip(-_polynomial(REFLECTANCE, x, y_powers), -60, 60)
    return scale, shear, CEILING * dr.rcp(1 + dr.exp(exponent))


def _azimuth(view: Vec3) -> tuple[Float, Float]:
    """cos and sin of the view's azimuth; (1, 0) where it has none."""
    squared = dr.fma(view.x, view.x, view.y * view.y)
    has_azimuth = squared > MIN_SQUARED_LENGTH
    inverse = dr.rsqrt(dr.select(has_azimuth, squared, 1))
    return dr.select(has_azimuth, view.x * inverse, 1), dr.select(has_azimuth, view.y * inverse, 0)


def _transformed_cosine(light: Vec3, view: Vec3, scale: Float, shear: Float) -> Float:
    """Density of the lobe, 1/sr: a² cos_light/(π ‖M⁻¹ light‖⁴), zero below the cloth."""
    cos_azimuth, sin_azimuth = _azimuth(view)
    towards = dr.fma(light.x, cos_azimuth, light.y * sin_azimuth)
    across = dr.fma(light.y, cos_azimuth, -light.x * sin_azimuth)
    x = dr.fma(scale, towards, shear * light.z)
    y = scale * across
    squared = dr.fma(x, x, dr.fma(y, y, light.z * light.z))
    value = dr.inv_pi * scale * scale * light.z * dr.rcp(maximum(squared * squared, 1e-20))
    return dr.select((light.z > 0) & (view.z > 0), value, 0)


def sheen(light: Vec3, view: Vec3, strength: Float, roughness: Float) -> Float:
    """f·cos_light of the sheen: C R times its density; Float, 1/sr."""
    scale, shear, reflectance = sheen_lobe(view.z, roughness)
    return strength * reflectance * _transformed_cosine(light, view, scale, shear)


def sheen_transmittance(view: Vec3, strength: Float, roughness: Float) -> Float:
    """1 − C R(view), what is left for the cloth below; 0.2 to 1 (Float)."""
    return 1 - strength * sheen_lobe(view.z, roughness)[2]


def sheen_with_transmittance(
    light: Vec3, view: Vec3, strength: Float, roughness: Float
) -> tuple[Float, Float]:
    """`sheen` and `sheen_transmittance` at the cost of one."""
    scale, shear, reflectance = sheen_lobe(view.z, roughness)
    weight = strength * reflectance
    return weight * _transformed_cosine(light, view, scale, shear), 1 - weight


def sample_sheen(view: Vec3, roughness: Float, u: Vec2) -> Vec3:
    """A light direction with exactly the density of the lobe; above the cloth but for rounding.

    Args:
        u: Vector2 of uniform numbers in [0, 1).
    """
    types = array_types(view)
    scale, shear, _ = sheen_lobe(view.z, roughness)
    cosine = cosine_about(types.Vector3(0, 0, 1), u)
    # M c, times a: only the direction matters.
    towards = dr.fma(-shear, cosine.z, cosine.x)
    across = cosine.y
    up = scale * cosine.z
    inverse = dr.rsqrt(maximum(dr.fma(towards, towards, dr.fma(across, across, up * up)), MIN_SQUARED_LENGTH))
    cos_azimuth, sin_azimuth = _azimuth(view)
    x = dr.fma(towards, cos_azimuth, -across * sin_azimuth)
    y = dr.fma(towards, sin_azimuth, across * cos_azimuth)
    return types.Vector3(x * inverse, y * inverse, up * inverse)


def sheen_pdf(light: Vec3, view: Vec3, roughness: Float) -> Float:
    """Density of `sample_sheen`, 1/sr."""
    scale, shear, _ = sheen_lobe(view.z, roughness)
    return _transformed_cosine(light, view, scale, shear)
