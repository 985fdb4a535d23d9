"""What `neumip` and `latent` make of the gallery's sources: time, size and error of a bake of each.

A bake that lies in the folder of runs is used again. A row has

- `bake_cpu_s`: CPU seconds of queries and training; `file_kb`, of the `.loom`, its source in it;
- `nmae`: mean absolute difference of f·cos over the mean, of footprints of 2 to 64 texels anywhere, seen from
  anywhere above and lit from above, from below too where `neumip` lets light pass, about directions that no
  training saw; `nmae_fine` of footprints up to 8 texels; `bias`: mean difference over the mean;
- `noise`: what `nmae` would be of a model without error, from two estimates of the truth.
"""

from __future__ import annotations

import json
import time
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from drjit.llvm.ad import Array2f, Array3f
from numpy.typing import NDArray

from loomlight.core.files import replacing
from loomlight.core.footprint import Box, box_footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.models.bake import save
from loomlight.models.registry import btf_of, make_model, model_from_loom
from loomlight.models.texture.model import TexturedModel
from loomlight.models.texture.pyramid import SIZE_OF_SIGMA
from loomlight.models.texture.queries import (
    TRANSMISSION_SHARE,
    EncodedBtf,
    draw_directions,
    draw_lights,
    footprint_values,
)
from loomlight.sources.kinds import Source, kind_of_file
from loomlight.sources.load import load_source
from studies.harness.study import REPOSITORY, Figures, Found, Run, Study, listed, names
from studies.papers.zeltner2024.analytic_brdfs import write_analytic_library

# Files of sources, the model that each is baked for, and its options; the library is written when needed.
LIBRARY = "merl-library"
SOURCES: dict[str, tuple[str, str, dict[str, Any]]] = {
    "jersey": ("examples/jersey/jersey.toml", "neumip", {"resolution": 64, "steps": 2000}),
    "corduroy": ("examples/corduroy/corduroy.toml", "neumip", {"resolution": 64, "steps": 2000}),
    "leather": ("examples/leather/leather.toml", "neumip", {"resolution": 128, "steps": 2500}),
    "brushed-metal": ("examples/materials/brushed-metal/brushed-metal.toml", "latent", {}),
    "glazed-ceramic": ("examples/materials/glazed-ceramic/glazed-ceramic.toml", "latent", {}),
    LIBRARY: (LIBRARY, "latent", {}),
}
_SIDES, _FINE = (2.0, 64.0), 8.0  # of footprints, texels
_SEED = 999  # of no training

_Floats = NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class _Queries:
    """Positions in repeats, sides in millimetres, lights and views."""

    positions: _Floats
    sides: _Floats
    lights: _Floats
    views: _Floats


@dataclass(frozen=True)
class LearnedSources(Settings):
    sources: str = names(",".join(SOURCES), "Sources of the gallery.", tuple(SOURCES))
    quality: str = setting("", "Of all trainings, in place of their own options.")
    resolution: int | None = setting(None, "Texels of all trainings.", low=1, otherwise="their own")
    steps: int | None = setting(None, "Of all trainings.", low=1, otherwise="their own")
    queries: int = setting(4096, "Of each of two estimates of the truth.", low=16)
    rays: int = setting(64, "Of a query.", low=1)


def measure(settings: LearnedSources, run: Run) -> Found:
    """A row for each source."""
    require_llvm()
    rows = {name: partial(_row, name, settings, run.runs) for name in listed(settings.sources)}
    return Found({"rows": run.each(rows)})


def source_of(name: str, folder: Path) -> Source:
    """The source; the library of measured BRDFs is written into a folder first."""
    if name == LIBRARY:
        (folder / name).mkdir(parents=True, exist_ok=True)
        write_analytic_library(folder / name)
        return load_source(folder / name, "merl")
    path = REPOSITORY / SOURCES[name][0]
    return load_source(path, kind_of_file(path, "fabric"))


def baked(name: str, source: Source, runs: Path, options: Mapping[str, Any] | None = None) -> Path:
    """The `.loom` of a source below the folder of runs, trained unless it is there.

    Args:
        options: of the training, in place of its own.
    """
    chosen = dict(options or SOURCES[name][2])
    words = "-".join(f"{key}-{value}" for key, value in chosen.items())
    folder = runs / "learned_sources" / "-".join(filter(None, (name, words)))
    file, record = folder / f"{name}.loom", folder / f"{name}.json"
    if not record.exists():
        folder.mkdir(parents=True, exist_ok=True)
        start = time.process_time()
        save(make_model(SOURCES[name][1], source, **chosen), file)
        with replacing(record) as temporary:
            temporary.write_text(json.dumps({"bake_cpu_s": round(time.process_time() - start, 1)}))
    return file


