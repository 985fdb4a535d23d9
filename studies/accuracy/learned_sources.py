"""What `neumip` and `latent` make of the gallery's sources: time, size and error of a bake of each.

    python -m studies.accuracy.learned_sources FOLDER [NAME …] --output FILE.json

A `.loom` in FOLDER that this script baked is used again. A row has

- `bake_cpu_s`: CPU seconds of queries and training; `file_kb`, of the `.loom`, its source in it;
- `nmae`: mean absolute difference of f·cos over the mean, of footprints of 2 to 64 texels anywhere, seen from
  anywhere above and lit from above, from below too where `neumip` lets light pass, about directions that no
  training saw; `nmae_fine` of footprints up to 8 texels; `bias`: mean difference over the mean;
- `noise`: what `nmae` would be of a model without error, from two estimates of the truth.
"""

from __future__ import annotations

import json
import time
from argparse import ArgumentParser, Namespace
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from drjit.llvm.ad import Array2f, Array3f
from numpy.typing import NDArray

from loomlight.core.files import replacing
from loomlight.core.footprint import Box, box_footprint
from loomlight.core.llvm import require_llvm
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
from studies.instruments.harness import Figures, run
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
_QUERIES, _RAYS = 4096, 64  # of each of two estimates of the truth
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


def measure(options: Namespace) -> Figures:
    require_llvm()
    options.folder.mkdir(parents=True, exist_ok=True)
    return {"rows": {name: _row(name, options) for name in options.names or SOURCES}}


def _row(name: str, options: Namespace) -> Figures:
    path, kind, chosen = SOURCES[name]
    if options.quality is not None:
        chosen = {"quality": options.quality}
    if name != LIBRARY:
        return _of_source(load_source(path, kind_of_file(path, "fabric")), name, kind, chosen, options.folder)
    with TemporaryDirectory() as place:
        library = Path(place) / name
        library.mkdir()
        write_analytic_library(library)
        return _of_source(load_source(library, "merl"), name, kind, chosen, options.folder)


def _of_source(source: Source, name: str, kind: str, chosen: dict[str, Any], folder: Path) -> Figures:
    file, record = folder / f"{name}.loom", folder / f"{name}.json"
    if not record.exists():
        start = time.process_time()
        save(make_model(kind, source, **chosen), file)
        with replacing(record) as temporary:
            temporary.write_text(json.dumps({"bake_cpu_s": round(time.process_time() - start, 1)}))
    model = model_from_loom(file)
    assert isinstance(model, TexturedModel)
    row: Figures = {
        "model": kind,
        **chosen,
        **json.loads(record.read_text()),
        "file_kb": file.stat().st_size >> 10,
    }
    queries = _drawn(model, source)
    found = _predicted(model, queries)
    halves = [_truth(source, model, queries, half) for half in (0, 1)]
    truth = 0.5 * (halves[0] + halves[1])
    errors, mean = np.abs(found - truth), np.abs(truth).mean()
    fine = queries.sides < _FINE * model.weights.shape.texel_mm
    row |= {"nmae": errors.mean() / mean, "nmae_fine": errors[fine].mean() / np.abs(truth[fine]).mean()}
    row |= {"bias": (found - truth).mean() / mean}
    row |= {"noise": 0.5 * np.abs(halves[0] - halves[1]).mean() / mean}
    return {
        key: value if isinstance(value, str | int) else float(f"{value:.4g}") for key, value in row.items()
    }


def _drawn(model: TexturedModel, source: Source) -> _Queries:
    rng = np.random.default_rng(_SEED)
    views = draw_directions(rng, _QUERIES)
    low, high = np.log(_SIDES)
    sides = np.exp(rng.uniform(low, high, _QUERIES)) * model.weights.shape.texel_mm
    if model.name == "latent":
        # A library's BRDFs do not mix.
        sides *= not model.weights.shape.is_apart
        lights = draw_lights(rng, views)
    else:
        btf, lights = btf_of(source, "neumip"), draw_directions(rng, _QUERIES)
        lights[:, 2] *= np.where(btf.transmits & (rng.random(_QUERIES) < TRANSMISSION_SHARE), -1, 1)
    return _Queries(rng.random((_QUERIES, 2), np.float32), sides.astype(np.float32), lights, views)


def _predicted(model: TexturedModel, queries: _Queries) -> _Floats:
    centres = (queries.positions * np.array(model.source.repeat_mm)).astype(np.float32)
    box = Box(Array2f(_columns(centres)), Array2f(queries.sides, queries.sides))
    at = model.at(Array3f(_columns(queries.views)), box_footprint(box))
    return np.asarray(at.value(Array3f(_columns(queries.lights))).numpy().T, np.float32)


def _truth(source: Source, model: TexturedModel, queries: _Queries, half: int) -> _Floats:
    """f·cos [n, 3] as a mean over each footprint."""
    total = np.zeros((_QUERIES, 3), np.float32)
    btf, shape = btf_of(source, model.name), model.weights.shape
    if model.name == "latent":
        levels = np.log2(np.maximum(queries.sides / shape.texel_mm, 1)).astype(np.float32)
        assert isinstance(btf, EncodedBtf)  # as all of this model
        texels = btf.texels(max(shape.columns, shape.rows))
        for ray in range(_RAYS):
            directions = queries.lights, queries.views
            total += footprint_values(btf, texels, queries.positions, levels, *directions, (_SEED, half, ray))
        return np.asarray(total / _RAYS, np.float32)
    for ray in range(_RAYS):
        spread = np.random.default_rng([_SEED, half, ray]).standard_normal((_QUERIES, 2))
        points = queries.positions * np.array(source.repeat_mm)
        points += spread * (queries.sides / SIZE_OF_SIGMA)[:, None]
        seed = (_SEED, half, ray)
        total += btf.values(points.astype(np.float32), queries.lights, queries.views, seed)
    return np.asarray(total / _RAYS, np.float32)


def _columns(values: _Floats) -> _Floats:
    return np.ascontiguousarray(values.T, np.float32)


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("folder", type=Path)
    parser.add_argument("--quality", metavar="NAME", help="of all trainings, in place of their options")
    parser.add_argument("names", nargs="*", choices=[[], *SOURCES], help="some of the sources")


if __name__ == "__main__":
    run(measure, _add_options)
