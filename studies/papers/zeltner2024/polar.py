"""zeltner2024's supplemental, figures 8 to 37: polar plots of values and of the sampler's density.

Each plot is the plane of incidence at one texel and view: f·cos of the reference (black) and of the model
(blue), and the sampler's density (orange), scaled to the model's mean, over the light's angle. The radius is
logarithmic and spans three decades below the largest value.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from drjit.llvm.ad import Array3f
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from loomlight.evaluation.table import Table
from loomlight.mitsuba import choose_variant
from loomlight.mitsuba.material_btf import MaterialBtf
from loomlight.models.interface import Model
from loomlight.models.texture.queries import footprint_values
from studies.harness.study import Found, Pixels, Run, Study, with_tables
from studies.instruments.sheet import PictureTable, Tile
from studies.papers.zeltner2024.stage import StageSettings, at_texel, trained

# Texels of uv, and angles of the view from the normal, degrees.
PLACES = ((0.3, 0.4), (0.55, 0.6), (0.7, 0.3))
VIEWS = (15.0, 60.0)
_DIRECTIONS = 361
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
    angles = np.linspace(-0.5, 0.5, _DIRECTIONS) * np.radians(178)
    light = np.stack([np.sin(angles), 0 * angles, np.cos(angles)], axis=1).astype(np.float32)
    view_angle = math.radians(view_degrees)
    view = np.array([math.sin(view_angle), 0, math.cos(view_angle)], np.float32)
    count = len(light)
    uv = np.tile(np.array(place, np.float32), (count, 1))
    texels = btf.texels(resolution)
    values = [
        footprint_values(
            btf, texels, uv, np.zeros(count, np.float32), light, np.tile(view, (count, 1)), (seed,)
        )
        for seed in range(samples)
    ]
    size = np.array(model.source.repeat_mm, np.float32)
    at = at_texel(model, uv[0] * size, min(model.source.repeat_mm) / resolution, np.tile(view, (count, 1)))
    value, density = at.value_and_pdf(Array3f(light.T.copy()))
    return Profile(
        angles,
        view_angle,
        np.mean(values, axis=0).mean(axis=1).astype(np.float64),
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
    scale = shown.model.mean() / max(shown.density.mean(), 1e-9)
    curves = ((shown.density * scale, _DENSITY), (shown.reference, _INK), (shown.model, _MODEL))
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
    sources = settings.sources()
    for number, source in enumerate(sources):
        model, btf = trained(source, settings, run.runs), MaterialBtf(source)
        tiles, errors = [], []
        for place in PLACES:
            for view in VIEWS:
                shown = profile(model, btf, settings.resolution, place, view, settings.spp)
                errors.append(_log_error(shown))
                tiles.append(Tile(polar_plot(shown), f"{errors[-1]:.3f}"))
        table.rows[source.name] = [*errors]
        pictures.add(source.name, tiles)
        run.report(number + 1, len(sources))
    note = (
        "The plane of incidence at a place of uv and an angle of view: f·cos of the reference (black) and of "
        "2×32 (blue), the sampler's density (orange), logarithmic over three decades."
    )
    return pictures.found(with_tables(table), note)


def _log_error(shown: Profile) -> float:
    """Mean difference in decades where the reference is no less than a thousandth of its largest value."""
    bright = shown.reference > 1e-3 * shown.reference.max()
    ratio = np.maximum(shown.model[bright], 1e-9) / shown.reference[bright]
    return float(np.abs(np.log10(ratio)).mean())


STUDY = Study(
    "papers/zeltner2024/polar",
    "polar plots of values and of the sampler's density",
    StageSettings(spp=64),
    polar_plots,
    stands_on=("latent",),
    small={"spp": 2, "steps": 6, "resolution": 16, "materials": "rough-plastic"},
)
