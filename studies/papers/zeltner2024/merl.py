"""One network of `latent` for a library of MERL files: how exact is it of each BRDF?

Without a library, `.binary` files of analytic BRDFs over the whole range of roughness are written to
a temporary folder (35 MB each) and read again: they stand for measurements and are none. Every BRDF is asked
at the middle of its cell, about pairs of directions that no training saw; the truth is the file's own value.

- `nmae`: mean absolute difference of f·cos over the mean; `bias`: mean difference over the mean; `smape`;
- `quartiles`, `worst`: of the BRDFs' nmae; `by_roughness`: its mean over each quarter of the analytic BRDFs,
  smooth ones first;
- of each decoder, `bytes`, and `file_bytes`: of texture and networks in float32, and of the files.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from drjit.llvm.ad import Array3f
from numpy.typing import NDArray

from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.models.texture.latent import LatentModel
from loomlight.models.texture.queries import draw_directions, draw_lights
from loomlight.models.texture.settings import DECODERS, LatentOptions
from loomlight.sources.merl import FILE_BYTES, MerlLibrary, load_merl
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.timing import spent
from studies.papers.zeltner2024.analytic_brdfs import write_analytic_library
from studies.papers.zeltner2024.stage import at_texel

_SEED = 999  # of no training
_FLOOR = 1e-4


@dataclass(frozen=True)
class Library(Settings):
    """Which BRDFs are learned, and how."""

    library: os.PathLike[str] | None = setting(
        None, "A folder of .binary files.", otherwise="analytic BRDFs", metavar="FOLDER"
    )
    count: int = setting(100, "Analytic BRDFs.", low=1, high=1000)
    decoders: str = names("2x32", "Hidden layers of each network.", tuple(DECODERS))
    steps: int = setting(2500, "Of a training, of 4096 queries.", low=1, high=10**7)
    pairs: int = setting(2000, "Of directions for each BRDF.", low=1, high=10**6)


def measure(settings: Library, run: Run) -> Found:
    """The errors of each decoder's network."""
    require_llvm()
    with library_of_settings(settings) as library:
        return Found(_figures(library, settings, run))


@contextmanager
def library_of_settings(settings: Library) -> Iterator[MerlLibrary]:
    """The library that is asked for: that of a folder, or analytic BRDFs, written as files and read again."""
    if settings.library is not None:
        yield load_merl(settings.library)
        return
    with TemporaryDirectory() as folder:
        write_analytic_library(folder, settings.count)
        yield load_merl(folder)


def middle_of(library: MerlLibrary, number: int) -> NDArray[np.float32]:
    """The middle of a BRDF's cell [2], millimetres."""
    columns, rows = library.grid
    width, height = library.repeat_mm
    cell = np.array([width / columns, height / rows], np.float32)
    return ((np.array([number % columns, number // columns]) + 0.5) * cell).astype(np.float32)


def _figures(library: MerlLibrary, settings: Library, run: Run) -> Figures:
    return {
        "source": "analytic" if settings.library is None else Path(settings.library).name,
        "brdfs": len(library.names),
        "steps": settings.steps,
        "file_bytes": FILE_BYTES * len(library.names),
        **run.each(
            {name: partial(_of_decoder, library, name, settings) for name in listed(settings.decoders)}
        ),
    }


def _of_decoder(library: MerlLibrary, decoder: str, settings: Library) -> Figures:
    """Figures of a network that is trained for a library."""
    options = LatentOptions(decoder=decoder, steps=settings.steps)
    model, times = spent(partial(LatentModel.for_source, library, options))
    each = [_errors(model, library, number, settings.pairs) for number in range(len(library.names))]
    overall = np.array([errors["nmae"] for errors in each])
    weights = model.weights
    parts = [weights.latents, *([] if weights.frames is None else [weights.frames])]
    parts += [array for layers in weights.layers.values() for layer in layers for array in layer]
    return {
        "train_s": round(times.cpu_seconds, 1),
        "means": {name: _short(np.mean([errors[name] for errors in each])) for name in each[0]},
        "quartiles": [_short(value) for value in np.percentile(overall, (25, 50, 75))],
        "worst": {"name": library.names[int(overall.argmax())], "nmae": _short(overall.max())},
        **({"by_roughness": _by_roughness(library, overall)} if settings.library is None else {}),
        "bytes": 4 * sum(part.size for part in parts),
        "nmae": {name: _short(value) for name, value in zip(library.names, overall, strict=True)},
    }


def _by_roughness(library: MerlLibrary, errors: NDArray[np.float64]) -> list[float]:
    """Mean errors of quarters; names of analytic BRDFs end with their number, smooth ones first."""
    order = np.argsort([name.rsplit("-", 1)[1] for name in library.names])
    return [_short(part.mean()) for part in np.array_split(errors[order], min(4, len(errors)))]


def _errors(model: LatentModel, library: MerlLibrary, number: int, pairs: int) -> Figures:
    """Errors of one BRDF over pairs of directions, lights of which gather about the highlight."""
    rng = np.random.default_rng([_SEED, number])
    views = draw_directions(rng, pairs)
    lights = draw_lights(rng, views)
    truth = library.evaluate(np.full(pairs, number), lights, views).astype(np.float64)
    at = at_texel(model, middle_of(library, number), model.weights.shape.texel_mm, views)
    value = at.value(Array3f(np.ascontiguousarray(lights.T, np.float32)))
    difference = np.array(value, np.float64).T - truth
    size = np.abs(difference)
    return {
        "nmae": size.sum() / truth.sum(),
        "bias": difference.sum() / truth.sum(),
        "smape": (2 * size / (np.abs(difference + truth) + truth + _FLOOR)).mean(),
    }


def _short(value: float | np.floating) -> float:
    return float(f"{float(value):.4g}")


def tables(figures: Figures) -> list[Table]:
    """A row a decoder."""
    columns = ["mean nMAE", "quartiles", "worst", "mean bias", "mean SMAPE", "kB", "seconds of training"]
    table = Table(f"{figures['brdfs']} BRDFs in one network", columns)
    for decoder, found in figures.items():
        if decoder in DECODERS:
            means = found["means"]
            table.rows[decoder] = [
                means["nmae"],
                ", ".join(f"{quartile:.3f}" for quartile in found["quartiles"]),
                found["worst"]["nmae"],
                means["bias"],
                means["smape"],
                found["bytes"] / 1000,
                found["train_s"],
            ]
    return [table]


STUDY = Study(
    "papers/zeltner2024/merl",
    "a library of BRDFs in one network",
    Library(),
    measure,
    tables,
    stands_on=("latent",),
    small={"count": 4, "steps": 4, "pairs": 50},
)
