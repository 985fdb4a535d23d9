"""Tables over directions: nodes on the hemisphere, and bilinear interpolation between them.

Azimuths are uniform; rings are uniform in (1 − cos θ)^¾, from the zenith to nearly grazing: visibility falls
with tan θ near the zenith, where uniform steps of cos θ are too wide, and fast near the horizon, where
uniform steps of θ are. Pictures of satins need the azimuths.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import UInt, Vec3
from loomlight.core.backend import array_types, clip, minimum
from loomlight.models.lobes.packed_uint8 import PackedWeights

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
