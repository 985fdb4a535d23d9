"""How much less noise `samples` has than `point` from afar, by MSE × processor time.

    python -m studies.speed.cell_places [--output FILE.json]

Drape and cylinder of the image benchmark at ten yarns a pixel: one directional light, direct light only, box
filter, pixels wholly on cloth; `--light studio` is an environment. Against `point` at 64 samples a pixel
stand paths of several points each, spread over the primitive cell of the weave. The reference is `point` with
1024 samples. Every picture of a comparison is taken in one process; an efficiency of 5 is a fifth of the MSE
in equal processor time.
"""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.fabric import Fabric, fabric_from_text
from loomlight.mitsuba import LIGHTS, choose_variant, render, shapes
from loomlight.mitsuba.measured_scenes import MeasuredShot, shot_scene
from loomlight.mitsuba.plugins import material_bsdf
from studies.instruments.harness import Figures, run

_YARNS = 10.0
SHOTS = {
    "drape": MeasuredShot((shapes.drape,), (0.35, 0.55, 1.0), (-0.6, 0.75, 0.6), _YARNS),
    "cylinder": MeasuredShot((shapes.cylinder,), (0.0, 0.0, 1.0), (1.0, 0.35, 0.4), _YARNS, zoom=1.2),
}
# Efficiency to reach.
BARS = {"drape": 5.0, "cylinder": 3.0}
# Paths a pixel and points a path; `point` itself has 0.
ROWS = ((64, 0), (4, 16), (4, 64), (16, 16), (64, 16))
REFERENCE_PATHS, SEEDS = 1024, 3


def picture(shot: MeasuredShot, fabric: Fabric, size: tuple[int, int], points: int) -> Any:
    """A function from samples a pixel and a seed to the pixels that count [n, 3]."""
    options: dict[str, Any] = {"points": points} if points else {}
    bsdf = material_bsdf(fabric, "samples" if points else "point", **options)
    made = shot_scene(shot, [(fabric, bsdf)], size)

    def take(samples: int, seed: int) -> NDArray[np.float64]:
        film = render(made.scene, spp=samples, seed=seed, integrator=made.integrator, denoise="off")
        return np.asarray(film, np.float64)[made.counted][:, :3]

    return take


def compared(shot: MeasuredShot, fabric: Fabric, size: tuple[int, int]) -> list[dict[str, Any]]:
    """A row for each number of paths and points, `point` itself first."""
    reference = picture(shot, fabric, size, 0)(REFERENCE_PATHS, 1)
    rows: list[dict[str, Any]] = []
    for paths, points in ROWS:
        take = picture(shot, fabric, size, points)
        take(paths, 2)
        start = time.process_time()
        films = [take(paths, 3 + seed) for seed in range(SEEDS)]
        seconds = (time.process_time() - start) / SEEDS
        mse = float(np.mean([np.square(film - reference).mean() for film in films]))
        row: dict[str, Any] = {"paths": paths, "points": points, "mse": mse, "cpu_seconds": seconds}
        row["relative_bias"] = float(np.mean([film.mean() for film in films]) / reference.mean() - 1)
        first = rows[0] if rows else row
        row["efficiency"] = first["mse"] * first["cpu_seconds"] / (mse * seconds)
        rows.append(row)
        print(row, flush=True)
    return rows


def add_options(parser: ArgumentParser) -> None:
    """Which weaves, and the size of pictures."""
    parser.add_argument("--size", default="160x120")
    parser.add_argument("--weaves", default="satin 8/3")
    parser.add_argument("--light", default="directional", choices=LIGHTS)


def measure(options: Namespace) -> Figures:
    """Every scene and weave, and those whose best row misses its bar."""
    choose_variant()
    width, height = (int(side) for side in options.size.split("x"))
    shots = {name: replace(shot, light=options.light) for name, shot in SHOTS.items()}
    runs = {
        f"{name}, {weave}": compared(shot, fabric_from_text(weave), (width, height))
        for name, shot in shots.items()
        for weave in options.weaves.split(",")
    }
    best = {name: max(row["efficiency"] for row in rows) for name, rows in runs.items()}
    missed = [name for name, found in best.items() if found < BARS[name.split(",")[0]]]
    return {"size": options.size, "yarns_per_pixel": _YARNS, "missed": missed, "runs": runs}


if __name__ == "__main__":
    run(measure, add_options, prints=False)
