"""Seconds from an edit of a fabric to a picture that shows it, with lobes, in a live picture.

A flat piece is shown with one sample a pixel, at 16 × 16 pixels, what a first pixel takes, and at 256 × 256.
An edit is a scene parameter set and updated, or for the weave another fabric given to the BSDF; then the
picture is taken. Figures are of several edits to values never seen before; the share of baking stands beside,
and the first edit of its kind, which may trace the picture anew. Each last picture is compared with one that
is traced anew. Bars, to the first pixel: 30 ms for colour, roughness and height scale, 150 ms for the weave.
"""

from __future__ import annotations

import statistics
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from typing import Any
from unittest.mock import patch

import mitsuba as mi
import numpy as np

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf
from loomlight.mitsuba.bsdf import model_bsdfs
from loomlight.mitsuba.live import LivePicture
from loomlight.models.lobes import model as lobes_model
from studies.harness.study import Figures, Found, Run, Study, listed_numbers
from studies.instruments.scene_edits import SceneEdits
from studies.instruments.timing import timed

WEAVES = ("satin 5/2", "twill 2/1", "houndstooth", "basket 2/2", "satin 8/3", "twill 3/1", "plain")
BARS_MS = {"colour": 30.0, "roughness": 30.0, "height scale": 30.0, "weave": 150.0}


class Bench:
    """One live picture of a fabric, edits of it, and what they took."""

    def __init__(self, side: int, edits: int) -> None:
        """Shows a twill, and takes its first pictures."""
        self.shown = build_scene(
            "flat",
            material_bsdf(fabric_from_text("twill 3/1")),
            size=(side, side),
            light="directional",
            max_depth=2,
        )
        self.live = LivePicture(self.shown.scene, integrator=self.shown.integrator)
        self.count = edits
        self.edits = SceneEdits(self.shown.scene)

    def edit(self, name: str, number: int) -> None:
        """Edits what `name` says to a value of its own for each number."""
        value = (number + 1) / (self.count + 3)
        if name == "weave":
            self._weave(WEAVES[number % len(WEAVES)])
        elif name == "colour":
            self.edits.apply({"warp.diffuse_reflect": mi.Color3f(value, 0.5 * value, 0.2)})
        else:
            parameter = {"roughness": "warp.roughness", "height scale": "warp.height_scale"}[name]
            self.edits.apply({parameter: 0.1 + 0.8 * value})

    def _weave(self, weave: str) -> None:
        (cloth,) = (s.bsdf() for s in self.shown.scene.shapes() if s.bsdf() in model_bsdfs())
        cloth.set_source(fabric_from_text(weave))

    def edited(self, name: str, number: int) -> None:
        """An edit and the picture that shows it."""
        self.edit(name, number)
        self.live.take(number)

    def off(self) -> float:
        """Largest difference between the live picture and one traced anew."""
        fresh = mi.render(self.shown.scene, integrator=self.shown.integrator, spp=1, seed=3)
        return float(np.abs(self.live.take(3) - np.array(fresh)).max())


@contextmanager
def baking_times() -> Iterator[list[float]]:
    """Seconds of each baking of tables."""
    taken: list[float] = []
    bake_tables = lobes_model.bake_tables

    def baked(*arguments: Any) -> Any:
        tables, seconds = timed(lambda: bake_tables(*arguments))
        taken.append(seconds)
        return tables

    with patch.object(lobes_model, "bake_tables", baked):
        yield taken


def milliseconds(bench: Bench, name: str) -> dict[str, float]:
    """What edits of one kind take, milliseconds."""
    whole: list[float] = []
    with baking_times() as bakings:
        for number in range(bench.count + 2):
            # The first two are those of kernels that no earlier edit compiled.
            if number == 2:
                bakings.clear()
            whole.append(1e3 * timed(partial(bench.edited, name, number))[1])
    baked = 1e3 * statistics.median(bakings) if bakings else 0.0
    return {
        "median_ms": round(statistics.median(whole[2:]), 2),
        "least_ms": round(min(whole[2:]), 2),
        "first_ms": round(whole[0], 2),
        "of_it_baking_ms": round(baked, 2),
        "largest_difference": round(bench.off(), 7),
    }


@dataclass(frozen=True)
class LobesEdit(Settings):
    sides: str = setting("16,256", "Pixels of pictures, the first against the bars.", metavar="N,…")
    edits: int = setting(9, "Of each kind.", low=1)


def measure(settings: LobesEdit, run: Run) -> Found:
    """Milliseconds of every kind of edit at both sizes, and which bars they miss."""
    choose_variant()
    runs: dict[str, dict[str, Any]] = {}
    sides = [int(side) for side in listed_numbers("sides", settings.sides)]
    for side in sides:
        bench = Bench(side, settings.edits)
        runs[f"{side} × {side}"] = {name: milliseconds(bench, name) for name in BARS_MS}
    first = runs[f"{sides[0]} × {sides[0]}"]
    missed = [name for name, bar in BARS_MS.items() if first[name]["median_ms"] > bar]
    return Found({"bars_ms": BARS_MS, "missed": missed, "runs": runs})


def tables(figures: Figures) -> list[Table]:
    """Milliseconds by kind of edit, a table a size."""
    keys = ("median_ms", "of_it_baking_ms", "first_ms")
    return [
        Table(
            f"Edits, {size} pixels",
            ["ms", "of it baking", "the first, ms"],
            {name: [found[key] for key in keys] for name, found in kinds.items()},
            digits=2,
        )
        for size, kinds in figures["runs"].items()
    ]


STUDY = Study(
    "speed/lobes_edit",
    "seconds from an edit of a fabric to a picture that shows it, with `lobes`",
    LobesEdit(),
    measure,
    tables,
    stands_on=("lobes cost",),
    small={"sides": "16", "edits": 1},
)
