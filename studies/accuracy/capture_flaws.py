"""Captured fabrics where photographs have what rendered ones lack: lenses, sensors, folds, labels, shadows.

Each swatch of `accuracy/capture` is photographed without a flaw, and with one at a time: light that falls to
half in the corners; a white balance that is a fifth off, with white paper in the same light as `white`; a
lens out of focus by 1.5 pixels; a sensor of red, green and blue pixels, filled in between; sharpening; a
label of a fifth by an eighth in a corner; wrinkles that shade by ±10 %; a tilt of 10°; the shadow of a hand
over a third; JPEG of quality 60. A capture is good if the weave is right, is refused or said to be a guess.
"""

from __future__ import annotations

import tempfile
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.capturing.capture import capture
from loomlight.capturing.photo import WHITE_PAPER
from loomlight.capturing.thread_grid import blurred
from loomlight.core.colour import to_hex
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from studies.accuracy.capture import (
    KINDS,
    QUALITY,
    SURE,
    WIDTH_MM,
    Shot,
    delta_e_of,
    random_fabric,
    same_weave,
    tilted,
)
from studies.harness.study import Figures, Found, Pixels, Run, Study

Linear = NDArray[np.float64]
WEAVES = ("plain", "twill 2/1", "satin 5/2", "herringbone 2/2 8")
TURN = 0.03


@dataclass(frozen=True)
class Flaws(Settings):
    count: int = setting(4, "Swatches, each photographed with every flaw.", low=1)
    pixels: int = setting(480, "Of a side of a photograph.", low=200)
    spp: int = setting(4, "Samples a pixel of it.", low=1)
    seed: int = setting(93, "Of fabrics and photographs; capture was mended on 92.", low=0)


@dataclass(frozen=True)
class Flaw:
    """What is wrong with a photograph.

    Attributes:
        light: changes the light that falls on the sensor, linear RGB [height, width, 3].
        finish: changes the picture that the camera writes, 8-bit sRGB.
        tilt: of the camera, radians.
        white: what white is multiplied by [3].
        quality: of JPEG.
    """

    light: Callable[[Linear], Linear] = lambda linear: linear
    finish: Callable[[Pixels], Pixels] = lambda picture: picture
    tilt: float = 0.0
    white: tuple[float, float, float] = (1.0, 1.0, 1.0)
    quality: int = QUALITY


def vignetted(linear: Linear) -> Linear:
    """Half as bright in the corners."""
    place = (np.arange(len(linear)) + 0.5) / len(linear) - 0.5
    return linear * (1 - np.square(place)[:, None, None] - np.square(place)[None, :, None])


def defocused(linear: Linear, sigma: float = 1.5) -> Linear:
    """Out of focus by so many pixels."""
    return np.stack([blurred(channel, sigma) for channel in np.moveaxis(linear, -1, 0)], axis=-1)


def mosaicked(linear: Linear) -> Linear:
    """One channel a pixel, and the others between their nearest."""
    rows, columns = np.mgrid[0 : linear.shape[0], 0 : linear.shape[1]]
    odd_row, odd_column = rows % 2 == 1, columns % 2 == 1
    masks = (~odd_row & ~odd_column, odd_row != odd_column, odd_row & odd_column)
    found = np.empty_like(linear)
    for channel, mask in enumerate(masks):
        found[..., channel] = _filled(linear[..., channel], mask)
    return found


def _filled(plane: Linear, known: NDArray[np.bool_]) -> Linear:
    """Means of the known ones among nine neighbours, nearer ones twice."""
    weight = np.array([1.0, 2.0, 1.0])

    def spread(values: Linear) -> Linear:
        for axis in (0, 1):
            padded = np.pad(values, [(1, 1) if each == axis else (0, 0) for each in (0, 1)], "reflect")
            parts = [np.take(padded, np.arange(values.shape[axis]) + shift, axis) for shift in range(3)]
            values = sum(part * each for part, each in zip(parts, weight, strict=True))
        return values

    return np.where(known, plane, spread(plane * known) / spread(known.astype(np.float64)))


def sharpened(picture: Pixels) -> Pixels:
    """With halos: as much added as what a blur of 1.5 pixels takes away."""
    values = picture.astype(np.float64)
    return np.rint(np.clip(2 * values - defocused(values), 0, 255)).astype(np.uint8)


