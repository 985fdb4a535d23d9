"""zeltner2024's supplemental, figures 6 to 37: polar plots of values and of the sampler's density.

Figures 6 and 7 are of a library of BRDFs in one network of 3×64, a plot of each; 8 to 37 of materials, by
decoders of all sizes, at several texels from two views. Each plot is a plane of incidence: f·cos of the
reference (black) and of the model (blue), and the sampler's density (orange), scaled to the model's mean,
over the light's angle. The radius is logarithmic and spans three decades below the largest value.

The MERL database is not at hand: BRDFs are analytic unless `--library` names a folder of its files.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from drjit.llvm.ad import Array3f
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from loomlight.core.llvm import require_llvm
from loomlight.evaluation.table import Table
from loomlight.mitsuba import choose_variant
from loomlight.mitsuba.material_btf import MaterialBtf
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.texture.latent import LatentModel
from loomlight.models.texture.queries import footprint_values
from loomlight.models.texture.settings import DECODERS, LatentOptions
from studies.harness.study import Found, Pixels, Run, Study, listed, with_tables
from studies.instruments.sheet import PictureTable, Row, Tile, contact_sheet
from studies.papers.zeltner2024.merl import Library, library_of_settings, middle_of
from studies.papers.zeltner2024.stage import StageSettings, at_texel, trained

# Texels of uv, and angles of the view from the normal, degrees.
PLACES = ((0.3, 0.4), (0.55, 0.6), (0.7, 0.3))
VIEWS = (15.0, 60.0)
_DIRECTIONS = 361
# Of the library's plots, and how many stand beside one another.
LIBRARY_VIEW, _ACROSS = 45.0, 10
_CURVES = (
    "The plane of incidence: f·cos of the reference (black) and of the network (blue), the sampler's density "
    "(orange), logarithmic over three decades,"
)
_SIDE, _DECADES = 200, 3.0
_INK, _MODEL, _DENSITY, _FAINT = (20, 20, 20), (40, 90, 220), (230, 130, 20), (205, 205, 205)


@dataclass(frozen=True, eq=False)
class Profile:
    """Values over the light's angle in a plane of incidence.

    Attributes:
        angles: of lights from the normal, radians; the view's is positive.
        view: the view's, radians.
        reference, model: mean of the channels of f·cos, 1/sr.
        density: of the sampler, 1/sr.
    """

    angles: NDArray[np.float64]
    view: float
    reference: NDArray[np.float64]
    model: NDArray[np.float64]
    density: NDArray[np.float64]

    @property
    def scaled_density(self) -> NDArray[np.float64]:
        """The density times the factor that gives it the model's mean."""
        return self.density * (self.model.mean() / max(self.density.mean(), 1e-9))


def profile(
    model: Model,
    btf: MaterialBtf,
    resolution: int,
    place: tuple[float, float],
    view_degrees: float,
    samples: int,
) -> Profile:
    """The profile at a texel; the reference is filtered over it.

    Args:
        resolution: texels a side.
        samples: of the reference.
    """
    light, views = plane_of_incidence(view_degrees)
    count = len(light)
    uv = np.tile(np.array(place, np.float32), (count, 1))
    texels = btf.texels(resolution)
    values = [
        footprint_values(btf, texels, uv, np.zeros(count, np.float32), light, views, (seed,))
        for seed in range(samples)
    ]
    size = np.array(model.source.repeat_mm, np.float32)
    at = at_texel(model, uv[0] * size, min(model.source.repeat_mm) / resolution, views)
    return profile_of(at, np.mean(values, axis=0), view_degrees)


