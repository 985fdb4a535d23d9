"""The picture of a page's stage by Mitsuba, for pages whose own adapter takes minutes for it.

The page sends what it shows: the fabric, its mesh, camera, lights and background. So the picture is of the same
scene, from the same place; it has light between folds of the cloth no more than the page's own.
"""

from __future__ import annotations

import io
import json
import struct
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.viewer.fabric_json import fabric_of_json

# Of a request, with a mesh of a million triangles; and sides of a picture, pixels.
MAX_BYTES = 96 << 20
MAX_SIDE = 4096
SAMPLES = 8
# Rays that a pixel of the ground sends, and the lamp's radius: as `shaders/layers.slang:ground_light`, which adds
# up 4 in each of its passes.
_GROUND_RAYS, _LAMP_RADIUS = 16, 0.176
# Deviation, pixels: soft shadows lose their noise.
_SHADOW_BLUR = 2.5

Tensors = Mapping[str, NDArray[Any]]


@dataclass(frozen=True)
class Stage:
    """What a page shows. Lengths are metres, radiance is linear RGB.

    Attributes:
        fabric: what is woven.
        mesh: "positions", "normals" [n, 3], "uv" [n, 2] and "triangles" [m, 3].
        uv_size_mm: millimetres per unit of u and of v.
        size: width and height of the picture, pixels.
        origin, target: of the camera.
        towards, irradiance: of the lamp; None for no lamp.
        environment: radiance [rows, columns, 3], the top row first; None for none.
        turn: of it about the vertical, degrees.
        background: radiance beside the cloth.
        ground: unit normal, offset, and the lamp's share in its light.
        exposure: stops.
    """

    fabric: Fabric
    mesh: Tensors
    uv_size_mm: tuple[float, float]
    size: tuple[int, int]
    origin: NDArray[np.float64]
    target: NDArray[np.float64]
    towards: NDArray[np.float64] | None
    irradiance: NDArray[np.float64]
    environment: NDArray[np.float32] | None
    turn: float
    background: NDArray[np.float64]
    ground: tuple[NDArray[np.float64], float, float]
    exposure: float


def stage_of(content: bytes) -> Stage:
    """The stage that a page describes: a safetensors file, whose metadata holds the rest as JSON in "stage".

    Raises:
        InputError: content that is none, or a value that cannot be.
    """
    from safetensors.numpy import load

    try:
        (length,) = struct.unpack_from("<Q", content)
        said = json.loads(json.loads(content[8 : 8 + length])["__metadata__"]["stage"])
        tensors = load(content)
        width, height = (int(side) for side in said["size"])
        lamp, ground = said["lamp"], said["ground"]
        stage = Stage(
            fabric=fabric_of_json(said["fabric"]),
            mesh={name: tensors[name] for name in ("positions", "normals", "uv", "triangles")},
            uv_size_mm=(float(said["uvSizeMm"][0]), float(said["uvSizeMm"][1])),
            size=(width, height),
            origin=_vector(said["camera"]["origin"]),
            target=_vector(said["camera"]["target"]),
            towards=None if lamp is None else _vector(lamp["towards"]),
            irradiance=_vector([0, 0, 0] if lamp is None else lamp["irradiance"]),
            environment=tensors.get("environment"),
            turn=float(said["turn"]),
            background=_vector(said["background"]),
            ground=(_vector(ground["normal"]), float(ground["offset"]), float(ground["lampShare"])),
            exposure=float(said["exposure"]),
        )
    except InputError:
        raise
    except Exception as error:  # content of any kind
        raise InputError(f"The request describes no stage of a page ({type(error).__name__}).") from error
    if not (1 <= width <= MAX_SIDE and 1 <= height <= MAX_SIDE):
        raise InputError(f"size = {width} × {height} is out of range: 1 to {MAX_SIDE} pixels each way.")
    return stage


