"""Captured fabrics against those that were photographed: random cloths, rendered as a camera would see them.

Each swatch is a named weave of a kind of yarn, in colours, setts and irregularities drawn by chance, 20 mm
of it under a flash: turned up to 4° against the picture, tilted up to 5°, darker towards its corners, exposed
so that next to nothing is white, with noise of 2.5 of 255, and as JPEG. It is captured from that file, by
its width and by the colour of white paper in it. A window lies within 15° of the middle of a side, 30° to 50°
high, and its light falls by a third across the picture.

Weaves count as right when the drawdown is the same in some place. Colours differ by CIEDE2000 from the
nearest found in the same family; the largest counts. Bounds hold if both families lie within those that stand
in the file. FLIP compares the photograph with the render in the
same light, whose threads lie as in the photograph; beside it stands that of another piece of the same cloth,
whose fibres, hairs and slubs lie elsewhere: no render can be expected to go below that by much. A failure
that says so gave a warning or was refused. Of weaves that are said to be sure (0.9 and more), 19 of 20
should be right.
"""

from __future__ import annotations

import itertools
import tempfile
import warnings
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.capturing.capture import LIGHTS, capture
from loomlight.capturing.captured import Captured
from loomlight.capturing.photo import WHITE_PAPER
from loomlight.capturing.photographer import CAMERA_WIDTHS, Framing, Light, photograph
from loomlight.core.colour import (
    delta_e_2000,
    lab_of_linear,
    linear_of_lab,
    linear_to_srgb,
    srgb_to_linear,
    to_hex,
)
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import flip_mean
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import edited_fabric
from loomlight.weave.recognition import smallest_repeat
from studies.harness.study import Figures, Found, Pixels, Run, Study

WEAVES = (
    *(
        "plain",
        "twill 2/1",
        "twill 1/2 s",
        "twill 2/2",
        "twill 2/2 s",
        "twill 3/1",
        "twill 3/1 s",
        "twill 1/3",
    ),
    *("satin 5/2", "satin 8/3", "sateen 5/2", "sateen 8/3", "basket 2/2", "warp rib 2/2", "weft rib 2/2"),
    *("herringbone 2/2 8", "houndstooth 4", "gingham 8", "pinstripe 12", "denim"),
)
# Orders of colours of their own, in which fields give none.
COLOURED = ("houndstooth 4", "gingham 8", "pinstripe 12", "denim")
KINDS = ("cotton", "combed cotton", "mercerised cotton", "linen", "wool", "worsted", "silk", "viscose")
WIDTH_MM, NOISE, QUALITY = 20.0, 0.01, 90
# A window is so far from the middle of a side, and so high, degrees; its light falls by a share across.
WINDOW_TURN, WINDOW_ELEVATIONS, WINDOW_FALL_OFF = 15.0, (30.0, 50.0), 0.3
TURN, TILT, FALL_OFF = np.radians(4.0), np.radians(5.0), 0.15
# Where another piece of a cloth lies, repeats across and up.
_REPEATS_ON = 7, 11
# Confidence from which on a weave is said to be sure.
SURE, SURE_AND_RIGHT = 0.9, 0.95
# Where reliability is counted: confidences from each of these to the next.
BINS = (0.0, 0.5, 0.8, SURE, 1.001)
# Share of bounds that should hold.
BOUNDS_HOLD = 0.8
# Sheets that are shown.
SHOWN = 4
# Whether bounds of the file hold, by name of its figure.
HELD = {"sett_held": "setts", "colours_held": "colours", "roughness_held": "roughness", "gap_held": "gaps"}
# What issue and page promise: share of weaves, relative errors, CIEDE2000, FLIP.
BARS = {"weave": 0.9, "sett": 0.02, "delta_e": 3.0, "roughness": 0.25, "flip": 0.12}


