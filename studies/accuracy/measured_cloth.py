"""Cloth of ours beside measured BRDFs: how near the nearest plausible fabric comes, and where it is wrong.

Each of 14 measured fabrics and 7 felts (`instruments/measured_brdf.py`) is fitted by cloth of one yarn:
height and twist out of a few; colour, strength, tint, roughness and grazing rise of the highlight, and
sheen by least squares. They are isotropic, so ours is the mean over turns of the cloth. The error is the rms
of ln(f·cos + 0.001) over pairs of light and view to 80°, of the fabric file that the fit writes, by `lobes`.
Fits see other pairs than errors do. Fitted alike: Lambert's law, Mitsuba's principled BSDF with sheen, of as
many numbers as ours, nine, the same with clear coat, eleven, and OpenPBR with fuzz, ten. Ours chooses one of
six cloths beside.

*Without rise* is the same cloth with `specular_grazing = 0`.

Curves tell cloth from paint: albedo at 75° over that at 0°, what returns to the light at 60° over that at 0°,
and the mirror's direction at 75° over that at 0°.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import product
from typing import Any

import mitsuba as mi
import numpy as np
from drjit.llvm.ad import Array3f, Float
from scipy.optimize import least_squares

from loomlight.core.colour import to_hex
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.isotropic import VIEWS, Angles, Floats, Pairs, logarithm, rise, rms, turned_value
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric import fabric_from_text
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.resolve import OPTICAL_DEPTH
from loomlight.scattering.albedo import albedos_from_colour
from loomlight.scattering.fibre import cloth_layer_bound
from loomlight.scattering.grazing import Grazing
from loomlight.scattering.sheen import sheen_with_transmittance
from studies.harness.study import Figures, Found, Pixels, Run, Study, listed, names
from studies.instruments.measured_brdf import measured_brdfs
from studies.instruments.standard_brdfs import Fitted, lambert, openpbr, principled
from studies.instruments.turned_cloth import TurnedTerms, turned_terms

# Cloth to choose from.
WEAVES = ("plain",)
HEIGHTS = (0.05, 0.2, 0.4)
TWISTS = (0.0, -25.0)
# Grids of what is interpolated.
ROUGHNESSES = (0.1, 0.18, 0.3, 0.42, 0.55, 0.75, 1.0)
SHEEN_ROUGHNESSES = (0.05, 0.15, 0.25, 0.4, 0.6, 0.8, 1.0)
GREYS = (0.02, 0.1, 0.3, 0.6, 0.9)
TRANSLUCENCY = 0.12
# Largest rise of the highlight that a fabric file may state.
MAX_GRAZING = 4.0
# Pairs that fits see.
FITTED = 256
# Materials that others have.
OTHERS: dict[str, Callable[[Pairs], Fitted]] = {
    "Lambert": lambert,
    "principled": principled,
    "with coat": partial(principled, coat=True),
    "OpenPBR": openpbr,
}
_OURS = ("specular", "tint", "roughness", "sheen", "sheen roughness", "grazing")


@dataclass(frozen=True)
class MeasuredCloth(Settings):
    """Which BRDFs, and over how many pairs."""

    brdfs: str = names("", "Of the file, as set/name; by default all.")
    weaves: str = names(",".join(WEAVES), "Weaves to choose from.")
    heights: int = setting(
        len(HEIGHTS), "Heights to choose from, the first so many.", low=1, high=len(HEIGHTS)
    )
    pairs: int = setting(4096, "Of light and view.", low=64, high=1 << 16)
    turns: int = setting(12, "Of the cloth.", low=2, high=64)


@dataclass(frozen=True)
class Cloth:
    """A cloth of one yarn, whatever its colours."""

    weave: str
    height: float
    twist: float

    def fabric(self, albedo: Floats, roughness: float, more: str = "", sheen: str = "") -> Fabric:
        """The fabric of a colour [3], both families alike."""
        yarn = (
            f"albedo = {_triple(albedo)}\nroughness = {roughness:.4f}\nheight_scale = {self.height}\n"
            f"twist_deg = {self.twist}\ntranslucency = {TRANSLUCENCY}\n{more}"
        )
        return fabric_from_text(f'weave = "{self.weave}"\n[warp]\n{yarn}\n[weft]\n{yarn}\n{sheen}')


class ClothFit:
    """What cloth of one structure answers for pairs, as its colours and highlights are chosen."""

    def __init__(self, cloth: Cloth, pairs: Pairs, turns: int) -> None:
        self.cloth = cloth
        half_grey = np.full(3, 0.3)
        self._terms = [turned_terms(cloth.fabric(half_grey, each), pairs, turns) for each in ROUGHNESSES]
        self._bounced = np.stack(
            [turned_terms(cloth.fabric(np.full(3, grey), 0.4), pairs, turns).bounced for grey in GREYS]
        )
        light, view = (
            Array3f(np.ascontiguousarray(part.T, np.float32)) for part in (pairs.light, pairs.view)
        )
        lobes = [sheen_with_transmittance(light, view, Float(1), Float(each)) for each in SHEEN_ROUGHNESSES]
        # Of a rise of 1, and what diffuse light loses at a loss of 1 for the light and for the view.
        whole, up = Grazing(1.0, 1.0), Array3f(0, 0, 1)
        self._rise = whole.rise(light, view).numpy()[:, None]
        self._losses = [1 - whole.kept(each, up).numpy()[:, None] for each in (light, view)]
        self._sheens = np.array([[part.numpy() for part in lobe] for lobe in lobes], float)

    def fitted(self, rises: bool) -> Fitted:
        """Colour, then `_OURS`; roughness by place in its grid.

        Args:
            rises: False leaves out the last number, 0.
        """
        last = len(ROUGHNESSES) - 1, len(SHEEN_ROUGHNESSES) - 1
        low = np.array([*3 * [1e-4], 0, 0, 0, 0, 0, 0])
        high = np.array([*3 * [0.999], 1, 1, last[0], 1, last[1], MAX_GRAZING])
        starts = [np.array([0.2, 0.3, 4.0, sheen, 3.0, 1.0]) for sheen in (0.02, 0.3)]
        count = len(low) if rises else len(low) - 1
        return Fitted(low[:count], high[:count], self.value, [start[: count - 3] for start in starts])

    def value(self, numbers: Floats) -> Floats:
        """f·cos [n, 3]; without the last number there is no rise."""
        colour, specular, tint, place, strength, sheen, gain = _named(numbers)
        terms = _between(self._terms, place)
        bound = cloth_layer_bound(float(_roughness(place)), OPTICAL_DEPTH)
        albedos = albedos_from_colour(colour, specular, TRANSLUCENCY, OPTICAL_DEPTH, bound)
        grazing = Grazing.of(gain, _roughness(place))
        kept = (1 - grazing.loss * self._losses[0]) * (1 - grazing.loss * self._losses[1])
        bounced = np.stack([_interpolated(self._bounced, GREYS, each) for each in colour], axis=1)
        body = terms.specular[:, None] * (highlight_of(colour, specular, tint) + gain * self._rise)
        body = body + kept * (terms.diffuse[:, None] * albedos.diffuse_reflect + bounced)
        lobe, through = _interpolated(self._sheens, range(len(SHEEN_ROUGHNESSES)), sheen)
        transmittance = 1 - strength * (1 - through)
        found: Floats = transmittance[:, None] * body + (terms.lit * strength * lobe)[:, None]
        return found

    def fabric(self, numbers: Floats) -> Fabric:
        """The fabric file of what was fitted."""
        colour, specular, tint, place, strength, sheen, gain = _named(numbers)
        rough = np.interp(sheen, range(len(SHEEN_ROUGHNESSES)), SHEEN_ROUGHNESSES)
        return self.cloth.fabric(
            colour,
            _roughness(place),
            f"specular = {specular:.4f}\nspecular_grazing = {gain:.4f}\n"
            f"specular_reflect = {_triple(highlight_of(colour, specular, tint))}\n",
            f"[sheen]\nstrength = {strength:.4f}\nroughness = {rough:.4f}\n",
        )


def highlight_of(colour: Floats, specular: float, tint: float) -> Floats:
    """The albedo of a highlight between white, 0, and the hue of the yarn, 1."""
    return specular * (1 - tint + tint * colour / colour.max())


def _named(numbers: Floats) -> tuple[Floats, float, float, float, float, float, float]:
    """Colour, then `_OURS`; the last one may be missing."""
    specular, tint, place, strength, sheen, *rest = (float(number) for number in numbers[3:])
    return numbers[:3], specular, tint, place, strength, sheen, rest[0] if rest else 0.0


def _triple(colour: Floats) -> str:
    """Linear RGB as fabric files have it: hexadecimal digits of dark colours are off by a tenth."""
    return "[" + ", ".join(f"{part:.6f}" for part in colour) + "]"


def _roughness(place: float) -> float:
    return float(np.exp(np.interp(place, range(len(ROUGHNESSES)), np.log(ROUGHNESSES))))


def _between(terms: Sequence[TurnedTerms], place: float) -> TurnedTerms:
    first = min(int(place), len(terms) - 2)
    return terms[first].blended(terms[first + 1], place - first)


def _interpolated(rows: Floats, places: Sequence[float], place: float) -> Floats:
    above_it = int(np.clip(np.searchsorted(places, place), 1, len(places) - 1))
    low, high = places[above_it - 1], places[above_it]
    share = float(np.clip((place - low) / (high - low), 0, 1))
    found: Floats = (1 - share) * rows[above_it - 1] + share * rows[above_it]
    return found


# ------------------------------------------------------------------------------------------------------- fits


def fit(material: Fitted, measured: Floats) -> tuple[float, Floats]:
    """The least rms of `logarithm`, and the numbers that have it."""
    truth = logarithm(measured)
    colour = np.clip(np.pi * measured.mean(axis=0) * 2, 0.01, 0.9)
    best: tuple[float, Floats] = (np.inf, material.low)
    for start in material.starts:
        found = least_squares(
            lambda numbers: (logarithm(material.value(numbers)) - truth).ravel(),
            np.clip(np.concatenate([colour, start]), material.low + 1e-6, material.high - 1e-6),
            bounds=(material.low, material.high),
            x_scale=material.high - material.low,
            diff_step=1e-3,
            max_nfev=25,
        )
        error = float(np.sqrt(2 * found.cost / truth.size))
        best = min(best, (error, found.x), key=lambda each: each[0])
    return best


# ---------------------------------------------------------------------------------------------------- running


def measure(settings: MeasuredCloth, run: Run) -> Found:
    """Errors, numbers and curves of each BRDF."""
    require_llvm()
    mi.set_variant("llvm_ad_rgb")
    angles = Angles.drawn(settings.pairs)
    fitted = Pairs.drawn(np.random.default_rng(1), min(FITTED, settings.pairs))
    brdfs = measured_brdfs()
    chosen = listed(settings.brdfs) or list(brdfs)
    cloths = [
        ClothFit(Cloth(*each), fitted, settings.turns)
        for each in product(listed(settings.weaves), HEIGHTS[: settings.heights], TWISTS)
    ]
    fits = {name: of(fitted) for name, of in OTHERS.items()}
    shown = {name: of(angles.pairs) for name, of in OTHERS.items()}

    def nearest(rises: bool, measured: Floats) -> tuple[Floats, ClothFit]:
        found = [(fit(each.fitted(rises), measured), each) for each in cloths]
        (_, numbers), cloth = min(found, key=lambda each: each[0][0])
        return numbers, cloth

    def scored(value: Floats, measured: Floats) -> Figures:
        error = rms(value[: angles.errors], measured[: angles.errors])
        return {"rms": round(error, 4), **angles.curves(value)}

    def one(name: str) -> Figures:
        pairs = angles.pairs
        truth = brdfs[name].value(fitted.light, fitted.view) * fitted.light[:, 2:]
        measured = brdfs[name].value(pairs.light, pairs.view) * pairs.light[:, 2:]
        found: dict[str, Any] = {"measured": angles.curves(measured)}
        for label, material in fits.items():
            found[label] = scored(shown[label].value(fit(material, truth)[1]), measured)
        for label, rises in (("without rise", False), ("cloth", True)):
            numbers, cloth = nearest(rises, truth)
            found[label] = scored(turned_value(cloth.fabric(numbers), pairs, settings.turns), measured)
        found["cloth"] = {
            **found["cloth"],
            "weave": cloth.cloth.weave,
            "height": cloth.cloth.height,
            "twist": cloth.cloth.twist,
            **dict(zip(_OURS, [round(float(each), 3) for each in numbers[3:]], strict=True)),
            "colour": to_hex(numbers[:3]),
        }
        found["cloth"]["roughness"] = round(_roughness(numbers[5]), 3)
        return found

    rows = run.each({name: partial(one, name) for name in chosen})
    fabrics = [row for name, row in rows.items() if not is_felt(name)]
    nearer = {
        label: {
            other: sum(row[label]["rms"] < row[other]["rms"] for row in fabrics)
            for other in OTHERS
            if other != "Lambert"
        }
        for label in ("without rise", "cloth")
    }
    figures = {"brdfs": rows, "nearer": nearer, "fabrics": len(fabrics)}
    return Found(figures, curves_sheet(figures))


# Of the cloth that is nearest, in the table.
_CHOSEN = ("weave", "height", "twist", "roughness", "specular", "tint", "grazing", "sheen")
# Labels and keys of the lines of plots.
_LINES = {
    "measured": "measured",
    "cloth": "cloth",
    "without rise": "without rise",
    "principled": "principled",
    "OpenPBR": "OpenPBR",
}


def curves_sheet(figures: Figures) -> Pixels:
    """Albedo, and what the mirror's direction shows, over the view's angle, each over that at 0°."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    shown = [name for name in figures["brdfs"] if not is_felt(name)][::3]
    figure = Figure(figsize=(12, 5), dpi=100, layout="constrained")
    canvas = FigureCanvasAgg(figure)
    axes = figure.subplots(2, len(shown), squeeze=False, sharex=True)
    for column, name in enumerate(shown):
        row = figures["brdfs"][name]
        for axis, curve in zip(axes[:, column], ("albedo", "mirror"), strict=True):
            for label, key in _LINES.items():
                values = np.array(row[key][curve])
                axis.plot(VIEWS, values / values[0], "k" if key == "measured" else "", label=label)
            axis.set_yscale("linear" if curve == "albedo" else "log")
        axes[0, column].set_title(name.split("/")[1], fontsize=10)
        axes[1, column].set_xlabel("view, degrees")
    for axis, text in zip(axes[:, 0], ("albedo over that at 0°", "mirror over that at 0°"), strict=True):
        axis.set_ylabel(text)
    axes[0, 0].legend(fontsize=8)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3].copy()


