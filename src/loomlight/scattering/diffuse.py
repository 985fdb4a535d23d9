"""Blended diffuse: light scattered many times inside a yarn, between the yarn's normal and the cloth's.

The macro normal n_s is (0, 0, 1) and decides the side; `normal` is the yarn's n_p; `blend` is w, 0 to 1.
Values are free of the albedo and hold the light's cosine: chen2024 eq. 1 times ⟨light·n_s⟩. The far side
is the same in −light.
"""

from __future__ import annotations

import drjit as dr

from loomlight.core.arrays import Float, Vec2, Vec3
from loomlight.core.backend import array_types, maximum, minimum
from loomlight.scattering.directions import cosine_about


def diffuse_reflection(light: Vec3, normal: Vec3, blend: Float) -> Float:
    """(w⟨light·n_p⟩ + (1 − w)⟨light·n_s⟩)/π for light above the cloth, else 0; Float, 1/sr."""
    return dr.select(light.z > 0, diffuse_pdf(light, normal, blend), 0)


def diffuse_transmission(light: Vec3, normal: Vec3, blend: Float) -> Float:
    """The same for light below the cloth, with the cosines to −n_p and −n_s; Float, 1/sr."""
    return diffuse_reflection(-light, normal, blend)


def sample_diffuse(normal: Vec3, blend: Float, u: Vec2) -> Vec3:
    """A light direction for reflection; the negated one serves for transmission.

    Cosine-weighted about n_p in a share w of the cases, else about n_s. Some directions of the first kind
    lie below the cloth and reflect nothing: the density counts them and their weight is zero.

    Args:
        u: Vector2 of uniform numbers in [0, 1).
    """
    types = array_types(u)
    about_yarn = u.x < blend
    # The number that chose is stretched back to [0, 1) and used again.
    start = dr.select(about_yarn, 0, blend)
    width = dr.select(about_yarn, blend, 1 - blend)
    stretched = minimum((u.x - start) / maximum(width, 1e-7), dr.one_minus_epsilon(types.Float))
    axis = dr.select(about_yarn, normal, types.Vector3(0, 0, 1))
    return cosine_about(axis, types.Vector2(stretched, u.y))


def diffuse_pdf(light: Vec3, normal: Vec3, blend: Float) -> Float:
    """Density of `sample_diffuse`, 1/sr: both cosines clamped at zero, blended, over π."""
    about_yarn = maximum(dr.dot(light, normal), 0)
    about_cloth = maximum(light.z, 0)
    return dr.inv_pi * dr.lerp(about_cloth, about_yarn, blend)
