"""Lanes that wait until there are enough of them for all lanes of a vector."""

from __future__ import annotations

from typing import Any

from llvmlite import ir

from loomlight.core.lane_code import Code
from loomlight.core.lane_values import INDEX, TRUTH, WHOLE, Lanes, leaves_of, with_leaves


class Pile:
    """Lanes put aside with what belongs to each, on the stack: the last come first, without gaps.

    What belongs to them is a tree of lanes, of the same kinds each time.
    """

    def __init__(self, code: Code, like: Any, room: int) -> None:
        """For trees like one, of which there are never more than so many at once."""
        self._code, self._like = code, like
        self._kinds = [code.as_lanes(leaf).kind for leaf in leaves_of(like)]
        # What is true is kept as bits of one number. Whole vectors are read, though some of their lanes are
        # not on the pile.
        self._truths = self._kinds.count(TRUTH)
        rows = len(self._kinds) - self._truths + (self._truths > 0)
        self._rows = [code.stack(room + code.vectors.lanes) for _ in range(rows)]
        self._height = code.variable(INDEX)

    def clear(self) -> None:
        """Takes all away."""
        self._code.builder.store(INDEX(0), self._height)

    def is_left(self) -> ir.Value:
        """Whether there is any."""
        return self._code.builder.icmp_signed(">", self._code.builder.load(self._height), INDEX(0))

    def put(self, tree: Any, chosen: Lanes) -> None:
        """Puts chosen lanes on top."""
        code, height = self._code, self._code.builder.load(self._height)
        for leaf, row in zip(self._packed(tree), self._rows, strict=True):
            code.compress(leaf, chosen, code.element(row, height))
        code.builder.store(code.builder.add(height, code.count_of(chosen)), self._height)

    def take(self) -> tuple[Any, Lanes]:
        """Takes the topmost lanes, at most a vector of them, and tells which there are."""
        code, lanes = self._code, INDEX(self._code.vectors.lanes)
        height = code.builder.load(self._height)
        below = code.builder.sub(height, lanes)
        enough = code.builder.icmp_signed(">", below, INDEX(0))
        first = code.builder.select(enough, below, INDEX(0))
        code.builder.store(first, self._height)
        found = [code.load(code.element(row, first), align=4) for row in self._rows]
        there = code.numbered(first) < code.in_all_lanes(height)
        return self._unpacked(found), there

    def _packed(self, tree: Any) -> list[Lanes]:
        code = self._code
        leaves = [code.as_lanes(leaf, kind) for leaf, kind in zip(leaves_of(tree), self._kinds, strict=True)]
        packed = [code.as_floats(leaf) for leaf in leaves if leaf.kind != TRUTH]
        bits: Any = 0
        for number, leaf in enumerate(leaf for leaf in leaves if leaf.kind == TRUTH):
            bits = code.select(leaf, code.converted(1 << number, WHOLE), 0) | bits
        return [*packed, code.as_floats(bits)] if self._truths else packed

    def _unpacked(self, rows: list[Lanes]) -> Any:
        code, numbers, truths, leaves = self._code, iter(rows), 0, []
        for kind in self._kinds:
            if kind == TRUTH:
                leaves.append((code.as_kind(rows[-1], WHOLE) & (1 << truths)) > 0)
                truths += 1
            else:
                leaves.append(code.as_kind(next(numbers), kind))
        return with_leaves(self._like, iter(leaves))
