"""Fitted materials of chosen numbers, for tests of what is written of them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any
from unittest.mock import patch

import numpy as np

from loomlight.exporters import fit
from loomlight.exporters.fit import FittedMaterial


def plain_material(
    size: tuple[float, float] = (2.0, 3.0), shape: tuple[int, int] = (4, 6), **changes: Any
) -> FittedMaterial:
    """A material of the same numbers in all texels; highlights are wide along y.

    Args:
        size: millimetres of what the textures hold.
        shape: rows and columns.
        changes: other fields; of textures a value, or texels.
    """
    vectors = {"normal": [0, 0, 1], "axis_x": [0, 1, 0], "axis_y": [-1, 0, 0], "direction": [0, 1]}
    colours = {"base": [0.3, 0.35, 0.4], "transmit": [0.5, 0.3, 0.1], "specular": [1.0, 0.8, 0.6]}
    numbers = {"transmission": 0.3, "alpha_x": 0.6, "alpha_y": 0.15, "cover": 1.0, "height": 0.2}
    maps = vectors | colours | numbers
    arrays = {
        name: np.array(np.broadcast_to(value, (*shape, *np.shape(maps[name]))), float)
        for name, value in (maps | {name: changes[name] for name in maps if name in changes}).items()
    }
    made = FittedMaterial(
        **arrays,
        weight=0.2,
        sheen=np.zeros(3),
        sheen_roughness=0.5,
        size=size,
        error=0.1,
        brightness=1.0,
    )
    return replace(made, **{name: value for name, value in changes.items() if name not in maps})


def few_queries() -> Any:
    """A fit of so few queries that it takes no time, and is not good."""
    return patch.multiple(fit, _REFLECTED=120, _TRANSMITTED=40)