@dataclass(frozen=True)
class Capture(Settings):
    count: int = setting(40, "Swatches.", low=1)
    pixels: int = setting(640, "Of a side of a photograph.", low=200)
    spp: int = setting(9, "Samples a pixel of it.", low=1)
    light: str = setting("flash", "Of the photographs.", choices=LIGHTS)
    seed: int = setting(90, "Of fabrics and photographs; capture was mended on 67 to 72.", low=0)


def measure(settings: Capture, run: Run) -> Found:
    """What is right of each swatch, and how many meet each bar."""
    require_llvm()
    shown: dict[str, Pixels] = {}

    def of(number: int) -> dict[str, Any]:
        row, sheet = _swatch(number, settings)
        if sheet is not None:
            shown[f"swatch {number}"] = sheet
        return row

    found = run.each({f"swatch {number}": partial(of, number) for number in range(settings.count)})
    rows = [*found.values()]
    done = [row for row in rows if row["refused"] == ""]
    right = [row for row in done if row["weave_right"]]

    def share(name: str) -> float:
        return float(np.mean([row[name] <= BARS[name] for row in right])) if right else 0.0

    shares = {
        "weave": len(right) / len(rows),
        **{name: share(name) for name in ("sett", "delta_e", "roughness", "flip")},
    }
    failed = [row for row in rows if not row.get("weave_right")]
    missed = [] if shares["weave"] >= BARS["weave"] else [f"weave right: {shares['weave']:.2f}"]
    missed += [
        f"{name}: median {value:.3g}"
        for name in ("sett", "delta_e", "roughness", "flip")
        if right and (value := float(np.median([row[name] for row in right]))) > BARS[name]
    ]
    bins = _reliability(done)
    sure = bins[-1]
    if sure["swatches"] and sure["right"] < SURE_AND_RIGHT * sure["swatches"]:
        missed.append(f"sure and right: {sure['right']} of {sure['swatches']}")
    hold = {name: float(np.mean([row[name] for row in right])) if right else 0.0 for name in HELD}
    missed += [f"{name}: {held:.2f}" for name, held in hold.items() if right and held < BOUNDS_HOLD]
    figures = {
        "reliability": bins,
        "bounds_hold": hold,
        "bars": BARS,
        "shares": shares,
        "failures": len(failed),
        "failures_that_say_so": sum(bool(row["refused"] or row["doubts"]) for row in failed),
        "false_doubts": sum(bool(row["doubts"]) for row in right),
        "rows": rows,
        "missed": missed,
    }
    return Found(figures, pictures=shown)


