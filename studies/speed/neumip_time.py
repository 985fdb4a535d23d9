"""How long a material takes by quality, extrapolated from a few steps and queries of a fabric.

    python -m studies.speed.neumip_time [--fabric TEXT] [--steps N] [--output FILE]

Processor seconds of both cores together, which other programs lengthen little; on two idle cores a training
takes a little more than half of them by the clock, as queries and large batches use both.
"""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import btf_of
from loomlight.models.texture.neumip_training import taken_queries, train_neumip
from loomlight.models.texture.settings import NEUMIP_QUALITIES
from studies.instruments.harness import Figures, run

# Queries that are taken to extrapolate from.
_QUERIES = 1 << 18


def measure(options: Namespace) -> Figures:
    """Processor seconds of queries, steps and whole trainings."""
    require_llvm()
    source = fabric_from_text(options.fabric)
    btf = btf_of(source, "neumip")
    rows: Figures = {}
    for quality, whole in NEUMIP_QUALITIES.items():
        few = replace(whole, queries=_QUERIES, steps=options.steps)
        shape = whole.shape(source, btf.faces)
        marks: list[float] = []
        with TemporaryDirectory() as place:
            folder = Path(place)
            taken_queries(source, btf, replace(few, seed=1), folder)
            begun = time.process_time()
            taken_queries(source, btf, few, folder)
            queries = (time.process_time() - begun) / _QUERIES * whole.queries
            train_neumip(source, few, folder, _marker(marks))
            fit = time.process_time() - marks[-1]
        # Reports of the queries come first; the first step compiles and allocates.
        step = (marks[-1] - marks[-options.steps + 1]) / (options.steps - 2)
        rows[quality] = {
            "texels": f"{shape.columns} × {shape.rows}",
            "queries": whole.queries,
            "cpu_seconds_of_queries": queries,
            "cpu_seconds_of_a_step": step,
            "steps": whole.steps,
            "cpu_seconds_of_proposal": fit / few.sampler_steps * whole.sampler_steps,
            "cpu_minutes": (queries + step * whole.steps) / 60,
        }
    return {"fabric": options.fabric, "steps_measured": options.steps, "rows": rows}


def _marker(marks: list[float]) -> Callable[[int, int], None]:
    """Keeps the processor seconds of each report."""
    return lambda done, total: marks.append(time.process_time())


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--fabric", default="twill 2/2")
    parser.add_argument("--steps", type=int, default=8)


if __name__ == "__main__":
    run(measure, _add_options)
