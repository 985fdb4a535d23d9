"""How much noise the sampler of a model saves: variances of weights against those of a cosine on either side.

Footprints of 0.05 to 5 threads lie anywhere, and views all around. A weight is the luminance of f·cos over
the density, times the sky's radiance in that direction, given that light does not pass straight through a
hole. The cosine knows the shares of both sides: each is drawn in proportion to what it scatters. A row has,
under a white sky and under the environment if one is given,

- `gain`: variance of the cosine over that of the sampler, both summed over places; above 1 the sampler is
  better; `median_gain` is the median over places;
- `deviation`: of the sampler, over the mean;
- `mean_ratio`: of both means, which estimate the same number;
- `largest`, `largest_by_cosine`: the largest weights of all, under a white sky;
- `sample_ns`: CPU nanoseconds of a view and a sample of it, the least of three; `cosine_ns` of a view and a
  value, as a cosine's sample needs; `equal_time_gain`: the gain times the second over the first;
- of a `.loom` of a Mitsuba material, `source_gain`: the variance of the material's own sampler, at the middle
  of the footprint, over that of the model's; `source_ns`, and `source_equal_time_gain`, by their product.
"""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Cell, Table
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.registry import MODELS, make_model, model_from_loom, parse_options
from loomlight.sources.load import load_source
from loomlight.sources.material import Material
from studies.accuracy.learned_sources import SOURCES, baked, source_of
from studies.harness.study import REPOSITORY, Figures, Found, Run, Study, example, listed, names
from studies.instruments.luminance import LUMINANCE

_THREADS = 0.05, 5.0
_TEXELS = 64  # across sources without threads
_SEED = 999
_BRIGHTEST = 10.0  # of a sky, over its mean
_SOURCES_HELP = "Example fabrics, .loom files, or sources of the gallery, which are trained first."

_Floats = NDArray[np.float64]
T = TypeVar("T")


class _Sky:
    """Radiance by direction: white, or a latitude-longitude picture that z is up in, its sun dimmed."""

    def __init__(self, file: os.PathLike[str] | None) -> None:
        self._picture: _Floats | None = None
        if file is not None:
            import mitsuba as mi

            mi.set_variant("scalar_rgb")
            picture = np.array(mi.Bitmap(str(file)), np.float64)[..., :3] @ LUMINANCE
            # What is brighter, light samples find: a few texels would decide everything.
            picture = np.minimum(picture, _BRIGHTEST * picture.mean())
            rows = np.sin((np.arange(len(picture)) + 0.5) / len(picture) * math.pi)[:, None]
            self._picture = picture / ((picture * rows).sum() / (rows.sum() * picture.shape[1]))

    def radiance(self, light: _Floats) -> _Floats:
        """Luminances in directions [3, n]."""
        if self._picture is None:
            return np.ones(light.shape[1])
        rows, columns = self._picture.shape
        row = np.arccos(np.clip(light[2], -1, 1)) / math.pi * rows
        column = (np.arctan2(light[1], light[0]) / (2 * math.pi) + 0.5) * columns
        found: _Floats = self._picture[
            np.minimum(row.astype(int), rows - 1), np.minimum(column.astype(int), columns - 1)
        ]
        return found


@dataclass(frozen=True)
class Sampling(Settings):
    sources: str = names("denim,silk-satin,organza,linen,wool-houndstooth", _SOURCES_HELP)
    model: str = setting("neural", "Of fabrics.", choices=tuple(MODELS))
    options: str = names("", "Of that model: name=value.")
    environment: os.PathLike[str] | None = setting(None, "A picture of a sky.")
    places: int = setting(1000, "Places and views.", low=1)
    samples: int = setting(64, "Directions of each.", low=8)


def measure(settings: Sampling, run: Run) -> Found:
    """A row for each source."""
    require_llvm()
    skies = {"white": _Sky(None)}
    if settings.environment is not None:
        skies["environment"] = _Sky(settings.environment)
    cases = {
        Path(name).stem: partial(_rounded_row, name, settings, skies, run.runs)
        for name in listed(settings.sources)
    }
    return Found(
        {
            "model": settings.model,
            "options": listed(settings.options),
            "places": settings.places,
            "samples": settings.samples,
            "rows": run.each(cases),
        }
    )


def _model(name: str, settings: Sampling, runs: Path) -> Model:
    if name in SOURCES:
        return model_from_loom(baked(name, source_of(name, runs / "learned_sources"), runs))
    if name.endswith(".loom"):
        return model_from_loom(name)
    source = load_source(name if Path(name).suffix else example(name), "fabric")
    return make_model(settings.model, source, parse_options(settings.model, listed(settings.options)))


