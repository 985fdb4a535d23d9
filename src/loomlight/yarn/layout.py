"""Where the threads of one repeat lie, how wide they are and how they bend."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError

# Dense drafts give a thickness at or above the spacing; threads never touch closer than this share of it.
MIN_GAP = 0.005


@dataclass(frozen=True, eq=False)
class FamilyLayout:
    """The threads of one family, in thread order.

    Attributes:
        spacing: distance that each thread takes up [n], millimetres, > 0.
        width: visible width of each thread [n], millimetres; at most 0.995 of its spacing is used.
        inclination: U, the angle of a float's ends to the cloth, radians, 0 to 80°.
        twist: ψ, the angle of the fibres to the yarn, radians, −89° to 89°.
        height_scale: β, 0.01 to 2.
    """

    spacing: NDArray[np.float64]
    width: NDArray[np.float64]
    inclination: float
    twist: float
    height_scale: float

    def __post_init__(self) -> None:
        if self.spacing.shape != self.width.shape or self.spacing.ndim != 1 or self.spacing.size == 0:
            raise InputError("Each thread needs one spacing and one width.")
        _require_within("spacing (mm)", self.spacing, 1e-4, 1e4)
        _require_within("width (mm)", self.width, 1e-5, 1e5)
        _require_within("inclination (degrees)", math.degrees(self.inclination), 0, 80)
        _require_within("twist (degrees)", math.degrees(self.twist), -89, 89)
        _require_within("height_scale", self.height_scale, 0.01, 2)

    @property
    def visible_width(self) -> NDArray[np.float64]:
        """Width of each thread that is used [n], millimetres."""
        return np.minimum(self.width, (1 - MIN_GAP) * self.spacing)

    @property
    def open_share(self) -> float:
        """Share of the cloth's side that no thread of the family covers."""
        return 1 - float(self.visible_width.sum() / self.spacing.sum())


