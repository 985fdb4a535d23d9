"""Our cloth against fibres path traced in its place: what still differs, kind by kind of yarn.

A repeat of each cloth of `instruments/yarn_cloths.py` in the flat scene's studio, seen from straight above at
48 pixels a thread, once with the point model and once as fibres: the mean colour over that of our cloth,
with the absorption that the albedos give and with the sheet's; the share of pixels that see paper between
yarns; heights of what is seen; the contrast of luminance in three bands of size, and the brightest and
darkest pixels over the median.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import drjit as dr
import mitsuba as mi
import numpy as np
from drjit.llvm import Bool, Float
from numpy.typing import NDArray

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import choose_variant, render
from loomlight.mitsuba.denoising import gaussian_blur
from loomlight.yarn.geometry import YarnGeometry
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.fibre_scene import Shown, fibre_picture, fibre_scene
from studies.instruments.luminance import LUMINANCE
from studies.instruments.yarn_cloths import ABSORPTION, OF_GAPS, cloth, flat_scene

Picture = NDArray[np.float64]

FAR = 10
OURS_SAMPLES = 64
# Sizes of detail, in threads: what a Gaussian of the first deviation keeps and one of the second does not.
BANDS = {"fibres": (0.0, 0.04), "yarns": (0.04, 0.25), "weave": (0.25, 1.0)}
# Of the fit: steps, samples of a pixel, and how log colour follows log absorption at first.
STEPS, FIT_SAMPLES, FIRST_SLOPE = 4, 64, -0.3
LARGEST_FACTOR = 50.0


def repeat_of(fabric: Fabric) -> int:
    """Threads of a repeat, at least four: all of it is seen."""
    threads = max(fabric.layout().warp_on_top.shape)
    return threads * -(-4 // threads)


def both(
    fabric: Fabric, pixels: int, absorption: tuple[float, float, float], spp: int
) -> tuple[Picture, Picture]:
    """Our picture of a repeat and that of its fibres, linear RGB."""
    threads = repeat_of(fabric)
    scene = flat_scene(fabric, pixels * threads, threads)
    ours = render(scene.scene, spp=OURS_SAMPLES, integrator=scene.integrator)
    fibres = fibre_picture(fabric, scene, Shown(threads, absorption=absorption), spp)
    return ours.astype(np.float64), fibres


def contrast(picture: Picture, pixels: int) -> dict[str, float]:
    """Standard deviation of luminance over its mean, in bands of size."""
    light = picture @ LUMINANCE
    sizes = {size for band in BANDS.values() for size in band if size > 0}
    blurred = {size: gaussian_blur(light[..., None], size * pixels)[..., 0] for size in sizes} | {0.0: light}
    return {
        name: float((blurred[low] - blurred[high]).std() / light.mean())
        for name, (low, high) in BANDS.items()
    }


def extremes(picture: Picture) -> dict[str, float]:
    """The 1st and 99th percentiles of luminance over the median."""
    low, middle, high = np.percentile(picture @ LUMINANCE, (1, 50, 99))
    return {"dark": float(low / middle), "bright": float(high / middle)}


def seen_of_fibres(fabric: Fabric, pixels: int, paper_mm: float = -3.0) -> dict[str, float]:
    """Share of pixels that see paper, and the deviation of heights of the others, millimetres."""
    threads = repeat_of(fabric)
    scene = fibre_scene(fabric, flat_scene(fabric, pixels * threads, threads), Shown(threads))
    aov = mi.load_dict({"type": "aov", "aovs": "place:position"})
    height = np.asarray(mi.render(scene, spp=1, integrator=aov))[..., -1]
    on_cloth = height > paper_mm
    return {"open": float(1 - on_cloth.mean()), "relief": float(height[on_cloth].std())}


def seen_of_ours(fabric: Fabric, count: int = 512) -> dict[str, float]:
    """The same of the height field, from straight above."""
    geometry = YarnGeometry(fabric.layout())
    steps = ((np.arange(count) + 0.5) / count).astype(np.float32)
    x, y = (
        grid.ravel() * np.float32(size)
        for grid, size in zip(np.meshgrid(steps, steps), geometry.size, strict=True)
    )
    point = geometry.surface(Float(x), Float(y), Bool(False))
    height, hole = Float(point.height), Bool(point.hole)
    dr.eval(height, hole)
    is_open = np.broadcast_to(hole.numpy(), x.shape)
    return {"open": float(is_open.mean()), "relief": float(height.numpy()[~is_open].std())}


def compare(name: str, near: int, spp: int) -> Figures:
    """Figures of one kind, with close pictures of `near` pixels a thread."""
    fabric = cloth(name)
    ours, fibres = both(fabric, near, ABSORPTION[name], spp)
    _, as_given = both(fabric, FAR, (1.0, 1.0, 1.0), 4 * spp)
    far, matched = both(fabric, FAR, ABSORPTION[name], 4 * spp)
    return {
        "far, absorption of albedos": (as_given.mean((0, 1)) / far.mean((0, 1))).tolist(),
        "far": (matched.mean((0, 1)) / far.mean((0, 1))).tolist(),
        "near": (fibres.mean((0, 1)) / ours.mean((0, 1))).tolist(),
        "contrast": {"ours": contrast(ours, near), "fibres": contrast(fibres, near)},
        "extremes": {"ours": extremes(ours), "fibres": extremes(fibres)},
        "seen": {"ours": seen_of_ours(fabric), "fibres": seen_of_fibres(fabric, near)},
    }


def fitted(name: str) -> tuple[float, float, float]:
    """Factors of absorption at which fibres have our mean colour, by secants of logarithms."""
    fabric = cloth(name)
    threads = repeat_of(fabric)
    scene = flat_scene(fabric, FAR * threads, threads)
    wanted = np.log(render(scene.scene, spp=OURS_SAMPLES, integrator=scene.integrator).mean((0, 1)))
    factor, slope = np.zeros(3), np.full(3, FIRST_SLOPE)
    before: tuple[Picture, Picture] | None = None
    for _ in range(STEPS):
        red, green, blue = np.exp(factor)
        picture = fibre_picture(fabric, scene, Shown(threads, 20, 8, (red, green, blue)), FIT_SAMPLES)
        found = np.log(picture.mean((0, 1)))
        if before is not None:
            moved = factor - before[0]
            trusted = np.abs(moved) > 0.1
            slope = np.where(
                trusted, np.clip((found - before[1]) / np.where(trusted, moved, 1), -1.5, -0.1), slope
            )
        before = factor, found
        most = np.log(LARGEST_FACTOR)
        factor = np.clip(factor + np.clip((wanted - found) / slope, -1.5, 1.5), -most, most)
    red, green, blue = (float(value) for value in np.exp(factor))
    return red, green, blue


@dataclass(frozen=True)
class FibreTruth(Settings):
    only: str = names(",".join(OF_GAPS), "Kinds of yarn.", tuple(ABSORPTION))
    near: int = setting(48, "Pixels a thread of close pictures.", low=2)
    spp: int = setting(16, "Samples a pixel of close pictures of fibres.", low=1)
    fit: bool = setting(False, "Finds the absorption that gives both the same mean colour instead.")


def measure(settings: FibreTruth, run: Run) -> Found:
    choose_variant(None)
    mi.set_log_level(mi.LogLevel.Error)
    kinds = listed(settings.only)
    if settings.fit:
        return Found({"absorption": run.each({name: partial(fitted, name) for name in kinds})})
    return Found(
        {"kinds": run.each({name: partial(compare, name, settings.near, settings.spp) for name in kinds})}
    )


def tables(figures: Figures) -> list[Table]:
    """Mean colours, what is open and how deep, contrasts by size, and extremes: fibres, then ours."""
    kinds = figures.get("kinds", {})
    colours: dict[str, list[Cell]] = {
        name: [_three(found["far, absorption of albedos"]), _three(found["far"]), _three(found["near"])]
        for name, found in kinds.items()
    }
    absorption: dict[str, list[Cell]] = {
        name: [_three(found)] for name, found in figures.get("absorption", {}).items()
    }
    columns = [*BANDS, "darkest", "brightest", "open", "relief, mm"]
    seen: dict[str, list[Cell]] = {
        name: [
            _beside(found, *place)
            for place in (
                *(("contrast", band) for band in BANDS),
                ("extremes", "dark"),
                ("extremes", "bright"),
                ("seen", "open"),
                ("seen", "relief"),
            )
        ]
        for name, found in kinds.items()
    }
    titles = ["far, absorption of albedos", "far", "near"]
    return [
        table
        for table in (
            Table("Mean colour of fibres over ours", titles, colours, "Red, green, blue."),
            Table("Contrast, extremes and openness", columns, seen, "Fibres, and ours after the stroke."),
            Table("Factors of absorption", ["red, green, blue"], absorption),
        )
        if table.rows
    ]


def _three(values: list[float]) -> str:
    return ", ".join(f"{value:.2f}" for value in values)


def _beside(found: Figures, what: str, name: str) -> str:
    return " / ".join(f"{found[what][whose][name]:.3g}" for whose in ("fibres", "ours"))


STUDY = Study(
    "accuracy/fibre_truth",
    "our cloth against fibres path traced in its place, kind by kind of yarn",
    FibreTruth(),
    measure,
    tables,
    stands_on=("point", "picture"),
    small={"only": "silk", "near": 8, "spp": 1},
)
