"""Scenes of several pieces, and cloth as a ray-traced height field.

Covers: studies/instruments/composed_scenes.py, studies/instruments/cosine_bsdf.py
Covers: studies/papers/zhu2024/height_field.py
Covers: mitsuba/shapes.py
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import ClothMesh, material_bsdf, render, shapes
from loomlight.mitsuba.lights import light_dicts
from loomlight.mitsuba.shapes import ground
from studies.instruments.composed_scenes import Composition, composed_scene, scene_of_shapes
from studies.papers.zhu2024.height_field import height_field_shape

SIZE = (24, 16)
THREADS = 6


def square(side: float, offset: float = 0.0, grid: int = 2) -> ClothMesh:
    """A square that faces +z, with u to the right."""
    return shapes.grid_surface(
        grid, lambda u, v: (side * (u - 0.5) + offset, side * (v - 0.5), 0 * u), "square"
    )


def grey(_millimetres: tuple[float, float]) -> dict[str, Any]:
    return {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.5}}


def light(towards: tuple[float, float, float] = (0.0, 0.0, 1.0)) -> dict[str, Any]:
    return light_dicts("directional", np.zeros(3), 1.0, np.array(towards))


def test_pixels_on_one_piece_count() -> None:
    pieces = [square(0.1, -0.06), square(0.1, 0.06)]
    props = {**light(), "ground": ground(np.zeros(3), 0.1, -0.05)}
    scene = composed_scene(Composition(pieces, (0.0, 0.0, 1.0), props), [grey, grey], SIZE)
    counted = scene.counted
    assert counted.shape == SIZE[::-1]
    # Between the pieces and beyond them nothing counts.
    assert not counted[:, SIZE[0] // 2].any()
    assert not counted[0].any()
    assert counted[SIZE[1] // 2, 2:9].all()
    assert counted[SIZE[1] // 2, -9:-2].all()
    picture = render(scene.scene, spp=1, integrator=scene.integrator)
    assert np.allclose(picture[counted], 0.5, atol=1e-3)


@pytest.mark.usefixtures("height_field_alone")
def test_a_height_field_shows_what_the_point_model_shows() -> None:
    """Parallax and shadows by Mitsuba's rays and by the search of yarns, on plain weave seen aslant."""
    yarn = "translucency = 0\nspecular = 0.4\nroughness = 0.4\n"
    fabric = fabric_from_text(
        # Mitsuba's light scatters once here.
        f'name = "plain"\nweave = "plain"\nends_per_cm = 5\npicks_per_cm = 5\ngap = 0.02\n'
        "interreflection = false\n"
        f'[warp]\ncolor = "#cc8844"\n{yarn}[weft]\ncolor = "#4488cc"\n{yarn}'
    )
    side = 0.01 * THREADS / 5
    shown = Composition([square(side)], (0.8, 0.3, 1.0), light((-0.7, 0.3, 0.7)), zoom=3.0)
    shapes = [height_field_shape(square(side, grid=THREADS * 24 + 1), fabric)]
    field = scene_of_shapes(shown, shapes, SIZE)
    point = composed_scene(shown, [material_bsdf(fabric, "point")], SIZE)
    assert point.counted.all()
    traced, searched = (render(scene.scene, spp=64, integrator=scene.integrator) for scene in (field, point))
    # Steps between yarns are slopes of a twenty-fourth of a thread here, and walls there.
    ratio = traced.mean(axis=(0, 1)) / searched.mean(axis=(0, 1))
    assert np.all(np.abs(ratio - 1) < 0.06)
    difference = np.abs(traced - searched).mean() / searched.mean()
    assert difference < 0.15
