"""Fibres of a fabric in the place of its cloth in the flat scene: the same camera, lights and paper."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import ClothScene
from loomlight.mitsuba.camera import View, perspective
from loomlight.mitsuba.denoising import denoised
from loomlight.mitsuba.rendering import render
from loomlight.mitsuba.scenes import empty_scene
from loomlight.mitsuba.shapes import backdrop
from loomlight.scattering.appearance import FamilyAppearance
from studies.instruments.fibre_yarns import Window, YarnCurves, yarn_curves, yarn_makes

# Cloth around the part that is shown, in threads, and longest paths: pale fibres scatter often.
_MARGIN = 1.2
_BOUNCES, _ROULETTE, _GUIDE_SAMPLES = 64, 6, 9
# Fibres' roughness around them less that along them, as rough ones are no cylinders either.
_ROUNDER = 0.5
# Colours are kept off black and white, where absorption ends.
_COLOURS = (0.002, 0.985)


@dataclass(frozen=True)
class Shown:
    """What of the fibres is shown.

    Attributes:
        threads: across the picture.
        fibres_across: of a thread, widths of a fibre.
        points: control points of a fibre between two crossings.
        absorption: factors of what fibres absorb, linear RGB.
    """

    threads: float
    fibres_across: float = 30
    points: int = 16
    absorption: tuple[float, float, float] = (1.0, 1.0, 1.0)


def fibre_picture(
    fabric: Fabric, scene: ClothScene, shown: Shown, spp: int, seed: int = 0
) -> NDArray[np.float64]:
    """Linear RGB [height, width, 3] of fibres in the place of the cloth of a flat scene, denoised."""
    fibres = fibre_scene(fabric, scene, shown)
    paths, direct = (
        mi.load_dict({"type": "path", "max_depth": depth, "rr_depth": _ROULETTE}) for depth in (_BOUNCES, 2)
    )
    normals = mi.load_dict({"type": "aov", "aovs": "normal:sh_normal"})
    halves = [
        render(fibres, spp=max(spp // 2, 1), seed=2 * seed + half, integrator=paths).astype(np.float64)
        for half in (0, 1)
    ]
    guides = [render(fibres, spp=_GUIDE_SAMPLES, seed=seed, integrator=guide) for guide in (normals, direct)]
    light = guides[1] / max(float(guides[1].mean()), 1e-6)
    return denoised(halves, np.concatenate([guides[0][..., -3:], light], axis=-1).astype(np.float32))


def fibre_scene(fabric: Fabric, scene: ClothScene, shown: Shown) -> mi.Scene:
    """The flat scene in millimetres, with fibres around the middle of its cloth and a sheet around them.

    Mitsuba's rays leave surfaces by ten-thousandths of the scene's unit: metres would lead out of fibres.
    """
    layout = fabric.layout()
    spacing = float(layout.warp.spacing.mean())
    middle = 0.5 * np.array(fabric.default_uv_size_mm)
    reach = spacing * (0.5 * shown.threads + _MARGIN)
    window = Window(*(middle - reach), *(middle + reach))
    curves = yarn_curves(fabric, window, yarn_makes(fabric, shown.fibres_across), shown.points)
    appearance = fabric.appearance()
    width, height = (int(size) for size in scene.scene.sensors()[0].film().size())
    paper = next(shape for shape in scene.scene.shapes() if shape.id() == "backdrop")
    view = View(1e3 * scene.view.origin, 1e3 * scene.view.target)
    # For the denoiser samples count in their own pixels alone.
    sensor = perspective(view, (width, height))
    sensor["film"]["rfilter"] = {"type": "box"}
    parts: dict[str, Any] = {
        **empty_scene(),
        "sensor": sensor,
        "light": scene.scene.emitters()[0],
        "backdrop": backdrop(np.zeros(3), float(middle.max()), 1e3 * float(paper.bbox().min.z)),
    }
    # By family and colour: kernels of fabrics with as many shapes are the same.
    groups: dict[tuple[bool, tuple[float, ...]], list[YarnCurves]] = {}
    for thread in curves:
        colour = fibre_colour(appearance.warp if thread.is_warp else appearance.weft, thread.thread)
        groups.setdefault((thread.is_warp, tuple(colour.tolist())), []).append(thread)
    with TemporaryDirectory() as folder:
        for number, ((is_warp, colours), threads) in enumerate(groups.items()):
            roughness = (appearance.warp if is_warp else appearance.weft).roughness
            parts[f"fibres{number}"] = _shape(
                [line - [*middle, 0] for thread in threads for line in (*thread.fibres, *thread.hairs)],
                threads[0].radius,
                fibre_bsdf(np.array(colours), roughness, shown.absorption),
                Path(folder),
            )
    mean = np.mean([fibre_colour(family, 0) for family in (appearance.warp, appearance.weft)], axis=0)
    parts |= _around(reach, float(middle.min()), mean, layout.open_area)
    return mi.load_dict(parts)


def fibre_colour(family: FamilyAppearance, thread: int) -> NDArray[np.float64]:
    """All that a thread scatters, to either side, linear RGB."""
    row = thread % len(family.diffuse_reflect)
    albedo = (
        family.diffuse_reflect[row]
        + family.diffuse_transmit[row]
        + 0.5 * np.maximum(family.specular_reflect[row], family.specular_transmit[row])
    )
    return np.clip(albedo, *_COLOURS)


def fibre_bsdf(
    colour: NDArray[np.float64], roughness: float, factors: tuple[float, float, float] = (1.0, 1.0, 1.0)
) -> dict[str, Any]:
    """Mitsuba's hair: absorption after Chiang et al. 2016, eq. 9, and a highlight like the layer.

    The layer's D(h) falls to half at 0.64 α from the fibre's normal plane, outgoing light at twice the angle;
    hair of longitudinal roughness β has Gaussians of the variance (0.726 β + 0.812 β²)².
    """
    n = min(_ROUNDER + roughness, 1)
    divisor = 5.969 - 0.215 * n + 2.532 * n**2 - 10.73 * n**3 + 5.574 * n**4 + 0.245 * n**5
    absorption = (np.log(colour) / divisor) ** 2 * factors
    deviation = 2 * 0.64 * roughness / math.sqrt(2 * math.log(2))
    longitudinal = (-0.726 + math.sqrt(0.726**2 + 4 * 0.812 * deviation)) / (2 * 0.812)
    return {
        "type": "hair",
        "sigma_a": {"type": "rgb", "value": absorption.tolist()},
        "longitudinal_roughness": longitudinal,
        "azimuthal_roughness": n,
        "scale_tilt": 0.0,
    }


def _shape(lines: list[NDArray[np.float64]], radius: float, bsdf: dict[str, Any], folder: Path) -> Any:
    """Curves of one colour; what a file would hold goes straight into the shape."""
    file = folder / "one.txt"
    file.write_text("\n".join(f"{x} 0 0 1" for x in range(4)))
    shape = mi.load_dict({"type": "bsplinecurve", "filename": str(file), "bsdf": bsdf})
    counts = np.array([len(line) for line in lines])
    starts = np.cumsum(counts) - counts
    points = np.concatenate(lines)
    segments = np.concatenate(
        [start + np.arange(count - 3) for start, count in zip(starts, counts, strict=True)]
    )
    params = mi.traverse(shape)
    rows = np.column_stack([points, np.full(len(points), radius)])
    params["control_points"] = mi.Float(rows.ravel().astype(np.float32))
    params["segment_indices"] = mi.UInt32(segments.astype(np.uint32))
    params["control_point_count"] = len(points)
    params.update()
    return shape


def _around(inner: float, outer: float, colour: NDArray[np.float64], open_share: float) -> dict[str, Any]:
    """A sheet around the fibres, as open as the cloth: half sides in millimetres."""
    bsdf = {
        "type": "mask",
        "opacity": 1 - open_share,
        "nested": {
            "type": "twosided",
            "nested": {"type": "diffuse", "reflectance": {"type": "rgb", "value": colour.tolist()}},
        },
    }
    half, middle = 0.5 * (outer - inner), 0.5 * (outer + inner)
    sides = {
        "left": (-middle, 0, half, outer),
        "right": (middle, 0, half, outer),
        "below": (0, -middle, inner, half),
        "above": (0, middle, inner, half),
    }
    return {
        name: {
            "type": "rectangle",
            "to_world": mi.ScalarTransform4f().translate([x, y, -0.1]).scale([wide, high, 1]),
            "bsdf": bsdf,
        }
        for name, (x, y, wide, high) in sides.items()
    }
