"""What learned frames gain in trainings of several lengths by the paper's recipe, carried on to its own.

Trainings of 1000, 3000, 10 000 … steps up to `--steps`, each with its whole schedule: encoder, textures and
cones take the same shares of all. Errors are of pictures, as in Tables 1 to 4. A line fitted to
the logarithms of all lengths is carried on to the paper's 300 000 steps: an extrapolation of one seed, which
noise of the pictures bends and which is no measurement.

A training that is stopped goes on from its last checkpoint when the same command runs again; trainings are
those of `tables1-4`, where these have as many steps.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial

import numpy as np

from loomlight.evaluation.table import Table
from loomlight.mitsuba import choose_variant
from loomlight.models.texture.settings import RUNGS
from loomlight.sources.material import Material
from studies.harness.study import Figures, Found, Run, Study, stored_tables, with_tables
from studies.papers.zeltner2024.stage import (
    METRICS,
    SHORT_RECIPE,
    StageSettings,
    model_factory,
    reference_factory,
    six_errors,
    stage_picture,
    stage_scene,
    trained,
)
from studies.papers.zeltner2024.two_normals import TWO_NORMALS

# Steps of trainings, and what is carried on to.
_LENGTHS, _PAPER_STEPS = (1000, 3000, 10_000, 30_000, 100_000), 300_000
# Of `METRICS`, those that are followed.
_SHOWN = {METRICS[0]: 0, METRICS[2]: 2}
_NAMES = ("with encoder", "with frames")
_EXTRAPOLATED = f"{_PAPER_STEPS} steps, extrapolated"


def learning_curve(settings: StageSettings, run: Run) -> Found:
    """Errors with encoder and with frames by steps, and how many times lower frames make them."""
    choose_variant()
    whole = settings.steps or _PAPER_STEPS
    lengths = [*(steps for steps in _LENGTHS if steps < whole), whole]
    rungs = RUNGS[1:]
    sources = settings.sources()
    # Short trainings first.
    cases = {
        (source.name, steps, rung): partial(_errors, source, replace(settings, steps=steps), run, rung)
        for steps in lengths
        for source in sources
        for rung in rungs
    }
    found = run.each({" ".join(map(str, case)): make for case, make in cases.items()})
    errors = dict(zip(cases, found.values(), strict=True))
    columns = [f"{steps} steps" for steps in lengths]
    tables = []
    for metric, place in _SHOWN.items():
        table = Table(metric, columns)
        for source in sources:
            for rung, name in zip(rungs, _NAMES, strict=True):
                label = f"{source.name}, {name}"
                table.rows[label] = [errors[source.name, steps, rung][place] for steps in lengths]
        tables.append(table)
    return Found(with_tables(*tables))


def curve_tables(figures: Figures) -> list[Table]:
    """Gains of frames, and the errors, each carried on to the paper's steps."""
    gain, shown = Table("Gain of frames", []), []
    for stored in stored_tables(figures):
        if stored.title in _SHOWN:
            lengths = [int(column.split()[0]) for column in stored.columns if "extrapolated" not in column]
            table = Table(stored.title, [*(f"{steps} steps" for steps in lengths), _EXTRAPOLATED])
            for label, row in stored.rows.items():
                curve = [float(cell or 0) for cell in row[: len(lengths)]]
                table.rows[label] = [*curve, _carried_on(lengths, curve)]
            gain.columns = table.columns
            for label, encoder in table.rows.items():
                source, name = label.rsplit(", ", 1)
                if name == _NAMES[0]:
                    frames = table.rows[f"{source}, {_NAMES[1]}"]
                    pairs = zip(encoder, frames, strict=True)
                    gain.rows[f"{source}, {table.title}"] = [float(a or 0) / float(b or 1) for a, b in pairs]
            shown.append(table)
    return [gain, *shown]


def _errors(source: Material, settings: StageSettings, run: Run, rung: str) -> list[float]:
    """The six errors of a picture of a rung."""
    scene = stage_scene(reference_factory(source), "whole", settings)
    model = trained(source, settings, run.runs, rung=rung, features="none")
    picture = stage_picture(stage_scene(model_factory(model), "whole", settings), settings)
    return [*six_errors(picture, stage_picture(scene, settings, 2), scene.counted).metrics]


def _carried_on(lengths: list[int], curve: list[float]) -> float:
    """A curve at the paper's steps, by the line that fits the logarithms best."""
    if len(lengths) < 2:
        return curve[-1]
    slope, start = np.polyfit(np.log(lengths), np.log(curve), 1)
    return math.exp(start + slope * math.log(_PAPER_STEPS))


STUDY = Study(
    "papers/zeltner2024/learning_curve",
    "what frames gain by steps of the paper's recipe",
    StageSettings(**SHORT_RECIPE, materials=",".join(TWO_NORMALS)),
    learning_curve,
    curve_tables,
    stands_on=("latent", "picture"),
    small={
        "size": (24, 16),
        "spp": 4,
        "quality": "preview",
        "steps": 30,
        "batch": 256,
        "queries": 4096,
        "resolution": 16,
        "materials": TWO_NORMALS[0],
    },
)
