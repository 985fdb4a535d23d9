"""How much less noise `samples` has than `point` from afar, by MSE × processor time.

Drape and cylinder of the image benchmark at ten yarns a pixel: one directional light, direct light only, box
filter, pixels wholly on cloth. Against `point` at 64 samples a pixel
stand paths of several points each, spread over the primitive cell of the weave. The reference is `point` with
1024 samples. Every picture of a comparison is taken in one process; an efficiency of 5 is a fifth of the MSE
in equal processor time.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.mitsuba import LIGHTS, choose_variant, render, shapes
from loomlight.mitsuba.measured_scenes import MeasuredShot, shot_scene
from loomlight.mitsuba.plugins import material_bsdf
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.timing import spent

_YARNS = 10.0
SHOTS = {
    "drape": MeasuredShot((shapes.drape,), (0.35, 0.55, 1.0), (-0.6, 0.75, 0.6), _YARNS),
    "cylinder": MeasuredShot((shapes.cylinder,), (0.0, 0.0, 1.0), (1.0, 0.35, 0.4), _YARNS, zoom=1.2),
}
# Efficiency to reach.
BARS = {"drape": 5.0, "cylinder": 3.0}
# Paths a pixel and points a path; `point` itself has 0.
ROWS = ((64, 0), (4, 16), (4, 64), (16, 16), (64, 16))
SEEDS = 3


def picture(shot: MeasuredShot, fabric: Fabric, size: tuple[int, int], points: int) -> Any:
    """A function from samples a pixel and a seed to the pixels that count [n, 3]."""
    options: dict[str, Any] = {"points": points} if points else {}
    bsdf = material_bsdf(fabric, "samples" if points else "point", **options)
    made = shot_scene(shot, [(fabric, bsdf)], size)

    def take(samples: int, seed: int) -> NDArray[np.float64]:
        film = render(made.scene, spp=samples, seed=seed, integrator=made.integrator, denoise="off")
        return np.asarray(film, np.float64)[made.counted][:, :3]

    return take


def films_of(take: Callable[[int, int], NDArray[np.float32]], paths: int) -> list[NDArray[np.float32]]:
    """A picture a seed."""
    return [take(paths, 3 + seed) for seed in range(SEEDS)]


def compared(shot: MeasuredShot, weave: str, settings: CellPlaces) -> list[dict[str, Any]]:
    """A row for each number of paths and points, `point` itself first."""
    fabric, size = fabric_from_text(weave), settings.size
    reference = picture(shot, fabric, size, 0)(settings.reference, 1)
    rows: list[dict[str, Any]] = []
    for paths, points in ((min(n, settings.most), min(m, settings.most)) for n, m in ROWS):
        take = picture(shot, fabric, size, points)
        take(paths, 2)
        films, taken = spent(partial(films_of, take, paths))
        seconds = taken.cpu_seconds / SEEDS
        mse = float(np.mean([np.square(film - reference).mean() for film in films]))
        row: dict[str, Any] = {"paths": paths, "points": points, "mse": mse, "cpu_seconds": seconds}
        row["relative_bias"] = float(np.mean([film.mean() for film in films]) / reference.mean() - 1)
        first = rows[0] if rows else row
        row["efficiency"] = first["mse"] * first["cpu_seconds"] / (mse * seconds)
        rows.append(row)
    return rows


@dataclass(frozen=True)
class CellPlaces(Settings):
    size: tuple[int, int] = setting((100, 75), "Pixels.", low=8)
    weaves: str = names("satin 8/3", "Weaves.")
    light: str = setting("directional", "Of the scene.", choices=LIGHTS)
    reference: int = setting(1024, "Samples of the reference.", low=1)
    most: int = setting(64, "Samples and points of a path, at most.", low=4)


def measure(settings: CellPlaces, run: Run) -> Found:
    """Every scene and weave, and those whose best row misses its bar."""
    choose_variant()
    shots = {name: replace(shot, light=settings.light) for name, shot in SHOTS.items()}
    runs = run.each(
        {
            f"{name}, {weave}": partial(compared, shot, weave, settings)
            for name, shot in shots.items()
            for weave in listed(settings.weaves)
        }
    )
    best = {name: max(row["efficiency"] for row in rows) for name, rows in runs.items()}
    missed = [name for name, found in best.items() if found < BARS[name.split(",")[0]]]
    return Found({"size": list(settings.size), "yarns_per_pixel": _YARNS, "missed": missed, "runs": runs})


def tables(figures: Figures) -> list[Table]:
    """Efficiency over `point` by scene, paths and points of a path."""
    rows = {
        f"{name}, {row['paths']} × {row['points'] or '`point`'}": [
            row["mse"],
            row["cpu_seconds"],
            row["relative_bias"],
            row["efficiency"],
        ]
        for name, found in figures["runs"].items()
        for row in found
    }
    columns = ["MSE", "processor s", "relative bias", "efficiency"]
    return [Table("Paths of several points", columns, rows)]


_SMALL = {"size": (24, 18), "reference": 16, "most": 4}
STUDIES = (
    Study(
        "speed/cell_places",
        "how much less noise `samples` has than `point` from afar in equal processor time",
        CellPlaces(),
        measure,
        tables,
        stands_on=("point", "samples", "point cost"),
        small=_SMALL,
    ),
    Study(
        "speed/cell_places_studio",
        "the same under an environment",
        CellPlaces(light="studio"),
        measure,
        tables,
        stands_on=("point", "samples", "point cost"),
        small=_SMALL,
    ),
)
