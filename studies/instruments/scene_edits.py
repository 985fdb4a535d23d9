"""Scene parameters changed by the end of their names, for scenes of one cloth."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray


class SceneEdits:
    """Changes the parameters of a scene, and takes them back."""

    def __init__(self, scene: mi.Scene) -> None:
        self._parameters = mi.traverse(scene)

    def apply(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Gives parameters values, updates the scene once, and returns the values that there were.

        Args:
            values: by the ends of parameters' names, such as "warp.roughness"; one parameter each.
        """
        before = {}
        for name, value in values.items():
            (key,) = (
                key
                for key in self._parameters.keys()  # noqa: SIM118 (no mapping)
                if key == name or key.endswith(f".{name}")
            )
            held = self._parameters[key]
            before[name] = type(held)(held)
            self._parameters[key] = type(held)(value)
        self._parameters.update()
        return before


def bitmap_texture(values: NDArray[np.float32]) -> dict[str, Any]:
    """The dictionary of a texture of linear colours [height, width, 3]."""
    return {"type": "bitmap", "bitmap": mi.Bitmap(values), "raw": True, "wrap_mode": "repeat"}
