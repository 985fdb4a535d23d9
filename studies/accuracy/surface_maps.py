"""Maps over a garment: what mixing a few variants errs, and what a picture with maps costs.

- levels: a number in the middle between two of the four variants that a picture of many greys makes, mixed
  of both, against cloth that has the number itself: mean difference of f·cos over lights and views, seen over
  three threads, over the mean; for the field's whole range and for the lowest four tenths of it.
- times: processor time of pictures of the drape with maps over those without, of alternate renderings.
"""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.backend import array_types, upload_vector
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float, require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric import load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.map_fields import fields_of, range_of
from loomlight.fabric.read import edited_fabric
from loomlight.mitsuba.pictures import render
from loomlight.mitsuba.variants import choose_variant
from loomlight.models.registry import make_model
from studies.harness.study import Figures, Found, Run, Study, example, listed, names
from studies.instruments.timing import least_times

FIELDS = ("roughness", "gap", "specular", "height_scale", "wear")
# Shares of a field's range that pictures of many greys span.
SHARES = (1.0, 0.4)
CASES = ("none", "color", "wear", "wear and gap")


@dataclass(frozen=True)
class Levels(Settings):
    queries: int = setting(4000, "Of each fabric.", low=1)
    fabrics: str = names("denim,linen", "Example fabrics.")
    fields: str = names(",".join(FIELDS), "Fields that maps change.", FIELDS)
    levels: int = setting(4, "Variants of a picture of many greys.", low=2)


@dataclass(frozen=True)
class Times(Settings):
    maps: str = names(
        ",".join(CASES), "What the pictures have; the first is what others cost more than.", CASES
    )
    rounds: int = setting(4, "Pictures of each.", low=1)
    size: tuple[int, int] = setting((480, 360), "Pixels.", low=8)
    spp: int = setting(32, "Samples a pixel.", low=1)


def values(fabric: Fabric, count: int, seed: int = 5) -> NDArray[np.float64]:
    """f·cos [n, 3] of `lobes` over footprints of three threads, from random views under random lights."""
    types = array_types(llvm_float())
    rng = np.random.default_rng(seed)

    def directions() -> Any:
        z = np.sqrt(rng.random(count) * 0.98 + 0.02)
        angle = 2 * np.pi * rng.random(count)
        across = np.sqrt(1 - z * z)
        return upload_vector(types.Vector3, (across * np.cos(angle), across * np.sin(angle), z))

    view, light = directions(), directions()
    width, height = fabric.repeat_mm
    centre = upload_vector(types.Vector2, rng.random((2, count)) * np.array([[width], [height]]))
    side = 3 * float(fabric.layout().warp.spacing.mean())
    model = make_model("lobes", fabric)
    model.upload(types)
    footprint = Footprint(centre, types.Vector2(side, 0), types.Vector2(0, side))
    return np.array(model.at(view, model.on_cloth(footprint)).value(light), np.float64).T


def measure_levels(settings: Levels, run: Run) -> Found:
    """Errors of mixtures."""
    require_llvm()
    rows = []
    for name in listed(settings.fabrics):
        fabric = load_fabric(example(name))
        for field in listed(settings.fields):
            low, high = range_of(fields_of(field)[0])
            for share in SHARES:
                ends = low, low + share * (high - low)
                errors = []
                knots = np.linspace(*ends, settings.levels)
                seen = [values(with_number(fabric, field, float(knot)), settings.queries) for knot in knots]
                for first in range(settings.levels - 1):
                    between = float(knots[first : first + 2].mean())
                    middle = values(with_number(fabric, field, between), settings.queries)
                    mixed = (seen[first] + seen[first + 1]) / 2
                    errors.append(float(np.abs(mixed - middle).mean() / middle.mean()))
                    bias = float(mixed.mean() / middle.mean() - 1)
                    rows.append(
                        {
                            "fabric": name,
                            "field": field,
                            "from": float(knots[first]),
                            "to": float(knots[first + 1]),
                            "error": errors[-1],
                            "bias": bias,
                        }
                    )
    return Found({"levels": rows})


def with_number(fabric: Fabric, field: str, value: float) -> Fabric:
    """The fabric with a number in both families."""
    edits: dict[str, Any] = dict.fromkeys(fields_of(field), value)
    if field == "gap":
        edits |= {f"{family}.width_mm": None for family in ("warp", "weft")}
    return edited_fabric(fabric, edits)


def measure_times(settings: Times, run: Run) -> Found:
    """Processor time of pictures, and of baking what they show."""
    choose_variant(None)
    fabric = load_fabric(example("denim"))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        ramp = Path(folder) / "ramp.png"
        Image.fromarray(np.tile(np.arange(256, dtype=np.uint8), (256, 1))).save(ramp)
        cases: dict[str, dict[str, Any]] = {
            "none": {},
            "color": {"color": ramp},
            "wear": {"wear": ramp},
            "wear and gap": {"wear": ramp, "gap": {"picture": ramp, "high": 0.4}},
        }
        chosen = {name: cases[name] for name in listed(settings.maps)}
        pictures = [
            partial(render, fabric, size=size, spp=spp, inset=False, maps=maps)
            for maps in chosen.values()
            for size, spp in (((32, 24), 1), (settings.size, settings.spp))
        ]
        seconds = [spent.cpu_seconds for spent in least_times(pictures, settings.rounds)]
    for case, start, picture in zip(chosen, seconds[::2], seconds[1::2], strict=True):
        rows.append({"maps": case, "start": start, "picture": picture, "ratio": picture / seconds[1]})
    return Found({"times": rows})


def tables_of_levels(figures: Figures) -> list[Table]:
    """The largest error and bias by field, over the whole range and its lowest four tenths."""
    found = figures["levels"]
    rows: dict[str, list[Cell]] = {}
    for fabric, field in dict.fromkeys((row["fabric"], row["field"]) for row in found):
        own = [row for row in found if (row["fabric"], row["field"]) == (fabric, field)]
        # The whole range comes first.
        parts = np.split(np.array(own), len(SHARES))
        rows[f"{fabric}, `{field}`"] = [100 * max(row["error"] for row in part) for part in parts]
    columns = ["whole range, %", "lowest four tenths, %"]
    return [Table("Largest error of a mixture in the middle", columns, rows)]


def tables_of_times(figures: Figures) -> list[Table]:
    """Processor seconds until a first picture, and of a picture."""
    rows = {row["maps"]: [row["start"], row["picture"], row["ratio"]] for row in figures["times"]}
    return [Table("Pictures with maps", ["start, s", "picture, s", "over none"], rows)]


STUDIES = (
    Study(
        "accuracy/surface_maps_levels",
        "maps over a garment: what mixing a few variants of a fabric errs",
        Levels(),
        measure_levels,
        tables_of_levels,
        stands_on=("lobes",),
        small={"queries": 100, "fabrics": "denim", "fields": "roughness", "levels": 2},
    ),
    Study(
        "accuracy/surface_maps_times",
        "maps over a garment: what a picture with maps costs",
        Times(),
        measure_times,
        tables_of_times,
        stands_on=("lobes", "picture", "lobes cost"),
        small={"maps": "none,wear", "rounds": 1, "size": (32, 24), "spp": 1},
    ),
)
