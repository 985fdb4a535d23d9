"""Kinds of yarn close up in the studio: every kind, gaps of their own, and cloth of fibres in their place.

- *kinds*: a close-up of every kind.
- *gaps*: six kinds at 10, 30, 100 and 300 pixels a thread, with a gap of 0.2 and with their own.
- *fibres*: the same kinds and zooms, each beside fibres path traced in the same place and light
  (`instruments/fibre_scene.py`), whose absorption shows the same colour (`ABSORPTION`).

The light comes from the side, so that relief shows. Numbers are mean values of 8-bit sRGB.
"""

from __future__ import annotations

from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from multiprocessing import get_context

import numpy as np

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.mitsuba import choose_variant, render
from studies.harness.study import (
    Figures,
    Found,
    Pixels,
    Run,
    Study,
    listed,
    listed_numbers,
    names,
    on_display,
)
from studies.instruments.fibre_scene import Shown, fibre_picture
from studies.instruments.sheet import Row, Tile, contact_sheet
from studies.instruments.yarn_cloths import ABSORPTION, CLOTHS, OF_GAPS, cloth, flat_scene

COLUMNS = 4
# Of fibres: pixels of a far thread, tries.
FAR_PIXELS, ATTEMPTS = 30, 3
EXPOSURE = 1.6


@dataclass(frozen=True)
class Kinds(Settings):
    only: str = names(",".join(CLOTHS), "Kinds of yarn.", tuple(CLOTHS))
    pixels: int = setting(300, "Of a thread.", low=1)
    threads: float = setting(1.6, "Across a close-up.", low=0.1)
    spp: int = setting(48, "Samples a pixel.", low=1)


@dataclass(frozen=True)
class Zooms(Settings):
    only: str = names(",".join(OF_GAPS), "Kinds of yarn.", tuple(OF_GAPS))
    zooms: str = setting("10,30,100,300", "Pixels a thread.", metavar="N,…")
    side: int = setting(160, "Pixels of a square.", low=4)
    spp: int = setting(48, "Samples a pixel.", low=1)


@dataclass(frozen=True)
class Fibres(Zooms):
    side: int = setting(128, "Pixels of a square.", low=4)
    fibre_spp: int = setting(16, "Samples a pixel of fibres.", low=1)


def close_up(
    name: str, pixels: float, threads: float, spp: int, more: str = "", denoise: str = "off"
) -> Pixels:
    """A square of cloth of `threads` threads, `pixels` pixels a thread; `more` are fields."""
    shown = flat_scene(cloth(name, more), round(pixels * threads), threads)
    return on_display(EXPOSURE * render(shown.scene, spp=spp, integrator=shown.integrator, denoise=denoise))


def fibre_close_up(name: str, pixels: float, threads: float, spp: int) -> Pixels:
    """The same square of fibres; far away fewer and thicker ones."""
    fabric = cloth(name)
    scene = flat_scene(fabric, round(pixels * threads), threads)
    across, points = (20, 8) if pixels < FAR_PIXELS else (30, 16)
    shown = Shown(threads, across, points, ABSORPTION[name])
    return on_display((EXPOSURE * fibre_picture(fabric, scene, shown, spp)).astype(np.float32))


def measure_kinds(settings: Kinds, run: Run) -> Found:
    """A close-up of every kind."""
    choose_variant(None)
    tiles = []
    for name in listed(settings.only):
        picture = close_up(name, settings.pixels, settings.threads, settings.spp)
        tiles.append(Tile(picture, name))
    rows = [Row("", tiles[first : first + COLUMNS]) for first in range(0, len(tiles), COLUMNS)]
    means = {tile.caption: {"mean": _mean(tile)} for tile in tiles}
    return Found({"means": means}, contact_sheet("Kinds of yarn", [], rows))


def measure_gaps(settings: Zooms, run: Run) -> Found:
    """Rows of kinds, with a gap of 0.2 and with their own."""
    choose_variant(None)
    zooms = listed_numbers("zooms", settings.zooms)
    rows = []
    for name in listed(settings.only):
        tiles = [
            # What is seen through holes is lit through holes: noise, with so few samples.
            Tile(close_up(name, pixels, settings.side / pixels, settings.spp, more, "auto"))
            for more in ("gap = 0.2", "")
            for pixels in zooms
        ]
        rows.append(Row(name, tiles))
    columns = [f"{kind}, {pixels:g}" for kind in ("gap 0.2", "own gap") for pixels in zooms]
    return _found("Gaps of yarns, by pixels a thread", columns, rows)


def measure_fibres(settings: Fibres, run: Run) -> Found:
    """Rows of kinds, each square beside that of fibres."""
    zooms = listed_numbers("zooms", settings.zooms)
    rows = [
        Row(name, [Tile(picture) for picture in _in_own_process(name, settings)])
        for name in listed(settings.only)
    ]
    columns = [f"{kind}, {pixels:g}" for pixels in zooms for kind in ("cloth", "fibres")]
    return _found("Cloth and fibres in its place, by pixels a thread", columns, rows)


def _in_own_process(name: str, settings: Fibres) -> list[Pixels]:
    """Mitsuba crashes in some pictures of curves on CPUs: each row has a process of its own."""
    for _ in range(ATTEMPTS - 1):
        with ProcessPoolExecutor(1, get_context("spawn")) as pool:
            try:
                return pool.submit(fibres_row, name, settings).result()
            except BrokenProcessPool:
                continue
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        return pool.submit(fibres_row, name, settings).result()


def fibres_row(name: str, settings: Fibres) -> list[Pixels]:
    """Our cloth and fibres at each zoom."""
    choose_variant(None)
    pictures = []
    for pixels in listed_numbers("zooms", settings.zooms):
        threads = settings.side / pixels
        pictures.append(close_up(name, pixels, threads, settings.spp))
        pictures.append(fibre_close_up(name, pixels, threads, settings.fibre_spp))
    return pictures


def _found(title: str, columns: list[str], rows: list[Row]) -> Found:
    means = {row.label: dict(zip(columns, map(_mean, row.tiles), strict=True)) for row in rows}
    return Found({"means": means}, contact_sheet(title, columns, rows))


def _mean(tile: Tile) -> float:
    assert tile.picture is not None
    return float(np.mean(tile.picture))


def tables(figures: Figures) -> list[Table]:
    """Means of pictures."""
    means = figures["means"]
    columns = list(next(iter(means.values())))
    return [
        Table(
            "Means of pictures, 8-bit sRGB",
            columns,
            {name: list(row.values()) for name, row in means.items()},
        )
    ]


_SMALL = {"only": "linen", "zooms": "10", "side": 16, "spp": 1}
STUDIES = (
    Study(
        "look/yarns",
        "a close-up of every kind of yarn",
        Kinds(),
        measure_kinds,
        tables,
        stands_on=("point", "picture"),
        small={"only": "linen", "pixels": 16, "spp": 1},
    ),
    Study(
        "look/yarn_gaps",
        "kinds of yarn by zoom, with a gap of 0.2 and with their own",
        Zooms(),
        measure_gaps,
        tables,
        stands_on=("point", "picture"),
        small=_SMALL,
    ),
    Study(
        "look/yarn_fibres",
        "kinds of yarn by zoom, each beside fibres path traced in its place",
        Fibres(),
        measure_fibres,
        tables,
        stands_on=("point", "picture"),
        small={**_SMALL, "fibre_spp": 1},
    ),
)
