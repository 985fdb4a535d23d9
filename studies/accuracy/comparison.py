"""Models side by side, as `loomlight compare` has them: pictures of eight scenes, and queries of one fabric.

Each fabric is compared as the command does it, which writes its page into the folder of runs. Tables are
those of that page: FLIP and errors of pictures by scene, and what models answer to the same queries, with
their costs and sizes.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from pathlib import Path

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.compare import compare
from loomlight.evaluation.table import Cell, Table
from loomlight.mitsuba.measured_scenes import MEASURED_SCENES
from loomlight.models.registry import MODELS
from studies.harness.study import Figures, Found, Run, Study, example, listed, names


@dataclass(frozen=True)
class Compared(Settings):
    fabrics: str = names("denim", "Example fabrics.")
    models: str = names("point,lobes,neural", "Models.", tuple(MODELS))
    scenes: str = names(",".join(MEASURED_SCENES), "Scenes.", tuple(MEASURED_SCENES))
    size: tuple[int, int] = setting((400, 225), "Pixels.", low=8)
    spp: int = setting(64, "Samples a pixel of the reference.", low=1)


def measure(settings: Compared, run: Run) -> Found:
    """Tables by fabric."""
    cases = {name: partial(_of_fabric, name, settings, run) for name in listed(settings.fabrics)}
    return Found({"size": list(settings.size), "spp": settings.spp, "fabrics": run.each(cases)})


def _of_fabric(name: str, settings: Compared, run: Run) -> Figures:
    folder = Path(run.runs, "compared", name)
    folder.parent.mkdir(parents=True, exist_ok=True)
    found = compare(
        example(name),
        listed(settings.models),
        folder,
        scenes=listed(settings.scenes),
        size=settings.size,
        reference_samples=settings.spp,
        progress=lambda what, done, total: run.report(done, total),
    )
    return {"refused": found.refused, "tables": [table.to_dict() for table in found.tables]}


def tables(figures: Figures) -> list[Table]:
    """Mean FLIP by fabric, and models asked the same."""
    flip: dict[str, list[Cell]] = {}
    asked: list[Table] = []
    for found in figures["fabrics"].values():
        by_title = {table["title"]: Table.from_dict(table) for table in found["tables"]}
        for row, cells in by_title["Mean FLIP"].rows.items():
            values = [cell for cell in cells if isinstance(cell, float)]
            flip.setdefault(row, []).append(sum(values) / len(values))
        asked += [by_title[title] for title in ("All models",) if title in by_title]
    return [Table("Mean FLIP of the scenes", list(figures["fabrics"]), flip), *asked]


STUDIES = (
    Study(
        "accuracy/image_benchmark",
        "pictures of eight scenes by each model against many samples: FLIP of four fabrics",
        Compared(fabrics="denim,silk-satin,wool-houndstooth,linen"),
        measure,
        tables,
        stands_on=("point", "lobes", "neural", "network", "picture"),
        small={"fabrics": "denim", "models": "point", "scenes": "flat far", "size": (16, 16), "spp": 4},
    ),
    Study(
        "accuracy/comparison_denim",
        "all models on denim, asked the same: errors, costs, sizes and bakes",
        Compared(models=",".join(MODELS), scenes="flat middle", size=(48, 27), spp=4),
        measure,
        tables,
        stands_on=tuple(name for name in MODELS if name != "samples"),
        small={"models": "point", "scenes": "flat far", "size": (16, 16)},
    ),
)
