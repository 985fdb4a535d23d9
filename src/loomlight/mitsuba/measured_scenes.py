"""The scenes of the image benchmark: which pixels count, and how many yarns a pixel covers.

One directional light, direct light only, box filter, no ground. Distances are given in yarns a pixel, not in
metres: the weave is scaled on the piece of cloth until the median pixel covers so many, so that every fabric
is seen at the same scales. A pixel counts if it lies wholly on one piece of cloth.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.queries import fabric_scale
from loomlight.core.errors import InputError
from loomlight.fabric import Fabric
from loomlight.mesh.cloth_mesh import ClothMesh, uv_size
from loomlight.mitsuba import shapes
from loomlight.mitsuba.camera import framing, perspective, require_size
from loomlight.mitsuba.lights import light_dicts
from loomlight.mitsuba.meshes import to_shape
from loomlight.mitsuba.plugins import material_bsdf
from loomlight.mitsuba.scenes import BsdfFactory, empty_scene, loaded_bsdf
from loomlight.models.interface import Model

# Direct light alone: camera to cloth to light.
_DEPTH = 2
# Places in a pixel at which it must meet one piece: its corners, the middles of its sides and its own.
_PLACES = (0.001, 0.5, 0.999)


@dataclass(frozen=True)
class MeasuredShot:
    """Contents of a scene; direct light only.

    Attributes:
        pieces: makes the pieces of cloth, in the order of the fabrics.
        towards_camera, towards_light: directions from the first piece, of any length.
        yarns: yarns that the median pixel covers, along one side.
        zoom: 1 frames the first piece.
        light: one of `LIGHTS`.
    """

    pieces: tuple[Callable[[], ClothMesh], ...]
    towards_camera: tuple[float, float, float]
    towards_light: tuple[float, float, float]
    yarns: float
    zoom: float = 1.0
    light: str = "directional"


def _background() -> ClothMesh:
    """A flat piece of 0.8 m just behind the sphere's middle."""
    flat = shapes.flat().scaled(8.0)
    return ClothMesh(
        flat.positions + np.array([0.0, 0.0, -0.02]), flat.normals, flat.uv, flat.triangles, "background"
    )


_FRONT, _ABOVE = (0.0, 0.0, 1.0), (0.35, 0.55, 1.0)
_FLAT, _DRAPE = (shapes.flat,), (shapes.drape,)
_SHOTS = {
    "flat near": MeasuredShot(_FLAT, (0.5, -0.3, 1.0), (-0.5, 0.6, 0.8), 0.25, zoom=2.4),
    "flat middle": MeasuredShot(_FLAT, (0.5, -0.3, 1.0), (-0.5, 0.6, 0.8), 2.5, zoom=2.4),
    "flat far": MeasuredShot(_FLAT, (0.5, -0.3, 1.0), (-0.5, 0.6, 0.8), 10.0, zoom=2.4),
    "drape near": MeasuredShot(_DRAPE, _ABOVE, (-0.6, 0.75, 0.6), 0.6, zoom=3.0),
    "drape far": MeasuredShot(_DRAPE, _ABOVE, (-0.6, 0.75, 0.6), 4.0),
    "cylinder grazing": MeasuredShot((shapes.cylinder,), _FRONT, (1.0, 0.35, 0.4), 3.0, zoom=1.2),
    "sphere": MeasuredShot((shapes.sphere,), _FRONT, (-0.45, 0.6, 0.75), 3.0),
    "two fabrics": MeasuredShot((shapes.sphere, _background), _FRONT, (-0.45, 0.6, 0.75), 3.0, zoom=0.8),
}
MEASURED_SCENES = tuple(_SHOTS)


@dataclass(frozen=True, eq=False)
class MeasuredScene:
    """A scene that is ready to render.

    Attributes:
        scene: the Mitsuba scene.
        integrator: the `footprint_path` to render it with.
        counted: pixels that lie wholly on one piece of cloth [height, width].
        yarns_per_pixel: median over these, the side of the footprint in yarns.
    """

    scene: mi.Scene
    integrator: mi.Integrator
    counted: NDArray[np.bool_]
    yarns_per_pixel: float


def measured_scene(
    name: str,
    fabrics: Sequence[Fabric],
    model: str | Callable[[Fabric], Model],
    size: tuple[int, int],
    pixel_centres: bool = False,
) -> MeasuredScene:
    """One of `MEASURED_SCENES`; a Mitsuba variant must be set.

    Args:
        fabrics: of its pieces; "two fabrics" takes two, the others the first.
        model: as `material_bsdf` takes it; or a function from a fabric to its model.
        size: width and height in pixels.
        pixel_centres: rays go through the middle of pixels, for one sample of models that filter.

    Raises:
        InputError: an unknown scene, too few fabrics, a size out of range, or a fabric that is refused.
    """
    shot = _shot(name)
    if len(fabrics) < len(shot.pieces):
        raise InputError(f'The scene "{name}" shows {len(shot.pieces)} fabrics, and {len(fabrics)} is given.')
    # Models may take minutes to make: none is made of a fabric that the shot does not show.
    shown = fabrics[: len(shot.pieces)]
    if isinstance(model, str):
        bsdfs = [material_bsdf(fabric, model) for fabric in shown]
    else:
        bsdfs = [material_bsdf(model(fabric)) for fabric in shown]
    return shot_scene(shot, list(zip(shown, bsdfs, strict=True)), size, pixel_centres)


