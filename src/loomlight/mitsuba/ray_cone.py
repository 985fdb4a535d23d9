"""The pixel footprint along a path: a cone around the ray, and what it covers in a surface's uv.

A cone has a width (the side of a square perpendicular to the ray, scene units) and a spread (its growth per
unit of distance, radians). On the camera's own ray the true differentials are used instead.
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.backend import maximum, minimum

# A footprint seen at a grazing angle is stretched at most this much; beyond, the plane leaves the object.
_MAX_STRETCH = 20.0
# One scattering event opens the cone by at most this angle (radians).
_MAX_OPENING = 1.0


def pixel_cone(ray: Any) -> tuple[Any, Any]:
    """Width at the origin and spread of the cone whose cross-section has the area of the ray's pixel."""
    if not ray.has_differentials:
        return mi.Float(0), mi.Float(0)
    width = dr.sqrt(dr.norm(dr.cross(ray.o_x - ray.o, ray.o_y - ray.o)))
    spread = dr.sqrt(dr.norm(dr.cross(ray.d_x - ray.d, ray.d_y - ray.d)))
    return width, spread


def opening(pdf: Any, samples: Any) -> Any:
    """Angle by which a scattered sample of density `pdf` (1/sr) opens the cone, radians.

    One of `samples` samples stands for the solid angle 1/(samples·pdf); delta events do not open it.
    """
    angle = dr.rsqrt(maximum(pdf * samples, 1e-6))
    return minimum(angle, _MAX_OPENING)


def cone_partials(si: Any, direction: Any, width: Any) -> tuple[Any, Any]:
    """duv_dx and duv_dy of a cone of `width` that travels along `direction` and meets `si`.

    The first is the footprint's long side, along the ray's projection; the second its short side.
    """
    cosine = dr.dot(direction, si.n)
    along = direction - cosine * si.n
    length = dr.norm(along)
    fallback, _ = mi.coordinate_system(si.n)
    along = dr.select(length > 1e-4, along / maximum(length, 1e-4), fallback)
    across = dr.cross(si.n, along)
    stretch = minimum(dr.rcp(maximum(dr.abs(cosine), 1e-3)), _MAX_STRETCH)
    return _to_uv(si, along * (width * stretch)), _to_uv(si, across * width)


def _to_uv(si: mi.SurfaceInteraction3f, step: Any) -> Any:
    # Least squares in the tangent plane; a surface without a usable uv gets no footprint.
    uu, uv, vv = dr.squared_norm(si.dp_du), dr.dot(si.dp_du, si.dp_dv), dr.squared_norm(si.dp_dv)
    u, v = dr.dot(step, si.dp_du), dr.dot(step, si.dp_dv)
    inverse = dr.rcp(uu * vv - uv * uv)
    inverse = dr.select(dr.isfinite(inverse), inverse, 0)
    return mi.Vector2f(vv * u - uv * v, uu * v - uv * u) * inverse
