"""Is `latent` faster than the layered material that it stands for? CPU seconds of the same picture.

    python -m studies.papers.zeltner2024.speed [--output FILE.json]

The stage of zeltner2024's tables: the same sphere, light, samples and length of paths, rendered in turns with
Mitsuba's own layers, by `footprint_path` as models are and by Mitsuba's `path`, and with `latent` of each
decoder. Each has a process of its own that finds no compiled kernels: Dr.Jit traces all BSDFs of a process,
whichever scene they are of. `first` is the picture in which kernels are traced and compiled, `following` are
those after it. Weights change no time, so that trainings are of a few steps, unless `--pictures` asks for
pictures and their errors. A row has CPU seconds, the least of each, and `speedup`.
"""

from __future__ import annotations

import os
import time
from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import patch

import mitsuba as mi
import numpy as np
from PIL import Image

from loomlight.mitsuba.measured_scenes import MeasuredScene
from studies.instruments.harness import Figures, run
from studies.papers.figure import on_display
from studies.papers.setting import Setting
from studies.papers.zeltner2024.layered_materials import LAYERED
from studies.papers.zeltner2024.six_layers import SIX_LAYERS
from studies.papers.zeltner2024.stage import (
    DEPTH,
    model_factory,
    reference_factory,
    six_errors,
    stage_material,
    stage_picture,
    stage_scene,
    trained,
)

# Mitsuba's own layers, by the integrator of this package that renders models too, and by Mitsuba's own.
_REFERENCE, _PATH = "reference", "reference by path"
# Of a training that is timed and not looked at.
_FEW_STEPS = 30
# Samples a pixel of pictures that are compared, in which noise is to be small beside errors.
_COMPARED_SAMPLES = 256


def measure(options: Namespace) -> Figures:
    setting = Setting(
        size=(options.width, options.width * 9 // 16),
        samples=options.samples,
        model="latent",
        steps=_FEW_STEPS if options.pictures is None else None,
        runs=options.runs,
    )
    rows = {name: _row(name, setting, options) for name in options.materials}
    return {"samples": options.samples, "width": options.width, "rows": rows}


def _row(name: str, setting: Setting, options: Namespace) -> Figures:
    """The figures of a material."""
    ways = (_REFERENCE, _PATH, *options.decoders)
    # Trainings are kept, and read by the processes that are timed.
    for decoder in options.decoders:
        trained(stage_material(name), setting, decoder)
    seconds: dict[str, list[list[float]]] = {way: [] for way in ways}
    for _ in range(options.processes):
        for way in ways:
            seconds[way].append(_in_a_new_process(name, way, setting, options.turns))
    row = {
        "first": _speedups({way: min(times[0] for times in found) for way, found in seconds.items()}),
        "following": _speedups(
            {way: min(min(times[1:]) for times in found) for way, found in seconds.items()}
        ),
    }
    if options.pictures is not None:
        row["errors"] = _errors(name, options.decoders, setting, options.pictures / f"{name}.png")
    return row


def _scene(name: str, way: str, setting: Setting) -> MeasuredScene:
    """The stage with a material: its own layers, or a model with the decoder of this name."""
    source = stage_material(name)
    if way not in (_REFERENCE, _PATH):
        return stage_scene(model_factory(trained(source, setting, way)), "whole", setting)
    scene = stage_scene(reference_factory(source), "whole", setting)
    if way == _REFERENCE:
        return scene
    return replace(scene, integrator=mi.load_dict({"type": "path", "max_depth": DEPTH}))


def _timed(name: str, way: str, setting: Setting, turns: int) -> list[float]:
    """CPU seconds of a picture and of `turns` that follow it."""
    scene = _scene(name, way, setting)
    seconds = []
    for turn in range(turns + 1):
        start = time.process_time()
        stage_picture(scene, setting, seed=turn)
        seconds.append(time.process_time() - start)
    return seconds


def _in_a_new_process(name: str, way: str, setting: Setting, turns: int) -> list[float]:
    """`_timed` in a process that finds no kernels on disk."""
    with (
        TemporaryDirectory() as kernels,
        patch.dict(os.environ, {"DRJIT_CACHE_DIR": kernels}),
        ProcessPoolExecutor(1, get_context("spawn")) as pool,
    ):
        return pool.submit(_timed, name, way, setting, turns).result()


def _speedups(least: dict[str, float]) -> Figures:
    """Seconds of each way, and how many times as fast as the reference it is."""
    return {way: round(seconds, 3) for way, seconds in least.items()} | {
        f"speedup {way}": round(least[_REFERENCE] / seconds, 2)
        for way, seconds in least.items()
        if way != _REFERENCE
    }


def _errors(name: str, decoders: Sequence[str], setting: Setting, file: Path) -> Figures:
    """Errors of whole pictures on the sphere, and of noise alone; the pictures side by side in a file."""
    setting = replace(setting, samples=_COMPARED_SAMPLES)
    scene = _scene(name, _REFERENCE, setting)
    truth, other = (stage_picture(scene, setting, seed) for seed in (2, 3))
    shown = {"noise alone": other}
    for decoder in decoders:
        shown[decoder] = stage_picture(_scene(name, decoder, setting), setting, seed=3)
    file.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(np.concatenate([on_display(picture) for picture in shown.values()], axis=1)).save(file)
    mean = float(truth[scene.counted].mean(dtype=np.float64))
    found: Figures = {"samples": setting.samples}
    for way, picture in shown.items():
        flip, absolute = six_errors(picture, truth, scene.counted).metrics[:2]
        bias = float(picture[scene.counted].mean(dtype=np.float64)) / mean - 1
        found[way] = {"FLIP": round(flip, 4), "nMAE": round(absolute / mean, 4), "bias": round(bias, 4)}
    return found


def _add_options(parser: ArgumentParser) -> None:
    known = (*LAYERED, SIX_LAYERS)
    parser.add_argument("--materials", nargs="+", default=LAYERED, choices=known)
    parser.add_argument("--decoders", nargs="+", default=["2x32"])
    parser.add_argument("--samples", type=int, default=32)
    parser.add_argument("--width", type=int, default=256)
    parser.add_argument("--turns", type=int, default=3, help="pictures after the first one of a process")
    parser.add_argument("--processes", type=int, default=2, help="of each way")
    parser.add_argument("--runs", type=Path, default=Path("out/runs"), help="keeps trainings")
    parser.add_argument(
        "--pictures", type=Path, help="train whole previews, write their pictures here, and give errors"
    )


if __name__ == "__main__":
    run(measure, _add_options)