def _rounded_row(name: str, settings: Sampling, skies: dict[str, _Sky], runs: Path) -> Figures:
    row = _row(_model(name, settings, runs), settings, skies)
    return {key: float(f"{value:.4g}") for key, value in row.items()}


def _row(model: Model, settings: Sampling, skies: dict[str, _Sky]) -> Figures:
    places, samples = settings.places, settings.samples
    rng = np.random.default_rng(_SEED)
    view, footprint = _places(model, rng, places, samples)
    at = model.at(view, footprint)
    numbers = [Float(rng.random(places * samples, np.float32)) for _ in range(3)]
    dr.eval(view, footprint, numbers)
    drawn, seconds = _timed(lambda: model.at(view, footprint).sample(numbers[0], Array2f(*numbers[1:])))
    is_null = np.array(drawn.is_null)
    scatters = ~is_null.reshape(places, samples)
    own_light = np.array(drawn.light, np.float64)
    own = np.where(is_null, 0, LUMINANCE @ np.array(drawn.weight, np.float64))
    sides = [_by_cosine(at, rng, side) for side in (1, -1)]
    by_cosine = Array3f(sides[0][1].astype(np.float32))
    cosine_seconds = _timed(lambda: model.at(view, footprint).value(by_cosine))[1]
    energies = [weights.reshape(places, samples).mean(axis=1) for weights, _ in sides]
    total = np.maximum(energies[0] + energies[1], 1e-9)
    # Neither share is 0: an energy is an estimate.
    first = np.clip(energies[0] / total, 0.01, 0.99)
    shares = [first, 1 - first]
    row: Figures = {}
    for name, spent in (("sample", seconds), ("cosine", cosine_seconds)):
        row[f"{name}_ns"] = 1e9 * spent / (places * samples)
    source = None
    if isinstance(model.source, Material):
        source = _by_source(model.source, view, footprint, numbers)
        row["source_ns"] = 1e9 * source.seconds / (places * samples)
    for name, sky in skies.items():
        grid = (own * sky.radiance(own_light)).reshape(places, samples)
        # Given that light does not pass through a hole, f·cos over the density is smaller by that share.
        grid = np.where(scatters, grid * scatters.mean(axis=1, keepdims=True), np.nan)
        mean, moment = np.zeros(places), np.zeros(places)
        for (weights, light), share in zip(sides, shares, strict=True):
            side = (weights * sky.radiance(light)).reshape(places, samples)
            mean += side.mean(axis=1)
            moment += (side**2).mean(axis=1) / share
        seen = scatters.sum(axis=1) > samples // 8
        grid, mean, moment = grid[seen], mean[seen], moment[seen]
        own_variance, variance = np.nanvar(grid, axis=1), np.maximum(moment - mean**2, 0)
        prefix = "" if name == "white" else f"{name}_"
        row[f"{prefix}gain"] = variance.mean() / own_variance.mean()
        row[f"{prefix}equal_time_gain"] = row[f"{prefix}gain"] * row["cosine_ns"] / row["sample_ns"]
        row[f"{prefix}median_gain"] = float(np.median(variance / np.maximum(own_variance, 1e-12)))
        row[f"{prefix}mean_ratio"] = np.nanmean(grid, axis=1).mean() / mean.mean()
        row[f"{prefix}deviation"] = math.sqrt(own_variance.mean()) / mean.mean()
        if source is not None:
            of_source = (source.weights * sky.radiance(source.light)).reshape(places, samples)
            gain = of_source.var(axis=1).mean() / own_variance.mean()
            row[f"{prefix}source_gain"] = gain
            row[f"{prefix}source_mean_ratio"] = of_source.mean() / np.nanmean(grid, axis=1).mean()
            row[f"{prefix}source_equal_time_gain"] = gain * row["source_ns"] / row["sample_ns"]
    row["largest"] = own.max()
    row["largest_by_cosine"] = max(
        float((weights.reshape(places, samples) / share[:, None]).max())
        for (weights, _), share in zip(sides, shares, strict=True)
    )
    return row


def _timed(compute: Callable[[], T]) -> tuple[T, float]:
    """What a function returns, and its least CPU seconds of three."""
    times = []
    for _ in range(3):
        dr.sync_thread()
        start = time.process_time()
        found = compute()
        dr.eval(found)
        dr.sync_thread()
        times.append(time.process_time() - start)
    return found, min(times)


@dataclass(frozen=True, eq=False)
class _OfSource:
    """Luminances of weights [n], directions [3, n], and CPU seconds of a source's own sampler."""

    weights: _Floats
    light: _Floats
    seconds: float


