"""Scenes of several pieces of cloth, each of its own material, at their true scale.

Box filter: a sample is of its pixel alone, so that pictures of models that average over the footprint and
of those that do not have the same expectation. A pixel counts if it lies wholly on one piece of cloth.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.cloth_mesh import ClothMesh, uv_size
from loomlight.mitsuba.camera import framing, perspective, require_size
from loomlight.mitsuba.measured_scenes import MeasuredScene
from loomlight.mitsuba.meshes import to_shape
from loomlight.mitsuba.scenes import BsdfFactory, empty_scene, loaded_bsdf

# Places in a pixel at which it must meet one piece: its corners, the middles of its sides and its own.
_PLACES = (0.001, 0.5, 0.999)
# Ids of shapes that are cloth begin with it.
_CLOTH = "piece"


@dataclass(frozen=True, eq=False)
class Composition:
    """What a scene shows, whatever the cloth is made of.

    Attributes:
        pieces: the meshes.
        towards_camera: direction from the pieces to the camera, of any length.
        props: further parts of the scene by name, as Mitsuba's dictionaries: emitters, furniture, a ground.
        max_depth: longest path in segments; 2 is direct light alone.
        zoom: 1 frames all pieces; above, the camera comes closer to `focus`.
        focus: a point in world coordinates; by default the middle of the pieces.
    """

    pieces: Sequence[ClothMesh]
    towards_camera: tuple[float, float, float]
    props: Mapping[str, Any]
    max_depth: int = 2
    zoom: float = 1.0
    focus: tuple[float, float, float] | None = None


def composed_scene(
    shown: Composition, bsdfs: Sequence[BsdfFactory], size: tuple[int, int], pixel_centres: bool = False
) -> MeasuredScene:
    """The scene of a composition; a Mitsuba variant must be set.

    Args:
        bsdfs: of its pieces.
        size: width and height in pixels.
        pixel_centres: rays go through the middle of pixels, for one sample of models that filter.

    Raises:
        InputError: a size out of range, or a BSDF that cannot be made.
    """
    shapes = [
        to_shape(piece, loaded_bsdf(bsdf(uv_size(piece))))
        for piece, bsdf in zip(shown.pieces, bsdfs, strict=True)
    ]
    return scene_of_shapes(shown, shapes, size, pixel_centres)


def scene_of_shapes(
    shown: Composition, shapes: Sequence[mi.Mesh], size: tuple[int, int], pixel_centres: bool = False
) -> MeasuredScene:
    """The scene of a composition, of shapes that are ready in place of its pieces; see `composed_scene`."""
    require_size(size)
    points = np.concatenate([piece.positions for piece in shown.pieces])
    view = framing(points, np.array(shown.towards_camera), size)
    focus = view.target if shown.focus is None else np.array(shown.focus)
    sensor = perspective(view.closer(shown.zoom, focus), size)
    sensor["film"]["rfilter"] = {"type": "box"}
    parts: dict[str, Any] = {**empty_scene(), "sensor": sensor, **shown.props}
    for number, shape in enumerate(shapes):
        shape.set_id(f"{_CLOTH}{number}")
        parts[f"{_CLOTH}{number}"] = shape
    scene = mi.load_dict(parts)
    integrator = mi.load_dict(
        {"type": "footprint_path", "max_depth": shown.max_depth, "pixel_centres": pixel_centres}
    )
    return MeasuredScene(scene, integrator, cloth_pixels(scene, size), float("nan"))


def directions_alone() -> mi.Integrator:
    """Direct light that only the BSDF's directions find."""
    return mi.load_dict({"type": "direct", "emitter_samples": 0, "bsdf_samples": 1})


def cloth_pixels(scene: Any, size: tuple[int, int]) -> NDArray[np.bool_]:
    """Pixels that lie wholly on one piece of cloth of a composed scene [height, width]."""
    width, height = size
    pieces = {shape.id(): mi.ShapePtr(shape) for shape in scene.shapes() if shape.id().startswith(_CLOTH)}
    first = None
    shared = mi.Bool(True)
    for x in _PLACES:
        for y in _PLACES:
            number = _piece_seen(scene, list(pieces.values()), size, x, y)
            first = number if first is None else first
            shared &= (number == first) & (number >= 0)
    return np.array(shared, dtype=bool).reshape(height, width)


def _piece_seen(scene: Any, pieces: Sequence[Any], size: tuple[int, int], x: float, y: float) -> Any:
    """Number of the piece that rays through one place of every pixel meet, −1 for none."""
    width, height = size
    index = dr.arange(mi.UInt32, width * height)
    row = index // width
    place = mi.Point2f((mi.Float(index - row * width) + x) / width, (mi.Float(row) + y) / height)
    ray, _ = scene.sensors()[0].sample_ray(0.0, 0.5, place, mi.Point2f(0.5))
    found = scene.ray_intersect_preliminary(ray)
    number = mi.Int32(-1)
    for piece, pointer in enumerate(pieces):
        number = dr.select(found.is_valid() & (found.shape == pointer), mi.Int32(piece), number)
    return number
