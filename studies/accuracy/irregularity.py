"""Irregular yarns in pictures: their statistics against those of the process, means, repeats and zooms.

- *statistics*: cloth of one family that shows, whose shade varies, seen straight on at 1, 3 and 10 threads a
  pixel. The picture over that of even cloth is the process, filtered by the film's filter and the footprints:
  deviation and autocorrelation across and along the threads against those computed from its spectrum.
- *means*: pictures of linen and denim over those of their even twins, under a dome and four lights.
- *queries*: errors of `lobes` and `neural` against means over 2048 points, of the two and their even twins.
- *repeats*: the largest autocorrelation of a metre of linen, at lags of more than a tenth of a metre across
  the threads, over what the pictures of other seeds have with it by chance.
- *dolly*: linen and denim from 2 m to 1 cm: the largest step of the mean over a square metre from one of 40
  sizes of footprints to the next, which a seam between regimes would be.
- *shimmer*: FLIP from frame to frame while a camera moves away, over that of `point` with 64 samples.
- *times*: processor time of pictures over those of even twins.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float, require_llvm
from loomlight.core.settings import Settings
from loomlight.evaluation.metrics import flip_mean
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import edited_fabric
from loomlight.mitsuba.plugins import make_bsdf
from loomlight.mitsuba.rendering import render
from loomlight.mitsuba.variants import choose_variant
from loomlight.models.interface import Model
from loomlight.models.registry import make_model
from loomlight.scattering import irregularity
from studies.harness.study import Figures, Found, Run, Study, example, listed, names
from studies.instruments.directions import above
from studies.instruments.timing import least_times

EXAMPLES = ("linen", "denim")
# The warp alone reflects, and its shade alone varies.
ONE_FAMILY = """
weave = "plain"
ends_per_cm = 15
picks_per_cm = 15
interreflection = false
[warp]
albedo = [0.2, 0.2, 0.2]
specular = 0.0
translucency = 0.0
shade = 0.3
[weft]
albedo = [0.0, 0.0, 0.0]
specular = 0.0
translucency = 0.0
"""
LIGHTS: dict[str, dict[str, Any]] = {
    "dome": {"type": "constant", "radiance": 1.0},
    **{
        name: {"type": "directional", "direction": direction, "irradiance": math.pi}
        for name, direction in {
            "above": [0.0, 0.0, -1.0],
            "along the weft": [-0.8, 0.0, -0.6],
            "along the warp": [0.0, 0.9, -0.4],
            "behind": [0.3, 0.2, 0.9],
        }.items()
    },
}
PIXELS = 256
# Of the film's Gaussian, half a pixel wide: what splats samples, and the side of footprints, pixels.
SPLAT, FOOTPRINT_SIDE = 0.4, math.sqrt(12 * (0.5**2 - 0.4**2))
LAGS = 6
# Queries lie within 70 degrees of the normal.
LEAST_COSINE = math.cos(math.radians(70))


def even(fabric: Fabric) -> Fabric:
    """The fabric of even yarns."""
    return edited_fabric(fabric, {"variation.irregularity": 0.0, "variation.colour_noise": 0.0})


def straight_on(
    model: Model, side: float, light: dict[str, Any], spp: int = 64, pixels: int = PIXELS, depth: int = 2
) -> NDArray[np.float64]:
    """A picture [pixels, pixels] of a square of cloth of a side, millimetres, seen straight on."""
    place = mi.ScalarTransform4f()
    half = float(side) / 2000
    scene = mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "footprint_path", "max_depth": depth},
            "sensor": {
                "type": "orthographic",
                "to_world": place.look_at([0, 0, 1], [0, 0, 0], [0, 1, 0]).scale([half, half, 1]),
                "film": {"type": "hdrfilm", "width": pixels, "height": pixels, "pixel_format": "rgb"},
            },
            "light": light,
            "cloth": {
                "type": "rectangle",
                "to_world": place.scale([2 * half, 2 * half, 1]),
                "bsdf": make_bsdf(model, (float(2 * side), float(2 * side))),
            },
        }
    )
    return np.asarray(render(scene, spp=spp), np.float64).mean(axis=-1)


# ---------------------------------------------------------------------------------------------- statistics


def statistics() -> list[dict[str, Any]]:
    """Deviation and autocorrelation of pictures and of the process, by threads a pixel."""
    fabric = fabric_from_text(ONE_FAMILY)
    spacing = 10 / 15
    models = [make_model("lobes", one) for one in (fabric, even(fabric))]
    table = irregularity.irregular_table(fabric.appearance().warp.irregularity, 0.8)
    reflects = float(fabric.appearance().warp.diffuse_reflect[0, 0])
    slope = (1 - reflects) / (1 + reflects)
    rows = []
    for threads in (1, 3, 10):
        pixel = threads * spacing
        pictures = [straight_on(model, PIXELS * pixel, LIGHTS["above"]) for model in models]
        gain = (pictures[0] / pictures[1])[8:-8, 8:-8]
        found = correlations(gain - gain.mean(), LAGS)
        expected = predicted(table, pixel, spacing, slope, LAGS)
        rows.append(
            {
                "threads a pixel": threads,
                "mean": float(gain.mean()),
                "deviation": [float(math.sqrt(part[0, 0])) for part in (found, expected)],
                "across": [(part[0, :] / part[0, 0]).round(4).tolist() for part in (found, expected)],
                "along": [(part[:, 0] / part[0, 0]).round(4).tolist() for part in (found, expected)],
            }
        )
    return rows


def correlations(picture: NDArray[np.float64], lags: int) -> NDArray[np.float64]:
    """Autocovariance [lags, lags] of a picture at lags along (rows) and across the warp (columns)."""
    rows, columns = picture.shape
    return np.array(
        [
            [(picture[: rows - i, : columns - j] * picture[i:, j:]).mean() for j in range(lags)]
            for i in range(lags)
        ]
    )


def predicted(
    table: irregularity.IrregularTable, pixel: float, spacing: float, slope: float, lags: int
) -> NDArray[np.float64]:
    """Autocovariance [lags, lags] of gains that the process predicts for pixels of a side, millimetres."""
    closed = np.concatenate([table.integrals, np.zeros_like(table.integrals[:, :1])], axis=1)
    steps = np.diff(np.diff(closed[: irregularity.ROWS + 1, :, 2].astype(np.float64), axis=0), axis=1)
    power = np.abs(np.fft.rfft(steps * table.units[2], axis=1)) ** 2 / irregularity.SAMPLES**2
    waves = power.mean(axis=0) * np.r_[1.0, np.full(power.shape[1] - 2, 2.0), 1.0]
    f = np.fft.rfftfreq(irregularity.SAMPLES, irregularity.STEP)
    # Footprints are at least a step long, and steps are constant.
    along_side = max(FOOTPRINT_SIDE * pixel, irregularity.STEP)
    kernel = np.sinc(f * along_side) ** 2 * np.exp(-((2 * math.pi * f * SPLAT * pixel) ** 2))
    along = np.array([(waves * kernel * np.cos(2 * math.pi * f * lag * pixel)).sum() for lag in range(lags)])
    # Threads vary independently: white, by steps of a thread.
    f = np.linspace(0, 40 / pixel, 400_001)
    white = spacing * np.sinc(f * spacing) ** 2
    kernel = np.sinc(f * FOOTPRINT_SIDE * pixel) ** 2 * np.exp(-((2 * math.pi * f * SPLAT * pixel) ** 2))
    across = np.array(
        [2 * np.trapezoid(white * kernel * np.cos(2 * math.pi * f * lag * pixel), f) for lag in range(lags)]
    )
    return slope**2 * along[:, None] * across


# --------------------------------------------------------------------------------------------------- means


def means() -> list[dict[str, Any]]:
    """Means of pictures of irregular cloth over those of even cloth, by light and threads a pixel."""
    rows = []
    for name in EXAMPLES:
        fabric = load_fabric(example(name))
        models = [make_model("lobes", one) for one in (fabric, even(fabric))]
        for threads in (1, 3, 10):
            side = 128 * threads * 10 / 15
            ratios = {}
            for light, emitter in LIGHTS.items():
                depth = 3 if light == "dome" else 2
                pictures = [straight_on(model, side, emitter, 32, 128, depth).mean() for model in models]
                ratios[light] = pictures[0] / pictures[1]
            rows.append({"fabric": name, "threads a pixel": threads, "over even cloth": ratios})
    return rows


# ------------------------------------------------------------------------------------------------- queries


def queries(count: int = 2000, points: int = 2048) -> list[dict[str, Any]]:
    """Errors of models against means over points, of linen and denim and their even twins, by footprint."""
    rng = np.random.default_rng(5)
    types = array_types(llvm_float())
    lights, views = (
        types.Vector3(*(types.Float(part.astype(np.float32)) for part in above(rng, count, LEAST_COSINE)))
        for _ in range(2)
    )
    centre = types.Vector2(
        *(types.Float(part.astype(np.float32)) for part in rng.uniform(0, 900, (2, count)))
    )
    rows = []
    for name in EXAMPLES:
        fabric = load_fabric(example(name))
        for kind, one in (("irregular", fabric), ("even", even(fabric))):
            truth_model = make_model("samples", one, points=points)
            models = [make_model(model, one) for model in ("lobes", "neural")]
            for threads in (1.0, 3.0, 10.0):
                side = dr.opaque(types.Float, threads * 10 / 15)
                footprint = Footprint(centre, types.Vector2(side, 0), types.Vector2(0, side))
                truth, *found = (
                    np.array(model.at(views, model.on_cloth(footprint)).value(lights), np.float64)
                    for model in (truth_model, *models)
                )
                errors = {
                    model.name: float(np.abs(got - truth).sum() / truth.sum())
                    for model, got in zip(models, found, strict=True)
                }
                rows.append({"fabric": name, "yarns": kind, "threads": threads, "errors": errors})
    return rows


# ------------------------------------------------------------------------------------------------- repeats


def repeats() -> dict[str, float]:
    """The largest autocorrelation of a metre of linen at far lags across the threads, and by chance."""
    count, side = 1024, 1000.0
    found = []
    fabric = load_fabric(example("linen"))
    for seed in (11, 12):
        model = make_model("lobes", edited_fabric(fabric, {"variation.seed": seed}))
        picture = straight_on(model, side, LIGHTS["above"], 16, count)
        # Slow waves of many threads together are no repeat.
        found.append(picture / picture.mean() - 1)
    spectra = [np.fft.rfft2(picture, (2 * count, 2 * count)) for picture in found]
    far = count // 10
    results = {}
    for name, other in (("with itself", 0), ("with another seed", 1)):
        correlation = np.fft.irfft2(spectra[0] * np.conj(spectra[other]))
        correlation /= math.sqrt((found[0] ** 2).sum() * (found[other] ** 2).sum())
        # Lags at which at least a quarter of the cloth overlaps, away from lag 0.
        near = np.abs(np.fft.fftfreq(2 * count, 1 / (2 * count)))
        allowed = (
            (near[:, None] < count * 0.75) & (near < count * 0.75) & ((near[:, None] > far) & (near > far))
        )
        results[name] = float(np.abs(correlation[allowed]).max())
    return results


# --------------------------------------------------------------------------------------------------- dolly


def dolly(steps: int = 40, count: int = 1 << 17) -> list[dict[str, Any]]:
    """Largest steps of the mean value at random places of a square metre as footprints shrink.

    Pictures of 512 pixels of 2 m have footprints of 4 mm, those of 1 cm of a fiftieth of a millimetre.
    """
    rng = np.random.default_rng(7)
    types = array_types(llvm_float())
    centre = types.Vector2(
        *(types.Float(part.astype(np.float32)) for part in rng.uniform(0, 1000, (2, count)))
    )
    light, view = types.Vector3(-0.8, 0, 0.6), types.Vector3(0.3, 0.2, math.sqrt(1 - 0.13))
    sides = 2000 / 512 * (10 / 2000) ** (np.arange(steps) / (steps - 1))
    rows = []
    for name in EXAMPLES:
        fabric = load_fabric(example(name))
        found = {}
        for kind, one in (("irregular", fabric), ("even", even(fabric))):
            model = make_model("lobes", one)
            means = []
            for each in sides:
                side = dr.opaque(types.Float, float(each))
                footprint = Footprint(centre, types.Vector2(side, 0), types.Vector2(0, side), types.Float(16))
                at = model.at(view, model.on_cloth(footprint))
                means.append(float(np.array(at.value(light), np.float64).mean()))
            found[kind] = np.array(means)
        step = {kind: float(np.abs(np.diff(np.log(means))).max()) for kind, means in found.items()}
        over = found["irregular"] / found["even"]
        rows.append({"fabric": name, "largest step": step, "over even cloth": [over.min(), over.max()]})
    return rows


def shimmer(pairs: int = 8) -> list[dict[str, Any]]:
    """FLIP between neighbouring frames of 60 from 5 to 50 cm, of `lobes` and of `point` with 64 samples."""
    rows = []
    for name in EXAMPLES:
        fabric = load_fabric(example(name))
        found = {}
        for model_name, spp in (("lobes", 64), ("point", 256)):
            model = make_model(model_name, fabric)
            changes = []
            for first in np.linspace(0, 58, pairs).round():
                pictures = [
                    np.repeat(
                        straight_on(model, 25 * 10 ** (frame / 59), LIGHTS["along the weft"], spp, 128)[
                            ..., None
                        ],
                        3,
                        axis=-1,
                    )
                    for frame in (first, first + 1)
                ]
                whole = np.ones(pictures[0].shape[:2], bool)
                first_frame, second = (picture.astype(np.float32) for picture in pictures)
                changes.append(flip_mean(first_frame, second, whole))
            found[model_name] = float(np.mean(changes))
        rows.append({"fabric": name, **found, "ratio": found["lobes"] / found["point"]})
    return rows


# --------------------------------------------------------------------------------------------------- times


def times(rounds: int = 5) -> list[dict[str, Any]]:
    """Processor time of pictures of the drape over those of even cloth, of alternate renderings."""
    from loomlight.mitsuba.pictures import render as picture_of

    rows = []
    for name in EXAMPLES:
        fabric = load_fabric(example(name))
        models = [make_model("lobes", one) for one in (fabric, even(fabric))]
        for zoom in (1.0, 30.0):
            pictures = [
                partial(picture_of, model, scene="drape", size=(480, 360), spp=32, zoom=zoom, inset=False)
                for model in models
            ]
            # Of these the first one compiles.
            best = [each.cpu_seconds for each in least_times(pictures, rounds + 1)]
            rows.append({"fabric": name, "zoom": zoom, "seconds": best, "ratio": best[0] / best[1]})
    return rows


PARTS = {
    "statistics": statistics,
    "means": means,
    "queries": queries,
    "repeats": repeats,
    "dolly": dolly,
    "shimmer": shimmer,
    "times": times,
}


@dataclass(frozen=True)
class Irregularity(Settings):
    parts: str = names(",".join(PARTS), "What is measured.", tuple(PARTS))


def measure(settings: Irregularity, run: Run) -> Found:
    """The figures of all parts that are asked for."""
    require_llvm()
    choose_variant(None)
    return Found(run.each({part: PARTS[part] for part in listed(settings.parts)}))


def tables(figures: Figures) -> list[Table]:
    """A table a part that is there."""
    found = []
    if rows := figures.get("statistics"):
        shown = {
            str(row["threads a pixel"]): [
                *row["deviation"],
                _farthest(row["across"]),
                _farthest(row["along"]),
            ]
            for row in rows
        }
        columns = ["deviation", "predicted", "largest difference of autocorrelations, across", "along"]
        found.append(Table("Statistics of pictures, by threads a pixel", columns, shown))
    if rows := figures.get("means"):
        shown = {
            f"{row['fabric']}, {row['threads a pixel']} threads a pixel": list(
                row["over even cloth"].values()
            )
            for row in rows
        }
        found.append(
            Table("Mean brightness over even cloth", list(rows[0]["over even cloth"]), shown, digits=4)
        )
    if rows := figures.get("queries"):
        shown = {
            f"{row['fabric']}, {row['yarns']}, {row['threads']:g} threads": list(row["errors"].values())
            for row in rows
        }
        found.append(Table("Errors against means over 2048 points", list(rows[0]["errors"]), shown))
    if correlations := figures.get("repeats"):
        shown = {"a metre of linen": list(correlations.values())}
        found.append(Table("Largest autocorrelation at far lags", list(correlations), shown))
    if rows := figures.get("dolly"):
        shown = {row["fabric"]: [*row["largest step"].values(), *row["over even cloth"]] for row in rows}
        columns = ["largest step", "of even cloth", "least mean over even cloth", "largest"]
        found.append(Table("Brightness while footprints shrink", columns, shown))
    if rows := figures.get("shimmer"):
        shown = {row["fabric"]: [row["lobes"], row["point"], row["ratio"]] for row in rows}
        found.append(Table("FLIP from frame to frame", ["lobes", "point, 64 samples", "ratio"], shown))
    if rows := figures.get("times"):
        shown = {f"{row['fabric']}, zoom {row['zoom']:g}": [*row["seconds"], row["ratio"]] for row in rows}
        columns = ["processor s", "of even cloth", "ratio"]
        found.append(Table("Times of pictures", columns, shown))
    return found


def _farthest(pair: list[list[float]]) -> float:
    """The largest difference of two lists of numbers."""
    one, other = np.array(pair)
    return float(np.abs(one - other).max())


STUDY = Study(
    "accuracy/irregularity",
    "irregular yarns in pictures: statistics, means, repeats and zooms",
    Irregularity(),
    measure,
    tables,
    stands_on=("point", "lobes", "picture"),
    small={"parts": "queries"},
)
