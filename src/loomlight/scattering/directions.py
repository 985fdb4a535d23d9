"""Directions on the sphere from two uniform numbers."""

from __future__ import annotations

import drjit as dr

from loomlight.core.arrays import Vec2, Vec3
from loomlight.core.backend import array_types, maximum

# Below this squared length a vector has no direction left in float32; dividing by it must stay finite.
MIN_SQUARED_LENGTH = 1e-20


def uniform_on_sphere(u: Vec2) -> Vec3:
    """A direction uniform on the sphere.

    Args:
        u: Vector2 of uniform numbers in [0, 1).

    Returns:
        Vector3 of unit length, density 1/(4π) per steradian.
    """
    types = array_types(u)
    z = 1 - 2 * u.x
    # 1 − z² in the form that stays non-negative in floating point.
    radius = 2 * dr.sqrt(maximum(u.x * (1 - u.x), 0))
    sin, cos = dr.sincos(dr.two_pi * u.y)
    return types.Vector3(radius * cos, radius * sin, z)


def cosine_about(axis: Vec3, u: Vec2) -> Vec3:
    """A direction whose density is its cosine with `axis` over π.

    A point of the unit sphere around the tip of `axis`, seen from the origin, has exactly that density, so
    no frame has to be built.

    Args:
        axis: Vector3, unit.
        u: Vector2 of uniform numbers in [0, 1).
    """
    towards = axis + uniform_on_sphere(u)
    return towards * dr.rsqrt(maximum(dr.squared_norm(towards), MIN_SQUARED_LENGTH))
