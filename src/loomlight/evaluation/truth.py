"""The truth of the query benchmark: slices on the reference plane, searched finely and cached on disk.

The grid has 64 rays a thread (32 for repeats beyond 16 threads), so that its own error is 1 % of the mean
below a quarter yarn and 0.15 % above (docs/research/aggregation.md).
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError
from safetensors.numpy import load_file, save_file

from loomlight.aggregate.components import CHANNELS, COLOURS, LIGHT_VISIBILITY
from loomlight.aggregate.queries import QuerySet, admits_transmission, fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.core.errors import InputError
from loomlight.core.files import cache_folder, replacing
from loomlight.core.llvm import llvm_float
from loomlight.fabric.fabric import Fabric
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.rays import REFERENCE_QUALITY

PAIRS, FOOTPRINTS = 160, 160
# Part of every key: to be raised when geometry, scattering, slices or query sets change their values.
_VERSION = 3
_FINE, _COARSE = 64, 32
_MAX_FINE_REPEAT = 16 * 16
_TRUTHS = (*CHANNELS, *COLOURS, LIGHT_VISIBILITY)
_QUERIES = ("lights", "views", "pairs", "centres", "sizes")


def query_truth(
    fabric: Fabric,
    seed: int,
    pairs: int = PAIRS,
    footprints: int = FOOTPRINTS,
    with_colours: bool = False,
    folder: str | os.PathLike[str] | None = None,
    float_type: type | None = None,
) -> tuple[QuerySet, NDArray[np.float32]]:
    """Queries of a fabric and the exact means of its channels over them [pairs, footprints, 5].

    Lights and views lie on both sides; if the fabric's threads transmit light, half of the pairs are of
    different sides (transmission), else none.

    Args:
        seed: of the queries.
        with_colours: adds red, green and blue with the threads' own albedos, and the light visibility, which
            scales sheen: [pairs, footprints, 9].
        folder: of cached results; None is the user's cache.
        float_type: the Dr.Jit Float type to compute with; None is LLVM's.

    Returns:
        the queries, and means in the order of `CHANNELS`: components in 1/sr, `hole` as a fraction.

    Raises:
        InputError: no pairs or footprints, or a repeat too large for one slice (128 by 128 threads).
    """
    root = Path(cache_folder("truth") if folder is None else folder)
    file = root / f"{_key(fabric, seed, pairs, footprints)}.safetensors"
    cached = _read(file, (pairs, footprints, len(_TRUTHS)))
    if cached is None:
        cached = _compute(fabric, seed, pairs, footprints, float_type or llvm_float())
        _write(file, *cached)
    queries, means = cached
    return queries, means if with_colours else means[..., : len(CHANNELS)]


def reference_model(fabric: Fabric) -> YarnScattering:
    """The point model of a fabric with the search quality of the truth."""
    return YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance(), REFERENCE_QUALITY)


def texels_per_thread(fabric: Fabric) -> int:
    """Rays a thread of the truth's grid."""
    return _FINE if fabric.draft.drawdown.size <= _MAX_FINE_REPEAT else _COARSE


def _compute(
    fabric: Fabric, seed: int, pairs: int, footprints: int, float_type: type
) -> tuple[QuerySet, NDArray[np.float32]]:
    transmits = admits_transmission(fabric.appearance())
    queries = query_set(fabric_scale(fabric.layout()), pairs, footprints, seed, transmits=transmits)
    slices = FabricSlices(
        reference_model(fabric),
        float_type,
        texels_per_thread(fabric),
        with_colours=True,
        with_light_visibility=True,
    )
    means = slices.box_means(queries.lights, queries.views, queries.pairs, queries.centres, queries.boxes)
    return queries, means


def _key(fabric: Fabric, seed: int, pairs: int, footprints: int) -> str:
    """A hash of everything that the truth depends on: numbers, not names."""
    digest = hashlib.sha256(repr((_VERSION, seed, pairs, footprints)).encode())
    digest.update(repr(texels_per_thread(fabric)).encode())
    for part in _numbers(fabric):
        digest.update(repr(part.shape).encode() + part.tobytes())
    return digest.hexdigest()[:32]


def _numbers(fabric: Fabric) -> Iterator[NDArray[np.float64]]:
    layout, appearance = fabric.layout(), fabric.appearance()
    yield np.asarray(layout.warp_on_top, np.float64)
    yield np.array([appearance.diffuse_blend, appearance.optical_depth])
    for family in (layout.warp, layout.weft):
        for name in ("spacing", "width", "inclination", "twist", "height_scale"):
            yield np.asarray(getattr(family, name), np.float64)
    for scattering in (appearance.warp, appearance.weft):
        for name in ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit"):
            yield np.asarray(getattr(scattering, name), np.float64)
        yield np.array([scattering.roughness])
    yield np.array([appearance.openness is not None], np.float64)


def _read(file: Path, shape: tuple[int, int, int]) -> tuple[QuerySet, NDArray[np.float32]] | None:
    """The queries and means in a file; None if it does not exist or is damaged."""
    try:
        tensors = load_file(file)
        queries = QuerySet(*(tensors[name] for name in _QUERIES))
        means = tensors["means"]
    except (OSError, SafetensorError, KeyError):
        return None
    return (queries, means) if means.shape == shape else None


def _write(file: Path, queries: QuerySet, means: NDArray[np.float32]) -> None:
    """Writes the file; ignores errors, which cost time on the next run."""
    tensors = {name: np.ascontiguousarray(getattr(queries, name)) for name in _QUERIES}
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        with replacing(file) as temporary:
            save_file({**tensors, "means": means}, temporary)
    except (OSError, InputError, SafetensorError):
        return
