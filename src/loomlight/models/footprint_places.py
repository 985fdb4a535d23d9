"""Places of points in footprints, stratified over the pattern's primitive cell.

What a cloth does to light repeats with its primitive cell (`yarn/layout.py`). A point c of the cell,
of area C, has n(c) translates in a footprint P, so ∫_P f dx / |P| = C/|P| ∫ n(c) f(c) dc / C. Points c spread
evenly over the cell, each moved to one of its n(c) translates and weighed by n(c)·C/|P|, estimate the mean
over the footprint without bias, whatever does not repeat (colours, chance) included, and see every part of
the pattern equally often. Footprints of few cells take points spread over themselves.

Translates are counted row by row of the cell's first shift. Footprints of more rows are cut into equal
parallelograms, of which each point takes one.
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import numpy as np

from loomlight.core.arrays import Float, UInt, Vec2
from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum
from loomlight.core.footprint import Footprint
from loomlight.models.random_numbers import uniform
from loomlight.yarn.layout import ClothLayout, primitive_cell

# Cells of the smallest footprint whose points are spread over the cell: with fewer, weights differ too much.
MIN_CELLS = 1.5
# Rows of translates that an edge of a part passes; a part has at most twice as many.
_EDGE_ROWS = 3
# An edge along the rows is turned by so many rows: a hundred-thousandth of a part is missed.
_LEAST_SLOPE = 1e-5
# Powers of the root of x⁶ = x + 1, in units of 2⁻³²: multiples fill a cube evenly (Roberts 2018). Two of its
# dimensions are the place in the cell, two the part, one the translate.
_SHARES = tuple(round(2**32 * 1.1347241384015194**-power) for power in range(1, 6))


class PrimitiveCell:
    """The primitive cell of one cloth on any backend; `shifts` are its two shifts [2, 2], millimetres."""

    def __init__(self, layout: ClothLayout) -> None:
        self.shifts = primitive_cell(layout)
        self._uploaded: dict[type, list[Any]] = {}

    def on(self, types: ArrayTypes) -> list[Any]:
        """Matrices from cells to millimetres and back, four numbers each, row by row."""
        if types.Float not in self._uploaded:
            numbers = np.stack([self.shifts.T, np.linalg.inv(self.shifts.T)]).ravel()
            self._uploaded[types.Float] = [dr.opaque(types.Float, float(number)) for number in numbers]
        return self._uploaded[types.Float]


class FootprintPlaces:
    """Points of footprints and their weights; a seed a footprint moves them."""

    def __init__(self, cell: PrimitiveCell, footprint: Footprint, seed: UInt) -> None:
        types = array_types(footprint.centre.x)
        matrices = cell.on(types)
        self._footprint, self._to_mm, to_cells = footprint, matrices[:4], matrices[4:]
        self._starts = [uniform(seed, dimension) for dimension in range(len(_SHARES))]
        edges = [_times(to_cells, edge) for edge in (footprint.duv_dx, footprint.duv_dy)]
        self.on_cell = abs(edges[0].x * edges[1].y - edges[0].y * edges[1].x) >= MIN_CELLS
        self._counts = [maximum(dr.ceil(abs(edge.y) * (1 / _EDGE_ROWS)), 1) for edge in edges]
        parts = [edge / count for edge, count in zip(edges, self._counts, strict=True)]
        self._edges = first, second = [
            types.Vector2(edge.x, dr.copysign(maximum(abs(edge.y), _LEAST_SLOPE), edge.y)) for edge in parts
        ]
        area = first.x * second.y - first.y * second.x
        self._cells = abs(area)
        self._corner = _times(to_cells, footprint.centre)
        for edge, count in zip(self._edges, self._counts, strict=True):
            self._corner -= 0.5 * count * edge
        # Of a part: where its rows begin, and the two strips between opposite edges as x of a row at y.
        self._bottom = minimum(first.y, 0) + minimum(second.y, 0)
        self._strips = [(second.x / second.y, area / second.y), (first.x / first.y, -area / first.y)]

    def at(self, number: UInt) -> tuple[Vec2, Float]:
        """Place of a point, millimetres [2], and its weight."""
        types = array_types(self._cells)
        turns = [
            start + types.Float(number * share >> 8) * 2**-24
            for start, share in zip(self._starts, _SHARES, strict=True)
        ]
        u, v, *part, translate = (turn - dr.floor(turn) for turn in turns)
        corner = self._corner
        for share, count, edge in zip(part, self._counts, self._edges, strict=True):
            corner = corner + minimum(dr.floor(share * count), count - 1) * edge
        from_corner = types.Vector2(u, v) - corner
        from_corner -= dr.floor(from_corner)
        bottom = dr.ceil(self._bottom - from_corner.y)
        rows, total = [], types.Float(0)
        for row in range(2 * _EDGE_ROWS):
            y = from_corner.y + bottom + row
            begins = [dr.fma(slope, y, minimum(width, 0)) for slope, width in self._strips]
            end = minimum(*(low + abs(width) for low, (_, width) in zip(begins, self._strips, strict=True)))
            start = dr.ceil(maximum(*begins) - from_corner.x)
            count = maximum(dr.ceil(end - from_corner.x) - start, 0)
            rows.append((start, count))
            total += count
        chosen = minimum(dr.floor(translate * total), total - 1)
        x, y = types.Float(0), types.Float(0)
        for row, (start, count) in enumerate(rows):
            here = (chosen >= 0) & (chosen < count)
            x, y = dr.select(here, start + chosen, x), dr.select(here, bottom + row, y)
            chosen -= count
        place = _times(self._to_mm, corner + from_corner + types.Vector2(x, y))
        spread = self._footprint.at(u - 0.5, v - 0.5)
        return dr.select(self.on_cell, place, spread), dr.select(self.on_cell, total / self._cells, 1)


def _times(matrix: list[Any], vector: Vec2) -> Vec2:
    a, b, c, d = matrix
    return type(vector)(a * vector.x + b * vector.y, c * vector.x + d * vector.y)
