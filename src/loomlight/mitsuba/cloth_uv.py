"""From a surface's uv to draft coordinates, the same weave on every uv convention."""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.backend import array_types
from loomlight.core.footprint import Footprint
from loomlight.mitsuba.ray_cone import cone_partials


def draft_position(si: mi.SurfaceInteraction3f, uv_size: Any) -> tuple[Any, Any]:
    """Draft coordinates x, y in millimetres of `si`, where `uv_size` is mm per unit of u and of v.

    The frame's y is n × x. Where dp/dv points against it (OBJ as Mitsuba loads it, glTF, mirrored islands)
    the draft counts from the other end of v, so that a Z twill stays a Z twill.
    """
    v = dr.select(_mirrored(si), 1 - si.uv.y, si.uv.y)
    return si.uv.x * mi.Float(uv_size[0]), v * mi.Float(uv_size[1])


def draft_footprint(si: mi.SurfaceInteraction3f, uv_size: Any, uv_footprint: tuple[Any, Any]) -> Footprint:
    """A footprint in draft coordinates, millimetres; see `draft_position`.

    Args:
        uv_footprint: its edges in uv.
    """
    types = array_types(mi.Float)
    turn = dr.select(_mirrored(si), mi.Float(-1), 1)

    def step(edge: Any) -> Any:
        return types.Vector2(edge.x * mi.Float(uv_size[0]), turn * edge.y * mi.Float(uv_size[1]))

    return Footprint(types.Vector2(*draft_position(si, uv_size)), *(step(edge) for edge in uv_footprint))


def uv_footprint(si: mi.SurfaceInteraction3f, pixel_angle: float) -> tuple[Any, Any]:
    """Edges of the footprint in uv, as the integrator sets them.

    Args:
        pixel_angle: of a cone from the camera, radians, where the integrator sets no footprint; 0 for none.
    """
    if pixel_angle <= 0:
        return si.duv_dx, si.duv_dy
    is_set = (dr.squared_norm(si.duv_dx) > 0) | (dr.squared_norm(si.duv_dy) > 0)
    cone = cone_partials(si, -si.to_world(si.wi), si.t * pixel_angle)
    return dr.select(is_set, si.duv_dx, cone[0]), dr.select(is_set, si.duv_dy, cone[1])


def _mirrored(si: Any) -> Any:
    return dr.dot(dr.cross(si.dp_du, si.dp_dv), si.sh_frame.n) < 0