def shot_scene(
    shot: MeasuredShot,
    cloths: Sequence[tuple[Fabric, BsdfFactory]],
    size: tuple[int, int],
    pixel_centres: bool = False,
) -> MeasuredScene:
    """The scene of any shot; a Mitsuba variant must be set. See `measured_scene`.

    Args:
        cloths: a fabric, whose yarns are counted, and its BSDF for each piece of the shot; more are left out.

    Raises:
        InputError: a size out of range.
    """
    require_size(size)
    counted, side_mm = _measured(shot, size)
    scale = [
        shot.yarns * fabric_scale(fabric.layout()).thread / side
        for (fabric, _), side in zip(cloths, side_mm, strict=False)
    ]
    scene = mi.load_dict(_parts(shot, size, [bsdf for _, bsdf in cloths], scale))
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": _DEPTH, "pixel_centres": pixel_centres})
    return MeasuredScene(scene, integrator, counted, shot.yarns)


def shot_counted(shot: MeasuredShot, size: tuple[int, int]) -> NDArray[np.bool_]:
    """Pixels of a shot that lie wholly on one piece of cloth [height, width], whatever the fabric."""
    return _measured(shot, size)[0]


def require_scenes(names: Sequence[str]) -> None:
    """Raises InputError unless at least one scene is named and all are in `MEASURED_SCENES`."""
    if not names:
        raise InputError(f"No scene is given: name some of {', '.join(_SHOTS)}.")
    for name in names:
        _shot(name)


def _shot(name: str) -> MeasuredShot:
    if name not in _SHOTS:
        raise InputError(f'scene = "{name}" is no scene of the image benchmark: use {", ".join(_SHOTS)}.')
    return _SHOTS[name]


def _parts(
    shot: MeasuredShot, size: tuple[int, int], bsdfs: Sequence[BsdfFactory], scale: Sequence[float]
) -> dict[str, Any]:
    """The scene's dictionary, with the weave of each piece drawn 1/`scale` times as large as it is."""
    pieces = [piece() for piece in shot.pieces]
    first = pieces[0].positions
    view = framing(first, np.array(shot.towards_camera), size)
    sensor = perspective(view.closer(shot.zoom, view.target), size)
    sensor["film"]["rfilter"] = {"type": "box"}
    parts: dict[str, Any] = {**empty_scene(), "sensor": sensor}
    for number, (piece, bsdf) in enumerate(zip(pieces, bsdfs, strict=False)):
        across, along = uv_size(piece)
        material = loaded_bsdf(bsdf((across * scale[number], along * scale[number])))
        parts[f"cloth{number}"] = to_shape(piece, material)
    centre = (first.min(axis=0) + first.max(axis=0)) / 2
    return parts | light_dicts(shot.light, centre, 1.0, np.array(shot.towards_light))


@lru_cache(maxsize=32)
def _measured(shot: MeasuredShot, size: tuple[int, int]) -> tuple[NDArray[np.bool_], list[float]]:
    """Pixels that lie wholly on one piece [height, width]; the side of each piece's median footprint, mm."""

    def grey(_uv_size: tuple[float, float]) -> dict[str, Any]:
        return {"type": "twosided", "bsdf": {"type": "diffuse"}}

    scene = mi.load_dict(_parts(shot, size, [grey] * len(shot.pieces), [1.0] * len(shot.pieces)))
    found, shared = _seen(scene, size, 0.5, 0.5)
    si, number = found
    for x in _PLACES:
        for y in _PLACES:
            _, other = _seen(scene, size, x, y)[0]
            shared &= other == number
    area = dr.abs(si.duv_dx.x * si.duv_dy.y - si.duv_dx.y * si.duv_dy.x).numpy()
    pieces = np.where(shared.numpy(), number.numpy().astype(np.intp), -1)
    sides = []
    for index, piece in enumerate(shot.pieces):
        across, along = uv_size(piece())
        sides.append(float(np.sqrt(np.median(area[pieces == index]) * across * along)))
    return (pieces >= 0).reshape(size[::-1]), sides


def _seen(scene: mi.Scene, size: tuple[int, int], x: float, y: float) -> Any:
    """Hits of rays through one place of every pixel: interaction, number of the piece, place."""
    width, height = size
    index = dr.arange(mi.UInt32, width * height)
    row = index // width
    place = mi.Point2f((mi.Float(index - row * width) + x) / width, (mi.Float(row) + y) / height)
    ray, _ = scene.sensors()[0].sample_ray_differential(0.0, 0.5, place, mi.Point2f(0.5))
    si = scene.ray_intersect(ray)
    si.compute_uv_partials(ray)
    number = mi.Int32(-1)
    for index_of, shape in enumerate(scene.shapes()):
        number = dr.select(si.shape == mi.ShapePtr(shape), mi.Int32(index_of), number)
    return (si, number), si.is_valid()
