"""Is `latent` faster than the layered material that it stands for? CPU seconds of the same picture.

The stage of zeltner2024's tables: the same sphere, light, samples and length of paths, rendered in turns with
Mitsuba's own layers, by `footprint_path` as models are and by Mitsuba's `path`, and with `latent` of each
decoder. Each has a process of its own that finds no compiled kernels: Dr.Jit traces all BSDFs of a process,
whichever scene they are of. `first` is the picture in which kernels are traced and compiled, `following` are
those after it. Weights change no time, so that trainings are of a few steps, unless pictures and their errors
are asked for. A row has CPU seconds, the least of each, and `speedup`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import mitsuba as mi
import numpy as np

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.mitsuba.measured_scenes import MeasuredScene
from loomlight.models.texture.settings import DECODERS
from studies.harness.study import Figures, Found, Pixels, Run, Study, listed, names, on_display
from studies.instruments.processes import in_own_process
from studies.instruments.timing import spent
from studies.papers.zeltner2024.six_layers import SIX_LAYERS
from studies.papers.zeltner2024.stage import (
    DEPTH,
    MATERIALS,
    StageSettings,
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


@dataclass(frozen=True)
class Speed(Settings):
    """What is timed, and how often."""

    materials: str = names("rough-plastic,glazed-ceramic", "Materials that are timed.", MATERIALS)
    decoders: str = names("2x32", "Hidden layers of `latent`.", tuple(DECODERS))
    samples: int = setting(32, "A pixel.", low=1, high=1_000_000)
    width: int = setting(256, "Of pictures, pixels.", low=16, high=8192)
    turns: int = setting(3, "Pictures after the first one of a process.", low=1, high=100)
    processes: int = setting(2, "Of each way.", low=1, high=100)
    pictures: bool = setting(False, "Whole previews are trained; their pictures and errors are shown too.")

    def stage(self) -> StageSettings:
        """The settings of the stage."""
        steps = None if self.pictures else _FEW_STEPS
        return StageSettings(size=(self.width, self.width * 9 // 16), spp=self.samples, steps=steps)


def measure(settings: Speed, run: Run) -> Found:
    """The times of each material, and, if they are asked for, errors and pictures."""
    materials = listed(settings.materials)
    rows = run.each({name: partial(_row, name, settings, run.runs) for name in materials})
    pictures = {}
    if settings.pictures:
        for name in materials:
            rows[name]["errors"], pictures[name] = _errors(
                name, listed(settings.decoders), settings.stage(), run.runs
            )
    return Found({"samples": settings.samples, "width": settings.width, "rows": rows}, pictures=pictures)


def tables(figures: Figures) -> list[Table]:
    """CPU seconds by way, and errors of pictures."""
    found, timed = [], ("first", "following")
    columns = [*timed, *(f"times as fast, {which}" for which in timed)]
    for name, row in figures["rows"].items():
        ways = [way for way in row["first"] if not way.startswith("speedup")]
        table = Table(f"{name}: CPU seconds of a picture", columns)
        for way in ways:
            seconds = [row[which][way] for which in timed]
            table.rows[way] = [*seconds, *(row[which].get(f"speedup {way}") for which in timed)]
        found.append(table)
        if "errors" in row:
            errors = {way: cells for way, cells in row["errors"].items() if isinstance(cells, dict)}
            kinds = list(next(iter(errors.values())))
            rows = {way: [cells[kind] for kind in kinds] for way, cells in errors.items()}
            found.append(Table(f"{name}: errors of a picture", kinds, rows))
    return found


def _row(name: str, settings: Speed, runs: Path) -> Figures:
    """The times of a material."""
    decoders, stage = listed(settings.decoders), settings.stage()
    ways = (_REFERENCE, _PATH, *decoders)
    # Trainings are kept, and read by the processes that are timed.
    for decoder in decoders:
        trained(stage_material(name, stage.resolution), stage, runs, decoder)
    seconds: dict[str, list[list[float]]] = {way: [] for way in ways}
    for _ in range(settings.processes):
        for way in ways:
            seconds[way].append(_in_a_new_process(name, way, stage, runs, settings.turns))
    return {
        "first": _speedups({way: min(times[0] for times in found) for way, found in seconds.items()}),
        "following": _speedups(
            {way: min(min(times[1:]) for times in found) for way, found in seconds.items()}
        ),
    }


def _scene(name: str, way: str, settings: StageSettings, runs: Path) -> MeasuredScene:
    """The stage with a material: its own layers, or a model with the decoder of this name."""
    source = stage_material(name, settings.resolution)
    if way not in (_REFERENCE, _PATH):
        return stage_scene(model_factory(trained(source, settings, runs, way)), "whole", settings)
    scene = stage_scene(reference_factory(source), "whole", settings)
    if way == _REFERENCE:
        return scene
    return replace(scene, integrator=mi.load_dict({"type": "path", "max_depth": DEPTH}))


def _timed(name: str, way: str, chosen: Mapping[str, Any], runs: str, turns: int) -> list[float]:
    """CPU seconds of a picture and of `turns` that follow it.

    Args:
        chosen: settings of the stage by name.
    """
    settings = StageSettings.of(
        {key: tuple(value) if isinstance(value, list) else value for key, value in chosen.items()}
    )
    scene = _scene(name, way, settings, Path(runs))
    seconds = []
    for turn in range(turns + 1):
        _, times = spent(partial(stage_picture, scene, settings, seed=turn))
        seconds.append(times.cpu_seconds)
    return seconds


def _in_a_new_process(name: str, way: str, settings: StageSettings, runs: Path, turns: int) -> list[float]:
    """`_timed` in a process that finds no kernels on disk."""
    with TemporaryDirectory() as kernels:
        arguments = name, way, settings.chosen(), str(runs.resolve()), turns
        return in_own_process(_timed, *arguments, environment={"DRJIT_CACHE_DIR": kernels})


def _speedups(least: dict[str, float]) -> Figures:
    """Seconds of each way, and how many times as fast as the reference it is."""
    return {way: round(seconds, 3) for way, seconds in least.items()} | {
        f"speedup {way}": round(least[_REFERENCE] / seconds, 2)
        for way, seconds in least.items()
        if way != _REFERENCE
    }


def _errors(
    name: str, decoders: Sequence[str], settings: StageSettings, runs: Path
) -> tuple[Figures, Pixels]:
    """Errors of whole pictures on the sphere, and of noise alone; the pictures side by side."""
    settings = replace(settings, spp=_COMPARED_SAMPLES)
    scene = _scene(name, _REFERENCE, settings, runs)
    truth, other = (stage_picture(scene, settings, seed) for seed in (2, 3))
    shown = {"noise alone": other}
    for decoder in decoders:
        shown[decoder] = stage_picture(_scene(name, decoder, settings, runs), settings, seed=3)
    beside = np.concatenate([on_display(picture) for picture in shown.values()], axis=1)
    mean = float(truth[scene.counted].mean(dtype=np.float64))
    found: Figures = {"samples": settings.spp}
    for way, picture in shown.items():
        flip, absolute = six_errors(picture, truth, scene.counted).metrics[:2]
        bias = float(picture[scene.counted].mean(dtype=np.float64)) / mean - 1
        found[way] = {"FLIP": round(flip, 4), "nMAE": round(absolute / mean, 4), "bias": round(bias, 4)}
    return found, beside


STUDIES = (
    Study(
        "papers/zeltner2024/speed",
        "CPU seconds of `latent` and of the layers that it stands for",
        Speed(),
        measure,
        tables,
        stands_on=("latent", "picture"),
        small={"materials": "rough-plastic", "samples": 1, "width": 16, "turns": 1, "processes": 1},
    ),
    Study(
        "papers/zeltner2024/speed_six_layers",
        "the same of six layers, with errors of pictures",
        Speed(materials=SIX_LAYERS, pictures=True),
        measure,
        tables,
        stands_on=("latent", "picture"),
        small={
            "materials": "rough-plastic",
            "samples": 1,
            "width": 16,
            "turns": 1,
            "processes": 1,
            "pictures": False,
        },
    ),
)
