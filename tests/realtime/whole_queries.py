"""Whole queries of `point` and `lobes` in Slang. Drivers compile each text once, so all tests share these."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.realtime.words import Packed
from tests.helpers.slang import mapped

_WHITE = (1.0, 1.0, 1.0)
# Of `detail.slang`.
_NO_DETAIL = -1.0


def lobes_values(
    arguments: Mapping[str, NDArray[Any]], looks: tuple[Any, ...] | Packed, tint: tuple[float, ...] = _WHITE
) -> NDArray[np.float32]:
    """f·cos [n, 3] of footprints.

    Args:
        arguments: centre, light, view, dx and dy.
        looks: layout, appearance, and tables of lobes, or all of it packed.
        tint: multiplies the diffuse albedos.
    """
    body = (
        "Footprint p; p.centre = centre; p.dx = dx; p.dy = dy;"
        "let e = lobes_estimate(fabric, p, 1.0, light, view);"
        "let v = composed(fabric, e.components, e.close, e.albedos, tint, light, view);"
    )
    names = ("centre", "light", "view", "dx", "dy")
    rows = {name: arguments[name] for name in names} | {"tint": _rows(tint, arguments)}
    return mapped("lobes footprint separable", body, "v.x; v.y; v.z", rows, looks)


def point_values(
    arguments: Mapping[str, NDArray[Any]], looks: tuple[Any, ...] | Packed, tint: tuple[float, ...] = _WHITE
) -> NDArray[np.float32]:
    """f·cos, delta transmission, n_x, n_y, t_x and the red diffuse albedo of points [n, 8].

    Args:
        arguments: x, y, light, view, and perhaps side: of a footprint, millimetres; yarns are smooth without.
        looks: layout and appearance, or all of it packed.
        tint: multiplies the diffuse albedos.
    """
    body = (
        "let q = default_quality(); var p = locate_yarn(fabric, q, x, y, view, side);"
        "let bounced = bounced_at(fabric, p, tint); let albedo = p.albedos.diffuse_reflect.x;"
        "p.albedos = tinted(p.albedos, tint); let f = evaluate_with(fabric, q, p, bounced, light, view);"
        "let through = straight_through(fabric, p, view);"
    )
    results = "f.x; f.y; f.z; through; p.normal.x; p.normal.y; p.tangent.x; albedo"
    rows = {name: arguments[name] for name in ("x", "y", "light", "view")}
    smooth = np.full(len(rows["x"]), _NO_DETAIL, np.float32)
    rows |= {"side": arguments.get("side", smooth), "tint": _rows(tint, arguments)}
    return mapped("point search separable", body, results, rows, looks)


def _rows(tint: tuple[float, ...], arguments: Mapping[str, NDArray[Any]]) -> NDArray[np.float32]:
    return np.tile(np.float32(tint), (len(arguments["light"]), 1))
