"""Points of cloth with footprints, as an integrator hands them to a BSDF, and what BSDFs make of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from loomlight.core.backend import upload, upload_vector
from loomlight.mitsuba.props import _field
from loomlight.models.bake import bake, save
from loomlight.models.registry import MODELS, model_class
from tests.helpers.directions import unit_vectors
from tests.helpers.fabrics import CHEAPEST as FABRIC_CHEAPEST


def vectors(values: np.ndarray) -> Any:
    """Rows [n, 3] as Mitsuba's vectors."""
    return upload_vector(mi.Vector3f, values.T)


def interactions(uv: np.ndarray, views: np.ndarray, sides: np.ndarray) -> Any:
    """Points of cloth in the identity frame; footprints are squares of these sides in uv."""
    count = len(uv)
    si = dr.zeros(mi.SurfaceInteraction3f, count)
    si.uv = upload_vector(mi.Point2f, uv.T)
    si.n = mi.Normal3f(0, 0, 1)
    si.sh_frame = mi.Frame3f(mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0), mi.Vector3f(0, 0, 1))
    si.dp_du, si.dp_dv = mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0)
    si.wi = vectors(views)
    si.t = mi.Float(1)
    side = upload(mi.Float, sides)
    si.duv_dx, si.duv_dy = mi.Vector2f(side, 0), mi.Vector2f(0, side)
    return si


def random_interactions(count: int, seed: int = 0) -> tuple[Any, np.ndarray, np.ndarray, np.ndarray]:
    """Points, and what they are of: uv, views, and sides of 0.01 to 0.5."""
    rng = np.random.default_rng(seed)
    uv, views = rng.random((count, 2)), unit_vectors(rng, count)
    sides = np.exp(rng.uniform(np.log(0.01), np.log(0.5), count))
    return interactions(uv, views, sides), uv, views, sides


def side_by_side(*cloths: dict[str, Any]) -> Any:
    """A scene of squares of cloth beside each other, 16 by 16 pixels each, under one light."""
    width = len(cloths)
    pieces = {
        f"cloth {number}": {
            "type": "rectangle",
            "to_world": mi.ScalarTransform4f().translate([2.0 * number + 1 - width, 0, 0]),
            "bsdf": cloth,
        }
        for number, cloth in enumerate(cloths)
    }
    rest = {
        "type": "scene",
        "light": {"type": "directional", "direction": [0.3, -0.2, -1]},
        "sensor": {
            "type": "orthographic",
            "to_world": mi.ScalarTransform4f().look_at([0, 0, 5], [0, 0, 0], [0, 1, 0])
            @ mi.ScalarTransform4f().scale([width, 1, 1]),
            "film": {"type": "hdrfilm", "width": 16 * width, "height": 16, "rfilter": {"type": "box"}},
        },
    }
    return mi.load_dict(rest | pieces)


def mean_value(bsdf: Any) -> np.ndarray:
    """What 500 points give back of one light, in the mean [3]."""
    si, *_ = random_interactions(500, seed=4)
    return np.array(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(0.1, 0.2, 0.97))).mean(axis=1)


def pretrained(cloth: dict[str, Any], folder: Path) -> dict[str, Any]:
    """A BSDF of an inline fabric; of a model that is trained the same by a `.loom`, which `folder` keeps."""
    name = next(name for name, entry in MODELS.items() if entry.plugin == cloth["type"])
    if not model_class(name).trains:
        return cloth
    inline = {key: value for key, value in cloth.items() if _field(key) is not None}
    fabric = mi.load_dict({"type": "woven_point", **inline}).model.fabric
    file = folder / f"{len(list(folder.iterdir()))}.loom"
    save(bake(fabric, name), file)
    return {key: value for key, value in cloth.items() if key not in inline} | {"fabric": str(file)}


# Options of the cheapest bakes: what holds for any holds for these.
CHEAPEST = {MODELS[name].plugin: options for name, options in FABRIC_CHEAPEST.items()}
CHEAPEST["woven_samples"] = {"points": 2}
# Open cloth of translucent yarns, 4 mm a unit of uv.
TWILL = {
    "weave": "twill 2/1",
    "warp_color": "#c08040",
    "weft_color": "#4060c0",
    "warp_translucency": 0.3,
    "gap": 0.2,
    "uv_size": "4,4",
}


def woven(plugin: str, folder: Path | None = None, **parameters: Any) -> Any:
    """The BSDF of a cloth.

    Args:
        folder: of the `.loom` of a model that is trained.
        parameters: beside those of `TWILL`, or in their place.
    """
    cloth = {"type": plugin, **CHEAPEST.get(plugin, {}), **TWILL, **parameters}
    return mi.load_dict(cloth if folder is None else pretrained(cloth, folder))