def stage_picture(stage: Stage) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] of a stage, by direct light as the page has it.

    Raises:
        InputError: a mesh or a fabric that cannot be shown.
        MissingDependencyError: no usable LLVM library.
    """
    from loomlight.mitsuba.variants import choose_variant

    choose_variant(None)
    import mitsuba as mi

    from loomlight.mesh.cloth_mesh import ClothMesh, checked
    from loomlight.mitsuba.camera import View, perspective
    from loomlight.mitsuba.material import material_bsdf
    from loomlight.mitsuba.meshes import to_shape
    from loomlight.mitsuba.rendering import render
    from loomlight.mitsuba.scenes import empty_scene

    arrays = (np.asarray(stage.mesh[name], float) for name in ("positions", "normals", "uv"))
    mesh = checked(ClothMesh(*arrays, np.asarray(stage.mesh["triangles"], np.int64), "The page's mesh"))
    sensor = perspective(View(stage.origin, stage.target), stage.size)
    sensor["film"]["pixel_format"] = "rgba"
    # Light that comes from cloth, by one reflection.
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": 2, "hide_emitters": True})
    parts: dict[str, Any] = {**empty_scene(), "integrator": integrator, "sensor": sensor}
    parts["cloth"] = to_shape(mesh, material_bsdf(stage.fabric)(stage.uv_size_mm))
    if stage.towards is not None:
        irradiance = {"type": "rgb", "value": stage.irradiance.tolist()}
        parts["lamp"] = {
            "type": "directional",
            "direction": (-stage.towards).tolist(),
            "irradiance": irradiance,
        }
    if stage.environment is not None:
        parts["environment"] = {
            "type": "envmap",
            "bitmap": mi.Bitmap(np.ascontiguousarray(stage.environment, np.float32)),
            "to_world": mi.ScalarTransform4f().rotate([0, 1, 0], stage.turn),
        }
    scene = mi.load_dict(parts)
    picture = render(scene, spp=SAMPLES, integrator=integrator)
    light = _ground_light(scene, stage)[..., None]
    behind = (1 - np.clip(picture[..., 3:], 0, 1)) * light * stage.background
    return np.asarray(2.0**stage.exposure * (picture[..., :3] + behind), np.float32)


def _ground_light(scene: Any, stage: Stage) -> NDArray[np.float64]:
    """Share of its light that the cloth leaves the ground [height, width], where a pixel's ray meets it."""
    import drjit as dr
    import mitsuba as mi

    from loomlight.mitsuba.denoising import gaussian_blur

    width, height = stage.size
    pixel = dr.arange(mi.UInt32, width * height)
    place = mi.Point2f(
        (mi.Float(pixel % width) + 0.5) / width,
        (mi.Float(pixel // width) + 0.5) / height,
    )
    camera, _ = scene.sensors()[0].sample_ray(0, 0, place, mi.Point2f(0))
    unit, offset, lamp_share = stage.ground
    normal = mi.Vector3f(unit)
    above, along = dr.dot(normal, mi.Vector3f(stage.origin)) - offset, dr.dot(normal, camera.d)
    shows = (above > 0) & (along < 0)
    position = camera.o - camera.d * dr.select(shows, above / along, 0)
    lamp = mi.Vector3f([0, 1, 0] if stage.towards is None else stage.towards / np.linalg.norm(stage.towards))
    numbers = mi.load_dict({"type": "independent"})
    numbers.seed(0, width * height)
    blocked = mi.Float(0)
    for _ in range(_GROUND_RAYS):
        of_lamp = numbers.next_1d() < lamp_share
        sphere = mi.warp.square_to_uniform_sphere(numbers.next_2d())
        # A normal and a point of the unit sphere about its tip: directions in proportion to their cosine.
        towards = dr.select(of_lamp, lamp + _LAMP_RADIUS * sphere, normal + 0.9999 * sphere)
        ray = mi.Ray3f(position + 1e-5 * normal, dr.normalize(towards))
        blocked += dr.select(scene.ray_test(ray, shows), 1, 0)
        dr.eval(blocked)
    opaque = 1 - stage.fabric.layout().open_area
    light = dr.select(shows, 1 - blocked * (opaque / _GROUND_RAYS), 1)
    return gaussian_blur(np.asarray(light, float).reshape(height, width, 1), _SHADOW_BLUR)[..., 0]


def stage_png(content: bytes) -> bytes:
    """The PNG of a stage; see `stage_of` and `stage_picture`."""
    from PIL import Image

    from loomlight.core.colour import linear_to_srgb

    linear = stage_picture(stage_of(content))
    pixels = np.round(255 * linear_to_srgb(np.clip(linear, 0, 1))).astype(np.uint8)
    Image.fromarray(pixels).save(stream := io.BytesIO(), "png", compress_level=1)
    return stream.getvalue()


def _vector(values: Any) -> NDArray[np.float64]:
    vector = np.array([float(value) for value in values])
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise InputError(f"{values!r} is no vector of three numbers.")
    return vector
