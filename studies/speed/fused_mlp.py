"""Queries a second of fused networks of the shapes in use, against the machine.

    python -m studies.speed.fused_mlp [--output FILE.json]

Operations are two for each weight. Each share is of the FMA peak measured right before and after, with
independent chains of multiply-adds on all cores, so that shares hold on busy machines.
"""

from __future__ import annotations

from argparse import Namespace
from itertools import pairwise

import numpy as np

from loomlight.core.parallel_map import core_count
from loomlight.core.simd import DenseLayer, FusedMlp
from studies.instruments.harness import Figures, run
from studies.instruments.machine import fma_peak, median_seconds

COUNT = 1 << 17
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


def measure(_: Namespace) -> Figures:
    """Rates of all shapes."""
    figures: Figures = {"cores": core_count(), "networks": {}}
    for name, (widths, skip) in SHAPES.items():
        mlp = network(widths, skip)
        rng = np.random.default_rng(1)
        inputs = [*rng.normal(size=(mlp.inputs, COUNT)).astype(np.float32)]
        outputs = [*np.empty((mlp.outputs, COUNT), np.float32)]

        def launch(mlp: FusedMlp = mlp, inputs: list = inputs, outputs: list = outputs) -> None:
            mlp.launch(inputs, outputs)

        before = fma_peak()
        rate = COUNT / median_seconds(launch)
        peak = 0.5 * (before + fma_peak())
        figures["networks"][name] = {
            "millions_per_second": round(rate / 1e6, 2),
            "gflops": round(rate * mlp.flops / 1e9, 1),
            "share_of_fma_peak": round(rate * mlp.flops / peak, 3),
        }
    return figures


if __name__ == "__main__":
    run(measure)
