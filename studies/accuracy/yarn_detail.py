"""Yarns close up against smooth yarns: do means stay, and what does the detail cost?

The same points of 2/2 twill, all over 200 mm of it, with and without detail: reflectance under a dome, seen
from 8° and from 52°, and f·cos of lights from three directions. Points are paired, so that deviations are
those of the detail alone. The cost is that of the point model's values, search included, over that of smooth
yarns.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import drjit as dr
import numpy as np
from drjit.llvm import Array3f, Float

from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric import fabric_from_text
from loomlight.fabric.fields import YARNS
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.directions import as_vectors, by_cosine, copies
from studies.instruments.timing import least_times

COLOURS = {"white": "#ffffff", "dark": "#806040"}
VIEWS = {"8°": (0.1, 0.1, 0.99), "52°": (0.6, 0.5, 0.62)}
LIGHTS = {"above": (0.05, 0.02, 1.0), "45°": (0.5, -0.5, 0.7), "60°": (-0.8, 0.3, 0.5)}
# A two-thousandth of a thread: everything shows.
SIDE = 2.5e-4
MAX = 0.01


def values(
    model: YarnScattering, at: tuple[Float, Float], light: Array3f, view: Array3f, close: bool
) -> Float:
    """Means over the channels of f·cos, over the cosine of the light."""
    point = model.locate(*at, view, size=Float(SIDE) if close else None)
    value = model.evaluate(point, light, view)
    mean = (value.x + value.y + value.z) * dr.rcp(3 * light.z)
    dr.eval(mean)
    return mean


def differences(model: YarnScattering, count: int) -> dict[str, tuple[float, float]]:
    """Relative differences of means, and their deviations, by light and view."""
    rng = np.random.default_rng(1)
    x, y = (Float((200 * rng.random(count)).astype(np.float32)) for _ in range(2))
    lights = {
        "dome": as_vectors(by_cosine(rng, count)),
        **{name: copies(light, count) for name, light in LIGHTS.items()},
    }
    found = {}
    for view_name, view in VIEWS.items():
        for light_name, light in lights.items():
            smooth, close = (
                np.asarray(values(model, (x, y), light, copies(view, count), shows).numpy(), np.float64)
                for shows in (False, True)
            )
            change = (close - smooth) / smooth.mean()
            found[f"{light_name}, seen from {view_name}"] = (
                float(change.mean()),
                float(change.std() / math.sqrt(count)),
            )
    return found


def cost(model: YarnScattering, count: int) -> float:
    """CPU time with detail over that without, of the faster of three."""
    rng = np.random.default_rng(2)
    x, y = (Float((200 * rng.random(count)).astype(np.float32)) for _ in range(2))
    light, view = copies(LIGHTS["45°"], count), copies(VIEWS["52°"], count)
    runs = [lambda shows=shows: values(model, (x, y), light, view, shows).numpy() for shows in (False, True)]
    least_times(runs, 1)  # compiles
    smooth, close = least_times(runs, 3)
    return close.cpu_seconds / smooth.cpu_seconds


@dataclass(frozen=True)
class YarnDetail(Settings):
    points: int = setting(100_000, "Points of the cloth.", low=2)
    yarns: str = names(",".join(YARNS), "Kinds of yarn.", tuple(YARNS))


def measure(settings: YarnDetail, run: Run) -> Found:
    require_llvm()
    figures: Figures = {"differences": {}, "deviations": {}, "cost": {}, "missed": []}
    for name in listed(settings.yarns):
        for colour, code in COLOURS.items():
            colours = f'[warp]\ncolor = "{code}"\n[weft]\ncolor = "{code}"\n'
            even = "variation.irregularity = 0\n"
            fabric = fabric_from_text(f'weave = "twill 2/2"\nyarn = "{name}"\n{even}{colours}')
            model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())
            found = differences(model, settings.points)
            key = f"{name}, {colour}"
            figures["differences"][key] = {what: value for what, (value, _) in found.items()}
            figures["deviations"][key] = {what: deviation for what, (_, deviation) in found.items()}
            domes = [found[f"dome, seen from {view}"] for view in VIEWS]
            figures["missed"] += [key] * any(abs(value) > MAX + 2 * error for value, error in domes)
            figures["cost"][key] = cost(model, settings.points)
    return Found(figures)


def tables(figures: Figures) -> list[Table]:
    """Changes by yarn and colour; the bar is on those under a dome."""
    columns = ["dome, 8°", "dome, 52°", "largest of six directions", "cost"]
    rows: dict[str, list[Cell]] = {}
    for name, found in figures["differences"].items():
        domes = [f"dome, seen from {view}" for view in VIEWS]
        directed = max((value for what, value in found.items() if what not in domes), key=abs)
        deviations = figures["deviations"][name]
        means: list[Cell] = [f"{100 * found[what]:+.2f} ± {100 * deviations[what]:.2f} %" for what in domes]
        rows[name] = [*means, f"{100 * directed:+.1f} %", figures["cost"][name]]
    return [Table("Yarns close up against smooth yarns", columns, rows)]


STUDY = Study(
    "accuracy/yarn_detail",
    "yarns close up against smooth yarns: means, and what the detail costs",
    YarnDetail(),
    measure,
    tables,
    stands_on=("point",),
    small={"points": 1000, "yarns": "cotton"},
)
