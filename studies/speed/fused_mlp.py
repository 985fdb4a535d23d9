"""Queries a second of fused networks of the shapes in use, against the machine.

Operations are two for each weight. Each share is of the FMA peak measured right before and after, with
independent chains of multiply-adds on all cores, so that shares hold on busy machines.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from loomlight.core.parallel_map import core_count
from loomlight.core.settings import Settings, setting
from loomlight.core.simd import DenseLayer, FusedMlp
from loomlight.evaluation.table import Table
from studies.harness.study import Figures, Found, Run, Study
from studies.instruments.machine import fma_peak, median_seconds

# Widths of all layers, and whether the third layer adds the first one's sums.
SHAPES = {
    "4x25": ([10, 25, 25, 25, 25, 3], False),
    "2x16": ([6, 16, 16, 4], False),
    "2x32": ([20, 32, 32, 3], False),
    "3x64": ([32, 64, 64, 64, 7], False),
    "5x64 with skip": ([40, 64, 64, 64, 64, 64, 12], True),
}


def network(widths: list[int], skip: bool) -> FusedMlp:
    """A network of random weights."""
    rng = np.random.default_rng(0)
    layers = [
        DenseLayer(
            rng.normal(size=(after, before)) * np.sqrt(2 / before),
            np.zeros(after),
            "leaky_relu" if number + 2 < len(widths) else "none",
            skip_from=0 if skip and number == 2 else None,
        )
        for number, (before, after) in enumerate(pairwise(widths))
    ]
    return FusedMlp(layers)


@dataclass(frozen=True)
class FusedMlpSpeed(Settings):
    count: int = setting(1 << 17, "Queries.", low=64)


def measure(settings: FusedMlpSpeed, run: Run) -> Found:
    """Rates of all shapes."""
    figures: Figures = {"cores": core_count(), "networks": {}}
    for name, (widths, skip) in SHAPES.items():
        mlp = network(widths, skip)
        rng = np.random.default_rng(1)
        inputs = [*rng.normal(size=(mlp.inputs, settings.count)).astype(np.float32)]
        outputs = [*np.empty((mlp.outputs, settings.count), np.float32)]

        def launch(mlp: FusedMlp = mlp, inputs: list = inputs, outputs: list = outputs) -> None:
            mlp.launch(inputs, outputs)

        before = fma_peak()
        rate = settings.count / median_seconds(launch)
        peak = 0.5 * (before + fma_peak())
        figures["networks"][name] = {
            "millions_per_second": round(rate / 1e6, 2),
            "gflops": round(rate * mlp.flops / 1e9, 1),
            "share_of_fma_peak": round(rate * mlp.flops / peak, 3),
        }
    return Found(figures)


def tables(figures: Figures) -> list[Table]:
    """Rates by network."""
    keys = ("millions_per_second", "gflops", "share_of_fma_peak")
    rows = {name: [found[key] for key in keys] for name, found in figures["networks"].items()}
    return [Table("Fused networks", ["million queries/s", "GFLOP/s", "of the FMA peak"], rows)]


STUDY = Study(
    "speed/fused_mlp",
    "queries a second of fused networks of the shapes in use, against the machine",
    FusedMlpSpeed(),
    measure,
    tables,
    small={"count": 1 << 10},
)
