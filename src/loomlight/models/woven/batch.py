"""The decoder through ONNX Runtime, for numpy arrays of queries: no Dr.Jit once a fabric is encoded."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.models.woven.encoding import EncodedFabric
from loomlight.models.woven.onnx_graphs import decoder_graph
from loomlight.models.woven.places import network_places
from loomlight.models.woven.pyramid import taps
from loomlight.models.woven.weights import Weights

# Queries at once: their activations stay in the cache.
_CHUNK = 4096
_MIRROR = np.array([1, 1, -1], np.float32)


def decode(
    weights: Weights,
    encoded: EncodedFabric,
    lights: NDArray[np.float32],
    views: NDArray[np.float32],
    footprints: NDArray[np.float32],
) -> NDArray[np.float32]:
    """Components, 1/sr, and hole fraction [n, 5] of n queries.

    Args:
        lights, views: unit vectors [n, 3]; z < 0 is behind the cloth.
        footprints: position x and y and side [n, 3], in threads; see `pool.places_of`.
    """
    found = np.empty((len(lights), 5), np.float32)
    for first in range(0, len(lights), _CHUNK):
        part = slice(first, first + _CHUNK)
        found[part] = _decoded(weights, encoded, lights[part], views[part], footprints[part])
    return found


def _decoded(
    weights: Weights,
    encoded: EncodedFabric,
    lights: NDArray[np.float32],
    views: NDArray[np.float32],
    footprints: NDArray[np.float32],
) -> NDArray[np.float32]:
    behind = views[:, 2] < 0
    turn = np.where(behind[:, None], _MIRROR, np.float32(1))
    components, hole = decoder_session(weights).run(
        None,
        {
            "latent": _latents(encoded, footprints, behind),
            "place": network_places(weights.table, encoded.picks, encoded.ends, footprints),
            "light": lights * turn,
            "view": views * turn,
        },
    )
    return np.concatenate([components, hole[:, None]], axis=1)


def _latents(
    encoded: EncodedFabric, footprints: NDArray[np.float32], behind: NDArray[np.bool_]
) -> NDArray[np.float32]:
    """Interpolated latents [n, latent_size] of the faces that are seen."""
    texels = len(encoded.faces[0])
    both = encoded.both
    if texels == 1:
        return both[behind.astype(np.intp)]
    index, share = taps(encoded.levels, *footprints.T)
    index += texels * behind[:, None]
    return np.matmul(share[:, None], both[index])[:, 0]


@cache
def decoder_session(weights: Weights) -> Any:
    """ONNX Runtime's session of the decoder."""
    import onnxruntime

    return onnxruntime.InferenceSession(
        decoder_graph(weights).SerializeToString(), providers=["CPUExecutionProvider"]
    )
