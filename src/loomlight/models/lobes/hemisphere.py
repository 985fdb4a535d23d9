"""Tables over directions: nodes on the hemisphere, and bilinear interpolation between them.

Azimuths are uniform; rings are uniform in (1 − cos θ)^¾, from the zenith to nearly grazing: visibility falls
with tan θ near the zenith, where uniform steps of cos θ are too wide, and fast near the horizon, where
uniform steps of θ are. Pictures of satins need the azimuths.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, minimum

# --------------------------------------------------------------------------------------------- packed uint8x4
# Packed uint8x4: the bytes of four groups in one 32-bit word, interpolated two at a time (SWAR).
#
# Weights are integers that sum to about 252. Of bytes 0 and 2 of a pack, 16 bits apart, each product with a
# weight stays below 2¹⁶, and so does the sum over all nodes: one multiplication serves two bytes. That takes
# a third of the operations of unpacking first, and errs by at most a 504th of the difference between nodes.


# Sum of all weights. Eight weights rounded up exceed it by at most 4, and 255·256 < 2¹⁶.
WEIGHT_SUM = 252
_EVEN_BYTES = 0x00FF00FF


def pack_count(per_family: int) -> int:
    """Packs of the groups of both families; each family begins with a pack of its own."""
    return 2 * -(-per_family // 4)


def byte_of_group(per_family: int) -> NDArray[np.intp]:
    """Index of each group's byte in its packs [2 K]."""
    group = np.arange(2 * per_family)
    return group % per_family + group // per_family * 4 * (pack_count(per_family) // 2)


class PackedWeights:
    """Interpolation weights of up to eight nodes, as integers."""

    def __init__(self, types: ArrayTypes, weights: Sequence[Float]) -> None:
        """Rounds weights, each ≥ 0, of sum 1."""
        self._types = types
        self._integers = [types.UInt32(dr.fma(weight, WEIGHT_SUM, 0.5)) for weight in weights]
        self._inverse_sum = dr.rcp(types.Float(sum(self._integers)))

    @property
    def shares(self) -> list[Float]:
        """The weights of the nodes as numbers of sum 1."""
        return [self._types.Float(weight) * self._inverse_sum for weight in self._integers]

    def interpolate(self, packs: Sequence[UInt]) -> list[Float]:
        """Weighted means of the four bytes of packs, one pack a node: four Floats, 0 to 255."""
        even = sum((pack & _EVEN_BYTES) * weight for pack, weight in zip(packs, self._integers, strict=True))
        odd = sum(
            ((pack >> 8) & _EVEN_BYTES) * weight for pack, weight in zip(packs, self._integers, strict=True)
        )
        return _unpack(self._types, even, odd, self._inverse_sum)


def mean_of_packs(types: ArrayTypes, packs: Sequence[UInt]) -> list[Float]:
    """Means of the four bytes of up to 256 packs: four Floats, 0 to 255."""
    even = sum(pack & _EVEN_BYTES for pack in packs)
    odd = sum((pack >> 8) & _EVEN_BYTES for pack in packs)
    return _unpack(types, even, odd, 1 / len(packs))


def _unpack(types: ArrayTypes, even: UInt, odd: UInt, scale: Float) -> list[Float]:
    """The four 16-bit sums of two 32-bit words, times a scale."""
    sums = (even & 0xFFFF, odd & 0xFFFF, even >> 16, odd >> 16)
    return [types.Float(part) * scale for part in sums]


# ------------------------------------------------------------------------------------------------- hemisphere


AZIMUTHS, RINGS = 32, 8
NODES = AZIMUTHS * RINGS
# cos θ of the last ring: more grazing rays through the plane z = 0 hit crests alone.
MIN_NODE_COSINE = 0.03


@cache
def node_directions() -> NDArray[np.float64]:
    """Unit vectors of all nodes [NODES, 3], azimuth by azimuth, z > 0; read-only."""
    azimuth = np.repeat(np.arange(AZIMUTHS) * (2 * math.pi / AZIMUTHS), RINGS)
    z = np.tile(1 - (1 - MIN_NODE_COSINE) * (np.arange(RINGS) / (RINGS - 1)) ** (4 / 3), AZIMUTHS)
    radius = np.sqrt(1 - z * z)
    directions = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)
    directions.flags.writeable = False
    return directions


@dataclass
class NodeTaps:
    """The four nodes around a direction.

    Attributes:
        nodes: their indices.
        weights: of the nodes.
    """

    nodes: tuple[UInt, ...]
    weights: PackedWeights


def node_taps(direction: Vec3, azimuths: int = AZIMUTHS) -> NodeTaps:
    """The nodes around a unit vector, by azimuth and |z|; `azimuths`, a power of two, may be fewer."""
    types = array_types(direction.x)
    turns = dr.atan2(direction.y, direction.x) * (0.5 * azimuths / math.pi)
    azimuth = dr.floor(turns)
    across = turns - azimuth
    root = dr.sqrt(clip((1 - dr.abs(direction.z)) * (1 / (1 - MIN_NODE_COSINE)), 0, 1))
    ring = (RINGS - 1) * root * dr.sqrt(root)
    inner = minimum(dr.floor(ring), RINGS - 2)
    out = ring - inner
    weights = (1 - across) * (1 - out), (1 - across) * out, across * (1 - out), across * out
    # Azimuths from −π on: conversion to unsigned integers needs positive ones; a power of two is a mask.
    column = types.UInt32(types.Int32(azimuth) + azimuths) & (azimuths - 1)
    following = (column + 1) & (azimuths - 1)
    first, second = column * RINGS + types.UInt32(inner), following * RINGS + types.UInt32(inner)
    return NodeTaps((first, first + 1, second, second + 1), PackedWeights(types, weights))
