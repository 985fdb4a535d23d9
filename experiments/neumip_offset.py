"""What the neural offset gains, by resolution and schedule: errors of held-out queries of a height field.

    python -m experiments.neumip_offset --folder FOLDER [--source FILE] [--resolution N]
        [--steps N] [--variants NAMES] [--output FILE]

Errors are of single levels: squared differences of π f·cos, without the noise of the truth, as each query is
estimated twice and the mean of (model − first)·(model − second) has none.
"""

from __future__ import annotations

import json
import time
from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from drjit.llvm.ad import Array2f, Array3f

from benchmarks.harness import REPOSITORY, Figures, run
from loomlight.assets.load import load_source
from loomlight.assets.sources import Source
from loomlight.core.footprint import Box, box_footprint
from loomlight.models.neumip.btf import btf_of
from loomlight.models.neumip.model import NeumipModel
from loomlight.models.neumip.networks import Weights
from loomlight.models.neumip.pyramid import SIZE_OF_SIGMA, PyramidShape
from loomlight.models.neumip.settings import QUALITIES, NeumipSettings
from loomlight.models.neumip.training.train import shape_of, train_neumip

LEVELS = (0, 1, 2, 3)
_SEED = 77
# Changes of the settings by name.
VARIANTS: dict[str, Callable[[NeumipSettings], NeumipSettings]] = {
    "without": lambda s: replace(s, offset=False),
    "frozen after 1/3": lambda s: replace(s, offset_share=1 / 3),
    "frozen after 2/3": lambda s: replace(s, offset_share=2 / 3),
    "never frozen": lambda s: replace(s, offset_share=1.0),
}


def truth(
    source: Source, shape: PyramidShape, level: int, count: int, samples: int
) -> tuple[tuple[np.ndarray[Any, Any], ...], list[np.ndarray[Any, Any]]]:
    """Positions, lights and views [n, …] of queries of one level, and two estimates of each [n, 3]."""
    rng = np.random.default_rng([_SEED, level])
    positions = rng.random((count, 2)) * np.array(source.repeat_mm)

    def directions() -> np.ndarray[Any, Any]:
        cosine, angle = 0.3 + 0.7 * np.sqrt(rng.random(count)), 2 * np.pi * rng.random(count)
        sine = np.sqrt(1 - cosine**2)
        return np.stack([sine * np.cos(angle), sine * np.sin(angle), cosine], 1).astype(np.float32)

    lights, views = directions(), directions()
    sigma = shape.texel_mm / SIZE_OF_SIGMA * 2**level
    btf, halves = btf_of(source), []
    for half in range(2):
        spread = np.random.default_rng([_SEED, level, half]).standard_normal((count, samples, 2))
        points = (positions[:, None] + sigma * spread).reshape(-1, 2).astype(np.float32)
        light, view = (np.repeat(part, samples, axis=0) for part in (lights, views))
        found = btf.values(points, light, view, (_SEED, level, half))
        halves.append(found.reshape(count, samples, 3).mean(axis=1))
    return (positions.astype(np.float32), lights, views), halves


def measure(options: Namespace) -> Figures:
    """Errors of the variants by level, behind the runs that the output file already holds."""
    source = load_source(options.source)
    base = replace(
        QUALITIES["preview"], resolution=options.resolution, steps=options.steps, queries=options.queries
    )
    shape = shape_of(source, base)
    held_out = {level: truth(source, shape, level, 4000, 64) for level in LEVELS}
    rows: Figures = {}
    for name in options.variants.split(","):
        settings = VARIANTS[name](base)
        begun = time.process_time()
        model = NeumipModel(source, _trained(source, settings, options.folder))
        seconds = time.process_time() - begun
        errors = [_error(model, shape, level, *held_out[level]) for level in LEVELS]
        rows[name] = {"squared_errors": errors, "cpu_seconds": seconds}
    run = {name: getattr(options, name) for name in ("resolution", "steps", "queries")}
    # Runs add up: each takes up to ten minutes of a core.
    earlier: list[Figures] = []
    if options.output is not None and options.output.exists():
        earlier = json.loads(options.output.read_text())["runs"]
    return {"levels": LEVELS, "runs": [*earlier, {**run, "rows": rows}]}


def _trained(source: Source, settings: NeumipSettings, folder: Path) -> Weights:
    """Weights of a variant; all variants share the queries in the folder."""
    place = folder / settings.identity(source)[:8]
    place.mkdir(parents=True, exist_ok=True)
    for file in folder.glob("queries-*.safetensors"):
        if not (place / file.name).exists():
            (place / file.name).symlink_to(file.resolve())
    weights = train_neumip(source, settings, place)
    for file in place.glob("queries-*.safetensors"):
        if not file.is_symlink():
            file.rename(folder / file.name)
    return weights


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--source", default=str(REPOSITORY / "examples/twisted-wool/twisted-wool.toml"))
    parser.add_argument("--resolution", type=int, default=128)
    parser.add_argument("--steps", type=int, default=3000)
    parser.add_argument("--queries", type=int, default=200)
    parser.add_argument("--variants", default=",".join(VARIANTS))
    parser.add_argument("--folder", type=Path, required=True, help="keeps queries and checkpoints")


def _error(
    model: NeumipModel,
    shape: PyramidShape,
    level: int,
    queries: tuple[np.ndarray[Any, Any], ...],
    halves: list[np.ndarray[Any, Any]],
) -> float:
    positions, lights, views = queries
    side = shape.texel_mm * 2**level
    box = Box(Array2f(np.ascontiguousarray(positions.T)), Array2f(side, side))
    at = model.at(Array3f(np.ascontiguousarray(views.T)), box_footprint(box))
    found = np.pi * at.value(Array3f(np.ascontiguousarray(lights.T))).numpy().T
    first, second = (np.pi * half for half in halves)
    return float(((found - first) * (found - second)).mean())


if __name__ == "__main__":
    run(measure, _add_options)
