"""Sums that code of `lane_code` adds up group by group, over vectors and then over lanes."""

from __future__ import annotations

from llvmlite import ir

from loomlight.core.lane_code import Code
from loomlight.core.lane_values import INDEX, Lanes


class LaneSums:
    """So many sums of each group, on the stack; a group is an index, or a number of Python's."""

    def __init__(self, code: Code, groups: int, count: int) -> None:
        self._code, self._count = code, count
        self._first = code.stack(groups * count * code.vectors.lanes)

    def clear(self, groups: ir.Value | int) -> None:
        """Begins anew for so many groups, one or more."""
        with self._code.loop(groups) as group:
            for place in self._places(group):
                self._code.store(self._code.number(0), place)

    def add(self, group: ir.Value | int, factor: Lanes, values: list[Lanes | float]) -> None:
        """Adds products of one factor to all of a group's sums."""
        for place, value in zip(self._places(group), values, strict=True):
            self._code.store(self._code.fma(factor, value, self._code.load(place)), place)

    def totals(self, group: ir.Value | int) -> list[ir.Value]:
        """Sums over all lanes: floats."""
        return [self._code.total(self._code.load(place)) for place in self._places(group)]

    def _places(self, group: ir.Value | int) -> list[ir.Value]:
        code, lanes = self._code, self._code.vectors.lanes
        index = group if isinstance(group, ir.Value) else INDEX(group)
        first = code.element(self._first, code.times(index, self._count * lanes))
        return [code.element(first, number * lanes) for number in range(self._count)]
