"""Fibres of woven cloth as curves: plies twisted about each yarn, fibres twisted within each ply.

The yarns are those of the surface model: at each crossing the centre line of the upper thread lies a
quarter of the cloth's thickness below its front, that of the lower thread as far above its back, both as
`YarnGeometry` has them; between crossings it swings by a cosine. Sections are ellipses as wide as the
layout's threads and as high as half of the cloth. Twists are rounded to whole turns of a repeat, so that
fibres go on in the next one.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.errors import InputError
from loomlight.core.llvm import llvm_float
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout

# Control points between two crossings.
_POINTS = 16
_MAX_FIBRES = 10_000_000
# Fibres of neighbours of a sunflower's seeds are turned by this angle, radians.
_GOLDEN_ANGLE = math.pi * (3 - math.sqrt(5))
# Fibres wander from their place in a ply by this share of its radius.
_WANDERING = 0.06


@dataclass(frozen=True)
class FibreSettings:
    """The make-up of yarns.

    Attributes:
        plies: of a yarn, 1 to 8.
        fibres: of a ply, 1 to 1000.
        packing: share of a yarn's section that is fibre, 0.05 to 0.9.
        seed: of places of fibres.
    """

    plies: int = 2
    fibres: int = 30
    packing: float = 0.5
    seed: int = 0

    def __post_init__(self) -> None:
        for name, low, high in (("plies", 1, 8), ("fibres", 1, 1000), ("packing", 0.05, 0.9)):
            value = getattr(self, name)
            if not low <= value <= high:
                raise InputError(f"{name} = {value} is wrong: give a number from {low} to {high}.")


@dataclass(frozen=True, eq=False)
class FibreCurves:
    """Fibres of one thread.

    Attributes:
        is_warp, thread: which one.
        points: control points of cubic B-splines [fibres, n, 3], millimetres; the cloth is about z = 0.
        radius: of each fibre, millimetres.
    """

    is_warp: bool
    thread: int
    points: NDArray[np.float64]
    radius: float


def fibre_curves(layout: ClothLayout, settings: FibreSettings) -> list[FibreCurves]:
    """The fibres of one repeat, thread by thread, warp first.

    Raises:
        InputError: more fibres than can be held.
    """
    picks, ends = layout.warp_on_top.shape
    if (picks + ends) * settings.plies * settings.fibres > _MAX_FIBRES:
        raise InputError(f"{picks + ends} threads have more than {_MAX_FIBRES} fibres.")
    front, back = _crossing_heights(layout)
    middle, quarter = 0.5 * (front + back), 0.25 * (front - back)
    warp_heights = middle + np.where(layout.warp_on_top, quarter, -quarter)
    weft_heights = middle - np.where(layout.warp_on_top, quarter, -quarter)
    curves = []
    for is_warp, family, other, heights in (
        (True, layout.warp, layout.weft, warp_heights.T),
        (False, layout.weft, layout.warp, weft_heights),
    ):
        thickness = 2 * quarter.mean()
        for thread in range(len(family.spacing)):
            rng = np.random.default_rng([settings.seed, int(is_warp), thread])
            along, height = _centre_line(other, heights[thread])
            # A weft's own direction is -x, and along x its turns are the other way.
            twist = family.twist if is_warp else -family.twist
            across, up, radius = _sections(
                family, twist, thread, thickness, along, float(other.spacing.sum()), settings, rng
            )
            place = np.cumsum(family.spacing)[thread] - 0.5 * family.spacing[thread] + across
            line = np.broadcast_to(along, across.shape)
            pair = (place, line) if is_warp else (line, place)
            curves.append(FibreCurves(is_warp, thread, np.stack([*pair, height + up], axis=-1), radius))
    return curves


def _crossing_heights(layout: ClothLayout) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Heights of front and back in the middle of each crossing [picks, ends], millimetres."""
    types = array_types(llvm_float())
    x, y = (np.cumsum(f.spacing) - 0.5 * f.spacing for f in (layout.warp, layout.weft))
    columns, rows = (grid.ravel().astype(np.float32) for grid in np.meshgrid(x, y))
    geometry, found = YarnGeometry(layout), []
    for is_back in (False, True):
        point = geometry.surface(types.Float(columns), types.Float(rows), types.Bool(is_back))
        height = types.Float(point.height)
        dr.eval(height)
        sign = -1 if is_back else 1
        heights = np.broadcast_to(height.numpy(), columns.shape).astype(np.float64)
        found.append(sign * heights.reshape(len(y), len(x)))
    return found[0], found[1]


def _centre_line(
    other: FamilyLayout, heights: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positions along a thread and heights of its centre [n], with those of splines across both sides."""
    size = float(other.spacing.sum())
    crossings = np.cumsum(other.spacing) - 0.5 * other.spacing
    count = _POINTS * len(crossings)
    # A cubic B-spline of n + 3 points has n parts; one begins at its second point.
    along = np.arange(-1, count + 2) * size / count
    knots = np.concatenate([crossings[-1:] - size, crossings, crossings[:1] + size])
    values = np.concatenate([heights[-1:], heights, heights[:1]])
    before = np.clip(np.searchsorted(knots, along % size, side="right") - 1, 0, len(knots) - 2)
    share = (along % size - knots[before]) / (knots[before + 1] - knots[before])
    blend = 0.5 - 0.5 * np.cos(math.pi * share)
    return along, values[before] + blend * (values[before + 1] - values[before])


def _sections(
    family: FamilyLayout,
    twist: float,
    thread: int,
    thickness: float,
    along: NDArray[np.float64],
    length: float,
    settings: FibreSettings,
    rng: np.random.Generator,
) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
    """Places of fibres in the yarn's section, across and up [fibres, n], and their radius, millimetres."""
    half_width, half_height = 0.5 * family.width[thread], 0.5 * min(thickness, family.width[thread])
    turns = round(length * math.tan(twist) / (2 * math.pi * half_width))
    angle = 2 * math.pi * turns * along / length
    count = settings.fibres
    radius = math.sqrt(settings.packing * half_width * half_height / (settings.plies * count))
    # Of a yarn of radius 1: one ply fills it; several touch each other and its outline.
    ply = 1.0 if settings.plies == 1 else 1 / (1 + 1 / math.sin(math.pi / settings.plies))
    seeds = np.arange(count)
    reach = ply * np.sqrt((seeds + 0.5) / count)
    across, up = [], []
    for number in range(settings.plies):
        turned = angle + 2 * math.pi * number / settings.plies
        phase = 2 * math.pi * rng.random((count, 1))
        # Whole waves of a repeat.
        waves = rng.integers(1, 4, (count, 1))
        wander = 1 + _WANDERING * np.sin(2 * math.pi * waves * along / length + phase)
        within = 2 * angle + (_GOLDEN_ANGLE * seeds + rng.random())[:, None]
        across.append((1 - ply) * np.cos(turned) + reach[:, None] * wander * np.cos(within))
        up.append((1 - ply) * np.sin(turned) + reach[:, None] * wander * np.sin(within))
    scale = 1 - radius / min(half_width, half_height)
    return (
        scale * half_width * np.concatenate(across),
        scale * half_height * np.concatenate(up),
        radius,
    )