def plane_of_incidence(view_degrees: float) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Lights [n, 3] from horizon to horizon in the plane of a view and the normal, and that view [n, 3]."""
    angles, view = _light_angles(), math.radians(view_degrees)
    light = np.stack([np.sin(angles), 0 * angles, np.cos(angles)], axis=1).astype(np.float32)
    return light, np.tile(np.array([math.sin(view), 0, math.cos(view)], np.float32), (len(light), 1))


def _light_angles() -> NDArray[np.float64]:
    return np.linspace(-0.5, 0.5, _DIRECTIONS) * np.radians(178)


def profile_of(at: FootprintBsdf, reference: NDArray[np.float32], view_degrees: float) -> Profile:
    """The profile of a BSDF of lights and views of `plane_of_incidence`.

    Args:
        reference: f·cos [n, 3] of the same directions.
    """
    lights, _ = plane_of_incidence(view_degrees)
    value, density = at.value_and_pdf(Array3f(lights.T.copy()))
    return Profile(
        _light_angles(),
        math.radians(view_degrees),
        reference.mean(axis=1).astype(np.float64),
        np.array(value, np.float64).mean(axis=0),
        np.array(density, np.float64),
    )


def polar_plot(shown: Profile) -> Pixels:
    """The plot, sRGB [side / 2, side, 3]."""
    image = Image.new("RGB", (_SIDE, _SIDE // 2 + 12), (255, 255, 255))
    draw = ImageDraw.Draw(image)
    middle, base, radius = _SIDE / 2, _SIDE / 2 + 4, _SIDE / 2 - 8
    for ring in range(1, int(_DECADES) + 1):
        r = radius * ring / _DECADES
        draw.arc((middle - r, base - r, middle + r, base + r), 180, 360, _FAINT)
    draw.line((middle - radius, base, middle + radius, base), _FAINT)
    x, y = math.sin(shown.view), math.cos(shown.view)
    draw.line((middle, base, middle + radius * x, base - radius * y), _FAINT)
    top = max(shown.reference.max(), shown.model.max(), 1e-6)
    curves = ((shown.scaled_density, _DENSITY), (shown.reference, _INK), (shown.model, _MODEL))
    for values, colour in curves:
        length = radius * np.clip(1 + np.log10(np.maximum(values, 1e-12) / top) / _DECADES, 0, 1)
        points = zip(
            middle + length * np.sin(shown.angles), base - length * np.cos(shown.angles), strict=True
        )
        draw.line([(float(a), float(b)) for a, b in points], colour, 1)
    return np.asarray(image)


def polar_plots(settings: StageSettings, run: Run) -> Found:
    """Plots of all materials, and their errors in the plane of incidence."""
    choose_variant()
    columns = [f"{u:g}, {v:g} at {view:g}°" for u, v in PLACES for view in VIEWS]
    table = Table("Mean |log10(model / reference)| above a thousandth of the largest value", columns)
    pictures = PictureTable("zeltner2024 supplemental, figures 8 to 37: polar plots", columns)
    cases = [(source, decoder) for source in settings.sources() for decoder in DECODERS]
    means: dict[str, list[float]] = {decoder: [] for decoder in DECODERS}
    for number, (source, decoder) in enumerate(cases):
        model, btf = trained(source, settings, run.runs, decoder), MaterialBtf(source)
        tiles, errors = [], []
        for place in PLACES:
            for view in VIEWS:
                shown = profile(model, btf, settings.resolution, place, view, settings.spp)
                errors.append(decades(shown.model, shown.reference))
                tiles.append(Tile(polar_plot(shown), f"{errors[-1]:.3f}"))
        label = f"{source.name}, {decoder.replace('x', '×')}"
        table.rows[label] = [*errors]
        pictures.add(label, tiles)
        means[decoder] += errors
        run.report(number + 1, len(cases))
    columns = [decoder.replace("x", "×") for decoder in DECODERS]
    spread = Table("Decades by decoder", columns)
    spread.rows["half of the plots below"] = [float(np.median(each)) for each in means.values()]
    spread.rows["worst"] = [max(each) for each in means.values()]
    return pictures.found(with_tables(spread, table), f"{_CURVES} at a place of uv and an angle of view.")


def library_plots(settings: Library, run: Run) -> Found:
    """Figures 6 and 7: a plot of each BRDF of a library that one network holds."""
    require_llvm()
    found: dict[str, list[float]] = {"values": [], "density": []}
    tiles = []
    decoder = listed(settings.decoders)[0]
    with library_of_settings(settings) as library:
        options = LatentOptions(decoder=decoder, steps=settings.steps)
        model = LatentModel.for_source(library, options, run.report)
        lights, views = plane_of_incidence(LIBRARY_VIEW)
        for number, name in enumerate(library.names):
            truth = library.evaluate(np.full(len(lights), number), lights, views)
            at = at_texel(model, middle_of(library, number), model.weights.shape.texel_mm, views)
            shown = profile_of(at, truth, LIBRARY_VIEW)
            found["values"].append(decades(shown.model, shown.reference))
            found["density"].append(decades(shown.scaled_density, shown.model))
            tiles.append(
                Tile(polar_plot(shown), f"{name.removeprefix('analytic-')} {found['values'][-1]:.3f}")
            )
    columns = ["lower quartile", "median", "upper quartile", "worst"]
    table = Table("Decades off, over the BRDFs", columns)
    named = {
        "network / BRDF": found["values"],
        "density / network": found["density"],
    }
    for label, errors in named.items():
        table.rows[label] = [*map(float, np.percentile(errors, (25, 50, 75, 100)))]
    table.note = f"Means of |log10| of ratios at {LIBRARY_VIEW:g}°, above a thousandth of the largest value."
    rows = [Row("", tiles[first : first + _ACROSS]) for first in range(0, len(tiles), _ACROSS)]
    title = "zeltner2024 supplemental, figures 6 and 7: a library in one network"
    sheet = contact_sheet(title, [], rows, f"{_CURVES} at {LIBRARY_VIEW:g}°; below, decades off.")
    return Found(with_tables(table, decoder=decoder, brdfs=len(tiles), each=found), sheet)


def decades(values: NDArray[np.float64], truth: NDArray[np.float64]) -> float:
    """Mean difference in decades where the truth is no less than a thousandth of its largest value."""
    bright = truth > 1e-3 * truth.max()
    ratio = np.maximum(values[bright], 1e-9) / truth[bright]
    return float(np.abs(np.log10(ratio)).mean())


STUDIES = (
    Study(
        "papers/zeltner2024/fig6-7",
        "polar plots of a library of BRDFs in one network",
        Library(decoders="3x64"),
        library_plots,
        stands_on=("latent",),
        small={"count": 4, "steps": 4},
    ),
    Study(
        "papers/zeltner2024/polar",
        "polar plots of values and of the sampler's density, by decoders of three sizes",
        StageSettings(spp=64),
        polar_plots,
        stands_on=("latent",),
        small={"spp": 2, "steps": 6, "resolution": 16, "materials": "rough-plastic"},
    ),
)
