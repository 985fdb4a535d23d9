"""Props of built-in scenes: paper below or behind it, and the ball under draped cloth."""

from __future__ import annotations

from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.mitsuba import cloth_shapes
from loomlight.mitsuba.meshes import to_shape

# White paper, as catalogues show cloth on: it lights folds from below and takes a soft shadow.
_PAPER = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.8}}


def ground(
    centre: NDArray[np.float64], radius: float, height: float, distance: float = 0.0
) -> dict[str, Any]:
    """A sheet of paper just below `height`, around an object of `radius`.

    It is 60 times as wide as the object or, if that is more, as the `distance` of the camera: rays that go
    down by 4 degrees meet it, with room for a turntable's camera, which stands farther away.
    """
    transform = mi.ScalarTransform4f().translate([centre[0], height - 1e-3 * radius, centre[2]])
    extent = 60 * max(radius, distance)
    return {"type": "disk", "to_world": transform.rotate([1, 0, 0], -90).scale(extent), "bsdf": _PAPER}


def backdrop(
    centre: NDArray[np.float64], radius: float, depth: float, distance: float = 0.0
) -> dict[str, Any]:
    """A sheet of paper at z = `depth` behind an object of `radius` that faces +z, as wide as `ground`'s."""
    transform = mi.ScalarTransform4f().translate([centre[0], centre[1], depth])
    return {"type": "disk", "to_world": transform.scale(60 * max(radius, distance)), "bsdf": _PAPER}


def ball(behind: float = 0.0) -> mi.Mesh:
    """The grey ball under the draped cloth, or unseen so many metres behind other cloth.

    Kernels depend on how many shapes and BSDFs there are, and of which classes: built-in scenes share theirs.
    """
    radius = cloth_shapes.DRAPE_BALL_RADIUS

    def place(u: NDArray[np.float64], v: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
        # At the very poles there would be no normals.
        around, polar = 2 * np.pi * u, np.pi * (1e-4 + (1 - 2e-4) * v)
        across = radius * np.sin(polar)
        return across * np.cos(around), radius * (1 + np.cos(polar)), across * np.sin(around) - behind

    grey: dict[str, object] = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.32}}
    return to_shape(cloth_shapes.grid_surface((129, 65), place, "ball"), grey)