def _by_source(source: Material, view: Array3f, footprint: Footprint, numbers: Sequence[Float]) -> _OfSource:
    """Directions that a material's BSDF draws itself."""
    import mitsuba as mi

    from loomlight.mitsuba.material_btf import material_bsdf_of

    mi.set_variant("llvm_ad_rgb")
    bsdf: Any = material_bsdf_of(source)
    context: Any = mi.BSDFContext()
    width, height = source.repeat_mm

    def sample() -> Any:
        si: Any = dr.zeros(mi.SurfaceInteraction3f, dr.width(view))
        si.uv = mi.Point2f(footprint.centre.x / width, footprint.centre.y / height)
        si.n, si.dp_du, si.dp_dv = mi.Normal3f(0, 0, 1), mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0)
        si.sh_frame = mi.Frame3f(si.dp_du, si.dp_dv, si.n)
        si.wi = mi.Vector3f(view.x, view.y, dr.abs(view.z))
        drawn, weight = bsdf.sample(context, si, numbers[0], mi.Point2f(*numbers[1:]))
        return drawn.wo, weight

    (light, weight), seconds = _timed(sample)
    toward = np.array(light, np.float64)
    toward[2] *= np.sign(np.array(view.z))
    return _OfSource(LUMINANCE @ np.nan_to_num(np.array(weight, np.float64)), toward, seconds)


def _places(model: Model, rng: np.random.Generator, places: int, samples: int) -> tuple[Array3f, Footprint]:
    """Views and square footprints, each repeated."""
    width, height = model.source.repeat_mm
    centre = rng.random((2, places)) * [[width], [height]]
    threads = np.exp(rng.uniform(math.log(_THREADS[0]), math.log(_THREADS[1]), places))
    ends = model.source.layout().warp_on_top.shape[1] if hasattr(model.source, "layout") else _TEXELS
    side = threads * width / ends
    view = rng.normal(size=(3, places))
    view /= np.linalg.norm(view, axis=0)
    centres, views = (np.repeat(part, samples, axis=1).astype(np.float32) for part in (centre, view))
    sides = Float(np.repeat(side, samples).astype(np.float32))
    return Array3f(views), Footprint(Array2f(centres), Array2f(sides, 0), Array2f(0, sides))


def _by_cosine(at: FootprintBsdf, rng: np.random.Generator, side: int) -> tuple[_Floats, _Floats]:
    """Luminances of weights, and cosine directions on the view's side (1) or on the other one."""
    view = np.array(at.view)
    u, azimuth = rng.random(view.shape[1]), 2 * math.pi * rng.random(view.shape[1])
    height = np.sqrt(np.maximum(1 - u, 1e-7))
    light = np.stack([np.sqrt(u) * np.cos(azimuth), np.sqrt(u) * np.sin(azimuth), height])
    light[2] *= side * np.where(view[2] < 0, -1, 1)
    value = np.array(at.value(Array3f(light.astype(np.float32))), np.float64)
    return (LUMINANCE @ value) * math.pi / height, light


def tables(figures: Figures) -> list[Table]:
    """Variances of a cosine over the sampler's, a row a source, under each sky."""
    rows: dict[str, list[Cell]] = {}
    for name, row in figures["rows"].items():
        cells: list[Cell] = []
        for key in ("gain", "equal_time_gain", "median_gain", "source_equal_time_gain"):
            cells += [row.get(key), row.get(f"environment_{key}")]
        rows[name] = [*cells, row["largest_by_cosine"], row["largest"]]
    gains = ("gain", "at equal time", "in the median place", "of its own sampler at equal time")
    columns = [f"{gain}: {sky}" for gain in gains for sky in ("white", "sky")]
    return [
        Table(
            "Variance of a cosine over the sampler's", [*columns, "largest weight: cosine", "sampler"], rows
        )
    ]


_FEW = {"sources": "denim", "places": 20}
STUDIES = (
    Study(
        "accuracy/sampling_neural_learned",
        "noise that the network's sampler of `neural` saves over cosines",
        Sampling(options="sampler=learned"),
        measure,
        tables,
        stands_on=("neural", "network"),
        small=_FEW,
    ),
    Study(
        "accuracy/sampling_neural_lobes",
        "noise that the fibre lobes in the place of that network save",
        Sampling(options="sampler=lobes"),
        measure,
        tables,
        stands_on=("neural", "network"),
        small=_FEW,
    ),
    Study(
        "accuracy/sampling_learned_sources",
        "noise that samplers of `neumip` and `latent` save on the gallery's sources",
        Sampling(
            sources=",".join(SOURCES),
            environment=REPOSITORY / "examples" / "room.exr",
            places=2000,
        ),
        measure,
        tables,
        stands_on=("neumip", "latent"),
        small={**_FEW, "model": "lobes", "environment": None},
    ),
)
