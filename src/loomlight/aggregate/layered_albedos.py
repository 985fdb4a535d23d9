"""Mean albedos of warp and weft of layered cloth, as a view and a light show its layers (`layer_shares.py`).

Of a family, the light that reaches a view from each layer weighs that layer's albedos. Light from the other
side passes straight through yarn only where no layer lies behind it: all other light leaves the layers behind
spread evenly over all directions, and so does what they send back. That light is `behind`, which no shadow
falls on, as points have it (`YarnScattering.at`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.layer_shares import (
    BACKED,
    BARE,
    COVERED,
    LIT,
    MAX_RATE,
    NO_RATE,
    RATE_HALF,
    RATES,
    light_half,
    view_half,
)
from loomlight.core.arrays import Color3, Float, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum, upload
from loomlight.scattering.appearance import ALBEDO_NAMES
from loomlight.scattering.point import Albedos

# Numbers of a family of a layer: its rates, and six colours of what lies behind; whole halves of rates.
SEEN_NUMBERS = (2 * RATES + 1) * RATE_HALF
# Smallest weight that is divided by.
MIN_WEIGHT = 1e-9


class SeenNumbers:
    """`Seen.numbers` on one backend."""

    def __init__(self, numbers: NDArray[np.float64], types: ArrayTypes) -> None:
        """
        Args:
            numbers: [stacks, layers, 2 faces, 2 families, `SEEN_NUMBERS`].
        """
        self._types = types
        self._table = upload(types.Float, numbers.ravel().astype(np.float32))
        self.stacks, self.layers = numbers.shape[:2]

    def row(self, stack: int, layer: int, family: int, back: Mask) -> UInt:
        """Index of the first half of a family of a layer, as a face has it."""
        first = ((stack * self.layers + layer) * 4 + family) * (SEEN_NUMBERS // RATE_HALF)
        step = 2 * (SEEN_NUMBERS // RATE_HALF)
        UInt32 = self._types.UInt32
        return dr.select(back, UInt32(first + step), UInt32(first))

    def half(self, row: UInt) -> list[Float]:
        """The numbers of a half."""
        return list(dr.gather(self._types.Vectors, self._table, row, shape=(RATE_HALF, dr.width(row))))


@dataclass(frozen=True)
class Behind:
    """Albedos of the light that layers behind a family send back and let out, Color3 each; see the module."""

    reflected: Color3
    transmitted: Color3


class LayeredAlbedos:
    """Mean albedos over footprints of layered cloth for one view each."""

    def __init__(
        self,
        numbers: SeenNumbers,
        planes: Sequence[tuple[Albedos, Albedos]],
        stacks: Sequence[Float],
        view: Vec3,
        back: Mask,
        nearest: tuple[UInt, Float] | None = None,
    ) -> None:
        """
        Args:
            planes: mean albedos of warp and weft of each layer over the footprints.
            stacks: share of each stack in them.
            view: unit vector [3] in the frame of the face that is seen.
            back: that face is the back.
            nearest: number of a layer, and how far it alone counts, 0 to 1; None for 0.
        """
        self._numbers, self._planes, self._stacks = numbers, planes, stacks
        self._view, self._back, self._nearest = view, back, nearest
        self._logarithms: dict[tuple[int, int, int], list[Float]] = {}

    def of_layer(self, number: UInt, weight: Float) -> LayeredAlbedos:
        """The same where a layer alone counts, by a weight from 0 to 1: that of the point in a close-up."""
        return LayeredAlbedos(
            self._numbers, self._planes, self._stacks, self._view, self._back, (number, weight)
        )

    @cached_property
    def albedos(self) -> tuple[Albedos, Albedos]:
        """Of warp and weft, for a light along the normal from either side; layers behind let out a part."""
        found = []
        for family in (0, 1):
            lit, through, entries = self._types.Float(0), self._types.Float(0), []
            for stack, layer in self._entries:
                of_lit, bare, covered = (
                    self._weight(self._of_view(stack, layer, family)[kind], stack, layer)
                    for kind in (LIT, BARE, COVERED)
                )
                let_out = self._behind(stack, layer, family)[0]
                entries.append((layer, of_lit, bare + covered * let_out))
                lit, through = lit + of_lit, through + bare + covered
            found.append(self._sum(entries, family, lit, through))
        return found[0], found[1]

    def towards(self, light: Vec3) -> tuple[Albedos, Albedos]:
        """Of warp and weft for a light, unit vector [3] in the frame of the face that is seen.

        Reflected or transmitted ones hold, as the side of the light tells.
        """
        is_beyond, found = light.z < 0, []
        x, y, z = light.x, light.y, dr.abs(light.z)
        terms = light_half(x, y, z, _sine(light), self._view.x, self._view.y)
        UInt32 = self._types.UInt32
        for family in (0, 1):
            total, entries = self._types.Float(0), []
            for stack, layer in self._entries:
                row, of_view = (
                    self._numbers.row(stack, layer, family, self._back),
                    self._of_view(stack, layer, family),
                )
                kind = dr.select(is_beyond, UInt32(BARE), UInt32(LIT))
                rate = dr.select(is_beyond, of_view[BARE], of_view[LIT])
                own = self._weight(_added(rate, self._numbers.half(row + 2 * kind + 1), terms), stack, layer)
                rest = _added(of_view[COVERED], self._numbers.half(row + (2 * COVERED + 1)), terms)
                total += own + dr.select(is_beyond, self._weight(rest, stack, layer), 0)
                entries.append((layer, own, self._types.Color3(own)))
            found.append(self._sum(entries, family, total, total))
        return found[0], found[1]

    def behind(self, layers: Sequence[Float]) -> tuple[Behind, Behind]:
        """What layers behind the warp and the weft that show add.

        Args:
            layers: share of light that fibre layers of albedo 1 of warp and weft let through.
        """
        found = []
        for family, share in enumerate(layers):
            reflected, transmitted = (self._types.Color3(0) for _ in range(2))
            for stack, layer in self._entries:
                let_out, returned = self._behind(stack, layer, family)
                seen = self._stacks[stack] * _rate(self._of_view(stack, layer, family)[BACKED])
                own = self._planes[layer][family]
                through = own.diffuse_transmit + share * own.specular_transmit
                reflected += seen * returned
                transmitted += seen * let_out * through
            found.append(Behind(reflected, transmitted))
        return found[0], found[1]

    @property
    def _types(self) -> ArrayTypes:
        return array_types(self._view.x)

    @property
    def _entries(self) -> list[tuple[int, int]]:
        """Numbers of stacks and layers."""
        return [(s, n) for s in range(self._numbers.stacks) for n in range(self._numbers.layers)]

    def _of_view(self, stack: int, layer: int, family: int) -> list[Float]:
        """Logarithms of the rates of each kind for a light along the normal."""
        key = stack, layer, family
        if key not in self._logarithms:
            row, view = self._numbers.row(stack, layer, family, self._back), self._view
            terms = view_half(view.x, view.y, view.z, _sine(view))
            zero = self._types.Float(0)
            self._logarithms[key] = [
                _added(zero, self._numbers.half(row + 2 * kind), terms) for kind in range(RATES)
            ]
        return self._logarithms[key]

    def _behind(self, stack: int, layer: int, family: int) -> tuple[Color3, Color3]:
        """What layers behind let out and what they send back, see `Seen.behind`."""
        numbers = self._numbers.half(self._numbers.row(stack, layer, family, self._back) + 2 * RATES)
        return self._types.Color3(*numbers[:3]), self._types.Color3(*numbers[3:6])

    def _weight(self, logarithm: Float, stack: int, layer: int) -> Float:
        """Weight of a layer by the logarithm of its rate."""
        weight = self._stacks[stack] * _rate(logarithm)
        if self._nearest is None:
            return weight
        number, alone = self._nearest
        return weight * dr.select(number == layer, self._types.Float(1), 1 - alone)

    def _sum(
        self, entries: Sequence[tuple[int, Float, Color3]], family: int, lit: Float, through: Float
    ) -> Albedos:
        """Albedos of layers, weighed for reflected and for transmitted light, over the sums of weights."""
        sums = [self._types.Color3(0) for _ in ALBEDO_NAMES]
        for layer, of_lit, of_through in entries:
            own = self._planes[layer][family]
            for number, name in enumerate(ALBEDO_NAMES):
                weight = of_through if name.endswith("transmit") else of_lit
                sums[number] += weight * getattr(own, name)
        inverse = [dr.rcp(maximum(total, MIN_WEIGHT)) for total in (lit, through)]
        return Albedos(
            *(
                total * inverse[int(name.endswith("transmit"))]
                for total, name in zip(sums, ALBEDO_NAMES, strict=True)
            )
        )


def _sine(direction: Vec3) -> Float:
    return dr.sqrt(dr.fma(direction.x, direction.x, direction.y * direction.y))


def _added(total: Float, numbers: Sequence[Float], terms: Sequence[Float]) -> Float:
    """With the products of numbers and terms."""
    for number, term in zip(numbers, terms, strict=True):
        total = dr.fma(number, term, total)
    return total


def _rate(logarithm: Float) -> Float:
    return dr.exp(clip(logarithm, NO_RATE, MAX_RATE))
