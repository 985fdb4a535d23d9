"""Garments without uv, cut into pieces: how far they are stretched and off the grain, and what that costs.

- *shapes*: those of `instruments/garment_shapes.py` of 10,000 triangles, the shirt of $LOOMLIGHT_DATA, and it
  with edges halved once and twice: pieces, their names, stretch (median, largest but for a thousandth of the
  area, and largest), degrees off the grain, triangles that are folded over.
- *costs*: processor seconds and the largest memory of a process that cuts the skirt at 10,000, 100,000 and
  1,000,000 triangles, reading not counted; memory is at least that of the process which starts it.
"""

from __future__ import annotations

import os
import resource
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.mesh.cloth_mesh import MeshPart
from loomlight.mesh.flattening import FlatTriangles, stretches
from loomlight.mesh.reading import read_parts
from loomlight.mesh.unwrap import cut_pieces, with_uv
from studies.harness.study import Figures, Found, Run, Study, listed_numbers
from studies.instruments.garment_shapes import SHAPES, refined, skirt
from studies.instruments.processes import in_own_process

SHIRT = Path("meshes") / "unisex_shirt.usd"


def shapes(triangles: int, halvings: int) -> list[dict[str, Any]]:
    """A row for each mesh; edges of the shirt are halved up to that many times."""
    parts = {name: make(triangles) for name, make in SHAPES.items()}
    data = os.environ.get("LOOMLIGHT_DATA")
    if data is not None:
        (part,) = read_parts(Path(data) / SHIRT)
        for times in range(halvings + 1):
            parts[f"shirt, refined {times} times" if times else "shirt"] = part
            part = replace(part, mesh=refined(part.mesh))
    return [_row(name, part) for name, part in parts.items()]


def _row(name: str, part: MeshPart) -> dict[str, Any]:
    found, mesh = cut_pieces([part]), part.mesh
    flat = FlatTriangles.of(mesh.positions[mesh.triangles], found.corners)
    stretch = stretches(flat.jacobian(found.uv))
    return {
        "mesh": name,
        "triangles": len(mesh.triangles),
        "pieces": found.count,
        "names": found.names,
        "stretch": found.stretch,
        "worst": found.worst,
        "largest": float(stretch[np.isfinite(stretch)].max()),
        "angle": found.angle,
        "folded": int(np.isinf(stretch).sum()),
    }


def costs(sizes: list[float]) -> list[dict[str, Any]]:
    """A row for each size, each of a process of its own."""
    return [{"triangles": int(size), **in_own_process(cost, int(size))} for size in sizes]


def cost(size: int) -> dict[str, float]:
    """What cutting a skirt costs this process: seconds of the processor and by the clock, and its peak."""
    part = skirt(size)
    begun, wall = time.process_time(), time.perf_counter()
    with_uv([part], cut_pieces([part]))
    usage = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return {
        "seconds": time.process_time() - begun,
        "wall": time.perf_counter() - wall,
        "mebibytes": usage,
    }


@dataclass(frozen=True)
class Unwrapping(Settings):
    triangles: int = setting(10_000, "Of each shape.", low=100)
    halvings: int = setting(2, "Times that the edges of the shirt are halved.", low=0, high=4)
    sizes: str = setting("10000,100000,1000000", "Triangles of the skirts that are timed.", metavar="N,…")


def measure(settings: Unwrapping, run: Run) -> Found:
    """The figures of all meshes and sizes."""
    sizes = listed_numbers("sizes", settings.sizes)
    return Found({"shapes": shapes(settings.triangles, settings.halvings), "costs": costs(sizes)})


def tables(figures: Figures) -> list[Table]:
    """A row a mesh, and one a size."""
    columns = ["triangles", "pieces", "stretch", "but a thousandth", "largest", "off the grain", "folded"]
    keys = ("triangles", "pieces", "stretch", "worst", "largest", "angle", "folded")
    meshes = {row["mesh"]: [row[key] for key in keys] for row in figures["shapes"]}
    sizes = {
        f"{row['triangles']:,}": [row["seconds"], row["wall"], row["mebibytes"]] for row in figures["costs"]
    }
    return [
        Table("Garments cut into pieces", columns, meshes),
        Table("What cutting a skirt costs", ["processor s", "s", "MiB"], sizes),
    ]


STUDY = Study(
    "accuracy/unwrapping",
    "garments without uv, cut into pieces: stretch, degrees off the grain, and what it costs",
    Unwrapping(),
    measure,
    tables,
    stands_on=("mesh",),
    small={"triangles": 500, "halvings": 0, "sizes": "500"},
)
