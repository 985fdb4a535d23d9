"""What rays met, added up by group, as code of `lane_code`: a block is the rays of one face and node.

Of every ray it is given which family was met (1 the warp, 0 the weft, −1 neither), the normal and the fibre
direction; `lit_code` also whether light reaches the point. A group is the nearest of its family, as
`GroupFinder` says. What is answered are rows of numbers, one for each group.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from llvmlite import ir

from loomlight.core.lane_code import Code, Vectors
from loomlight.core.lane_values import INDEX, Lanes
from loomlight.models.lobes.groups import NORMAL_SHARE, SUMS, sums_of
from loomlight.models.lobes.hemisphere import NODES
from loomlight.models.lobes.lane_sums import LaneSums

ROW = 16
# Sums of plan points: how many there are; how many of them light from the side seen reaches, and light from
# the other; π times the diffuse terms of either.
LIT_SUMS = 5
_FAMILY, _NORMAL, _TANGENT, _FREE = 0, 1, 4, 7
SEEN_QUERY, LIT_QUERY = 7, 8
# A row of what all rays share about each group: its centre, and 1 where it is of the warp. Of a node: its
# direction. Numbers: how many groups a face has, and w.
CENTRE, DIRECTION = 8, 4
_IS_WARP = 6
_GROUPS, _DIRECTIONS, _NUMBERS = range(3)
_FAR = 1e30


def seen_code(rays: int, wide: Vectors) -> Code:
    """Adds up what so many views of each node and face meet: what `sums_of` says."""
    code = Code(f"seen_{rays}", _of_rays(rays, wide))
    sorter = _Sorter(code, rays, SEEN_QUERY, SUMS)
    with code.blocks():
        sorter.write(lambda: sums_of(sorter.normal(), sorter.fibre_direction()))
    return code


def lit_code(rays: int, wide: Vectors) -> Code:
    """Adds up the light that so many plan points of each node and face get."""
    code = Code(f"lit_{rays}", _of_rays(rays, wide))
    sorter = _Sorter(code, rays, LIT_QUERY, LIT_SUMS)
    with code.blocks():
        sorter.write(sorter.light)
    return code


def _of_rays(rays: int, wide: Vectors) -> Vectors:
    return replace(wide, of_block=rays // wide.lanes)


class _Sorter:
    """Writes what adds up the rays of one block."""

    def __init__(self, code: Code, rays: int, query: int, sums: int) -> None:
        """For so many rays of a block, numbers of a ray, and sums of a group."""
        self._code, self._rays, self._rows = code, rays, query
        self._group = code.rows(1)
        self._values = code.rows(sums - 1)
        self._sums = LaneSums(code, 1, sums)
        self._shared = query + 1

    def write(self, values: Callable[[], list[Lanes]]) -> None:
        """Adds up ones, and values of the vector at hand."""
        code = self._code
        count, sums = code.whole(code.builder.load(self._number(0))), self._sums
        with code.each_vector():
            self._find_group(count)
            found = values()
            for number, value in enumerate(found):
                self._values[number] = value
        with code.loop(count) as group:
            sums.clear(1)
            # All sums of one group are held in registers.
            with code.each_vector():
                here = code.select(self._group[0] == code.counted(group), code.number(1), 0)
                sums.add(0, here, [1.0, *(self._values[number] for number in range(len(found)))])
            row = code.element(code.queries(self._rows), code.times(group, ROW))
            for number, total in enumerate(sums.totals(0)):
                code.builder.store(total, code.element(row, number))

    def normal(self) -> list[Lanes]:
        """Of what the rays of the vector at hand met."""
        return [self._code.given(_NORMAL + axis) for axis in range(3)]

    def fibre_direction(self) -> list[Lanes]:
        """Of what the rays of the vector at hand met."""
        return [self._code.given(_TANGENT + axis) for axis in range(3)]

    def light(self) -> list[Lanes]:
        """See `LIT_SUMS`."""
        code = self._code
        normal_x, normal_y, normal_z = self.normal()
        node, blend = self._direction(), code.shared(self._number(1), 0)
        x, y, z = (code.shared(node, axis) for axis in range(3))
        # The other side's light comes from below: its cosine with the normal is that of (x, y, −z), negated.
        # It falls on the other face, whose rays start at the same places.
        across = code.fma(normal_x, x, normal_y * y)
        cosines = code.fma(normal_z, z, across), code.fma(normal_z, z, -across)
        reaches = code.given(_FREE), code.load(self._free_behind(), align=4)
        terms = (
            free * code.fma(blend, code.maximum(cosine, 0) - z, z)
            for free, cosine in zip(reaches, cosines, strict=True)
        )
        return [*reaches, *terms]

    def _find_group(self, count: ir.Value) -> None:
        """The nearest group of the family that was met: a float, −1 where none was."""
        code, builder = self._code, self._code.builder
        family = code.given(_FAMILY)
        features = [*(NORMAL_SHARE * part for part in self.normal()), *self.fibre_direction()]
        least, best = (code.stack(code.vectors.lanes) for _ in range(2))
        code.store(code.number(_FAR), least)
        code.store(code.number(-1), best)
        groups, first = code.array(self._shared + _GROUPS), builder.mul(self._face(), count)
        with code.loop(count) as group:
            centre = code.element(groups, code.times(builder.add(first, group), CENTRE))
            distance = code.number(0)
            for number, feature in enumerate(features):
                offset = feature - code.shared(centre, number)
                distance = code.fma(offset, offset, distance)
            nearer = (distance < code.load(least)) & (family == code.shared(centre, _IS_WARP))
            code.store(code.select(nearer, distance, code.load(least)), least)
            code.store(code.select(nearer, code.counted(group), code.load(best)), best)
        self._group[0] = code.load(best)

    def _number(self, number: int) -> ir.Value:
        return self._code.element(self._code.array(self._shared + _NUMBERS), number)

    def _face(self) -> ir.Value:
        """0 or 1: blocks of the back come last."""
        builder = self._code.builder
        behind = builder.icmp_signed(">=", self._code.first_query(), INDEX(NODES * self._rays))
        return builder.zext(behind, INDEX)

    def _direction(self) -> ir.Value:
        """Where the direction of the block's node lies."""
        code, builder = self._code, self._code.builder
        block = builder.udiv(code.first_query(), INDEX(self._rays))
        node = builder.urem(block, INDEX(NODES))
        return code.element(code.array(self._shared + _DIRECTIONS), code.times(node, DIRECTION))

    def _free_behind(self) -> ir.Value:
        """Where it lies whether light reaches the other face at the same places."""
        builder, half = self._code.builder, NODES * self._rays
        step = builder.sub(INDEX(half), builder.mul(self._face(), INDEX(2 * half)))
        return self._code.element(self._code.queries(_FREE), step)
