"""Maps over a garment: what mixing a few variants errs, and what a picture with maps costs.

    python -m studies.accuracy.surface_maps --part levels --output FILE.json

- *levels*: a number in the middle between two of the four variants that a picture of many greys makes, mixed
  of both, against cloth that has the number itself: mean difference of f·cos over lights and views, seen over
  three threads, over the mean; for the field's whole range and for the lowest four tenths of it.
- *times*: processor time of pictures of the drape with maps over those without, of alternate renderings.
"""

from __future__ import annotations

import tempfile
import time
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.backend import array_types
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float, require_llvm
from loomlight.fabric import load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.map_fields import fields_of, range_of
from loomlight.fabric.read import edited_fabric
from loomlight.mitsuba.variants import choose_variant
from loomlight.models.registry import make_model
from studies.instruments.harness import REPOSITORY, Figures, run

EXAMPLES = ("denim", "linen")
FIELDS = ("roughness", "gap", "specular", "height_scale", "wear")
# Variants of a picture of many greys.
LEVELS = 4
QUERIES = 4000


def values(fabric: Fabric, seed: int = 5) -> NDArray[np.float64]:
    """f·cos [n, 3] of `lobes` over footprints of three threads, from random views under random lights."""
    types = array_types(llvm_float())
    rng = np.random.default_rng(seed)

    def directions() -> Any:
        z = np.sqrt(rng.random(QUERIES) * 0.98 + 0.02)
        angle = 2 * np.pi * rng.random(QUERIES)
        across = np.sqrt(1 - z * z)
        return types.Vector3(
            *(row.astype(np.float32) for row in (across * np.cos(angle), across * np.sin(angle), z))
        )

    view, light = directions(), directions()
    width, height = fabric.repeat_mm
    centre = types.Vector2(*((rng.random(QUERIES) * side).astype(np.float32) for side in (width, height)))
    side = 3 * float(fabric.layout().warp.spacing.mean())
    model = make_model("lobes", fabric)
    model.upload(types)
    footprint = Footprint(centre, types.Vector2(side, 0), types.Vector2(0, side))
    return np.array(model.at(view, model.on_cloth(footprint)).value(light), np.float64).T


def levels() -> list[dict[str, Any]]:
    """Errors of mixtures."""
    rows = []
    for name in EXAMPLES:
        fabric = load_fabric(REPOSITORY / "examples" / f"{name}.toml")
        for field in FIELDS:
            low, high = range_of(fields_of(field)[0])
            for share in (1.0, 0.4):
                ends = low, low + share * (high - low)
                errors = []
                knots = np.linspace(*ends, LEVELS)
                seen = [values(with_number(fabric, field, float(knot))) for knot in knots]
                for first in range(LEVELS - 1):
                    middle = values(with_number(fabric, field, float(knots[first : first + 2].mean())))
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
    return rows


def with_number(fabric: Fabric, field: str, value: float) -> Fabric:
    """The fabric with a number in both families."""
    edits: dict[str, Any] = dict.fromkeys(fields_of(field), value)
    if field == "gap":
        edits |= {f"{family}.width_mm": None for family in ("warp", "weft")}
    return edited_fabric(fabric, edits)


def times(rounds: int = 4) -> list[dict[str, Any]]:
    """Processor time of pictures, and of baking what they show."""
    from loomlight.mitsuba.pictures import render

    fabric = load_fabric(REPOSITORY / "examples" / "denim.toml")
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
        spent: dict[str, list[tuple[float, float]]] = {case: [] for case in cases}
        for _ in range(rounds):
            for case, maps in cases.items():
                began = time.process_time()
                render(fabric, size=(32, 24), spp=1, inset=False, maps=maps)
                ready = time.process_time()
                render(fabric, size=(480, 360), spp=32, inset=False, maps=maps)
                spent[case].append((ready - began, time.process_time() - ready))
        plain = np.min(spent["none"], axis=0)
        for case, seconds in spent.items():
            start, picture = np.min(seconds, axis=0)
            rows.append({"maps": case, "start": start, "picture": picture, "ratio": picture / plain[1]})
    return rows


PARTS = {"levels": levels, "times": times}


def measure(options: Namespace) -> Figures:
    """The figures of all parts, or of one."""
    require_llvm()
    choose_variant(None)
    chosen = PARTS if options.part is None else {options.part: PARTS[options.part]}
    return {name: part() for name, part in chosen.items()}


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--part", choices=PARTS, help="one part alone")


if __name__ == "__main__":
    run(measure, _add_options)