def _row(name: str, settings: LearnedSources, runs: Path) -> Figures:
    _, kind, chosen = SOURCES[name]
    given: dict[str, Any] = {"quality": settings.quality} if settings.quality else {}
    numbers = {"resolution": settings.resolution, "steps": settings.steps}
    given |= {key: value for key, value in numbers.items() if value is not None}
    source = source_of(name, runs / "learned_sources")
    file = baked(name, source, runs, given)
    model = model_from_loom(file)
    assert isinstance(model, TexturedModel)
    row: Figures = {
        "model": kind,
        **(given or chosen),
        **json.loads(file.with_suffix(".json").read_text()),
        "file_kb": file.stat().st_size >> 10,
    }
    queries = _drawn(model, source, settings.queries)
    found = _predicted(model, queries)
    halves = [_truth(source, model, queries, half, settings.rays) for half in (0, 1)]
    truth = 0.5 * (halves[0] + halves[1])
    errors, mean = np.abs(found - truth), np.abs(truth).mean()
    fine = queries.sides < _FINE * model.weights.shape.texel_mm
    row |= {"nmae": errors.mean() / mean, "nmae_fine": errors[fine].mean() / np.abs(truth[fine]).mean()}
    row |= {"bias": (found - truth).mean() / mean}
    row |= {"noise": 0.5 * np.abs(halves[0] - halves[1]).mean() / mean}
    return {
        key: value if isinstance(value, str | int) else float(f"{value:.4g}") for key, value in row.items()
    }


def _drawn(model: TexturedModel, source: Source, count: int) -> _Queries:
    rng = np.random.default_rng(_SEED)
    views = draw_directions(rng, count)
    low, high = np.log(_SIDES)
    sides = np.exp(rng.uniform(low, high, count)) * model.weights.shape.texel_mm
    if model.name == "latent":
        # A library's BRDFs do not mix.
        sides *= not model.weights.shape.is_apart
        lights = draw_lights(rng, views)
    else:
        btf, lights = btf_of(source, "neumip"), draw_directions(rng, count)
        lights[:, 2] *= np.where(btf.transmits & (rng.random(count) < TRANSMISSION_SHARE), -1, 1)
    return _Queries(rng.random((count, 2), np.float32), sides.astype(np.float32), lights, views)


def _predicted(model: TexturedModel, queries: _Queries) -> _Floats:
    centres = (queries.positions * np.array(model.source.repeat_mm)).astype(np.float32)
    box = Box(Array2f(_columns(centres)), Array2f(queries.sides, queries.sides))
    at = model.at(Array3f(_columns(queries.views)), box_footprint(box))
    return np.asarray(at.value(Array3f(_columns(queries.lights))).numpy().T, np.float32)


def _truth(source: Source, model: TexturedModel, queries: _Queries, half: int, rays: int) -> _Floats:
    """f·cos [n, 3] as a mean over each footprint."""
    total = np.zeros(queries.lights.shape, np.float32)
    btf, shape = btf_of(source, model.name), model.weights.shape
    if model.name == "latent":
        levels = np.log2(np.maximum(queries.sides / shape.texel_mm, 1)).astype(np.float32)
        assert isinstance(btf, EncodedBtf)  # as all of this model
        texels = btf.texels(max(shape.columns, shape.rows))
        for ray in range(rays):
            directions = queries.lights, queries.views
            total += footprint_values(btf, texels, queries.positions, levels, *directions, (_SEED, half, ray))
        return np.asarray(total / rays, np.float32)
    for ray in range(rays):
        spread = np.random.default_rng([_SEED, half, ray]).standard_normal(queries.positions.shape)
        points = queries.positions * np.array(source.repeat_mm)
        points += spread * (queries.sides / SIZE_OF_SIGMA)[:, None]
        seed = (_SEED, half, ray)
        total += btf.values(points.astype(np.float32), queries.lights, queries.views, seed)
    return np.asarray(total / rays, np.float32)


def _columns(values: _Floats) -> _Floats:
    return np.ascontiguousarray(values.T, np.float32)


def tables(figures: Figures) -> list[Table]:
    """A row for each source."""
    keys = ("bake_cpu_s", "file_kb", "nmae", "nmae_fine", "bias", "noise")
    rows = {f"{name}, `{row['model']}`": [row[key] for key in keys] for name, row in figures["rows"].items()}
    columns = ["bake, CPU s", "`.loom`, kB", "nMAE", "nMAE, fine", "bias", "noise"]
    return [Table("Sources that are no fabric", columns, rows)]


STUDY = Study(
    "accuracy/learned_sources",
    "what `neumip` and `latent` make of the gallery's sources: time, size and error of a bake",
    LearnedSources(),
    measure,
    tables,
    stands_on=("neumip", "latent"),
    small={"sources": "brushed-metal", "resolution": 32, "steps": 20, "queries": 64, "rays": 2},
)
