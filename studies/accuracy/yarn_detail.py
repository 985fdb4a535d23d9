"""Yarns close up against smooth yarns: do means stay, and what does the detail cost?

    python -m studies.accuracy.yarn_detail [--points N] [--output FILE.json]

The same points of 2/2 twill, all over 200 mm of it, with and without detail: reflectance under a dome, seen
from 8° and from 52°, and f·cos of lights from three directions. Points are paired, so that deviations are
those of the detail alone. The cost is that of the point model's values, search included, over that of smooth
yarns.
"""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from time import process_time

import drjit as dr
import numpy as np
from drjit.llvm import Array3f, Float
from numpy.typing import NDArray

from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.fabric.fields import YARNS
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from studies.instruments.harness import Figures, run

COLOURS = {"white": "#ffffff", "dark": "#806040"}
VIEWS = {"8°": (0.1, 0.1, 0.99), "52°": (0.6, 0.5, 0.62)}
LIGHTS = {"above": (0.05, 0.02, 1.0), "45°": (0.5, -0.5, 0.7), "60°": (-0.8, 0.3, 0.5)}
# A two-thousandth of a thread: everything shows.
SIDE = 2.5e-4
MAX = 0.01


def vectors(rows: NDArray[np.float64]) -> Array3f:
    return Array3f(*(Float(np.ascontiguousarray(column, np.float32)) for column in rows.T))


def unit(direction: tuple[float, float, float], count: int) -> Array3f:
    row = np.array(direction) / np.linalg.norm(direction)
    return vectors(np.tile(row, (count, 1)))


def dome(rng: np.random.Generator, count: int) -> Array3f:
    """Directions whose density is their cosine over π."""
    u, azimuth = rng.random(count), 2 * math.pi * rng.random(count)
    return vectors(
        np.stack([np.sqrt(u) * np.cos(azimuth), np.sqrt(u) * np.sin(azimuth), np.sqrt(1 - u)], axis=1)
    )


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
    lights = {"dome": dome(rng, count), **{name: unit(light, count) for name, light in LIGHTS.items()}}
    found = {}
    for view_name, view in VIEWS.items():
        for light_name, light in lights.items():
            smooth, close = (
                np.asarray(values(model, (x, y), light, unit(view, count), shows).numpy(), np.float64)
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
    light, view = unit(LIGHTS["45°"], count), unit(VIEWS["52°"], count)
    times = {False: math.inf, True: math.inf}
    for _ in range(4):  # the first compiles
        for shows in times:
            start = process_time()
            dr.sync_thread()
            values(model, (x, y), light, view, shows).numpy()
            times[shows] = min(times[shows], process_time() - start)
    return times[True] / times[False]


def measure(options: Namespace) -> Figures:
    require_llvm()
    figures: Figures = {"differences": {}, "deviations": {}, "cost": {}, "missed": []}
    print(
        "| `yarn` | colour | dome, 8° | dome, 52° | largest of six directions | cost |\n"
        "|---|---|---|---|---|---|"
    )
    for name in YARNS:
        for colour, code in COLOURS.items():
            colours = f'[warp]\ncolor = "{code}"\n[weft]\ncolor = "{code}"\n'
            even = "variation.irregularity = 0\n"
            fabric = fabric_from_text(f'weave = "twill 2/2"\nyarn = "{name}"\n{even}{colours}')
            model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())
            found = differences(model, options.points)
            key = f"{name}, {colour}"
            figures["differences"][key] = {what: value for what, (value, _) in found.items()}
            figures["deviations"][key] = {what: deviation for what, (_, deviation) in found.items()}
            domes = [found[f"dome, seen from {view}"] for view in VIEWS]
            figures["missed"] += [key] * any(abs(value) > MAX + 2 * error for value, error in domes)
            directed = max((value for what, (value, _) in found.items() if "dome" not in what), key=abs)
            figures["cost"][key] = cost(model, options.points)
            shown = " | ".join(f"{100 * value:+.2f} ± {100 * error:.2f} %" for value, error in domes)
            print(
                f"| {name} | {colour} | {shown} | {100 * directed:+.1f} % | {figures['cost'][key]:.2f} |",
                flush=True,
            )
    return figures


def add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--points", type=int, default=100_000)


if __name__ == "__main__":
    run(measure, add_options, prints=False)
