"""The decoder through ONNX Runtime, for numpy arrays of queries: no Dr.Jit once a fabric is encoded."""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.models.woven.architecture import (
    DENSITY_GAIN,
    DENSITY_SCALE,
    INCLINATION_CROWDING,
    LARGEST_OUTPUT,
    OPPOSITE,
    REFLECTION_GAIN,
    TRANSMISSION_GAIN,
)
from loomlight.models.woven.encoding import EncodedFabric
from loomlight.models.woven.latents import LatentRows
from loomlight.models.woven.onnx_decoder import batch_graph
from loomlight.models.woven.places import own_share, place_of
from loomlight.models.woven.weights import Weights

# Queries of one run of the layers, whose activations stay near a core, and runs that a thread prepares
# at once, so that numpy's calls cost nothing beside their work.
QUERIES_A_RUN = 2048
_RUNS = 16
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
    count, threads = len(lights), _cores()
    found = np.empty((count, 5), np.float32)
    runs = -(-count // QUERIES_A_RUN)
    block = QUERIES_A_RUN * max(1, min(_RUNS, -(-runs // threads)))
    parts = [slice(first, first + block) for first in range(0, count, block)]

    def answer(part: slice) -> None:
        found[part] = _decoded(weights, encoded, lights[part], views[part], footprints[part])

    if len(parts) < 2:
        for part in parts:
            answer(part)
        return found
    # Each core decodes blocks of its own: threads within a layer would wait for each other after every one.
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(answer, parts))
    return found


def _decoded(
    weights: Weights,
    encoded: EncodedFabric,
    lights: NDArray[np.float32],
    views: NDArray[np.float32],
    footprints: NDArray[np.float32],
) -> NDArray[np.float32]:
    """Of one block, on one core."""
    behind = views[:, 2] < 0
    if behind.all() or not behind.any():
        return _decoded_face(weights, encoded, lights, views, footprints, bool(behind.all()))
    found = np.empty((len(lights), 5), np.float32)
    for back in (False, True):
        seen = behind == back
        found[seen] = _decoded_face(weights, encoded, lights[seen], views[seen], footprints[seen], back)
    return found


def _decoded_face(
    weights: Weights,
    encoded: EncodedFabric,
    lights: NDArray[np.float32],
    views: NDArray[np.float32],
    footprints: NDArray[np.float32],
    back: bool,
) -> NDArray[np.float32]:
    """Of queries that see one face, one at least."""
    count = len(lights)
    light, view, (x, y, size) = (_columns(rows) for rows in (lights, views, footprints))
    turn = np.float32(-1 if back else 1)
    light[2] *= turn
    view[2] *= turn
    table = weights.table
    fetched = latent_rows(weights, encoded).at(x, y, size, np.full(len(x), back))
    place: Sequence[NDArray[np.float32]] = place_of(table, encoded.picks, encoded.ends, x, y, size)
    coded_size = place[2]
    if table.position == "one_blob":
        place = _with_squares([part - np.float32(0.5) for part in place])
    angles = [*light, *view[:2]]
    inputs = {
        "fetched": fetched.reshape(-1, 1, 1, QUERIES_A_RUN, fetched.shape[1]),
        "place": _by_runs(place),
    }
    if table.fibres:
        cosines, inclinations, densities = _along_fibres(encoded.fibres.face(back), light, view)
        angles += [*cosines, *densities]
        inputs["inclinations"] = _by_runs(_with_squares(inclinations))
    inputs["angles"] = _by_runs(angles)
    if table.bundles:
        inputs["half"] = _half_vectors(light, view)
    same = _bundles(encoded, back) if table.bundles else {}
    if encoded.correction is not None:
        same["correction"] = encoded.correction
        inputs["own"] = (own_share(coded_size) * (light[2] > 0)).reshape(-1, 1, QUERIES_A_RUN)
    session = decoder_session(weights, encoded.correction is not None)
    found = np.empty((5, len(x)), np.float32)
    for run in range(len(x) // QUERIES_A_RUN):
        part = slice(run * QUERIES_A_RUN, (run + 1) * QUERIES_A_RUN)
        output, share = session.run(None, {name: values[run] for name, values in inputs.items()} | same)
        found[:4, part], found[4, part] = output[0, :, 0], share[0, 0, 0]
    _unmap(found, light[2], weights)
    return found.T[:count]


def _half_vectors(light: NDArray[np.float32], view: NDArray[np.float32]) -> NDArray[np.float32]:
    """Half vectors of directions [3, m], a little short where these are nearly opposite [runs, 3, n]."""
    total = light + view
    total /= np.sqrt(np.einsum("cn,cn->n", total, total) + np.float32(OPPOSITE))
    return np.stack([part.reshape(-1, QUERIES_A_RUN) for part in total], axis=1)


def _bundles(encoded: EncodedFabric, back: bool) -> dict[str, NDArray[np.float32]]:
    """Bundles of a face as the session takes them."""
    rows = encoded.fibres.bundles(back).reshape(-1, 4)
    return {
        "axes": np.ascontiguousarray(rows[:, :3]),
        "widths": rows[:, 3].reshape(1, -1, 1, 1).copy(),
    }


def _columns(rows: NDArray[np.float32]) -> NDArray[np.float32]:
    """Rows [n, 3] as [3, m], where m is n made a whole number of runs by repeating the last."""
    count = len(rows)
    columns = np.empty((3, -(-count // QUERIES_A_RUN) * QUERIES_A_RUN), np.float32)
    columns[:, :count] = rows.T
    columns[:, count:] = rows[-1][:, None]
    return columns


def _by_runs(numbers: Sequence[NDArray[np.float32]]) -> NDArray[np.float32]:
    """Numbers of all queries [c][m] as the layers take them [runs, 1, c, 1, QUERIES_A_RUN]."""
    return np.stack([part.reshape(-1, 1, 1, QUERIES_A_RUN) for part in numbers], axis=2)


def _with_squares(numbers: Sequence[NDArray[np.float32]]) -> list[NDArray[np.float32]]:
    return [*numbers, *(part * part for part in numbers)]


def _along_fibres(
    fibres: NDArray[np.float32], light: NDArray[np.float32], view: NDArray[np.float32]
) -> tuple[list[NDArray[np.float32]], list[NDArray[np.float32]], list[NDArray[np.float32]]]:
    """Cosines of views, then of lights [4][n], inclinations [2][n], densities [2][n]; see
    `network.fibre_features`.

    Args:
        fibres: of the face that is seen; see `Fibres.face`.
        light, view: in the frame of that face [3, n].
    """
    total = light + view
    height = total[2] * total[2] + np.float32(OPPOSITE)
    inverse_square = 1 / (total[0] * total[0] + total[1] * total[1] + height)
    of_views, of_lights, inclinations, densities = [], [], [], []
    for x, y, roughness in fibres:
        of_view, of_light = (x * part[0] + y * part[1] for part in (view, light))
        cosine = of_view + of_light
        square = cosine * cosine
        reach = np.sqrt(square + height)
        reach *= np.float32(INCLINATION_CROWDING)
        reach += np.abs(cosine)
        cosine *= np.float32(1 + INCLINATION_CROWDING)
        squared = roughness * roughness
        square *= inverse_square
        square *= 1 - squared
        square += squared
        density = np.float32(DENSITY_GAIN / np.pi) * squared * roughness / (square * square)
        density += 1
        of_views.append(of_view)
        of_lights.append(of_light)
        inclinations.append(cosine / reach)
        densities.append(np.float32(DENSITY_SCALE) * np.log(density))
    return [*of_views, *of_lights], inclinations, densities


def _unmap(found: NDArray[np.float32], height: NDArray[np.float32], weights: Weights) -> None:
    """Makes components [4, n] and the hole fraction of what the network puts out: `losses.unmapped`."""
    gain = np.where(height > 0, np.float32(REFLECTION_GAIN), np.float32(TRANSMISSION_GAIN))
    mixed = weights.table.bundles
    mapped = found[2 if weights.linear_diffuse else 0 : 2 if mixed else 4]
    mapped[:] = np.expm1(np.clip(mapped, 0, LARGEST_OUTPUT)) / gain
    if weights.linear_diffuse:
        np.maximum(found[:2], 0, out=found[:2])
    if mixed:
        np.clip(found[2:4], 0, np.float32(np.expm1(LARGEST_OUTPUT)) / gain, out=found[2:4])
    np.clip(found[4], 0, 1, out=found[4])


@lru_cache(_KEPT)
def latent_rows(weights: Weights, encoded: EncodedFabric) -> LatentRows:
    """A fabric's latents as they are fetched."""
    return LatentRows(weights, encoded)


@cache
def decoder_session(weights: Weights, corrected: bool = False) -> Any:
    """ONNX Runtime's session of the decoder of `QUERIES_A_RUN` queries, on the thread that calls it."""
    import onnxruntime

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    # With a number of queries that is known, layers keep their blocks of channels.
    options.add_free_dimension_override_by_name("n", QUERIES_A_RUN)
    return onnxruntime.InferenceSession(
        batch_graph(weights, corrected).SerializeToString(), options, providers=["CPUExecutionProvider"]
    )


def _cores() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
