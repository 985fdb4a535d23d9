"""What a pixel costs on a graphics adapter: operations and bytes counted, and what cards allow at most.

What frames take is `speed/frames`. Counts are of the exported CUDA library, which slangc makes of the same
Slang: it is compiled for the CPU with numbers that count every operation that is executed
(`realtime_counts.cpp`), and runs the footprints and directions of frames. Networks that are trained for one
source have random weights, of which counts do not depend: `neumip` with textures of 64 texels and all of its
networks, `latent` with 128 texels and each decoder. `clustered 2 texels` is `cloth_estimate`. Integer
operations are not counted. Bytes are those of tables: loaded, and of the 32-byte sectors that a workgroup of
8 × 8 pixels touches, which caches deliver; memory delivers each table once a frame, as all tables fit into a
cache of some megabytes, and 24 bytes a pixel. From the counts follow what 60 frames a second take, and the
time on an RTX 4090's published peaks (82.6 TFLOP/s, 1008 GB/s), a bound from below that no program reaches.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from functools import cache, partial

import numpy as np
from numpy.typing import NDArray

from loomlight.core.settings import Settings
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric import load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.models.clustered.model import ClusteredModel
from loomlight.models.texture.settings import DECODERS
from loomlight.realtime.materials import Material
from studies.harness.study import Figures, Found, Run, Study, example, listed, names
from studies.instruments.counted_library import CountedLibrary, Counts, queries_of
from studies.instruments.random_networks import random_latent, random_neumip

# Pixels a thread.
DISTANCES = {"near": 20.0, "middle": 2.0, "far": 0.2}
PIXELS = 1920 * 1080
FRAMES_PER_SECOND = 60
PEAK_FLOPS, PEAK_BYTES = 82.6e12, 1008e9
# Milliseconds that others publish: a neural material without geometry, zeltner2024's shading, zhu2024's at 2
# samples, chen2024's frame.
PUBLISHED = {
    "neural material": 0.18,
    "zeltner2024 shading": 1.54,
    "zhu2024, 2 samples": 8.3,
    "chen2024 frame": 16.7,
}
_GROUPS = 24
# A pixel reads the number of its face, and writes 16 bytes of radiance and 4 of colour.
_PIXEL_BYTES = 24


@dataclass(frozen=True)
class RealtimeSpeed(Settings):
    fabrics: str = names("denim,silk-satin", "Example fabrics.")
    rows: str = names("", "Rows that are counted; by default all.")


def measure(settings: RealtimeSpeed, run: Run) -> Found:
    """Counts by fabric, model and distance."""
    fabrics = [load_fabric(example(name)) for name in listed(settings.fabrics)]
    rows = []
    for fabric in fabrics:
        for name, make in materials_of(fabric).items():
            if settings.rows and name not in listed(settings.rows):
                continue
            model, material, estimates = make()
            library = CountedLibrary(material, model, estimates)
            for distance, pixels in DISTANCES.items():
                counts = library.answers(_queries(fabric, pixels))[1]
                row = {"fabric": fabric.name, "model": name, "distance": distance}
                rows.append(row | _budget(counts, library.table_bytes))
    return Found({"counts": rows, "published_ms": PUBLISHED})


def materials_of(fabric: Fabric) -> dict[str, Callable[[], tuple[str, Material, bool]]]:
    """Functions to the model, what is exported, and whether estimates are counted, by the name of a row."""
    clustered = cache(partial(ClusteredModel.for_source, fabric))

    def of_fabric(name: str) -> tuple[str, Material, bool]:
        return name, fabric, False

    def of_decoder(name: str) -> tuple[str, Material, bool]:
        return "latent", random_latent(fabric, name), False

    return {
        **{name: partial(of_fabric, name) for name in ("lobes", "point", "neural")},
        "clustered": lambda: ("clustered", clustered(), False),
        "clustered 2 texels": lambda: ("clustered", clustered(), True),
        "neumip": lambda: ("neumip", random_neumip(fabric), False),
        **{f"latent {name}": partial(of_decoder, name) for name in DECODERS},
    }


def _queries(fabric: Fabric, pixels: float) -> NDArray[np.void]:
    """Workgroups of 8 × 8 pixels, 30° aslant, `pixels` a thread, anywhere on the cloth."""
    rng = np.random.default_rng(3)
    layout = fabric.layout()
    picks, ends = layout.warp_on_top.shape
    width, height = layout.size
    step = float(np.sqrt(width / ends * height / picks)) / pixels
    angle = np.radians(30)
    right, down = np.array([step, 0.0]), np.array([0.0, step / np.cos(angle)])
    corners = rng.uniform(0, 1, (_GROUPS, 1, 2)) * (10 * width, 10 * height)
    column, row = np.arange(64) % 8, np.arange(64) // 8
    centre = (corners + column[:, None] * right + row[:, None] * down).reshape(-1, 2)
    light = np.array([0.5, 0.3, 0.8]) / np.linalg.norm([0.5, 0.3, 0.8])
    view = np.array([0.0, -np.sin(angle), np.cos(angle)])
    everywhere = (np.tile(vector, (len(centre), 1)) for vector in (right, down, light, view))
    queries = queries_of(centre, *everywhere)
    queries["seed"] = rng.integers(1, 2**32, len(queries), dtype=np.uint32)
    return queries


def _budget(counts: Counts, table_bytes: int) -> Figures:
    """Counts a pixel, what 60 frames a second of 1920 × 1080 take, and times on the published peaks."""
    memory = table_bytes + _PIXEL_BYTES * PIXELS
    return asdict(counts) | {
        "operations": counts.operations,
        "table_bytes": table_bytes,
        "tflops_at_60": counts.operations * PIXELS * FRAMES_PER_SECOND / 1e12,
        "cache_gb_per_s_at_60": counts.sector_bytes * PIXELS * FRAMES_PER_SECOND / 1e9,
        "memory_gb_per_s_at_60": memory * FRAMES_PER_SECOND / 1e9,
        "ms_by_arithmetic_of_4090": 1e3 * counts.operations * PIXELS / PEAK_FLOPS,
        "ms_by_memory_of_4090": 1e3 * memory / PEAK_BYTES,
    }


def tables(figures: Figures) -> list[Table]:
    """Counts of the first fabric by model, near, middle and far."""
    counts = figures["counts"]
    first = counts[0]["fabric"]
    keys = (
        "operations",
        "tflops_at_60",
        "cache_gb_per_s_at_60",
        "memory_gb_per_s_at_60",
        "ms_by_arithmetic_of_4090",
    )
    rows: dict[str, list[Cell]] = {}
    for name in dict.fromkeys(row["model"] for row in counts):
        own = [row for row in counts if (row["fabric"], row["model"]) == (first, name)]
        rows[f"`{name}`"] = [", ".join(_two_digits(row[key]) for row in own) for key in keys]
    columns = ["operations", "TFLOP/s", "GB/s of caches", "GB/s of memory", "ms on an RTX 4090's peak"]
    note = f"{first}; near, middle, far; rates at 60 frames a second of 1080p."
    return [Table("What a pixel costs", columns, rows, note)]


def _two_digits(number: float) -> str:
    if number < 1000:
        return f"{number:.2g}" if number < 10 else f"{number:.0f}"
    return f"{round(number, -2):.0f}"


STUDY = Study(
    "speed/realtime",
    "what a pixel costs on a graphics adapter: operations and bytes",
    RealtimeSpeed(),
    measure,
    tables,
    stands_on=("shaders", "lobes cost", "point cost"),
    small={"fabrics": "denim", "rows": "point"},
)
