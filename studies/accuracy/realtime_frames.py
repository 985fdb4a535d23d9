"""Frames of `loomlight.realtime` beside Mitsuba's direct light: FLIP of six fabrics at three distances.

    python -m studies.accuracy.realtime_frames [--output FILE.json]

Both render the same rectangle with the same model under one directional light. Two seeds of Mitsuba are
compared too: no frame can be closer than they are to each other.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.evaluation.metrics import flip_mean
from loomlight.fabric import load_fabric
from loomlight.mesh.cloth_mesh import ClothMesh
from loomlight.mitsuba import material_bsdf, render
from loomlight.mitsuba.meshes import to_shape
from loomlight.mitsuba.scenes import empty_scene
from loomlight.realtime import Camera, Cloth, DirectionalLight, Environment, Renderer, rectangle
from loomlight.realtime.scene import Light
from studies.instruments.harness import REPOSITORY, Figures, run

EXAMPLES = REPOSITORY / "examples"
FABRICS = ("denim", "wool-houndstooth", "silk-satin", "linen", "organza", "damask")
DISTANCES = (0.01, 0.05, 0.2)  # metres
SIDE, SIZE, SAMPLES = 0.1, 32, 512
TOWARDS = (0.5, 0.3, 0.8)


def mitsuba_frame(
    cloths: Sequence[Cloth],
    camera: Camera,
    size: tuple[int, int],
    lights: Sequence[Light] = (),
    environment: Environment | None = None,
    model: str = "point",
    spp: int = SAMPLES,
    seed: int = 0,
) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] of the same scene by Mitsuba: direct light, box filter."""
    place = mi.ScalarTransform4f()
    film = {"type": "hdrfilm", "width": size[0], "height": size[1], "rfilter": {"type": "box"}}
    parts: dict[str, Any] = {
        **empty_scene(),
        "integrator": {"type": "footprint_path", "max_depth": 2},
        "sensor": {
            "type": "perspective",
            "fov": camera.field_of_view,
            "fov_axis": "smaller",
            "near_clip": camera.near,
            "to_world": place.look_at(
                *([float(part) for part in vector] for vector in (camera.origin, camera.target, camera.up))
            ),
            "film": {**film, "pixel_format": "rgb"},
        },
    }
    for number, cloth in enumerate(cloths):
        mesh = cloth.mesh
        shape = ClothMesh(
            mesh.positions, mesh.normals, mesh.uv, mesh.faces.astype(np.int64), f"cloth{number}"
        )
        texture = None if cloth.albedo is None else _texture(cloth.albedo)
        bsdf = material_bsdf(cloth.fabric, model, albedo=texture)(cloth.uv_size_mm)
        parts[f"cloth{number}"] = to_shape(shape, bsdf)
    for number, light in enumerate(lights):
        is_point, vector, colour = light.record()
        rgb = {"type": "rgb", "value": colour.tolist()}
        parts[f"light{number}"] = (
            {"type": "point", "position": vector.tolist(), "intensity": rgb}
            if is_point
            else {"type": "directional", "direction": (-vector).tolist(), "irradiance": rgb}
        )
    if environment is not None:
        parts["environment"] = {
            "type": "envmap",
            "bitmap": mi.Bitmap(np.asarray(environment.radiance, np.float32)),
            "to_world": place.rotate([0, 1, 0], environment.turn),
        }
    return render(mi.load_dict(parts), spp=spp, seed=seed)


def _texture(albedo: NDArray[np.floating]) -> dict[str, Any]:
    return {"type": "bitmap", "bitmap": mi.Bitmap(np.asarray(albedo, np.float32)), "raw": True}


def compare(
    name: str, distance: float, model: str, samples: int = SAMPLES, side: int = SIZE
) -> dict[str, Any]:
    """FLIP of a frame against Mitsuba, and of two seeds of Mitsuba against each other."""
    cloths = [Cloth(rectangle(SIDE, SIDE), load_fabric(EXAMPLES / f"{name}.toml"))]
    camera = Camera((0, -0.6 * distance, 0.8 * distance))
    lights = [DirectionalLight(TOWARDS)]
    size = (side, side)
    renderer = Renderer(cloths, size, model)
    # One pass of `lobes` takes the points of Mitsuba's estimate; others are nearer to the truth.
    passes = 8 if model == "point" else 1
    found = renderer.render(camera, lights, passes=passes, samples=samples // passes).linear[..., :3]
    first, second = (
        mitsuba_frame(cloths, camera, size, lights, model=model, spp=samples, seed=s) for s in (0, 1)
    )
    whole = np.ones(size, bool)
    return {
        "fabric": name,
        "distance_m": distance,
        "model": model,
        "flip": round(float(flip_mean(found, first, whole)), 4),
        "flip_of_two_seeds": round(float(flip_mean(second, first, whole)), 4),
        "brightness_ratio": round(float(found.mean() / first.mean()), 4),
    }


def measure(arguments: Namespace) -> Figures:
    """All rows."""
    mi.set_variant("llvm_ad_rgb")
    rows = [
        compare(name, distance, model, arguments.samples, arguments.size)
        for model in arguments.models.split(",")
        for name in arguments.fabrics.split(",")
        for distance in DISTANCES
    ]
    largest = max(row["flip"] for row in rows)
    return {"size": arguments.size, "samples": arguments.samples, "rows": rows, "largest_flip": largest}


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--models", default="point,lobes", help="point, lobes, or both")
    parser.add_argument("--fabrics", default=",".join(FABRICS), help="names of examples")
    parser.add_argument("--size", type=int, default=SIZE, help="pixels a side")
    parser.add_argument("--samples", type=int, default=SAMPLES, help="a pixel, of both")


if __name__ == "__main__":
    run(measure, _add_options)
