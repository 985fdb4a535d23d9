"""Pictures of cloth on a turntable: it turns, camera and light stay."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import Any, Unpack

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import upload
from loomlight.core.errors import InputError
from loomlight.mitsuba.camera import framing
from loomlight.mitsuba.material_picture import (
    further_cloths,
    picture_options,
    scene_options,
    shown_material,
    warn_of_hidden_weave,
)
from loomlight.mitsuba.plugins import material_bsdf
from loomlight.mitsuba.rendering import render
from loomlight.mitsuba.scenes import CLOTH_NAME, SCENES, UNCOVERED_NAME, ClothScene, SceneOptions, build_scene
from loomlight.mitsuba.variants import choose_variant
from loomlight.models.material_spec import Material
from loomlight.picture_settings import RenderKeywords, RenderSettings

# Positions of pieces of a mesh, by the names of their shapes.
_PIECE = re.compile(rf"({CLOTH_NAME}\d*|{UNCOVERED_NAME})\.vertex_positions")
# Degrees at which the whole cloth has to be in the picture.
_ANGLES = tuple(float(angle) for angle in range(0, 360, 15))
_UP = np.array([0.0, 1.0, 0.0])


def turntable(
    material: Material,
    count: int,
    scene: str | os.PathLike[str] | None = None,
    settings: RenderSettings | None = None,
    **changes: Unpack[RenderKeywords],
) -> Iterator[NDArray[np.float32]]:
    """`count` pictures of one turn of a material on a built-in scene or a mesh; see `render`.

    Raises:
        InputError: a scene file, or a material or value that cannot be used.
    """
    chosen = (settings or RenderSettings()).changed(**changes)
    if scene is not None:
        chosen = chosen.changed(scene=scene)
    if str(chosen.scene) not in SCENES:
        raise InputError(
            f"turntable = {count} does not go with the scene {chosen.scene}: nothing in it turns."
        )
    choose_variant(chosen.variant)
    whole: SceneOptions = {**scene_options(chosen), "zoom": 1.0}
    spec = shown_material(material, chosen)
    bsdf, others = material_bsdf(spec), further_cloths(chosen)
    shown = build_scene(chosen.scene, bsdf, others=others, **whole)
    shown.integrator.soft_terminator = chosen.soft_terminator
    turning = Turntable(shown, chosen.zoom, about_middle=chosen.mesh is not None)
    warn_of_hidden_weave(spec.source, shown.pixel_mm(), chosen)
    yield from turning.pictures(count, **picture_options(chosen))


class Turntable:
    """A built-in scene, or one around a mesh, whose cloth turns about a vertical.

    The camera stands as far away as the whole turn needs, and closer by `zoom`. Built-in cloths turn about
    the origin, where a ball carries the drape; `about_middle` is for others.
    """

    def __init__(self, shown: ClothScene, zoom: float = 1.0, *, about_middle: bool = False) -> None:
        self._shown = shown
        self._params: Any = mi.traverse(shown.scene)
        matches = map(_PIECE.fullmatch, self._params.keys())
        self._rows = {match[1]: self._rows_of(match[1]) for match in matches if match}
        positions = np.concatenate([rows for rows, _ in self._rows.values()])
        low, high = positions.min(axis=0), positions.max(axis=0)
        self._axis = (low + high) / 2 * (1 - _UP) if about_middle else 0 * _UP
        width, height = shown.scene.sensors()[0].film().size()
        whole = np.concatenate([self._turned(positions, angle) for angle in _ANGLES])
        towards_camera = shown.view.origin - shown.view.target
        view = framing(whole, towards_camera, (int(width), int(height)), shown.view.field_of_view)
        middle = self._axis + _UP * (low + high) / 2
        shown.look_from(view.closer(zoom, middle if zoom > 1 else view.target))

    def pictures(self, count: int, **options: Any) -> Iterator[NDArray[np.float32]]:
        """`count` pictures of one turn, linear RGB [height, width, 3]; the first as the scene has the cloth.

        Args:
            options: of `render`: spp, seed, exposure, white_balance, denoise.
        """
        for number in range(count):
            self._turn(360 * number / count)
            yield render(self._shown.scene, integrator=self._shown.integrator, **options)

    def _turn(self, angle: float) -> None:
        for piece, (positions, normals) in self._rows.items():
            rows = {"positions": self._turned(positions, angle), "normals": _rotated(normals, angle)}
            for name, values in rows.items():
                self._params[f"{piece}.vertex_{name}"] = upload(mi.Float, values.astype(np.float32))
        self._params.update()

    def _turned(self, positions: NDArray[np.float64], angle: float) -> NDArray[np.float64]:
        return _rotated(positions - self._axis, angle) + self._axis

    def _rows_of(self, piece: str) -> tuple[NDArray[np.float64], ...]:
        """Positions and normals [n, 3] of a piece."""
        arrays = ("vertex_positions", "vertex_normals")
        return tuple(
            np.array(self._params[f"{piece}.{name}"], dtype=np.float64).reshape(-1, 3) for name in arrays
        )


def _rotated(vectors: NDArray[np.float64], angle: float) -> NDArray[np.float64]:
    """[n, 3], counter-clockwise as seen from above, degrees."""
    cosine, sine = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    return vectors @ np.array([[cosine, 0, -sine], [0, 1, 0], [sine, 0, cosine]])
