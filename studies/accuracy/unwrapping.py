"""Garments without uv, cut into pieces: how far they are stretched and off the grain, and what that costs.

    python -m studies.accuracy.unwrapping [--output FILE.json]

- *shapes*: those of `instruments/garment_shapes.py` of 10,000 triangles, the shirt of $LOOMLIGHT_DATA, and it
  with edges halved once and twice: pieces, their names, stretch (median, largest but for a thousandth of the
  area, and largest), degrees off the grain, triangles that are folded over.
- *costs*: processor seconds and the largest memory of a process that cuts the skirt at 10,000, 100,000 and
  1,000,000 triangles, reading not counted; memory is at least that of the process which starts it.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import time
from argparse import Namespace
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from loomlight.mesh.cloth_mesh import MeshPart
from loomlight.mesh.flattening import FlatTriangles, stretches
from loomlight.mesh.reading import read_parts
from loomlight.mesh.unwrap import cut_pieces, with_uv
from studies.instruments.garment_shapes import SHAPES, refined, skirt
from studies.instruments.harness import Figures, run

SHIRT = Path("meshes") / "unisex_shirt.usd"
SIZES = (10_000, 100_000, 1_000_000)


def shapes() -> list[dict[str, Any]]:
    """A row for each mesh."""
    parts = {name: make(10_000) for name, make in SHAPES.items()}
    data = os.environ.get("LOOMLIGHT_DATA")
    if data is not None:
        (part,) = read_parts(Path(data) / SHIRT)
        for times in range(3):
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


def costs() -> list[dict[str, Any]]:
    """A row for each size, each of a process of its own."""
    rows = []
    for size in SIZES:
        command = [sys.executable, "-m", "studies.accuracy.unwrapping", "--cost", str(size)]
        printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        seconds, wall, mebibytes = map(float, printed.split())
        rows.append({"triangles": size, "seconds": seconds, "wall": wall, "mebibytes": mebibytes})
    return rows


def _print_cost(size: int) -> None:
    part = skirt(size)
    begun, wall = time.process_time(), time.perf_counter()
    with_uv([part], cut_pieces([part]))
    usage = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(time.process_time() - begun, time.perf_counter() - wall, usage)


def measure(options: Namespace) -> Figures:
    """The figures of all meshes and sizes."""
    return {"shapes": shapes(), "costs": costs()}


if __name__ == "__main__":
    if sys.argv[1:2] == ["--cost"]:
        _print_cost(int(sys.argv[2]))
    else:
        run(measure)