def _reliability(done: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Of the swatches of each bin of confidence: how many, how sure on average, and how many are right."""
    found = []
    for low, high in itertools.pairwise(BINS):
        rows = [row for row in done if low <= row["confidence"] < high]
        mean = float(np.mean([row["confidence"] for row in rows])) if rows else 0.0
        right = sum(row["weave_right"] for row in rows)
        found.append({"from": low, "swatches": len(rows), "confidence": mean, "right": right})
    return found


def _swatch(number: int, settings: Capture) -> tuple[dict[str, Any], Pixels | None]:
    """A swatch captured: what is right, and the sheet."""
    rng = np.random.default_rng([settings.seed, number])
    weave, kind = WEAVES[number % len(WEAVES)], str(rng.choice(KINDS))
    fabric = fabric_from_text(random_fabric(rng, weave, kind))
    row: dict[str, Any] = {"weave": weave, "kind": kind, "refused": "", "doubts": 0, "weave_right": False}
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore", LoomlightWarning)
        path = Path(folder) / f"{number}.jpg"
        picture, shot = photographed(fabric, rng, settings)
        Image.fromarray(picture).save(path, quality=QUALITY, subsampling=0)
        try:
            white = to_hex(np.full(3, WHITE_PAPER * shot.exposure))
            found = capture(path, width_mm=WIDTH_MM, white=white, light=settings.light)
        except InputError as error:
            return row | {"refused": str(error).replace(folder, "")}, None
        return row | compared(found, fabric) | {
            "flip_other": other_piece(fabric, picture, shot)
        }, found.sheet() if number < SHOWN else None


def random_fabric(rng: np.random.Generator, weave: str, kind: str) -> str:
    """The text of a fabric file: a weave and a kind of yarn, other numbers by chance."""
    ends = rng.uniform(12, 28)
    lines = [
        f'weave = "{weave}"',
        f'yarn = "{kind}"',
        f"ends_per_cm = {ends:.3f}",
        f"picks_per_cm = {ends * rng.uniform(0.75, 1.1):.3f}",
        "[variation]",
        f"seed = {int(rng.integers(1 << 31))}",
    ]
    roughness = np.exp(rng.normal(0, 0.15))
    base = {"cotton": 0.42, "combed cotton": 0.38, "mercerised cotton": 0.24, "linen": 0.3, "wool": 0.6}
    base |= {"worsted": 0.42, "silk": 0.1, "viscose": 0.22}
    colours = _colours(rng)
    for family, colour in zip(("warp", "weft"), colours, strict=True):
        lines += [f"[{family}]", f"roughness = {base[kind] * roughness:.4f}"]
        lines += [] if weave in COLOURED else [f'color = "{colour}"']
    return "\n".join(lines) + "\n"


def _colours(rng: np.random.Generator) -> tuple[str, str]:
    """Two colours of dyed yarn; of one swatch in five the same twice."""

    def one() -> str:
        chroma, hue = rng.uniform(0, 28), rng.uniform(0, 2 * np.pi)
        lab = [rng.uniform(40, 82), chroma * np.cos(hue), chroma * np.sin(hue)]
        return to_hex(np.clip(linear_of_lab(lab), 0.02, 0.95))

    first, other = one(), one()
    return first, first if rng.random() < 0.2 else other


@dataclass(frozen=True, eq=False)
class Shot:
    """How a swatch was photographed, so that another piece of its cloth can be photographed alike.

    Attributes:
        framing: of the cloth.
        samples: a pixel.
        seed: of their places, and of the noise.
        exposure: what white that faces the light has.
        light: of the photograph.
    """

    framing: Framing
    samples: int
    seed: int
    exposure: float = 1.0
    light: Light = field(default_factory=Light)

    def light_from(self, fabric: Fabric) -> NDArray[np.float64]:
        """Linear RGB [height, width, 3], darker towards the corners, and away from a window."""
        seen = photograph(fabric, self.framing, self.light, self.samples, self.seed)
        x = (np.arange(len(seen)) + 0.5) / len(seen) - 0.5
        y = -x[:, None]
        strength = 1 - FALL_OFF * 2 * (x**2 + y**2)
        if self.light.kind == "window":
            azimuth = np.radians(self.light.azimuth)
            strength *= 1 + WINDOW_FALL_OFF * (x * np.cos(azimuth) + y * np.sin(azimuth))
        return np.asarray(seen * strength[..., None])

    def developed(self, linear: NDArray[np.float64]) -> Pixels:
        """8-bit sRGB of linear RGB [height, width, 3], with noise."""
        noise = np.random.default_rng([self.seed, 1]).standard_normal(linear.shape)
        encoded = linear_to_srgb(self.exposure * linear) + NOISE * noise
        return np.rint(255 * np.clip(encoded, 0, 1)).astype(np.uint8)


def photographed(fabric: Fabric, rng: np.random.Generator, settings: Capture) -> tuple[Pixels, Shot]:
    """A photograph of a fabric, 8-bit sRGB [height, width, 3], and how it was taken."""
    side = settings.pixels
    framing = tilted(side, float(rng.uniform(-TURN, TURN)), rng.uniform(-TILT, TILT, size=2) / np.sqrt(2))
    shot = Shot(framing, settings.spp, int(rng.integers(1 << 31)))
    if settings.light == "window":
        azimuth = 90.0 * int(rng.integers(4)) + rng.uniform(-WINDOW_TURN, WINDOW_TURN)
        shot = replace(shot, light=Light("window", azimuth, rng.uniform(*WINDOW_ELEVATIONS)))
    linear = shot.light_from(fabric)
    shot = replace(shot, exposure=min(1.0, 0.9 / float(np.quantile(linear, 0.998))))
    return shot.developed(linear), shot


def tilted(side: int, turn: float, tilt: NDArray[np.float64]) -> Framing:
    """A square framing of turned cloth, at which the camera looks aslant, radians along x and y."""
    away = CAMERA_WIDTHS * WIDTH_MM
    axis = np.array([*np.tan(tilt), 1.0])
    axis /= np.linalg.norm(axis)
    right = np.array([np.cos(turn), np.sin(turn), 0.0])
    right -= (right @ axis) * axis
    right /= np.linalg.norm(right)
    up = np.cross(axis, right)
    # Rays of pixels, whose columns and rows are steps on a plane before the camera; rows count downwards.
    step, camera = WIDTH_MM / side, away * axis
    rays = np.stack([step * right, -step * up, -away * axis - step * side / 2 * (right - up)], axis=1)
    onto = np.stack([camera[2] * rays[0] - camera[0] * rays[2], camera[2] * rays[1] - camera[1] * rays[2]])
    matrix = np.stack([onto[0], onto[1], -rays[2]])
    return Framing((side, side), matrix, WIDTH_MM, (float(np.tan(tilt[0])), float(np.tan(tilt[1]))))


def compared(found: Captured, fabric: Fabric) -> dict[str, Any]:
    """What is right of a captured fabric."""
    truth = fabric.resolved
    setts = [found.setts[0].value, found.setts[1].value]
    given = [fabric.fields.ends_per_cm, fabric.fields.picks_per_cm]
    roughness, rough, gaps = [], [], []
    widths = fabric.layout().warp, fabric.layout().weft
    for number, family in enumerate((truth.warp, truth.weft)):
        mine = found.fit.yarns.numbers["roughness"][number]
        low, high = found.fit.bounds("roughness", number)
        rough.append(low <= family.roughness <= high)
        low, high = found.fit.bounds("fill", number)
        gaps.append(low <= 1 - widths[number].open_share <= high)
        roughness.append(abs(mine / family.roughness - 1))
    colours = delta_e_of(found, fabric)
    picture = found.render()
    return {
        "found": found.weave,
        "confidence": found.choice.confidence,
        "doubts": len(found.doubts),
        "weave_right": same_weave(found.choice.fit.structure, fabric.named_draft.drawdown),
        "sett": max(abs(mine / float(true or 1) - 1) for mine, true in zip(setts, given, strict=True)),
        "delta_e": colours,
        "roughness": max(roughness),
        "sett_held": all(
            abs(sett.value - float(true or 0)) <= sett.reach
            for sett, true in zip(found.setts, given, strict=True)
        ),
        "colours_held": colours <= found.fit.colour_error,
        "roughness_held": all(rough),
        "gap_held": all(gaps),
        "kind_found": found.fit.yarns.kind,
        "rms_255": 255 * float(np.sqrt(found.fit.cost)),
        "flip": flip_mean(picture, found.linear, np.ones(picture.shape[:2], bool)),
    }


def delta_e_of(found: Captured, fabric: Fabric) -> float:
    """The largest difference of a colour from the nearest found in the same family, CIEDE2000."""
    largest = 0.0
    for number, family in enumerate((fabric.resolved.warp, fabric.resolved.weft)):
        labs = lab_of_linear(found.fit.yarns.colours[number])
        for colour in np.unique(family.colours, axis=0):
            largest = max(largest, float(delta_e_2000(lab_of_linear(colour)[None], labs).min()))
    return largest


def other_piece(fabric: Fabric, picture: Pixels, shot: Shot) -> float:
    """FLIP between a photograph and another piece of the same cloth, photographed alike but without noise."""
    seed = ((fabric.fields.variation.seed or 0) + 1) % (1 << 32)
    # Some repeats on: plies are there at another turn, the weave at the same place.
    aside = np.eye(3)
    aside[:2, 2] = np.multiply(_REPEATS_ON, fabric.repeat_mm)
    framing = replace(shot.framing, to_cloth=aside @ shot.framing.to_cloth)
    other = replace(shot, framing=framing).light_from(edited_fabric(fabric, {"variation.seed": seed}))
    taken = srgb_to_linear(picture / 255) / shot.exposure
    return flip_mean(other.astype(np.float32), taken.astype(np.float32), np.ones(picture.shape[:2], bool))


def same_weave(one: NDArray[np.bool_], other: NDArray[np.bool_]) -> bool:
    """Whether two repeats are the same in some place."""
    first, second = (smallest_repeat(each) for each in (one, other))
    if first is None or second is None or first.shape != second.shape:
        return False
    return any(
        np.array_equal(np.roll(first, (down, right), (0, 1)), second)
        for down in range(first.shape[0])
        for right in range(first.shape[1])
    )


def tables(figures: Figures) -> list[Table]:
    """Shares that meet each bar, and each swatch."""
    bars, shares = figures["bars"], figures["shares"]
    rows = figures["rows"]
    right = [row for row in rows if row.get("weave_right")]
    summary: dict[str, list[float | int | str | None]] = {
        "weave right, of all": [bars["weave"], shares["weave"], ""]
    }
    names = {"sett": "setts", "delta_e": "colours, CIEDE2000", "roughness": "roughness", "flip": "FLIP"}
    for name, title in names.items():
        median = float(np.median([row[name] for row in right])) if right else 0.0
        summary[f"{title}, of these"] = [bars[name], shares[name], median]
    other = float(np.median([row["flip_other"] for row in right])) if right else 0.0
    summary["FLIP of another piece of the same cloth"] = ["", "", other]
    for name, title in HELD.items():
        summary[f"bounds that hold, of {title}"] = [BOUNDS_HOLD, figures["bounds_hold"][name], ""]
    columns = ["found", "sure", "sett", "CIEDE2000", "roughness", "FLIP"]
    each: dict[str, list[float | int | str | None]] = {
        f"{number + 1}. {row['weave']}, {row['kind']}": [
            row["found"], row["confidence"], row["sett"], row["delta_e"], row["roughness"], row["flip"]
        ] if not row["refused"] else ["refused", *[""] * 5]
        for number, row in enumerate(rows)
    }  # fmt: skip
    return [
        Table("Captured swatches that meet the bars", ["bar", "share that meets it", "median"], summary),
        _reliability_table(figures["reliability"]),
        Table("Each captured swatch", columns, each),
    ]


def _reliability_table(bins: list[dict[str, Any]]) -> Table:
    rows: dict[str, list[float | int | str | None]] = {}
    for low, part in zip(BINS, bins, strict=False):
        right = part["right"] / part["swatches"] if part["swatches"] else ""
        rows[f"{low:g} and more"] = [part["swatches"], part["confidence"], right]
    return Table("How sure of its weave, and how often right", ["swatches", "sure", "right"], rows)


STUDIES = (
    Study(
        "accuracy/capture",
        "fabrics captured from rendered photographs against those that were photographed",
        Capture(),
        measure,
        tables,
        stands_on=("point",),
        small={"count": 1, "pixels": 240, "spp": 1},
    ),
    Study(
        "accuracy/capture_window",
        "the same by the light of a window",
        Capture(count=10, light="window"),
        measure,
        tables,
        stands_on=("point",),
        small={"count": 1, "pixels": 240, "spp": 1},
    ),
)
