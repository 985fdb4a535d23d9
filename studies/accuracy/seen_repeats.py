"""Whether one sees that textures of uneven yarns repeat: pictures of flat cloth, and their autocorrelation.

The colours that an export's textures hold, laid side by side over a width of cloth, as means over pixels. At
a shift by a whole texture a picture is alike; the figure is how far that stands out, in deviations of what
shifts of the exported textures come to that are none. The same is done with textures of 24 threads, which
exports once had.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.exporters.materials import PIXEL
from loomlight.exporters.texels import TexelGrid, TextureSize, texture_grid
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import load_fabric
from studies.harness.study import (
    Figures,
    Found,
    Run,
    Study,
    example,
    listed,
    listed_numbers,
    names,
    on_display,
)
from studies.instruments.sheet import Row, Tile, contact_sheet

FABRICS = ("denim", "linen", "tweed")
_FEW_THREADS = 24
# Deviations above which a shift stands out.
BAR = 3.0
# Places a side of a pixel whose mean is taken.
_PLACES = 4
# Shifts that are told from none, and what two pictures overlap at least, as shares of a picture.
_LEAST_SHIFT, _LEAST_OVERLAP = 0.03, 0.1
# Mean of a picture on the display, linear.
_SHOWN_MEAN = 0.25


@dataclass(frozen=True)
class SeenRepeats(Settings):
    fabrics: str = names(",".join(FABRICS), "Example fabrics.")
    widths: str = setting("200,500", "Widths of cloth in the picture, millimetres.", metavar="MM,…")
    distance: float = setting(1.0, "That the textures are made for, metres.", low=0.01)
    side: int = setting(400, "Pixels of a picture.", low=32)


def measure(settings: SeenRepeats, run: Run) -> Found:
    """How far repeats stand out, by fabric, texture and width."""
    rows: list[Figures] = []
    tiles: list[Row] = []
    for name in listed(settings.fabrics):
        fabric = load_fabric(example(name))
        texel = 1000 * settings.distance * PIXEL
        kinds = {"24 threads": _few(fabric, texel), "as exported": texture_grid(fabric, texel)}
        colours = {kind: _colours(fabric, size) for kind, size in kinds.items()}
        for width in listed_numbers("widths", settings.widths):
            shown = []
            pictures = {kind: laid(*of_kind, width, settings.side) for kind, of_kind in colours.items()}
            weave = [settings.side * each / width for each in fabric.layout().size]
            alike = {kind: _alike(picture.mean(axis=-1), weave) for kind, picture in pictures.items()}
            periods = {
                kind: [settings.side * each / width for each in size_mm]
                for kind, (_, size_mm) in colours.items()
            }
            chance = [
                each[~_is_multiple(settings.side, period)]
                for each, period in zip(alike["as exported"], periods["as exported"], strict=True)
            ]
            for kind, (_, size_mm) in colours.items():
                picture = pictures[kind]
                found = standing_out(alike[kind], periods[kind], chance, settings.side)
                rows.append(
                    {
                        "fabric": name,
                        "width_mm": width,
                        "texture": kind,
                        "texture_mm": list(size_mm),
                        "deviations": found,
                        "contrast": float(picture.mean(axis=-1).std() / picture.mean()),
                    }
                )
                bright = _SHOWN_MEAN / picture.mean() * picture
                shown.append(Tile(on_display(bright.astype(np.float32)), f"{found:.1f} deviations"))
            tiles.append(Row(f"{name}, {width:g} mm", shown))
        run.report(len(tiles), len(listed(settings.fabrics)) * len(settings.widths.split(",")))
    return Found({"pictures": rows}, contact_sheet("Repeats of textures", [*kinds], tiles))


def _few(fabric: Fabric, texel: float) -> TextureSize:
    picks, ends = fabric.layout().warp_on_top.shape
    return texture_grid(fabric, texel, (-(-_FEW_THREADS // ends), -(-_FEW_THREADS // picks)))


def _colours(fabric: Fabric, size: TextureSize) -> tuple[NDArray[np.float64], tuple[float, float]]:
    """What each texel reflects in all [rows, columns, 3], and the millimetres of the texture."""
    grid = TexelGrid(fabric, *size)
    found = [
        (band.share[..., None] * (band.diffuse + band.specular)).sum(-2) * band.cover[:, None]
        for band in grid.bands()
    ]
    return np.concatenate(found).reshape(size.rows, size.columns, 3), grid.size


def laid(
    texture: NDArray[np.float64], size_mm: tuple[float, float], width: float, side: int
) -> NDArray[np.float64]:
    """Means over the pixels of a square picture [side, side, 3] of textures side by side."""
    place = (np.arange(side * _PLACES) + 0.5) * width / (side * _PLACES)
    column, row = (
        np.floor(place / each * count).astype(int) % count
        for each, count in zip(size_mm, texture.shape[1::-1], strict=True)
    )
    fine = texture[row[::-1, None], column[None, :]]
    return np.asarray(fine.reshape(side, _PLACES, side, _PLACES, 3).mean(axis=(1, 3)))


def standing_out(
    alike: list[NDArray[np.float64]], periods: list[float], chance: list[NDArray[np.float64]], side: int
) -> float:
    """How many deviations the correlation at a shift by a period is above the mean of other shifts.

    Args:
        alike: correlations by shift, across and up; see `_shifts`.
        periods: across and up, pixels; those that are not well within the picture count as none.
        chance: correlations at shifts that are no period.

    Returns:
        the larger one of both directions; 0 where neither period is in the picture.
    """
    found = [0.0]
    for values, period, others in zip(alike, periods, chance, strict=True):
        near = _is_multiple(side, period)
        if near.any():
            found.append(float((values[near].max() - others.mean()) / max(others.std(), 1e-9)))
    return max(found)


def _shifts(side: int) -> NDArray[np.int64]:
    return np.arange(int(_LEAST_SHIFT * side), int((1 - _LEAST_OVERLAP) * side))


def _is_multiple(side: int, period: float) -> NDArray[np.bool_]:
    """Whether shifts are near one by whole periods."""
    multiples = np.arange(1, int(side / max(period, 1)) + 1) * period
    distance = np.abs(_shifts(side)[:, None] - multiples).min(axis=1, initial=side)
    return np.asarray(distance <= max(2.0, 0.05 * period))


def _alike(picture: NDArray[np.float64], weave: list[float]) -> list[NDArray[np.float64]]:
    """Correlations of a picture with itself, shifted across and up, without its weave.

    Args:
        weave: width and height of a repeat, pixels, over which means are taken.
    """
    side = len(picture)
    for axis, pixels in ((1, weave[0]), (0, weave[1])):
        picture = _mean_over(picture, max(1, round(pixels)), axis)
    values = picture - picture.mean()
    shifts = _shifts(side)
    return [
        np.array([_correlation(turned[:, shift:], turned[:, :-shift]) for shift in shifts])
        for turned in (values, values.T)
    ]


def _mean_over(picture: NDArray[np.float64], count: int, axis: int) -> NDArray[np.float64]:
    """Means over so many pixels along an axis."""
    windows = np.lib.stride_tricks.sliding_window_view(picture, count, axis=axis)
    return np.asarray(windows.mean(axis=-1))


def _correlation(a: NDArray[np.float64], b: NDArray[np.float64]) -> float:
    return float((a * b).sum() / max(np.sqrt((a * a).sum() * (b * b).sum()), 1e-12))


def tables(figures: Figures) -> list[Table]:
    """Millimetres of the textures, and how far their repeats stand out."""
    rows = {
        f"{row['fabric']}, {row['width_mm']:g} mm, {row['texture']}": [
            *row["texture_mm"],
            row["deviations"],
        ]
        for row in figures["pictures"]
    }
    columns = ["width of the texture, mm", "height, mm", "repeat, deviations"]
    return [Table("Repeats of textures", columns, rows)]


STUDY = Study(
    "accuracy/seen_repeats",
    "whether one sees that textures of uneven yarns repeat",
    SeenRepeats(),
    measure,
    tables,
    small={"fabrics": "tweed", "widths": "200", "distance": 8.0, "side": 64},
)
