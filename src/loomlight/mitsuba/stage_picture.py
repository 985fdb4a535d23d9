"""The picture of a page's stage: cloth by direct light before a background that takes its shadow."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric
from loomlight.fabric.surface_maps import without_maps
from loomlight.mesh.cloth_mesh import ClothMesh, checked
from loomlight.mitsuba.camera import View, perspective
from loomlight.mitsuba.denoising import gaussian_blur
from loomlight.mitsuba.meshes import to_shape
from loomlight.mitsuba.plugins import material_bsdf
from loomlight.mitsuba.rendering import render
from loomlight.mitsuba.scenes import empty_scene
from loomlight.mitsuba.variants import choose_variant

_SAMPLES = 8
# Rays that a pixel of the ground sends, and the lamp's radius: as `shaders/layers.slang:ground_light`, which
# adds up 4 in each of its passes.
_GROUND_RAYS, _LAMP_RADIUS = 16, 0.0873
# Deviation, pixels: soft shadows lose their noise.
_SHADOW_BLUR = 2.5

Vector = NDArray[np.float64]


def stage_picture(
    *,
    fabric: Fabric,
    mesh: Mapping[str, NDArray[Any]],
    uv_size_mm: tuple[float, float],
    size: tuple[int, int],
    origin: Vector,
    target: Vector,
    towards: Vector | None,
    irradiance: Vector,
    environment: NDArray[np.float32] | None,
    turn: float,
    background: Vector,
    ground: tuple[Vector, float, float],
    exposure: float,
) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] of what the fields of `viewer.picture.Stage` say.

    Raises:
        InputError: a mesh or a fabric that cannot be shown.
        MissingDependencyError: no usable LLVM library.
    """
    choose_variant(None)
    positions, normals, uv = (np.asarray(mesh[name], float) for name in ("positions", "normals", "uv"))
    triangles = np.asarray(mesh["triangles"], np.int64)
    cloth = checked(ClothMesh(positions, normals, uv, triangles, "The page's mesh"))
    sensor = perspective(View(origin, target), size)
    sensor["film"]["pixel_format"] = "rgba"
    # Light that comes from cloth by one reflection: as far as the page's shaders follow it.
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": 2, "hide_emitters": True})
    parts: dict[str, Any] = {**empty_scene(), "integrator": integrator, "sensor": sensor}
    parts["cloth"] = to_shape(cloth, material_bsdf(without_maps(fabric))(uv_size_mm))
    if towards is not None:
        lamp = {"type": "rgb", "value": irradiance.tolist()}
        parts["lamp"] = {"type": "directional", "direction": (-towards).tolist(), "irradiance": lamp}
    if environment is not None:
        parts["environment"] = {
            "type": "envmap",
            "bitmap": mi.Bitmap(np.ascontiguousarray(environment, np.float32)),
            "to_world": mi.ScalarTransform4f().rotate([0, 1, 0], turn),
        }
    scene = mi.load_dict(parts)
    picture = render(scene, spp=_SAMPLES, integrator=integrator)
    light = _ground_light(scene, size, ground, towards, 1 - fabric.layout().open_area)[..., None]
    behind = (1 - np.clip(picture[..., 3:], 0, 1)) * light * background
    return np.asarray(2.0**exposure * (picture[..., :3] + behind), np.float32)


def _ground_light(
    scene: mi.Scene,
    size: tuple[int, int],
    ground: tuple[Vector, float, float],
    towards: Vector | None,
    opaque: float,
) -> NDArray[np.float64]:
    """Share of its light that the cloth leaves the ground [height, width], where a pixel's ray meets it."""
    width, height = size
    pixel = dr.arange(mi.UInt32, width * height)
    place = mi.Point2f((mi.Float(pixel % width) + 0.5) / width, (mi.Float(pixel // width) + 0.5) / height)
    camera, _ = scene.sensors()[0].sample_ray(0, 0, place, mi.Point2f(0))
    unit, offset, lamp_share = ground
    normal = mi.Vector3f(unit)
    above, along = dr.dot(normal, camera.o) - offset, dr.dot(normal, camera.d)
    shows = (above > 0) & (along < 0)
    position = camera.o - camera.d * dr.select(shows, above / along, 0)
    lamp = mi.Vector3f(np.array([0.0, 1.0, 0.0]) if towards is None else towards / np.linalg.norm(towards))
    numbers: Any = mi.load_dict({"type": "independent"})
    numbers.seed(0, width * height)
    blocked = mi.Float(0)
    for _ in range(_GROUND_RAYS):
        of_lamp = numbers.next_1d() < lamp_share
        sphere = mi.warp.square_to_uniform_sphere(numbers.next_2d())
        # A normal and a point of the unit sphere about its tip: directions in proportion to their cosine.
        direction = dr.select(of_lamp, lamp + _LAMP_RADIUS * sphere, normal + 0.9999 * sphere)
        ray = mi.Ray3f(position + 1e-5 * normal, dr.normalize(direction))
        blocked += dr.select(scene.ray_test(ray, shows), 1, 0)
        dr.eval(blocked)
    light = dr.select(shows, 1 - blocked * (opaque / _GROUND_RAYS), 1)
    return gaussian_blur(np.array(light, float).reshape(height, width, 1), _SHADOW_BLUR)[..., 0]