@dataclass(frozen=True, eq=False)
class ClothLayout:
    """One repeat of cloth.

    Attributes:
        warp_on_top: the drawdown, bool [picks, ends].
        warp, weft: its threads, as if all lay in one plane.
        layers: cloths that lie upon one another; none where one plane is all there is.
        stacking: which lies upon which where that changes; None where the first lies in front everywhere.
        ties: where threads of one layer rise over another, and are seen on it.
    """

    warp_on_top: NDArray[np.bool_]
    warp: FamilyLayout
    weft: FamilyLayout
    layers: tuple[Layer, ...] = ()
    stacking: Stacking | None = None
    ties: tuple[Ties, ...] = ()

    def __post_init__(self) -> None:
        expected = (self.weft.spacing.size, self.warp.spacing.size)
        if self.warp_on_top.shape != expected:
            raise InputError(f"The drawdown is {self.warp_on_top.shape}, but the threads make it {expected}.")

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the repeat, millimetres."""
        return float(self.warp.spacing.sum()), float(self.weft.spacing.sum())

    @property
    def depth(self) -> int:
        """How many layers lie upon one another where most do; 1 of cloth in one plane."""
        if self.stacking is not None:
            return int(self.stacking.ranks.max()) + 1
        return max(1, len(self.layers))

    @property
    def open_area(self) -> float:
        """Share of the plan where neither family lies: at most this goes straight through, from anywhere."""
        if self.stacking is not None:
            return min(layer.layout.open_area for layer in self.layers)
        if self.layers:
            return math.prod(layer.layout.open_area for layer in self.layers)
        return self.warp.open_share * self.weft.open_share


@dataclass(frozen=True, eq=False)
class Layer:
    """One layer of cloth that has several: threads that interlace with each other alone.

    Attributes:
        layout: of its threads alone, which lie in one plane and share the whole repeat.
        ends, picks: their numbers in the draft, ascending.
        start: where the first of their cells begins, x and y, millimetres in the draft's coordinates.
    """

    layout: ClothLayout
    ends: NDArray[np.intp]
    picks: NDArray[np.intp]
    start: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Ties:
    """Threads of one layer that rise over threads of another, the outermost of a face, and are seen there.

    Attributes:
        layer: the threads that tie and those that they cross, as a layer in which the former are on top at
            ties alone, seen from that face. Nothing but the ties is drawn of it.
        own: number of the layer whose threads tie.
        over: number of the layer that they rise over.
        is_warp: ends tie; else picks.
        back: the face is the back.
    """

    layer: Layer
    own: int
    over: int
    is_warp: bool
    back: bool

    @property
    def places(self) -> NDArray[np.bool_]:
        """Where a thread ties, among those of the layer [picks, ends]."""
        on_top = self.layer.layout.warp_on_top
        return on_top if self.is_warp != self.back else ~on_top


@dataclass(frozen=True, eq=False)
class Stacking:
    """Which layer lies upon which, where layers change places.

    Attributes:
        ranks: of each layer in each stack, 0 in front, −1 where it is none of it [stacks, layers].
        regions: the stack at each crossing of the draft, uint8 [picks, ends].
    """

    ranks: NDArray[np.int8]
    regions: NDArray[np.uint8]

    def shares(self) -> NDArray[np.float64]:
        """Share of the crossings that each stack has [stacks]."""
        return np.bincount(self.regions.ravel(), minlength=len(self.ranks)) / self.regions.size


def shared_spacing(
    spacing: NDArray[np.float64], threads: NDArray[np.intp]
) -> tuple[NDArray[np.float64], float]:
    """The room of some threads of a family where they alone fill its plane: half the way to their neighbours.

    Args:
        spacing: of all threads of the family [n], millimetres.
        threads: the numbers of some of them [k], ascending.

    Returns:
        spacing [k] of these, and where the room of the first begins, millimetres.
    """
    centres = (np.cumsum(spacing) - spacing / 2)[threads]
    before = np.concatenate([[centres[-1] - spacing.sum()], centres[:-1]])
    lower = (before + centres) / 2
    return np.diff(lower, append=lower[0] + spacing.sum()), float(lower[0])


def _require_within(name: str, value: NDArray[np.float64] | float, low: float, high: float) -> None:
    values = np.atleast_1d(np.asarray(value, dtype=np.float64))
    bad = ~(
        (values >= low * (1 - 1e-9)) & (values <= high * (1 + 1e-9)) | ((values >= low) & (values <= high))
    )
    if bad.any():
        raise InputError(f"{name} = {values[bad][0]:g} is outside {low:g} to {high:g}.")


# ----------------------------------------------------------------------------------------- the primitive cell
# The primitive translation cell of a cloth: the smallest pair of shifts under which its structure is
# itself.
#
# The structure is the drawdown with the spacing and the width of each thread; colours are no part of it.
# Satin 8/3 repeats after 8 ends and 8 picks, and its cell has 8 crossings: one end and three picks on, it
# is itself.


def primitive_cell(layout: ClothLayout) -> NDArray[np.float64]:
    """The shortest two shifts that span the cell: [2, 2], a row each, x and y, millimetres."""
    picks, ends = layout.warp_on_top.shape
    shifts = primitive_shifts(layout) * (np.asarray(layout.size) / (ends, picks))
    while True:  # Lagrange's reduction. Shifts of equal length must not take turns for ever.
        first, second = sorted(shifts, key=lambda shift: float(shift @ shift))
        shorter = second - np.round(first @ second / (first @ first)) * first
        if shorter @ shorter >= (1 - 1e-9) * (second @ second):
            return np.array([first, second])
        shifts = np.array([first, shorter])


def primitive_shifts(layout: ClothLayout) -> NDArray[np.int64]:
    """Two shifts [2, 2], a row each, ends and picks, that span all shifts that leave the structure alone."""
    threads = (np.stack([family.spacing, family.width], axis=1) for family in (layout.warp, layout.weft))
    ends, picks = (next(n for n in _multiples(len(rows), 1) if _is_period(rows, n)) for rows in threads)
    drawdown = layout.warp_on_top
    height = next(n for n in _multiples(len(drawdown), picks) if _is_period(drawdown, n))
    drawdown = drawdown[:height]
    width = drawdown.shape[1]
    # One with a long period of its own.
    columns = [column.tobytes() for column in drawdown.T[:64]]
    rarest = max(range(len(columns)), key=lambda number: (columns[number] * 2).find(columns[number], 1))
    for shift in _multiples(width, ends):
        there = drawdown[:, (rarest + shift) % width].tobytes() * 2
        up = there.find(columns[rarest])
        while 0 <= up < height:
            if up % picks == 0 and _is_period(drawdown, up, shift):
                return np.array([[shift, up], [0, height]])
            up = there.find(columns[rarest], up + 1)
    raise AssertionError("A repeat shifted by itself is itself.")


def _is_period(rows: NDArray[Any], shift: int, columns: int = 0) -> bool:
    """Whether a table that repeats is itself after a shift; a few rows say no at once."""
    every = np.arange(len(rows))
    few = every[:: max(1, len(rows) // 4)]
    return all(np.array_equal(np.roll(rows[part - shift], columns, 1), rows[part]) for part in (few, every))


def _multiples(whole: int, unit: int) -> list[int]:
    """Divisors of `whole` that are multiples of `unit`, which divides it, ascending."""
    return [number for number in range(unit, whole + 1, unit) if whole % number == 0]
