"""Functions of a direction as tables: nodes over the hemisphere, interpolated between.

Azimuths are even; rings are even in (1 − cos θ)^¾, from the zenith to nearly grazing: what is seen and lit
falls with tan θ near the zenith, where even steps of cos θ are too wide, and fast near the horizon, where
even steps of θ are. Twice as many nodes along both make estimates 5 % better.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import DRJIT, array_types
from loomlight.models.lobes.bytes import ByteWeights

AZIMUTHS, RINGS = 16, 8
NODES = AZIMUTHS * RINGS
# cos θ of the last ring: below, a ray through the cloth's plane meets crests alone.
LOWEST = 0.03


@cache
def node_directions() -> NDArray[np.float64]:
    """Unit vectors of all nodes [NODES, 3], azimuth by azimuth, z > 0: not to be written to."""
    azimuth = np.repeat(np.arange(AZIMUTHS) * (2 * math.pi / AZIMUTHS), RINGS)
    z = np.tile(1 - (1 - LOWEST) * (np.arange(RINGS) / (RINGS - 1)) ** (4 / 3), AZIMUTHS)
    radius = np.sqrt(1 - z * z)
    directions = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)
    directions.flags.writeable = False
    return directions


@dataclass
class NodeTaps:
    """The four nodes around a direction.

    Attributes:
        nodes: their numbers, UInt32 each.
        weights: their shares.
    """

    nodes: tuple[Any, ...]
    weights: ByteWeights


def node_taps(direction: Any) -> NodeTaps:
    """The nodes that a direction [3] lies between, by azimuth and by |z|."""
    types = array_types(direction.x)
    whole, inner, weights = around(direction, DRJIT)
    # Conversion to unsigned numbers needs positive ones; 16 azimuths are a mask.
    column = types.UInt32(types.Int32(whole) + AZIMUTHS) & (AZIMUTHS - 1)
    following = (column + 1) & (AZIMUTHS - 1)
    ring = types.UInt32(inner)
    first, second = column * RINGS + ring, following * RINGS + ring
    return NodeTaps((first, first + 1, second, second + 1), ByteWeights(types, weights))


def around(direction: Any, arrays: Any) -> tuple[Any, Any, tuple[Any, ...]]:
    """Where a direction [3] lies among the nodes.

    Args:
        arrays: `backend.DRJIT`, or a `Code` that is being written.

    Returns:
        the azimuth before it, −8 to 8, and the ring within it, as whole Floats; weights of that azimuth's
        inner and outer node, and of the next one's.
    """
    turns = arrays.atan2(direction.y, direction.x) * (0.5 * AZIMUTHS / math.pi)
    whole = arrays.floor(turns)
    share = turns - whole
    root = arrays.sqrt(arrays.clip((1 - arrays.abs(direction.z)) * (1 / (1 - LOWEST)), 0, 1))
    ring = (RINGS - 1) * root * arrays.sqrt(root)
    inner = arrays.minimum(arrays.floor(ring), RINGS - 2)
    out = ring - inner
    weights = (1 - share) * (1 - out), (1 - share) * out, share * (1 - out), share * out
    return whole, inner, weights
