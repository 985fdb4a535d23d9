"""Queries and pictures a second of all models by a backend of Dr.Jit, and its differences from LLVM.

Queries are of random lights on both sides, views, and footprints from a twentieth of a thread to a hundred
threads; a launch of them is timed until it is done, the least of some after a first one, which compiles.
Answers to a small set of them are compared with those of LLVM: the mean of absolute differences over the mean
answer, and the largest difference over the largest answer. Networks run there by the SIMD kernel and on cards
by cooperative vectors, so this compares two programs. Pictures are of a drape in the studio, as `loomlight
render` makes them. Each model is measured by a process of its own: a fault of a driver ends no other.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import ArrayTypes, array_types
from loomlight.core.errors import LoomlightError
from loomlight.core.footprint import Footprint
from loomlight.core.picture_settings import RenderSettings
from loomlight.core.settings import Settings, same_setting, setting
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric import load_fabric
from loomlight.models.interface import Model
from loomlight.models.registry import make_model
from studies.harness.study import Figures, Found, Run, Study, example, listed, names
from studies.instruments.processes import in_own_process
from studies.speed.frames import MODELS
from studies.speed.realtime import materials_of

_LLVM = "llvm_ad_rgb"
_ROUNDS = 3
# Sides of footprints, millimetres, smallest and largest over it.
_SMALLEST, _RANGE = 0.02, 2000


@dataclass(frozen=True)
class BackendSpeed(Settings):
    """Of what is measured on a backend."""

    variant: str = same_setting(RenderSettings, "variant", default=_LLVM, otherwise="")
    models: str = names(",".join(MODELS), "Models that are measured.", MODELS)
    fabric: str = names("denim", "An example fabric.")
    queries: int = setting(1 << 20, "Queries of a launch.", low=16, high=1 << 28)
    compared: int = setting(1 << 14, "Queries whose answers are compared with LLVM's.", low=16, high=1 << 24)
    size: tuple[int, int] = same_setting(RenderSettings, "size", default=(960, 540))
    spp: int = same_setting(RenderSettings, "spp", default=64)


def measure(settings: BackendSpeed, run: Run) -> Found:
    """Queries a second, pictures a second and differences, by model."""
    rows = {model: partial(_measured, settings, model) for model in listed(settings.models)}
    return Found({"variant": settings.variant, "rows": run.each(rows)})


def _measured(settings: BackendSpeed, row: str) -> Figures:
    shown = settings.size, settings.spp
    asked = settings.fabric, row, settings.variant, settings.queries, settings.compared, *shown
    try:
        return in_own_process(measured_model, *asked)
    except LoomlightError as error:
        return {"refused": str(error)}


def measured_model(
    fabric: str, row: str, variant: str, queries: int, compared: int, size: tuple[int, int], spp: int
) -> Figures:
    """What `measure` finds of one model."""
    from loomlight import render
    from loomlight.mitsuba import choose_variant

    choose_variant(variant)
    name, material, _ = materials_of(load_fabric(example(fabric)))[row]()
    model = material if isinstance(material, Model) else make_model(name, material)
    types = _types(variant)
    model.upload(types)
    asked = _asked(types, queries)
    _answers(model, asked)
    seconds = min(_seconds(lambda: _answers(model, asked)) for _ in range(_ROUNDS))
    answers = _numbers(_answers(model, _asked(types, compared)))
    llvm = _types(_LLVM)
    model.upload(llvm)
    reference = _numbers(_answers(model, _asked(llvm, compared)))
    picture = partial(render, model, variant=variant, size=(size[0], size[1]), spp=spp, inset=False)
    picture()
    picture_seconds = min(_seconds(picture) for _ in range(_ROUNDS))
    return {
        "queries_a_second": queries / seconds,
        "picture_seconds": picture_seconds,
        "samples_a_second": size[0] * size[1] * spp / picture_seconds,
        "mean_difference": float(np.abs(answers - reference).mean() / np.abs(reference).mean()),
        "largest_difference": float(np.abs(answers - reference).max() / np.abs(reference).max()),
        "finite": bool(np.isfinite(answers).all()),
    }


def _types(variant: str) -> ArrayTypes:
    float_type: type = import_module(f"drjit.{variant.split('_')[0]}.ad").Float
    return array_types(float_type)


def _asked(types: ArrayTypes, count: int) -> tuple[Any, Any, Footprint]:
    """Lights, views and footprints: the same numbers for any backend."""
    rng = np.random.default_rng(64)

    def directions(sides: NDArray[np.float64]) -> Any:
        z, turn = np.sqrt(rng.uniform(0.04, 1, count)), rng.uniform(0, 2 * np.pi, count)
        across = np.sqrt(1 - z * z)
        rows = across * np.cos(turn), across * np.sin(turn), sides * z
        return types.Vector3(*(row.astype(np.float32) for row in rows))

    light, view = directions(rng.choice([-1.0, 1.0], count)), directions(np.ones(count))
    centre = types.Vector2(*rng.uniform(0, 60, (2, count)).astype(np.float32))
    side = types.Float((_SMALLEST * _RANGE ** rng.random(count)).astype(np.float32))
    zero = types.Float(np.zeros(count, np.float32))
    return light, view, Footprint(centre, types.Vector2(side, zero), types.Vector2(zero, side))


def _answers(model: Model, asked: tuple[Any, Any, Footprint]) -> Any:
    import drjit as dr

    light, view, footprint = asked
    value = model.at(view, model.on_cloth(footprint)).value(light)
    dr.eval(value)
    dr.sync_thread()
    return value


def _numbers(value: Any) -> NDArray[np.float64]:
    return np.array(value, np.float64)


def _seconds(run: Any) -> float:
    start = time.perf_counter()
    run()
    return time.perf_counter() - start


def tables(figures: Figures) -> list[Table]:
    """Speeds and differences by model."""
    columns = {
        "million queries a second": lambda row: 1e-6 * row["queries_a_second"],
        "seconds a picture": lambda row: row["picture_seconds"],
        "million samples a second": lambda row: 1e-6 * row["samples_a_second"],
        "mean difference from LLVM": lambda row: row["mean_difference"],
        "largest": lambda row: row["largest_difference"],
    }
    rows: dict[str, list[Cell]] = {}
    for name, row in figures["rows"].items():
        refused = row.get("refused")
        cells = [refused, *[None] * (len(columns) - 1)] if refused else [get(row) for get in columns.values()]
        rows[f"`{name}`"] = cells
    return [Table(f"Models by {figures['variant']}", list(columns), rows)]


STUDY = Study(
    "speed/backends",
    "queries and pictures a second by a backend of Dr.Jit, and how far its answers are from LLVM's",
    BackendSpeed(),
    measure,
    tables,
    stands_on=("lobes cost", "point cost"),
    small={"models": "point,latent 2x16", "queries": 4096, "compared": 512, "size": (32, 18), "spp": 1},
)
