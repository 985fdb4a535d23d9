"""How long a material takes by quality, extrapolated from a few steps and queries of a fabric.

Processor seconds of both cores together, which other programs lengthen little; on two idle cores a training
takes a little more than half of them by the clock, as queries and large batches use both.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import btf_of
from loomlight.models.texture.neumip_training import taken_queries, train_neumip
from loomlight.models.texture.settings import NEUMIP_QUALITIES
from studies.harness.study import Figures, Found, Run, Study, listed, names


@dataclass(frozen=True)
class NeumipTime(Settings):
    fabric: str = setting("twill 2/2", "A fabric file, or a weave's name.")
    steps: int = setting(8, "Steps that are measured.", low=3)
    queries: int = setting(1 << 18, "Queries that are measured.", low=1 << 8)
    qualities: str = names(",".join(NEUMIP_QUALITIES), "Qualities.", tuple(NEUMIP_QUALITIES))


def measure(settings: NeumipTime, run: Run) -> Found:
    """Processor seconds of queries, steps and whole trainings."""
    require_llvm()
    source = fabric_from_text(settings.fabric)
    btf = btf_of(source, "neumip")
    rows: Figures = {}
    for quality in listed(settings.qualities):
        whole = NEUMIP_QUALITIES[quality]
        few = replace(whole, queries=settings.queries, steps=settings.steps)
        shape = whole.shape(source, btf.faces)
        marks: list[float] = []
        with TemporaryDirectory() as place:
            folder = Path(place)
            taken_queries(source, btf, replace(few, seed=1), folder)
            begun = time.process_time()
            taken_queries(source, btf, few, folder)
            queries = (time.process_time() - begun) / settings.queries * whole.queries
            train_neumip(source, few, folder, _marker(marks))
            fit = time.process_time() - marks[-1]
        # Reports of the queries come first; the first step compiles and allocates.
        step = (marks[-1] - marks[-settings.steps + 1]) / (settings.steps - 2)
        rows[quality] = {
            "texels": f"{shape.columns} × {shape.rows}",
            "queries": whole.queries,
            "cpu_seconds_of_queries": queries,
            "cpu_seconds_of_a_step": step,
            "steps": whole.steps,
            "cpu_seconds_of_proposal": fit / few.sampler_steps * whole.sampler_steps,
            "cpu_minutes": (queries + step * whole.steps) / 60,
        }
    return Found({"fabric": settings.fabric, "steps_measured": settings.steps, "rows": rows})


def _marker(marks: list[float]) -> Callable[[int, int], None]:
    """Keeps the processor seconds of each report."""
    return lambda done, total: marks.append(time.process_time())


def tables(figures: Figures) -> list[Table]:
    """Processor time by quality."""
    keys = ("texels", "queries", "steps", "cpu_seconds_of_queries", "cpu_seconds_of_a_step", "cpu_minutes")
    rows = {quality: [row[key] for key in keys] for quality, row in figures["rows"].items()}
    columns = ["texels", "queries", "steps", "queries, s", "a step, s", "minutes"]
    return [Table("Processor time of a training", columns, rows, f"{figures['fabric']}.")]


STUDY = Study(
    "speed/neumip_time",
    "how long a training of `neumip` takes by quality, extrapolated from a few steps",
    NeumipTime(),
    measure,
    tables,
    stands_on=("neumip",),
    small={"steps": 3, "queries": 1 << 14, "qualities": "preview"},
)
