"""Figured cloth: a motif in one structure on a ground in another, as a jacquard loom weaves damask."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.core.errors import InputError
from loomlight.weave.binding import bind_floats
from loomlight.weave.draft import Draft
from loomlight.weave.palette import from_palette
from loomlight.weave.structures import MAXIMUM_NAMED_THREADS, Structure, sateen, satin, twill

_IVORY_AND_GOLD = ("#e9dfc6", "#8c6a2f")
_SLATE_AND_CREAM = ("#39465c", "#e8e0cf")
_WINE_AND_ROSE = ("#5d1f2e", "#d9a9a0")


def figured_structure(mask: Mask, figure: Structure, ground: Structure, *, float_limit: int) -> Structure:
    """`figure` where `mask` is True and `ground` elsewhere, with floats bound where the two meet.

    Args:
        mask: bool [picks, ends], row 0 is pick 1; both structures must divide it.
        figure: bool [m, n].
        ground: bool [m, n].
        float_limit: the longest float that is left, in threads; at least the structures' own.

    Raises:
        InputError: a structure that does not divide the mask, or a limit that cannot be kept.
    """
    picks, ends = mask.shape
    for name, structure in (("figure", figure), ("ground", ground)):
        if picks % structure.shape[0] or ends % structure.shape[1]:
            raise InputError(
                f"The {name} structure has {structure.shape[1]} ends and {structure.shape[0]} picks, "
                f"which do not divide a motif of {ends} ends and {picks} picks."
            )
    tiled = [
        np.tile(structure, (picks // structure.shape[0], ends // structure.shape[1]))
        for structure in (figure, ground)
    ]
    warp_up = np.where(mask, *tiled)
    return bind_floats(warp_up, float_limit)


def damask(ends: int) -> Draft:
    """The ogee damask on so many ends (a multiple of 16 from 160): satin 8/3 on sateen 8/3.

    Raises:
        InputError: another number of ends.
    """
    picks = round(ends * OGEE_ASPECT)
    _check("damask", ends, picks, multiple=16, lowest=160)
    structure = figured_structure(ogee_damask(ends, picks), satin(8, 3), sateen(8, 3), float_limit=10)
    return _two_coloured(structure, f"damask {ends}", _IVORY_AND_GOLD)


def argyle_cloth(ends: int) -> Draft:
    """Argyle diamonds on so many ends (a multiple of 8 from 32): 3/1 twill on 1/3 twill.

    Raises:
        InputError: another number of ends.
    """
    picks = ends * 3 // 2
    _check("argyle", ends, picks, multiple=8, lowest=32)
    structure = figured_structure(argyle(ends, picks), twill((3, 1)), twill((1, 3)), float_limit=5)
    return _two_coloured(structure, f"argyle {ends}", _SLATE_AND_CREAM)


def diamond_figure(ends: int) -> Draft:
    """Diamonds within diamonds on so many ends (a multiple of 16 from 48): satin 8/3 on sateen 8/3.

    Raises:
        InputError: another number of ends.
    """
    _check("diamond figure", ends, ends, multiple=16, lowest=48)
    structure = figured_structure(lozenges(ends, ends), satin(8, 3), sateen(8, 3), float_limit=10)
    return _two_coloured(structure, f"diamond figure {ends}", _WINE_AND_ROSE)


def _check(name: str, ends: int, picks: int, multiple: int, lowest: int) -> None:
    if ends % multiple or ends < lowest or max(ends, picks) > MAXIMUM_NAMED_THREADS:
        nearest = max(
            lowest,
            min(round(ends / multiple) * multiple, MAXIMUM_NAMED_THREADS * ends // max(ends, picks, 1)),
        )
        nearest -= nearest % multiple
        raise InputError(
            f'"{name} {ends}" cannot be woven: its ends must be a multiple of {multiple}, at least {lowest}, '
            f"with at most {MAXIMUM_NAMED_THREADS} ends and picks; {nearest} would do."
        )


def _two_coloured(structure: Structure, title: str, colors: tuple[str, str]) -> Draft:
    picks, ends = structure.shape
    palette = np.array([parse_colour(color, "palette") for color in colors])
    return Draft(
        drawdown=structure,
        warp=from_palette(ends, np.array([0]), palette),
        weft=from_palette(picks, np.array([1]), palette),
        title=title,
        palette=palette,
    )


# ----------------------------------------------------------------------------------------------------- motifs
# Motifs for figured cloth: which crossings belong to the figure, bool [height, width], repeating both ways.
#
# Row 0 is the lowest. Shapes are given by formulas in units of half the repeat's width, sampled finer than
# the cloth and thresholded, so that they keep their outline at every size.


Mask = NDArray[np.bool_]
Plane = NDArray[np.float64]
# Samples that are spent on one motif.
_SAMPLES = 3e6


def lozenges(width: int, height: int) -> Mask:
    """Diamonds within diamonds: a filled one, a ring around it, and half-drop neighbours."""

    def shape(x: Plane, y: Plane) -> Mask:
        distance = np.abs(x) + np.abs(y)
        return (distance < 0.36) | ((distance > 0.56) & (distance < 0.78)) | (distance > 0.98)

    return _sampled(shape, width, height)


def argyle(width: int, height: int) -> Mask:
    """Large diamonds point to point, under a net of thin lines that change sides inside a diamond."""

    def shape(x: Plane, y: Plane) -> Mask:
        diamond = np.abs(x) + np.abs(y) < 1
        lines = np.minimum(np.abs(_fold(x + y, 2)), np.abs(_fold(x - y, 2))) < 0.07
        return diamond ^ lines

    return _sampled(shape, width, height)


def _fold(value: Plane, period: float) -> Plane:
    """The distance to the nearest multiple of `period`, signed."""
    return value - period * np.rint(value / period)


OGEE_ASPECT = 1.5


def ogee_damask(width: int, height: int) -> Mask:
    """A damask of our own: palmettes on leafy stems in a net of ogees, neighbours half a repeat higher.

    `width` and `height` are even, so that half a repeat is a whole number of threads.
    """
    finer = _finer(width, height)
    x, y = _axis(width * finer, 1.0), _axis(height * finer, OGEE_ASPECT)
    # All of it is mirror-symmetric, so that the right half is enough.
    right = x[x > 0]
    flower = _mirrored(_palmette(right[None, :], y[:, None]))
    half_drop = np.roll(flower, (flower.shape[0] // 2, flower.shape[1] // 2), axis=(0, 1))
    net = _mirrored(_ogee_net(right[None, :], y[:, None]))
    return _coarsened(flower | half_drop | net, finer)


def _finer(width: int, height: int) -> int:
    """Samples a crossing along one side: four, fewer where the cloth itself is fine enough."""
    return int(np.clip(np.sqrt(_SAMPLES / (width * height)), 1, 4))


def _axis(count: int, extent: float) -> Plane:
    return ((np.arange(count) + 0.5) / count * 2 - 1) * extent


def _mirrored(right: Mask) -> Mask:
    return np.concatenate([right[:, ::-1], right], axis=1)


def _coarsened(fine: Mask, finer: int) -> Mask:
    height, width = fine.shape[0] // finer, fine.shape[1] // finer
    return np.asarray(fine.reshape(height, finer, width, finer).mean(axis=(1, 3)) >= 0.5)


def _sampled(shape: Callable[[Plane, Plane], Mask], width: int, height: int) -> Mask:
    """`shape` over x and y in [-1, 1), which one repeat spans."""
    finer = _finer(width, height)
    return _coarsened(shape(_axis(width * finer, 1.0)[None, :], _axis(height * finer, 1.0)[:, None]), finer)


def _ogee_net(x: Plane, y: Plane) -> Mask:
    """A ribbon along the ogees x = (1 + cos(π y / aspect)) / 2, with a row of beads in its middle."""
    phase = np.pi * y / OGEE_ASPECT
    slope = 0.5 * np.pi / OGEE_ASPECT * np.sin(phase)
    across = (x - 0.5 * (1 + np.cos(phase))) / np.hypot(1, slope)
    ribbon = (np.abs(across) < 0.085) & (np.abs(across) > 0.052)
    beads = np.hypot(across, _fold(y, OGEE_ASPECT / 14)) < 0.034
    net = ribbon | beads
    for x_node, y_node in ((0.0, OGEE_ASPECT), (1.0, 0.0)):
        u, v = _fold(x - x_node, 2), _fold(y - y_node, 2 * OGEE_ASPECT)
        radius, angle = np.hypot(u, v), np.arctan2(v, u)
        petals = radius < 0.13 + 0.07 * np.abs(np.cos(4 * angle))
        rosette = (petals & (radius > 0.085)) | (radius < 0.055)
        net = (net & (radius > 0.235)) | rosette
    return net


@dataclass(frozen=True)
class _Leaf:
    """A leaf with its vein left open.

    Attributes:
        root: where it begins.
        degrees: where it points, from the vertical towards the right.
        length: from root to tip.
        breadth: half of its greatest breadth.
        bend: how far its tip is pushed sideways.
        vein: half of the vein's breadth at the root.
        fullest: below 1 it is broadest towards the root, above 1 towards the tip.
    """

    root: tuple[float, float]
    degrees: float
    length: float
    breadth: float
    bend: float = 0.0
    vein: float = 0.014
    fullest: float = 0.8

    def covers(self, x: Plane, y: Plane) -> Mask:
        """Where the leaf is, for x [1, n] and y [m, 1] in ascending order."""
        covered = np.zeros((y.size, x.size), dtype=bool)
        reach = self.length + self.breadth + abs(self.bend)
        columns = slice(*np.searchsorted(x[0], (self.root[0] - reach, self.root[0] + reach)))
        rows = slice(*np.searchsorted(y[:, 0], (self.root[1] - reach, self.root[1] + reach)))
        covered[rows, columns] = self._inside(x[:, columns], y[rows])
        return covered

    def _inside(self, x: Plane, y: Plane) -> Mask:
        turn = np.deg2rad(self.degrees)
        u, v = x - self.root[0], y - self.root[1]
        along = (u * np.sin(turn) + v * np.cos(turn)) / self.length
        safe = np.clip(along, 0, 1)
        across = np.abs((u * np.cos(turn) - v * np.sin(turn)) - self.bend * safe**2)
        half = self.breadth * np.sin(np.pi * safe**self.fullest) ** (0.9 if self.fullest < 1 else 0.6)
        vein = (across < self.vein * (1 - 0.6 * safe)) & (safe > 0.15) & (safe < 0.8)
        return (along > 0) & (along < 1) & (across < half) & ~vein


_PETALS = (
    _Leaf((0, 0), 0, 0.74, 0.115, vein=0.02, fullest=1.9),
    _Leaf((0, 0), 29, 0.74, 0.112, vein=0.02, fullest=1.9),
    _Leaf((0, 0), 57, 0.7, 0.105, vein=0.02, fullest=1.9),
)
_FOLIAGE = (
    _Leaf((0.02, -0.26), 76, 0.78, 0.09, bend=-0.14),
    _Leaf((0.02, -0.6), 52, 0.62, 0.1, bend=-0.16),
    _Leaf((0.01, -0.92), 34, 0.42, 0.07, bend=-0.08),
    _Leaf((0, 0.84), 0, 0.3, 0.06),
    _Leaf((0.03, 0.8), 42, 0.24, 0.05, bend=-0.05),
)


def _palmette(x: Plane, y: Plane) -> Mask:
    """The right half of a fan of petals over a scaled fruit, on a stem with leaves."""
    from_heart = np.hypot(x, y)
    flower = (np.abs(from_heart - 0.315) < 0.016) & (y > -0.1)
    for petal in _PETALS:
        flower |= petal.covers(x, y) & (from_heart > 0.36)
    for leaf in _FOLIAGE:
        flower |= leaf.covers(x, y)
    stem = (x < 0.022) & (y < -0.24) & (y > -1.12)
    berry = np.hypot(x - 0.52, y + 0.5) < 0.06
    return flower | _fruit(x, y) | stem | berry


def _fruit(x: Plane, y: Plane) -> Mask:
    """A drop with a rim, filled with scales."""
    v = (y + 0.02) / 0.26
    half = 0.2 * np.sqrt(np.clip(1 - v**2, 0, 1)) * (1 - 0.18 * v)
    depth = half - x
    rim = (depth > 0) & (depth < 0.035)
    scales = np.abs(_fold(x + 0.8 * y, 0.105)) + np.abs(_fold(x - 0.8 * y, 0.105)) < 0.058
    return rim | ((depth > 0.055) & scales)
