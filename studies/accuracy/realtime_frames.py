"""Frames of `loomlight.realtime` beside Mitsuba's direct light: FLIP of six fabrics at three distances.

Both render the same rectangle with the same model under one directional light. Two seeds of Mitsuba are
compared too: no frame can be closer than they are to each other.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import flip_mean
from loomlight.evaluation.table import Table
from loomlight.fabric import load_fabric
from loomlight.mesh.cloth_mesh import ClothMesh
from loomlight.mitsuba import material_bsdf, render
from loomlight.mitsuba.meshes import to_shape
from loomlight.mitsuba.scenes import empty_scene
from loomlight.realtime import Camera, Cloth, DirectionalLight, Environment, Renderer, rectangle
from loomlight.realtime.scene import Light
from studies.harness.study import Figures, Found, Run, Study, example, listed, listed_numbers, names

FABRICS = ("denim", "wool-houndstooth", "silk-satin", "linen", "organza", "damask")
SIDE = 0.1  # of the cloth, metres
TOWARDS = (0.5, 0.3, 0.8)


def mitsuba_frame(
    cloths: Sequence[Cloth],
    camera: Camera,
    size: tuple[int, int],
    lights: Sequence[Light] = (),
    environment: Environment | None = None,
    model: str = "point",
    spp: int = 512,
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


def compare(name: str, distance: float, model: str, samples: int = 512, side: int = 32) -> dict[str, Any]:
    """FLIP of a frame against Mitsuba, and of two seeds of Mitsuba against each other."""
    cloths = [Cloth(rectangle(SIDE, SIDE), load_fabric(example(name)))]
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


@dataclass(frozen=True)
class RealtimeFrames(Settings):
    models: str = names("point,lobes", "Models.", ("point", "lobes"))
    fabrics: str = names(",".join(FABRICS), "Example fabrics.")
    distances: str = setting("0.01,0.05,0.2", "Metres from the camera to the cloth.", metavar="M,…")
    size: int = setting(32, "Pixels a side.", low=8)
    samples: int = setting(512, "A pixel, of both.", low=1)


def measure(settings: RealtimeFrames, run: Run) -> Found:
    """All rows."""
    mi.set_variant("llvm_ad_rgb")
    rows = run.each(
        {
            f"{model}, {name}, {distance:g} m": partial(
                compare, name, distance, model, settings.samples, settings.size
            )
            for model in listed(settings.models)
            for name in listed(settings.fabrics)
            for distance in listed_numbers("distances", settings.distances)
        }
    )
    largest = max(row["flip"] for row in rows.values())
    return Found(
        {
            "size": settings.size,
            "samples": settings.samples,
            "rows": list(rows.values()),
            "largest_flip": largest,
        }
    )


def tables(figures: Figures) -> list[Table]:
    """FLIP by model, fabric and distance."""
    rows = {
        f"`{row['model']}`, {row['fabric']}, {1000 * row['distance_m']:g} mm": [
            row["flip"],
            row["flip_of_two_seeds"],
            row["brightness_ratio"],
        ]
        for row in figures["rows"]
    }
    columns = ["FLIP", "of two seeds of Mitsuba", "brightness over Mitsuba's"]
    return [Table(f"Frames of {figures['size']}² pixels against Mitsuba", columns, rows)]


_SMALL = {"models": "point", "fabrics": "denim", "distances": "0.05", "size": 8, "samples": 8}
STUDIES = (
    Study(
        "accuracy/realtime_frames",
        "frames of `loomlight.realtime` beside Mitsuba's direct light: FLIP of fabrics by distance",
        RealtimeFrames(),
        measure,
        tables,
        stands_on=("shaders", "point", "lobes"),
        small=_SMALL,
    ),
    Study(
        "accuracy/realtime_frames_256",
        "the same of `lobes`, in frames as large as they are shown",
        RealtimeFrames(models="lobes", size=256, samples=64),
        measure,
        tables,
        stands_on=("shaders", "lobes"),
        small=_SMALL,
    ),
)
