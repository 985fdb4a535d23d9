"""Seconds from an edit of a fabric to a picture that shows it, with lobes, in a live picture.

    python benchmarks/lobes_edit.py [--output benchmarks/results/lobes_edit.json]

A flat piece is shown with one sample a pixel, at 16 × 16 pixels, what a first pixel takes, and at 256 × 256.
An edit is a scene parameter set and updated, or for the weave another fabric given to the BSDF; then the
picture is taken. Figures are of several edits to values never seen before; the share of baking stands beside,
and the first edit of its kind, which may trace the picture anew. Each last picture is compared with one that
is traced anew. Bars, to the first pixel: 30 ms for colour, roughness and height scale, 150 ms for the weave.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from unittest.mock import patch

import mitsuba as mi
import numpy as np

from loomlight.core.provenance import provenance
from loomlight.evaluation.table import write_json
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf
from loomlight.mitsuba.live import LivePicture
from loomlight.mitsuba.scene_edits import SceneEdits
from loomlight.models.lobes import model as lobes_model

SIDES = (16, 256)
EDITS = 9
SHOWN = {"light": "directional", "max_depth": 2}
WEAVES = ("satin 5/2", "twill 2/1", "houndstooth", "basket 2/2", "satin 8/3", "twill 3/1", "plain")
BARS_MS = {"colour": 30.0, "roughness": 30.0, "height scale": 30.0, "weave": 150.0}


class Bench:
    """One live picture of a fabric, edits of it, and what they took."""

    def __init__(self, side: int) -> None:
        """Shows a twill, and takes its first pictures."""
        self.shown = build_scene(
            "flat", material_bsdf(fabric_from_text("twill 3/1")), size=(side, side), **SHOWN
        )
        self.live = LivePicture(self.shown.scene, integrator=self.shown.integrator)
        self.edits = SceneEdits(self.shown.scene)

    def edit(self, name: str, number: int) -> None:
        """Edits what `name` says to a value of its own for each number."""
        share = (number + 1) / (EDITS + 3)
        if name == "weave":
            self._weave(WEAVES[number % len(WEAVES)])
        elif name == "colour":
            self.edits.apply({"warp.diffuse_reflect": mi.Color3f(share, 0.5 * share, 0.2)})
        else:
            parameter = {"roughness": "warp.roughness", "height scale": "warp.height_scale"}[name]
            self.edits.apply({parameter: 0.1 + 0.8 * share})

    def _weave(self, weave: str) -> None:
        for shape in self.shown.scene.shapes():
            if type(shape.bsdf()).__name__ == "WovenLobes":
                shape.bsdf().set_source(fabric_from_text(weave))

    def off(self) -> float:
        """Largest difference between the live picture and one traced anew."""
        fresh = mi.render(self.shown.scene, integrator=self.shown.integrator, spp=1, seed=3)
        return float(np.abs(self.live.take(3) - np.array(fresh)).max())


@contextmanager
def baking_times() -> Iterator[list[float]]:
    """Seconds of each baking of tables."""
    taken: list[float] = []
    bake_tables = lobes_model.bake_tables

    def timed(*arguments: Any) -> Any:
        start = time.perf_counter()
        tables = bake_tables(*arguments)
        taken.append(time.perf_counter() - start)
        return tables

    with patch.object(lobes_model, "bake_tables", timed):
        yield taken


def milliseconds(bench: Bench, name: str) -> dict[str, float]:
    """What edits of one kind take, milliseconds."""
    whole: list[float] = []
    with baking_times() as bakings:
        for number in range(EDITS + 2):
            # The first two are those of kernels that no earlier edit compiled.
            if number == 2:
                bakings.clear()
            start = time.perf_counter()
            bench.edit(name, number)
            bench.live.take(number)
            whole.append(1e3 * (time.perf_counter() - start))
    baked = 1e3 * statistics.median(bakings) if bakings else 0.0
    return {
        "median_ms": round(statistics.median(whole[2:]), 2),
        "least_ms": round(min(whole[2:]), 2),
        "first_ms": round(whole[0], 2),
        "of_it_baking_ms": round(baked, 2),
        "largest_difference": round(bench.off(), 7),
    }


def main() -> None:
    """Runs the benchmark, prints it, and exits with 1 if a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=None)
    arguments = parser.parse_args()
    choose_variant()
    runs: dict[str, dict[str, Any]] = {}
    for side in SIDES:
        bench = Bench(side)
        runs[f"{side} × {side}"] = {name: milliseconds(bench, name) for name in BARS_MS}
        print(side, json.dumps(runs[f"{side} × {side}"]), flush=True)
    first = runs[f"{SIDES[0]} × {SIDES[0]}"]
    missed = [name for name, bar in BARS_MS.items() if first[name]["median_ms"] > bar]
    result = {
        **provenance("python benchmarks/lobes_edit.py", Path(__file__).parent),
        "bars_ms": BARS_MS,
        "missed": missed,
        "runs": runs,
    }
    if arguments.output is not None:
        write_json(arguments.output, result, digits=None)
    print("missed:", ", ".join(missed) or "none")
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
