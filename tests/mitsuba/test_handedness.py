"""A Z twill is a Z twill in the picture, whatever file the cloth comes from and whichever way its uv runs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import build_scene, material_bsdf, render
from tests.helpers.meshes import write_gltf, write_obj, write_ply

# A square of 8 mm that faces +z, x to the right and y up.
CORNERS = np.array([[0, 0, 0], [8, 0, 0], [8, 8, 0], [0, 8, 0]]) * 1e-3
UPRIGHT = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=float)
ISLANDS = {
    "upright": UPRIGHT,
    "u mirrored": UPRIGHT * [-1, 1] + [1, 0],
    "v mirrored": UPRIGHT * [1, -1] + [0, 1],
    "half a turn": 1 - UPRIGHT,
}
SIZE = 64


FORMATS: dict[str, Callable[[Path, np.ndarray], Path]] = {
    "obj": lambda folder, uv: write_obj(folder, CORNERS, uv),
    "ply": lambda folder, uv: write_ply(folder, CORNERS, uv),
    "gltf": lambda folder, uv: write_gltf(folder, CORNERS, uv, "quad.gltf"),
    "glb": lambda folder, uv: write_gltf(folder, CORNERS, uv),
}


def rising(mesh: Path | None, hand: str) -> float:
    """How much more the picture resembles itself along rising diagonals than along falling ones."""
    fabric = f'weave = "twill 3/1 {hand}"\n[warp]\ncolor = "#101010"\ntwist_deg = 0\n'
    fabric += '[weft]\ncolor = "#f0f0f0"\ntwist_deg = 0\n'
    zoom = 1.0 if mesh is not None else 12.0
    path = {"light": "directional", "light_from": (0.0, 45.0), "size": (SIZE, SIZE), "max_depth": 2}
    scene = build_scene(
        "flat", material_bsdf(fabric_from_text(fabric), "point"), mesh=mesh, zoom=zoom, **path
    )
    picture = render(scene.scene, spp=8).mean(axis=2)[12:-12, 12:-12]
    centred = picture - picture.mean()
    shift = 3  # pixels: about a thread
    inner = centred[shift:-shift, shift:-shift]
    up = centred[: -2 * shift, 2 * shift :]
    down = centred[2 * shift :, 2 * shift :]
    return float(np.mean(inner * up) - np.mean(inner * down)) / float(inner.var())


def test_the_measure_tells_z_from_s() -> None:
    # The flat piece is made here, with u to the right and v up: what the letters mean.
    assert rising(None, "z") > 0.3
    assert rising(None, "s") < -0.3


@pytest.mark.quick("upright-obj", "u mirrored-ply", "v mirrored-gltf", "half a turn-glb")
@pytest.mark.parametrize("name", FORMATS)
@pytest.mark.parametrize("island", ISLANDS)
def test_a_twill_keeps_its_hand(name: str, island: str, tmp_path: Path) -> None:
    mesh = FORMATS[name](tmp_path, ISLANDS[island])
    assert rising(mesh, "z") > 0.3
    assert rising(mesh, "s") < -0.3
