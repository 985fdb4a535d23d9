"""Props of built-in scenes: paper below or behind it, and the ball under draped cloth."""

from __future__ import annotations

from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.mitsuba import cloth_shapes

# White paper, as catalogues show cloth on: it lights folds from below and takes a soft shadow.
_PAPER = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.8}}


def ground(centre: NDArray[np.float64], radius: float, height: float) -> dict[str, Any]:
    """A wide sheet of paper just below `height`, around an object of `radius`."""
    transform = mi.ScalarTransform4f().translate([centre[0], height - 1e-3 * radius, centre[2]])
    return {
        "type": "disk",
        "to_world": transform.rotate([1, 0, 0], -90).scale(60 * radius),
        "bsdf": _PAPER,
    }


def backdrop(centre: NDArray[np.float64], radius: float, depth: float) -> dict[str, Any]:
    """A wide sheet of paper at z = `depth` behind an object of `radius` that faces +z."""
    transform = mi.ScalarTransform4f().translate([centre[0], centre[1], depth])
    return {"type": "disk", "to_world": transform.scale(60 * radius), "bsdf": _PAPER}


def ball() -> dict[str, Any]:
    """The grey ball under the draped cloth."""
    radius = cloth_shapes.DRAPE_BALL_RADIUS
    return {
        "type": "sphere",
        "center": [0, radius, 0],
        "radius": radius,
        "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.32}},
    }
