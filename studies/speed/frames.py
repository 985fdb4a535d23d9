"""What frames take on the graphics adapter of this machine, beside what their operations would take at best.

All pixels are cloth under one directional light, 0.2 m away, one pass: raster pass, layers of what it saw,
shading, and the rest (shadows, background, tone mapping). Milliseconds are the card's own, by timestamps,
the least of some frames after a first one, in which the driver compiles; on a software driver they are times
until a result is read back. Seconds of whole frames by the clock are beside them, reading back included.

What could be at best follows from what this adapter reaches in loops of multiply-adds and of copies alone
(`studies/instruments/adapter_times.py`), and from the operations and bytes of a pixel that the record of
`speed/realtime` holds. Networks that are trained for one source have random weights, as there. On a software
driver all of it says how that driver works, and nothing of cards.
"""

from __future__ import annotations

import time
from dataclasses import asdict, dataclass
from functools import partial

from loomlight.core.errors import InputError, LoomlightError
from loomlight.core.settings import Settings
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric import load_fabric
from loomlight.models.texture.settings import DECODERS
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.realtime.device import default_adapter
from studies.harness.record import RECORDS, read_record, record_file
from studies.harness.study import Figures, Found, Run, Study, example, listed, names
from studies.instruments.adapter_times import has_clock, measured_limits, pass_times
from studies.speed.realtime import materials_of

MODELS = ("lobes", "point", "clustered", "neural", "neumip", *(f"latent {name}" for name in DECODERS))
# Of the counts, the one whose pixels are about as large on the cloth.
_COUNTED = "middle"
_ROUNDS = 5
# Parts of a frame, and how the names of their passes begin.
_PARTS = {"raster": "raster", "layers": "first_layer", "shading": "shade_"}


@dataclass(frozen=True)
class FrameSpeed(Settings):
    """Of frames that are timed."""

    sizes: str = names("64x64", "Sizes of frames in pixels, such as 1920x1080,3840x2160.")
    models: str = names(",".join(MODELS), "Models whose frames are timed.", MODELS)
    fabric: str = names("denim", "An example fabric.")


def measure(settings: FrameSpeed, run: Run) -> Found:
    """Milliseconds of frames by model and size, and the limits of the adapter.

    Raises:
        InputError: a size that is none.
        MissingDependencyError: there is no adapter.
    """
    sizes = [_size(text) for text in listed(settings.sizes)]
    adapter = default_adapter()
    limits = run.parts.kept("limits", lambda: asdict(measured_limits(adapter)))
    cases = {
        f"{model}, {width} × {height}": partial(_frame, settings.fabric, model, (width, height))
        for width, height in sizes
        for model in listed(settings.models)
    }
    return Found(
        {
            "adapter": adapter.name,
            "is_software": adapter.is_software,
            "timed_by": "timestamps" if has_clock(adapter) else "reading back",
            "limits": limits,
            "frames": list(run.each(cases).values()),
        }
    )


def _size(text: str) -> tuple[int, int]:
    width, cross, height = text.partition("x")
    if not (cross and width.isdigit() and height.isdigit() and min(int(width), int(height)) >= 8):
        raise InputError(f'--sizes "{text}" is no size: write pixels such as 1920x1080, 8 or more each way.')
    return int(width), int(height)


def _frame(fabric: str, row: str, size: tuple[int, int]) -> Figures:
    """Times of a frame and its counts; where an adapter refuses, why."""
    found: Figures = {"model": row, "size": list(size), "counts": _counts(fabric, row)}
    try:
        return found | _times(fabric, row, size)
    except LoomlightError as error:
        return found | {"refused": str(error)}


def _times(fabric: str, row: str, size: tuple[int, int]) -> Figures:
    source = load_fabric(example(fabric))
    model, material, _ = materials_of(source)[row]()
    renderer = Renderer([Cloth(rectangle(1.0, 1.0), material, (1000.0, 1000.0))], size=size, model=model)
    camera, lights = Camera(origin=(0, -0.1, 0.17)), [DirectionalLight(towards=(0.5, 0.3, 0.8))]
    frame = partial(renderer.render, camera, lights, samples=1, passes=1)
    frame()
    times = pass_times(renderer, frame, _ROUNDS)
    parts = dict.fromkeys([*_PARTS, "rest"], 0.0)
    for name, milliseconds in times.within.items():
        part = next((part for part, prefix in _PARTS.items() if name.startswith(prefix)), "rest")
        parts[part] += milliseconds
    seconds = []
    for _ in range(_ROUNDS):
        start = time.perf_counter()
        frame()
        seconds.append(time.perf_counter() - start)
    return {"ms": parts, **asdict(times), "seconds_of_a_frame": min(seconds)}


def _counts(fabric: str, row: str) -> Figures:
    """Operations and bytes a pixel, of the record of `speed/realtime`; none of other fabrics."""
    counted = read_record(record_file(RECORDS, "speed/realtime")).figures["counts"]
    asked = (load_fabric(example(fabric)).name, row, _COUNTED)
    found = [each for each in counted if (each["fabric"], each["model"], each["distance"]) == asked]
    return {key: each[key] for each in found for key in ("operations", "sector_bytes", "table_bytes")}


def tables(figures: Figures) -> list[Table]:
    """Milliseconds of frames by size, and shares of the limits."""
    limits = figures["limits"]
    note = (
        f"{figures['adapter']}{', a software driver' if figures['is_software'] else ''}; timed by "
        f"{figures['timed_by']}. Loops alone reach {limits['flops'] / 1e9:.3g} GFLOP/s and "
        f"{limits['bytes'] / 1e9:.3g} GB/s; shading at best is by these."
    )
    columns = [
        *_PARTS,
        "rest",
        "frame by the clock",
        "operations a pixel",
        "bytes a pixel",
        "shading at best",
        "share of the best",
    ]
    made = []
    sizes = dict.fromkeys(tuple(frame["size"]) for frame in figures["frames"])
    for size in sizes:
        own = [frame for frame in figures["frames"] if tuple(frame["size"]) == size]
        rows = {f"`{frame['model']}`": _row(frame, limits, len(columns)) for frame in own}
        made.append(Table(f"Milliseconds of a frame of {size[0]} × {size[1]}", columns, rows, note))
    return made


def _row(frame: Figures, limits: Figures, count: int) -> list[Cell]:
    if "refused" in frame:
        return [frame["refused"], *[None] * (count - 1)]
    counts, pixels = frame["counts"], frame["size"][0] * frame["size"][1]
    best = None
    if counts:
        best = (
            1e3
            * pixels
            * max(counts["operations"] / limits["flops"], counts["sector_bytes"] / limits["bytes"])
        )
    shading = frame["ms"]["shading"]
    return [
        *(frame["ms"][part] for part in (*_PARTS, "rest")),
        1e3 * frame["seconds_of_a_frame"],
        counts.get("operations"),
        counts.get("sector_bytes"),
        best,
        None if best is None or shading == 0 else best / shading,
    ]


STUDY = Study(
    "speed/frames",
    "milliseconds of frames on a graphics adapter, beside what it could do at best",
    FrameSpeed(),
    measure,
    tables,
    stands_on=("shaders",),
    small={"sizes": "16x16", "models": "point,latent 2x16"},
)