def labelled(linear: Linear) -> Linear:
    """A paper label with lines of print in the upper left corner."""
    height, width = linear.shape[0] // 8, linear.shape[1] // 5
    rows, columns = np.mgrid[0:height, 0:width]
    print_there = (
        (rows % 8 < 2) & (columns > 6) & (columns < width - 6) & ((columns * 7 + rows // 8 * 3) % 5 > 1)
    )
    found = linear.copy()
    paper = 0.8 * float(np.quantile(linear, 0.98))
    found[:height, :width] = np.where(print_there[..., None], 0.1 * paper, paper)
    return found


def wrinkled(linear: Linear) -> Linear:
    """Smooth folds, whose slopes are up to a tenth brighter or darker."""
    waves = np.random.default_rng(5).standard_normal(linear.shape[:2])
    smooth = blurred(waves, linear.shape[0] / 8)
    return linear * (1 + 0.1 * smooth / np.abs(smooth).max())[..., None]


def shadowed(linear: Linear) -> Linear:
    """A hand's shadow, of 45 % of the light, over a third; its edge is soft."""
    height, width = linear.shape[:2]
    rows, columns = np.mgrid[0:height, 0:width]
    from_edge = (columns - 0.62 * width + 0.2 * (rows - height / 2)) / (0.03 * width)
    return linear * (1 - 0.55 / (1 + np.exp(-from_edge)))[..., None]


FLAWS = {
    "none": Flaw(),
    "vignetting, half in the corners": Flaw(vignetted),
    "white balance a fifth off": Flaw(white=(1.2, 1.0, 0.8)),
    "out of focus by 1.5 pixels": Flaw(defocused),
    "mosaic of the sensor": Flaw(mosaicked),
    "sharpening": Flaw(finish=sharpened),
    "label in a corner": Flaw(labelled),
    "wrinkles, ±10 %": Flaw(wrinkled),
    "tilt of 10°": Flaw(tilt=float(np.radians(10))),
    "shadow of a hand": Flaw(shadowed),
    "JPEG of quality 60": Flaw(quality=60),
}


def measure(settings: Flaws, run: Run) -> Found:
    """What becomes of each swatch with each flaw."""
    require_llvm()
    cases = {
        f"{title} {number}": partial(_capture, flaw, number, settings)
        for title, flaw in FLAWS.items()
        for number in range(settings.count)
    }
    rows = run.each(cases)
    figures: Figures = {"rows": rows, "count": settings.count}
    wrong = [name for name, row in rows.items() if row["said"] == "" and not row["right"]]
    figures["missed"] = [f"wrong and sure: {name}" for name in wrong]
    return Found(figures)


def _capture(flaw: Flaw, number: int, settings: Flaws) -> dict[str, Any]:
    """Whether the weave is right, what is said if not, and how far colours are off."""
    rng = np.random.default_rng([settings.seed, number])
    weave, kind = WEAVES[number % len(WEAVES)], str(rng.choice(KINDS))
    fabric = fabric_from_text(random_fabric(rng, weave, kind))
    framing = tilted(settings.pixels, TURN, np.array([flaw.tilt, 0.0]))
    shot = Shot(framing, settings.spp, int(rng.integers(1 << 31)))
    linear = flaw.light(shot.light_from(fabric) * flaw.white)
    shot = replace(shot, exposure=min(1.0, 0.9 / float(np.quantile(linear, 0.998))))
    picture = flaw.finish(shot.developed(linear))
    white = to_hex(np.clip(WHITE_PAPER * shot.exposure * np.array(flaw.white), 0, 1))
    row = {"weave": weave, "kind": kind, "right": False, "said": "", "confidence": 0.0, "delta_e": 0.0}
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore", LoomlightWarning)
        path = Path(folder) / "photo.jpg"
        Image.fromarray(picture).save(path, quality=flaw.quality, subsampling=0)
        try:
            found = capture(path, width_mm=WIDTH_MM, white=white)
        except InputError as error:
            return row | {"said": str(error).replace(f"{path}: ", "")}
    return row | {
        "right": same_weave(found.choice.fit.structure, fabric.named_draft.drawdown),
        "said": " ".join(found.doubts),
        "confidence": found.choice.confidence,
        "delta_e": delta_e_of(found, fabric),
    }


def tables(figures: Figures) -> list[Table]:
    """Of each flaw: how many weaves are right, how many are refused or guesses, how far colours are off."""
    rows: dict[str, list[float | int | str | None]] = {}
    for title in FLAWS:
        of_flaw = [figures["rows"][f"{title} {number}"] for number in range(figures["count"])]
        right = [row for row in of_flaw if row["right"]]
        rows[title] = [
            len(right),
            sum(row["confidence"] >= SURE for row in right),
            sum(row["said"] != "" and not row["right"] for row in of_flaw),
            sum(row["said"] == "" and not row["right"] for row in of_flaw),
            float(np.median([row["delta_e"] for row in right])) if right else "",
        ]
    columns = ["right", "right and sure", "refused, or a guess", "wrong and sure", "CIEDE2000"]
    return [Table("Swatches with each flaw", columns, rows)]


STUDY = Study(
    "accuracy/capture_flaws",
    "fabrics captured from photographs with flaws that real ones have",
    Flaws(),
    measure,
    tables,
    stands_on=("point",),
    small={"count": 1, "pixels": 240, "spp": 1},
)