def is_felt(name: str) -> bool:
    """Felts are pressed, not woven."""
    return "felt" in name


def tables(figures: Figures) -> list[Table]:
    """Errors, then curves."""
    errors = Table(
        "Errors: rms of ln(f·cos + 0.001)",
        [*OTHERS, "without rise", "cloth", *_CHOSEN],
    )
    shapes = Table(
        "Curves, measured / cloth / without rise / principled / OpenPBR",
        ["albedo 75° over 0°", "back at 60° over 0°", "mirror 75° over 0°"],
    )
    ratios: list[tuple[str, Callable[[Sequence[float]], float]]] = [
        ("albedo", lambda curve: rise(curve, 75.0)),
        ("back", lambda curve: rise(curve, 60.0)),
        ("mirror", lambda curve: rise(curve, 75.0)),
    ]
    for name, row in figures["brdfs"].items():
        cloth = row["cloth"]
        numbers: list[Cell] = [row[key]["rms"] for key in (*OTHERS, "without rise", "cloth")]
        errors.rows[name] = [*numbers, *(cloth[key] for key in _CHOSEN)]
        each_of = [row[key] for key in ("measured", "cloth", "without rise", "principled", "OpenPBR")]
        shapes.rows[name] = [
            " / ".join(f"{ratio(each[curve]):.2f}" for each in each_of) for curve, ratio in ratios
        ]
    nearer = Table(
        f"Nearer, of {figures['fabrics']} fabrics that are no felt, than", list(figures["nearer"]["cloth"])
    )
    for label, counts in figures["nearer"].items():
        nearer.rows[label] = list(counts.values())
    return [nearer, errors, shapes]


STUDY = Study(
    "accuracy/measured_cloth",
    "the nearest cloth of ours beside measured fabrics",
    MeasuredCloth(),
    measure,
    tables,
    stands_on=("lobes",),
    small={"brdfs": "merl/blue-fabric", "weaves": "plain", "heights": 1, "pairs": 64, "turns": 2},
)
