"""The decoder for numpy arrays of queries: no Dr.Jit once a fabric is encoded."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from loomlight.models.woven.compiled import FabricNumbers, compiled_decoder
from loomlight.models.woven.encoding import EncodedFabric
from loomlight.models.woven.latents import LatentRows
from loomlight.models.woven.weights import Weights

# Fabrics whose latents are kept as they are fetched.
_KEPT = 2


def decode(
    weights: Weights,
    encoded: EncodedFabric,
    lights: NDArray[np.float32],
    views: NDArray[np.float32],
    footprints: NDArray[np.float32],
) -> NDArray[np.float32]:
    """Components, 1/sr, and hole fraction [n, 5] of n queries, on all cores.

    Args:
        lights, views: unit vectors [n, 3]; z < 0 is behind the cloth.
        footprints: position x and y and side [n, 3], in threads; see `pool.places_of`.
    """
    light, view, footprint = (columns(rows) for rows in (lights, views, footprints))
    back = view[2] < 0
    turn = np.where(back, np.float32(-1), np.float32(1))
    light[2] *= turn
    view[2] *= turn
    found = np.empty((5, len(lights)), np.float32)
    numbers = fabric_numbers(weights, encoded)
    queries = [*one_square(footprint), *view, back.astype(np.float32), *light]
    compiled_decoder(weights).run("answers", numbers, queries, [*found])
    return found.T


def one_square(footprints: NDArray[np.float32]) -> list[NDArray[np.float32]]:
    """The numbers of `AnisotropicTaps` of footprints [3, n], position x and y and side."""
    still = np.zeros(footprints.shape[1], np.float32)
    return [*footprints, still, still]


def columns(rows: NDArray[np.floating]) -> NDArray[np.float32]:
    """Rows [n, k] as arrays of their own [k, n]."""
    return rows.T.astype(np.float32, order="C")


@lru_cache(_KEPT)
def fabric_numbers(weights: Weights, encoded: EncodedFabric) -> FabricNumbers:
    """What machine code reads of a fabric."""
    return FabricNumbers(weights, encoded, LatentRows.of(weights, encoded))
