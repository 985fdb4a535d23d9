"""Fibres of the kinds of yarn of a fabric: plies, stray, slubs and hairs as its file has them, as curves.

Yarns lie where the surface model has them. Their crowns follow its crowns, smoothed, as a yarn bends over
a quarter of its thickness at least. Above its edges the section is an ellipse through crown and edges
of the model's circle, below them it reaches as far as the yarn beneath leaves room. Fibres are as wide as the
model's, a thirtieth of a thread (`models/fabric_model.py`).

Lines are functions of the place along a thread and of its number: windows show parts of the same cloth.
In the frame of a yarn `across`, `along` and up are right-handed, so that both families twist alike.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.llvm import llvm_float
from loomlight.fabric.fabric import Fabric
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.threads import FamilyTables, section_drop

Rows = NDArray[np.float64]

# Of the thinnest thread, widths of a fibre.
FIBRES_ACROSS = 30
# Samples of a crown line between two crossings, and its smoothing over the height above the edges.
_SAMPLES, _SMOOTHING = 64, 0.5
# Depth of a section below its edges over the height above them, at least and at most.
_DEPTH = (0.4, 1.0)
# Plies press on each other: their radius over that of plies that only touch.
_PRESSED = 1.12
_GOLDEN_ANGLE = math.pi * (3 - math.sqrt(5))
# Fibres wander by waves of these lengths, in widths of a fibre, half the variance each.
_WAVES = ((18, 32), (50, 90))
# Slubs: largest change of the section's size, and lengths of their waves in widths of the yarn.
_SLUB, _SLUB_WAVES = 0.15, (5, 12)
# Hairs of a side in a square of a fibre's width: as many as the model's two grids have. Lengths in widths
# of a fibre, exponential within bounds; how steeply they leave, and how far they turn at most, radians.
_HAIRS = 2 / 17**2
_HAIR_LENGTH, _HAIR_BOUNDS = 21.0, (8.0, 80.0)
_HAIR_RISE, _HAIR_TURN = (0.25, 1.2), 1.6
_HAIR_POINTS = 9


@dataclass(frozen=True)
class YarnMake:
    """The make-up of the yarns of one family.

    Attributes:
        plies: twisted together, ≥ 1.
        ply_twist, twist: angles of plies and of fibres to the yarn at its surface, radians, negative for Z.
        tilt: standard deviation of the angles by which fibres stray, radians.
        slub, hairiness: 0 to 1, as in `YarnDetail`.
        packing: share of the section of plies that is fibre.
        fibre: diameter, millimetres.
    """

    plies: int
    ply_twist: float
    twist: float
    tilt: float
    slub: float
    hairiness: float
    packing: float
    fibre: float


@dataclass(frozen=True)
class Window:
    """A rectangle of cloth in draft coordinates, millimetres."""

    left: float
    bottom: float
    right: float
    top: float


@dataclass(frozen=True, eq=False)
class YarnLine:
    """The run of one thread within a repeat.

    Attributes:
        crown: heights of its highest line, evenly spaced along a repeat [n], millimetres.
        length: of the repeat along it, millimetres.
        centre: where it lies across, millimetres.
        half_width, rise, depth: of its section, from the middle sideways, up and down, millimetres.
    """

    crown: Rows
    length: float
    centre: float
    half_width: float
    rise: float
    depth: float

    def height(self, along: Rows) -> tuple[Rows, Rows]:
        """Height of the middle of the section at places along the thread, and its slope."""
        places = np.arange(len(self.crown)) * (self.length / len(self.crown))
        slope = np.gradient(np.tile(self.crown, 3), places[1])[len(places) : 2 * len(places)]
        found = (np.interp(along, places, line, period=self.length) for line in (self.crown, slope))
        crown, slopes = found
        return crown - self.rise, slopes


@dataclass(frozen=True, eq=False)
class YarnCurves:
    """Curves of one thread: `points` of cubic B-splines [n, 3], millimetres, of fibres and of hairs."""

    is_warp: bool
    thread: int
    fibres: list[Rows]
    hairs: list[Rows]
    radius: float


def yarn_makes(fabric: Fabric, fibres_across: float = FIBRES_ACROSS) -> tuple[YarnMake, YarnMake]:
    """The make-up of warp and weft that a fabric file gives."""
    layout, appearance, yarns = fabric.layout(), fabric.appearance(), fabric.resolved
    thinnest = min(layout.warp.visible_width.min(), layout.weft.visible_width.min())
    makes = []
    for family, kind in ((appearance.warp, yarns.warp.kind), (appearance.weft, yarns.weft.kind)):
        detail = family.detail
        makes.append(
            YarnMake(
                plies=detail.plies,
                ply_twist=detail.ply_twist,
                twist=detail.twist,
                tilt=detail.fibre_tilt,
                slub=detail.slub,
                hairiness=detail.hairiness,
                packing=kind.packing,
                fibre=float(thinnest) / fibres_across,
            )
        )
    return makes[0], makes[1]


def yarn_lines(layout: ClothLayout) -> tuple[list[YarnLine], list[YarnLine]]:
    """The runs of the warp's threads and of the weft's."""
    geometry = YarnGeometry(layout)
    warp, weft = geometry.families
    scales = layout.warp.height_scale, layout.weft.height_scale
    crowns = [
        _crowns(geometry, is_warp, own, other, scale)
        for is_warp, own, other, scale in ((True, warp, weft, scales[1]), (False, weft, warp, scales[0]))
    ]
    # Where two threads cross, the lower one's crown bounds the upper one's section from below.
    at_warp = crowns[0][:, _nearest(weft, crowns[0].shape[1])]
    # Along a weft places count from its start on the right.
    at_weft = crowns[1][:, _nearest(warp, crowns[1].shape[1], is_backwards=True)]
    room = np.abs(at_warp.T - at_weft)
    found: tuple[list[YarnLine], list[YarnLine]] = ([], [])
    for is_warp, own, other, scale, lines in (
        (True, warp, weft, scales[0], found[0]),
        (False, weft, warp, scales[1], found[1]),
    ):
        on_top = layout.warp_on_top if is_warp else ~layout.warp_on_top
        rises = scale * section_drop(own.half_width, own.half_width)
        for thread, rise in enumerate(rises):
            mask = on_top[:, thread] if is_warp else on_top[thread]
            gaps = (room[:, thread] if is_warp else room[thread])[mask]
            below = float(gaps.min()) - rise if gaps.size else rise
            line = crowns[0 if is_warp else 1][thread]
            lines.append(
                YarnLine(
                    crown=_smoothed(line, _SMOOTHING * rise * len(line) / other.period),
                    length=other.period,
                    centre=float(own.centre[thread]),
                    half_width=float(own.half_width[thread]),
                    rise=float(rise),
                    depth=float(np.clip(below, _DEPTH[0] * rise, _DEPTH[1] * rise)),
                )
            )
    return found


def yarn_curves(
    fabric: Fabric,
    window: Window,
    makes: tuple[YarnMake, YarnMake] | None = None,
    points: int = 16,
    seed: int = 0,
) -> list[YarnCurves]:
    """The fibres and hairs within a window, thread by thread, warp first.

    Args:
        makes: of warp and weft; None for those that the fabric's file gives.
        points: control points between two crossings.
    """
    layout = fabric.layout()
    makes = makes or yarn_makes(fabric)
    found = []
    for is_warp, lines, make in zip((True, False), yarn_lines(layout), makes, strict=True):
        own, other = (layout.warp, layout.weft) if is_warp else (layout.weft, layout.warp)
        period, step = float(own.spacing.sum()), float(other.spacing.mean()) / points
        low, high = (window.left, window.right) if is_warp else (window.bottom, window.top)
        ends = (window.bottom, window.top) if is_warp else (-window.right, -window.left)
        along = np.arange(math.floor(ends[0] / step) - 1.0, math.ceil(ends[1] / step) + 2.0) * step
        for repeat in range(math.floor(low / period) - 1, math.floor(high / period) + 2):
            for thread, line in enumerate(lines):
                centre = line.centre + repeat * period
                if not low - line.half_width < centre < high + line.half_width:
                    continue
                number = repeat * len(lines) + thread
                rng = np.random.default_rng([seed, int(is_warp), number + 2**20])
                fibres = _placed(is_warp, centre, _fibres(line, make, along, rng))
                hairs = [
                    _placed(is_warp, centre, hair[None])[0]
                    for hair in _hairs(line, make, ends, [seed, int(is_warp) + 2, number + 2**20])
                ]
                found.append(YarnCurves(is_warp, thread, list(fibres), hairs, 0.5 * make.fibre))
    return found


def ply_radius(plies: int) -> float:
    """Radius of a ply over that of its yarn: one fills it, several press on each other."""
    return 1.0 if plies == 1 else min(_PRESSED / (1 + 1 / math.sin(math.pi / plies)), 0.7)


def fibre_count(line: YarnLine, make: YarnMake) -> int:
    """Fibres of a ply."""
    section = 0.5 * math.pi * line.half_width * (line.rise + line.depth) * ply_radius(make.plies) ** 2
    return max(round(make.packing * section / (math.pi * 0.25 * make.fibre**2)), 1)


def _crowns(
    geometry: YarnGeometry, is_warp: bool, own: FamilyTables, other: FamilyTables, other_scale: float
) -> Rows:
    """Heights of the highest line of each thread of a family [threads, n] in its own direction, mm."""
    types = array_types(llvm_float())
    threads, crossings = len(own.centre), len(other.centre)
    count = _SAMPLES * crossings
    along = np.arange(count) * (other.period / count)
    across = np.repeat(own.centre, count)
    # A weft's own direction is -x.
    places = np.tile(along if is_warp else -along, threads)
    x, y = (across, places) if is_warp else (places, across)
    columns, rows = types.Float(x.astype(np.float32)), types.Float(y.astype(np.float32))
    heights, shows = [], []
    for is_back in (False, True):
        point = geometry.surface(columns, rows, types.Bool(is_back))
        height, shown = types.Float(point.height), types.Bool(point.is_warp)
        dr.eval(height, shown)
        heights.append(height.numpy().astype(np.float64))
        shows.append(np.broadcast_to(shown.numpy(), across.shape) == is_warp)
    # Where the other thread hides it, it lies below that one's edge.
    drop = np.interp(places % other.period, other.centre, other_scale * other.edge_drop, period=other.period)
    return np.where(shows[0], heights[0], -heights[1] - drop).reshape(threads, count)


def _nearest(other: FamilyTables, count: int, is_backwards: bool = False) -> NDArray[np.intp]:
    """Samples of crown lines where the threads of the other family cross."""
    places = -other.centre if is_backwards else other.centre
    return np.rint(places / other.period * count).astype(np.intp) % count


def _smoothed(line: Rows, deviation: float) -> Rows:
    """A periodic line under a Gaussian, `deviation` in samples."""
    frequencies = 2 * math.pi * np.fft.rfftfreq(len(line))
    kernel = np.exp(-0.5 * (frequencies * deviation) ** 2)
    return np.asarray(np.fft.irfft(np.fft.rfft(line) * kernel, len(line)))


def _fibres(line: YarnLine, make: YarnMake, along: Rows, rng: np.random.Generator) -> Rows:
    """Control points of fibres in the frame of a yarn [fibres, n, 3], millimetres."""
    count, ply = fibre_count(line, make), ply_radius(make.plies)
    size = np.array([line.half_width, 0.5 * (line.rise + line.depth)])
    edge = 0.5 * make.fibre / size.min()
    ply_rate, own_rate = _rates(line, make)
    places, phase = [], rng.random()
    for number in range(make.plies):
        turned = ply_rate * along + 2 * math.pi * (number / make.plies + phase)
        seeds = (np.arange(count) + rng.uniform(0.2, 0.8, count)) / count
        angle = _GOLDEN_ANGLE * np.arange(count) + rng.random() * 2 * math.pi
        radius = (ply - edge) * np.sqrt(seeds)
        start = np.stack([radius * np.cos(angle), radius * np.sin(angle)])
        # Of each fibre, across and up in the turning frame of its ply.
        wander = np.stack([_wander(make, along, count, rng) / extent for extent in size])
        place = start[:, :, None] + wander
        norm = np.hypot(*place)
        place *= np.minimum(1, (ply - edge) / np.maximum(norm, 1e-9))
        sine, cosine = np.sin(own_rate * along), np.cos(own_rate * along)
        centre = (1 - ply) * np.stack([np.cos(turned), np.sin(turned)])[:, None]
        within = np.stack([cosine * place[0] - sine * place[1], sine * place[0] + cosine * place[1]])
        places.append(centre + within)
    across, up = np.concatenate(places, axis=1)
    slub = 1 + _SLUB * make.slub * _slub_noise(line, along, rng)
    return _on_line(line, slub * across, slub * up, np.broadcast_to(along, across.shape))


def _rates(line: YarnLine, make: YarnMake) -> tuple[float, float]:
    """Turns of plies about the yarn and of fibres about their ply, radians a millimetre."""
    if make.plies == 1:
        return 0.0, math.tan(make.twist) / line.half_width
    ply = ply_radius(make.plies)
    of_plies = math.tan(make.ply_twist) / line.half_width
    return of_plies, (math.tan(make.twist) / line.half_width - of_plies * (1 - ply)) / ply


def _wander(make: YarnMake, along: Rows, count: int, rng: np.random.Generator) -> Rows:
    """Distances of fibres from their place [fibres, n], mm, whose slopes have the deviation `tilt`."""
    total = np.zeros((count, along.size))
    for low, high in _WAVES:
        length = make.fibre * rng.uniform(low, high, (count, 1))
        angle = 2 * math.pi * (along / length + rng.random((count, 1)))
        # A wave of amplitude a has slopes of the variance (2πa/length)²/2.
        total += math.tan(make.tilt) * length / (2 * math.pi) * np.sin(angle)
    return total


def _slub_noise(line: YarnLine, along: Rows, rng: np.random.Generator) -> Rows:
    """Numbers of variance 1/4 along a yarn."""
    length = 2 * line.half_width * rng.uniform(*_SLUB_WAVES, 2)
    phase = rng.random(2)
    return 0.5 * np.sin(2 * math.pi * (along[:, None] / length + phase)).sum(axis=1)


def _hairs(line: YarnLine, make: YarnMake, ends: tuple[float, float], seed: list[int]) -> list[Rows]:
    """Control points of hairs that begin between two places of a yarn, in its frame [n, 3], millimetres."""
    side, found = 2 * line.half_width, []
    # On both sides of the yarn, of which a viewer sees one.
    mean = 2 * _HAIRS * make.hairiness * (side / make.fibre) ** 2
    for part in range(math.floor(ends[0] / side), math.ceil(ends[1] / side)):
        rng = np.random.default_rng([*seed, part + 2**20])
        for _ in range(rng.poisson(mean)):
            found.append(_hair(line, make, (part + rng.random()) * side, rng))
    return found


def _hair(line: YarnLine, make: YarnMake, begin: float, rng: np.random.Generator) -> Rows:
    """A hair that leaves its yarn at a place along it: an arc of a circle, its root within the yarn."""
    around, rise = rng.random() * 2 * math.pi, rng.uniform(*_HAIR_RISE)
    length = make.fibre * float(np.clip(rng.exponential(_HAIR_LENGTH), *_HAIR_BOUNDS))
    height = line.rise if math.sin(around) > 0 else line.depth
    outwards = np.array([math.cos(around) * height, 0, math.sin(around) * line.half_width])
    outwards /= np.linalg.norm(outwards)
    forwards = np.array([0, rng.choice([-1.0, 1.0]), 0])
    start = math.cos(rise) * forwards + math.sin(rise) * outwards
    sideways = np.cross(start, rng.normal(size=3))
    sideways /= np.linalg.norm(sideways)
    angle = rng.uniform(0.1, 1) * _HAIR_TURN * np.linspace(-0.15, 1, _HAIR_POINTS)
    bow = length / angle[-1]
    arc = bow * (np.sin(angle)[:, None] * start + (1 - np.cos(angle))[:, None] * sideways)
    across, up = (np.array([0.93 * of(around)]) for of in (math.cos, math.sin))
    root = _on_line(line, across, up, np.array([begin]))
    return root + arc


def _on_line(line: YarnLine, across: Rows, up: Rows, along: Rows) -> Rows:
    """Points [..., 3] of a yarn's frame at places of its unit section, which stands square to its line."""
    height, slope = line.height(along)
    offset = up * np.where(up > 0, line.rise, line.depth)
    cosine = 1 / np.sqrt(1 + slope**2)
    return np.stack(
        [across * line.half_width, along - offset * slope * cosine, height + offset * cosine], axis=-1
    )


def _placed(is_warp: bool, centre: float, points: Rows) -> Rows:
    """Points of a yarn's frame in draft coordinates: a weft's own direction is -x."""
    across, along, up = np.moveaxis(points, -1, 0)
    pair = (centre + across, along) if is_warp else (-along, centre + across)
    return np.stack([*pair, up], axis=-1)
