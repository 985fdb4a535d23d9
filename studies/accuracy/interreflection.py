"""Light between yarns: models with its closed form against paths through the cloth, under a white sky.

Twelve pairs of weave and colours, six views each. Cloth that scatters like the point model is traced by
`cloth_paths.py`; a model's reflectance is the mean of its values over lights of the whole sphere and places
of the repeat, of the yarn that views meet. The bar is 3 % of the mean of the channels.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from drjit.llvm import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import MODELS, make_model
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.cloth_paths import radiance
from studies.instruments.directions import direction

WEAVES = ("plain", "twill 3/1", "satin 5")
COLOURS = (("#ffffff", "#ffffff"), ("#c03030", "#3050c0"), ("#e0c060", "#f0f0f0"), ("#20305c", "#d8d0c0"))
# Angles from the normal and azimuths, degrees.
VIEWS = ((0, 0), (30, 20), (30, 110), (55, 65), (55, 155), (70, 40))
BAR = 0.03


def fabric_text(weave: str, colours: tuple[str, str]) -> str:
    """A fabric with light between yarns."""
    warp, weft = colours
    return (
        f'weave = "{weave}"\ninterreflection = true\n'
        f'[warp]\ncolor = "{warp}"\n[weft]\ncolor = "{weft}"\ntranslucency = 0.2\n'
    )


def sky_value(model: Any, view: NDArray[np.float64], samples: int, seed: int) -> NDArray[np.float64]:
    """Radiance [3] of the yarn that a view meets under a white sky on both sides."""
    rng = np.random.default_rng(seed)
    width, height = model.fabric.repeat_mm
    x, y = (rng.random((2, samples)) * [[width], [height]]).astype(np.float32)
    centre = Array2f(x, y)
    side, zero = np.full(samples, width / 256, np.float32), np.zeros(samples, np.float32)
    footprint = Footprint(centre, Array2f(side, zero), Array2f(zero, side))
    at = model.at(Array3f(*(np.full(samples, part, np.float32) for part in view)), footprint)
    cosine, around = rng.random(samples), 2 * np.pi * rng.random(samples)
    sine = np.sqrt(1 - cosine**2)
    total = np.zeros(3)
    for sign in (1, -1):
        parts = (sine * np.cos(around), sine * np.sin(around), sign * cosine)
        light = Array3f(*(part.astype(np.float32) for part in parts))
        total += 2 * np.pi * np.array(at.value(light)).astype(np.float64).mean(axis=1)
    shown: NDArray[np.float64] = total / (1 - float(np.mean(Float(at.hole).numpy())))
    return shown


@dataclass(frozen=True)
class Interreflection(Settings):
    models: str = names("point,lobes", "Models.", tuple(MODELS))
    paths: int = setting(1 << 16, "Paths a view.", low=1)
    samples: int = setting(1 << 16, "Lights a view and model.", low=1)
    weaves: str = names(",".join(WEAVES), "Weaves.")
    colours: int = setting(len(COLOURS), "Pairs of colours, the first so many.", low=1, high=len(COLOURS))
    views: int = setting(len(VIEWS), "The first so many.", low=1, high=len(VIEWS))


def measure(settings: Interreflection, run: Run) -> Found:
    """Relative differences of the mean channel by model, weave, colours and view."""
    require_llvm()
    rows = []
    for weave in listed(settings.weaves):
        for colours in COLOURS[: settings.colours]:
            fabric = fabric_from_text(fabric_text(weave, colours))
            models = {name: make_model(name, fabric) for name in listed(settings.models)}
            for number, place in enumerate(VIEWS[: settings.views]):
                view = direction(*place)
                truth = radiance(fabric.layout(), fabric.appearance(), view, settings.paths, 17 + number)
                expected = float((truth.reflected + truth.transmitted).mean())
                row: dict[str, Any] = {
                    "weave": weave,
                    "colours": list(colours),
                    "view_deg": list(place),
                    "paths": expected,
                    "standard_error": float(truth.error.mean()),
                    "scattered_once": float(truth.once.mean()),
                }
                for name, model in models.items():
                    value = float(sky_value(model, view, settings.samples, 5).mean())
                    row[name] = value / expected - 1
                rows.append(row)
    summary = {
        name: {
            "mean": float(np.mean([abs(row[name]) for row in rows])),
            "largest": float(np.max([abs(row[name]) for row in rows])),
            "share_within_bar": float(np.mean([abs(row[name]) <= BAR for row in rows])),
        }
        for name in listed(settings.models)
    }
    lost = float(np.mean([1 - row["scattered_once"] / row["paths"] for row in rows]))
    return Found({"bar": BAR, "summary": summary, "share_that_scatters_again": lost, "rows": rows})


def tables(figures: Figures) -> list[Table]:
    """Differences by model, and those of each view beyond the bar."""
    columns = ["mean, %", "largest, %", "views within the bar, %"]
    rows = {
        f"`{name}`": [100 * found["mean"], 100 * found["largest"], 100 * found["share_within_bar"]]
        for name, found in figures["summary"].items()
    }
    again = 100 * figures["share_that_scatters_again"]
    note = f"Of the light that leaves, {again:.3g} % scatters more than once."
    return [Table("Reflectance against paths", columns, rows, note)]


STUDY = Study(
    "accuracy/interreflection",
    "light between yarns: models against paths through the cloth under a white sky",
    Interreflection(),
    measure,
    tables,
    stands_on=("point", "lobes"),
    small={"paths": 64, "samples": 256, "weaves": "plain", "colours": 1, "views": 1},
)
