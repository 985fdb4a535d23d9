"""White furnace of cloth with light between yarns: what white cloth returns, and whether any makes light.

White cloth of three weaves, by how strongly its yarns shine, is seen from six views. Random fabrics are those
of `white_furnace.py`: all parameter ranges, limits included. Reflectance is the mean weight of the
point model's sampler over places of the repeat, light through holes included: 1 if nothing is lost. The bars
are 0.95 to 1 for the whitest cloth, and 1.02 for all.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from drjit.llvm import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from loomlight.fabric.resolve import SPECULAR
from loomlight.scattering.openness import openness_of
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from studies.accuracy.interreflection import VIEWS, WEAVES
from studies.accuracy.white_furnace import fabric
from studies.harness.study import Figures, Found, Run, Study
from studies.instruments.directions import direction

LOW, HIGH = 0.95, 1.02
HIGHLIGHTS = 0.0, SPECULAR, 1.0
# From the normal, of the views of random fabrics, degrees; the last is beyond the bar.
ANGLES = 0, 40, 75, 85


def returned(
    model: YarnScattering, size: tuple[float, float], view: NDArray[np.float64], seed: int, samples: int
) -> float:
    """Mean weight of the sampler over the repeat, the largest of the channels."""
    rng = np.random.default_rng(seed)
    x, y = (rng.random((2, samples)) * [[size[0]], [size[1]]]).astype(np.float32)
    seen = Array3f(*(np.full(samples, part, np.float32) for part in view))
    point = model.locate(Float(x), Float(y), seen)
    numbers = rng.random((3, samples)).astype(np.float32)
    sample = model.sample(point, seen, Float(numbers[0]), Array2f(numbers[1], numbers[2]))
    return float(np.array(sample.weight).astype(np.float64).mean(axis=1).max())


def white_cloth(specular: float, samples: int) -> list[dict[str, object]]:
    """Reflectance of white cloth whose yarns have so strong a highlight, by weave and view."""
    yarn = f'albedo = "#fff"\nspecular = {specular}\n'
    rows: list[dict[str, object]] = []
    for weave in WEAVES:
        cloth = fabric_from_text(f'weave = "{weave}"\ninterreflection = true\n[warp]\n{yarn}[weft]\n{yarn}')
        model = YarnScattering(YarnGeometry(cloth.layout()), cloth.appearance())
        for place in VIEWS:
            value = returned(model, cloth.repeat_mm, direction(*place), 3, samples)
            rows.append({"specular": specular, "weave": weave, "view_deg": list(place), "returned": value})
    return rows


@dataclass(frozen=True)
class InterreflectionFurnace(Settings):
    fabrics: int = setting(60, "Random fabrics.", low=1)
    seed: int = setting(1, "Of the random fabrics.", low=0)
    samples: int = setting(1 << 15, "Places of a repeat.", low=1)


def measure(settings: InterreflectionFurnace, run: Run) -> Found:
    """Reflectances of white cloth, and the largest of random fabrics."""
    require_llvm()
    rng = np.random.default_rng(settings.seed)
    seen = []
    for number in range(settings.fabrics):
        geometry, appearance = fabric(rng, between_yarns=True)
        roughness = appearance.warp.roughness, appearance.weft.roughness
        openness = openness_of(geometry.layout, appearance.diffuse_blend, roughness, appearance.optical_depth)
        model = YarnScattering(geometry, replace(appearance, openness=openness))
        views = [direction(angle, 360 * rng.random()) for angle in ANGLES]
        seen.append([returned(model, geometry.size, view, number, settings.samples) for view in views])
    white = [row for specular in HIGHLIGHTS for row in white_cloth(specular, settings.samples)]
    largest = np.array(seen).max(axis=0)
    ranges = {}
    for specular in HIGHLIGHTS:
        values = [float(str(row["returned"])) for row in white if row["specular"] == specular]
        ranges[f"specular {specular:g}"] = {"least": min(values), "most": max(values)}
    return Found(
        {
            "bars": {"white cloth": [LOW, 1.0], "any": HIGH},
            "white_cloth": ranges,
            "fabrics": settings.fabrics,
            "largest": float(largest[:-1].max()),
            "largest_by_angle": {
                f"{angle}°": float(most) for angle, most in zip(ANGLES, largest, strict=True)
            },
            "above_bar": int(np.sum(np.array(seen)[:, :-1].max(axis=1) > HIGH)),
            "rows": white,
        }
    )


def tables(figures: Figures) -> list[Table]:
    """What white cloth returns by its highlight, and the most that random fabrics do by view."""
    white = {kind: [found["least"], found["most"]] for kind, found in figures["white_cloth"].items()}
    most = {angle: [value] for angle, value in figures["largest_by_angle"].items()}
    return [
        Table("White cloth in a white furnace", ["least", "most"], white),
        Table(f"The most of {figures['fabrics']} random fabrics", ["returned"], most, "By the view's angle."),
    ]


STUDY = Study(
    "accuracy/interreflection_furnace",
    "white furnace of cloth with light between yarns: what is lost, and whether any makes light",
    InterreflectionFurnace(),
    measure,
    tables,
    stands_on=("point",),
    small={"fabrics": 2, "samples": 1 << 10},
)
