"""From a surface's uv to draft coordinates, the same weave on every uv convention."""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi


def draft_position(si: Any, uv_size: Any) -> tuple[Any, Any]:
    """Draft coordinates x, y in millimetres of `si`, where `uv_size` is mm per unit of u and of v.

    The frame's y is n × x. Where dp/dv points against it (OBJ as Mitsuba loads it, glTF, mirrored islands)
    the draft counts from the other end of v, so that a Z twill stays a Z twill.
    """
    mirrored = dr.dot(dr.cross(si.dp_du, si.dp_dv), si.sh_frame.n) < 0
    v = dr.select(mirrored, 1 - si.uv.y, si.uv.y)
    return si.uv.x * mi.Float(uv_size[0]), v * mi.Float(uv_size[1])
