"""What stands beside cloth in built-in scenes: a ground, and the ball that cloth is draped over."""

from __future__ import annotations

from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.mitsuba import cloth_shapes


def ground(centre: NDArray[np.float64], radius: float, height: float) -> dict[str, Any]:
    """A wide grey disc just below `height`, around an object of `radius`."""
    transform = mi.ScalarTransform4f().translate([centre[0], height - 1e-3 * radius, centre[2]])
    return {
        "type": "disk",
        "to_world": transform.rotate([1, 0, 0], -90).scale(60 * radius),
        # Grey card: darker than most cloth, which stands out from it.
        "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.18}},
    }


def ball() -> dict[str, Any]:
    """The grey ball under the draped cloth."""
    radius = cloth_shapes.DRAPE_BALL_RADIUS
    return {
        "type": "sphere",
        "center": [0, radius, 0],
        "radius": radius,
        "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.32}},
    }
