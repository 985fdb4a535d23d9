"""How a fabric is encoded: the encoder, the cache of latents, and fine-tuning of the last layer."""

from __future__ import annotations

import hashlib
import math
from collections import OrderedDict
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError
from safetensors.numpy import load_file, save_file
from threadpoolctl import threadpool_limits

from loomlight.aggregate.queries import fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.core.errors import InputError, LoomlightError
from loomlight.core.extras import import_extra
from loomlight.core.files import cache_folder, replacing
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.architecture import (
    BUNDLE_UNIT,
    BUNDLES,
    FIELD_MAP,
    LEAKY_SLOPE,
    MAX_THREADS,
    OPPOSITE,
    VECTOR_MAP,
)
from loomlight.models.neural.decoder import columns, compiled_decoder, kernel_table, one_square
from loomlight.models.neural.encoded_fabric import (
    EncodedFabric,
    Fibres,
    footprints_in_threads,
    sizes_of,
)
from loomlight.models.neural.face_maps import face_maps
from loomlight.models.neural.weights import Weights, trained_ranges, warn_outside_ranges
from loomlight.scattering.point import YarnScattering
from loomlight.sources.loom_file import LoomFile
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout

# ---------------------------------------------------------------------------------------------------- encoder
# The encoder through ONNX Runtime: maps and parameters of a fabric in, latents of both faces out.
#
# torch exported its graph when the network was trained (`training/export.py`); it lies beside the weights.


def run_encoder(
    fabric: Fabric, weights: Weights, float_type: type, repeats: tuple[int, int] = (1, 1)
) -> EncodedFabric:
    """Latents of both faces, each of one run of the encoder.

    Args:
        float_type: the Dr.Jit Float type that the maps are computed with.
        repeats: repetitions of the repeat along picks and along ends.
    """
    layout = shortest_repeat(fabric.layout())
    picks, ends = layout.warp_on_top.shape
    geometry = YarnGeometry(layout)
    field = weights.table.latent == "field"
    rows, columns = (FIELD_MAP * picks, FIELD_MAP * ends) if field else (VECTOR_MAP, VECTOR_MAP)
    parameters = fabric_parameters(fabric)
    faces = []
    for back in (False, True):
        maps = face_maps(geometry, back, rows, columns, float_type)
        if field:
            maps = np.tile(maps, (1, *repeats))
        (latents,) = encoder_session(weights).run(None, {"maps": maps[None], "parameters": parameters})
        faces.append(latents.astype(np.float16))
    shape = picks * repeats[0], ends * repeats[1]
    return EncodedFabric.of(shape, (faces[0], faces[1]), Fibres.of(fabric))


@cache
def encoder_session(weights: Weights) -> Any:
    """ONNX Runtime's session of the encoder.

    Inputs are `maps` [1, 7, rows, columns] of one face and `parameters` [4], the output is `latents`
    [texels, latent_size] in the order of `levels_of` ("field"), or [1, latent_size] ("vector").
    """
    # Slow to import, and not needed if latents are cached.
    onnxruntime = import_extra("onnxruntime", "neural", "Encoding a fabric for the network")
    options = onnxruntime.SessionOptions()
    options.log_severity_level = 3
    try:
        return onnxruntime.InferenceSession(weights.encoder, options, providers=["CPUExecutionProvider"])
    # The exceptions of ONNX Runtime on unreadable models have no public base.
    except Exception as error:
        raise InputError(f"{weights.source}: ONNX Runtime cannot read the encoder beside it.") from error


def fabric_parameters(fabric: Fabric) -> NDArray[np.float32]:
    """α of warp and weft, β of warp and weft [4]."""
    layout, appearance = fabric.layout(), fabric.appearance()
    return np.array(
        [
            appearance.warp.roughness,
            appearance.weft.roughness,
            layout.warp.height_scale,
            layout.weft.height_scale,
        ],
        np.float32,
    )


def shortest_repeat(layout: ClothLayout) -> ClothLayout:
    """The layout of one repeat of the weave, which stripes of colours may have made longer."""
    drawdown = layout.warp_on_top
    picks = _period(layout.weft, lambda step: bool((np.roll(drawdown, step, 0) == drawdown).all()))
    ends = _period(layout.warp, lambda step: bool((np.roll(drawdown, step, 1) == drawdown).all()))
    return ClothLayout(drawdown[:picks, :ends], _first(layout.warp, ends), _first(layout.weft, picks))


def _period(family: FamilyLayout, repeats: Callable[[int], bool]) -> int:
    count = len(family.spacing)
    for step in range(1, count):
        if (
            count % step == 0
            and repeats(step)
            and _alike(family.spacing, step)
            and _alike(family.width, step)
        ):
            return step
    return count


def _alike(values: NDArray[np.float64], step: int) -> bool:
    return bool(np.allclose(np.roll(values, step), values, rtol=1e-9, atol=0))


def _first(family: FamilyLayout, count: int) -> FamilyLayout:
    return replace(family, spacing=family.spacing[:count], width=family.width[:count])


def repeat_threads(fabric: Fabric) -> tuple[int, int]:
    """Picks and ends of a fabric's shortest repeat."""
    picks, ends = shortest_repeat(fabric.layout()).warp_on_top.shape
    return picks, ends


# ----------------------------------------------------------------------------------------------- latent cache
# The cache of latents: the last fabrics in memory, and files under the user's cache folder.
#
# A file is a safetensors file whose name is the key: `front` and `back` in half precision, and `correction`
# where the last layer was fine-tuned. Damaged files are ignored, and their latents computed again.


# Part of every key: to be raised when maps of the same layout change.
_VERSION = 2
# Fabrics kept in memory, and texels above which a fabric is not kept on disk (8 MB of half precision).
_FABRICS_IN_MEMORY = 64
_MAX_TEXELS_ON_DISK = 1 << 16
_in_memory: OrderedDict[str, EncodedFabric] = OrderedDict()


def read_latents(
    key: str, fabric: Fabric, repeat: tuple[int, int], weights: Weights, fine_tuned: bool
) -> EncodedFabric | None:
    """The latents of a key, from memory or disk; None if they are not cached.

    Args:
        repeat: picks and ends.
    """
    return _in_memory.get(key) or _read(key, fabric, repeat, weights, fine_tuned)


def store_latents(key: str, encoded: EncodedFabric) -> None:
    """Stores latents under a key, as the most recently used."""
    if key not in _in_memory:
        _write(key, encoded)
    _in_memory[key] = encoded
    _in_memory.move_to_end(key)
    while len(_in_memory) > _FABRICS_IN_MEMORY:
        _in_memory.popitem(last=False)


def clear_encodings() -> None:
    """Clears the cache in memory."""
    _in_memory.clear()


def cache_key(fabric: Fabric, weights: Weights, repeats: tuple[int, int], fine_tuned: bool) -> str:
    """SHA-256 of everything that the latents depend on."""
    layout = shortest_repeat(fabric.layout())
    digest = hashlib.sha256(f"{_VERSION} {weights.sha256} {repeats} {fine_tuned}\n".encode())
    digest.update(repr(layout.warp_on_top.shape).encode() + np.packbits(layout.warp_on_top).tobytes())
    for family in (layout.warp, layout.weft):
        digest.update(np.asarray(family.spacing, np.float64).tobytes())
        digest.update(np.asarray(family.width, np.float64).tobytes())
        digest.update(repr((float(family.inclination), float(family.twist))).encode())
    digest.update(fabric_parameters(fabric).tobytes())
    appearance = fabric.appearance()
    digest.update(repr((float(appearance.diffuse_blend), float(appearance.optical_depth))).encode())
    return digest.hexdigest()


def _read(
    key: str, fabric: Fabric, repeat: tuple[int, int], weights: Weights, fine_tuned: bool
) -> EncodedFabric | None:
    """The latents on disk; None if there is no file or an unusable one."""
    picks, ends = repeat
    try:
        arrays = load_file(cache_folder("neural") / f"{key}.safetensors")
        read = LoomFile("neural", fabric, arrays).tables(
            EncodedFabric,
            sizes_of(picks, ends, weights.table),
            picks=picks,
            ends=ends,
            fibre_numbers=Fibres.of(fabric).array(),
        )
    except (InputError, SafetensorError, OSError, ValueError):
        return None
    return read if (read.correction is not None) == fine_tuned else None


def _write(key: str, encoded: EncodedFabric) -> None:
    """Writes latents to disk; ignores errors, which cost a run of the encoder next time."""
    if len(encoded.faces[0]) > _MAX_TEXELS_ON_DISK:
        return
    folder = cache_folder("neural")
    file = folder / f"{key}.safetensors"
    if file.exists():
        return
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with replacing(file) as temporary:
            arrays = encoded.arrays()
            del arrays["fibres"]  # those of the fabric
            save_file(arrays, temporary)
    except (OSError, LoomlightError, SafetensorError):
        return


# ------------------------------------------------------------------------------------------------ fine tuning
# Fine-tuning of the network's last layer for one fabric: seconds of linear algebra in place of training.
#
# Latents of fabrics outside the training set have small errors, which are visible in highlights of smooth
# fibres. The last layer outputs weights of the lobe basis, and specular components are linear in positive
# weights. So the layer is fitted to exact means of the fabric over whole repeats: regularized least squares
# of errors weighted between absolute and relative, by Gauss–Newton steps in the dual (kernel) form, as
# there are fewer queries than weights. The correction applies to reflection alone, and fades out for
# footprints towards a thread, as means over repeats do not determine them.


# Pairs of directions; longer repeats, whose pairs cost more, have down to this fraction of them.
_PAIRS = 1024
_MIN_PAIRS = 0.25
# Crossings of a repeat up to which slices have the first number of texels a thread, beyond it the second.
_SMALL_REPEAT = 256
_TEXELS = 8, 4
# Side of footprints in repeats, large enough to be means of the repeat.
_SIDE = 5.0
# Weight of an error: (truth + _DARK · mean truth)^_POWER.
_POWER, _DARK = -0.7, 0.15
# Regularization λ, as a fraction of the mean diagonal of the kernel.
_CHANGE = 0.003
_STEPS = 8
# Rows of a block of the factorisation: the fastest of 48, 64, 96 and 128 for 1024 rows.
_BLOCK = 64
# Line search: fractions of a Gauss–Newton step.
_STEP_SIZES = 1.0, 0.5, 0.25, 0.1, 0.03


def fitted_correction(
    fabric: Fabric, layout: ClothLayout, encoded: EncodedFabric, weights: Weights, float_type: type
) -> NDArray[np.float32]:
    """The correction of the last layer's rows for the lobe basis [2 · `BUNDLES`, hidden + 1].

    See `EncodedFabric`.

    Args:
        layout: the fabric's shortest repeat, without its colours.
        encoded: its latents.
        float_type: the Dr.Jit Float type to compute means with.
    """
    hidden, densities, truth = _fit_data(fabric, layout, encoded, weights, float_type)
    inputs = np.concatenate([hidden, np.ones((len(hidden), 1))], axis=1)
    name = f"decoder.angular.{weights.layers('decoder.angular') - 1}"
    layer = np.concatenate(
        [weights.tensor(f"{name}.weight"), weights.tensor(f"{name}.bias")[:, None]], axis=1
    )
    heads = np.split(layer[-2 * BUNDLES :].astype(np.float64), 2)

    def family_fit(family: int) -> NDArray[np.float64]:
        return _fitted(heads[family], inputs, BUNDLE_UNIT * densities[:, family], truth[:, 2 + family])

    # One core a family: threads within a small factorisation wait longer than they compute, and up to fifty
    # times as long on a busy machine.
    with threadpool_limits(1, "blas"), ThreadPoolExecutor(2) as pool:
        fitted = pool.map(family_fit, (0, 1))
        correction = [rows - head for rows, head in zip(fitted, heads, strict=True)]
    return np.concatenate(correction).astype(np.float32)


def _fitted(
    head: NDArray[np.float64],
    inputs: NDArray[np.float64],
    densities: NDArray[np.float64],
    truth: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Rows of the last layer [bundles, k] after the steps.

    Args:
        inputs: of the layer [n, k].
        densities: of bundles towards the half vectors [n, bundles].
        truth: the component [n].
    """
    mean = float(truth.mean())
    if mean <= 0:
        return head
    importance = (truth + _DARK * mean) ** _POWER
    similarity = inputs @ inputs.T
    scale = np.mean(np.diagonal(similarity))
    similarity /= scale

    def errors(rows: NDArray[np.float64]) -> NDArray[np.float64]:
        lobe_weights = inputs @ rows.T
        modelled = np.einsum(
            "nb,nb->n", densities, np.where(lobe_weights > 0, lobe_weights, LEAKY_SLOPE * lobe_weights)
        )
        return (truth - modelled) * importance

    error = errors(head)
    factor = np.empty_like(similarity)
    for _ in range(_STEPS):
        slopes = densities * np.where(inputs @ head.T > 0, 1, LEAKY_SLOPE) * importance[:, None]
        change = (slopes * _solution(slopes, similarity, error, factor)[:, None]).T @ inputs / scale
        # The model is linear only near the current weights: a line search over fractions of the step.
        candidates = [head + size * change for size in _STEP_SIZES]
        results = [errors(rows) for rows in candidates]
        best = min(range(len(candidates)), key=lambda number: float(np.square(results[number]).sum()))
        if np.square(results[best]).sum() >= np.square(error).sum():
            break
        head, error = candidates[best], results[best]
    return head


def _solution(
    slopes: NDArray[np.float64],
    similarity: NDArray[np.float64],
    errors: NDArray[np.float64],
    factor: NDArray[np.float64],
) -> NDArray[np.float64]:
    """The solution x [n] of (K + λ I) x = errors with the kernel K = slopes·slopesᵀ ∘ likeness.

    λ is `_CHANGE` of the kernel's mean diagonal. A blocked Cholesky factorisation in products of matrices,
    which makes the kernel's lower triangle as it goes: as fast as LAPACK's.

    Args:
        slopes: of errors by bundles [n, bundles].
        likeness: of inputs [n, n].
        factor: memory for the factor [n, n].
    """
    count = len(errors)
    ridge = _CHANGE * float(np.square(slopes).sum(1) @ np.diagonal(similarity)) / count
    solution = np.empty_like(errors)
    starts, inverses = range(0, count, _BLOCK), []
    for first in starts:
        block = slice(first, first + _BLOCK)
        panel = slopes[first:] @ slopes[block].T
        panel *= similarity[first:, block]
        panel[np.diag_indices(panel.shape[1])] += ridge
        panel -= factor[first:, :first] @ factor[block, :first].T
        inverse = np.linalg.inv(np.linalg.cholesky(panel[:_BLOCK]))
        np.matmul(panel, inverse.T, out=factor[first:, block])
        solution[block] = inverse @ (errors[block] - factor[block, :first] @ solution[:first])
        inverses.append(inverse)
    for first, inverse in zip(reversed(starts), reversed(inverses), strict=True):
        block, after = slice(first, first + _BLOCK), slice(first + _BLOCK, count)
        solution[block] = inverse.T @ (solution[block] - factor[after, block].T @ solution[after])
    return solution


def _fit_data(
    fabric: Fabric, layout: ClothLayout, encoded: EncodedFabric, weights: Weights, float_type: type
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Data of the fit: inputs of the last layer [n, hidden], densities [n, 2, bundles], truth [n, 4]."""
    per_thread = _TEXELS[layout.warp_on_top.size > _SMALL_REPEAT]
    model = YarnScattering(YarnGeometry(layout), fabric.appearance())
    slices = FabricSlices(model, float_type, per_thread, shadows="mapped")
    scale = fabric_scale(layout)
    pairs = round(_PAIRS * max(_MIN_PAIRS, min(1, _SMALL_REPEAT / layout.warp_on_top.size)))
    queries = query_set(scale, pairs, 1, seed=0, lights=pairs // 4, views=pairs // 4)
    sides = np.full((pairs, 1), _SIDE * scale.repeat)
    # Boxes as large as the repeat, whose means are exact.
    boxes = np.broadcast_to(np.array(layout.size), (pairs, 1, 2))
    truth = slices.box_means(queries.lights, queries.views, queries.pairs, queries.centres, boxes)[:, 0, :4]
    lights, views = queries.lights[queries.pairs[:, 0]], queries.views[queries.pairs[:, 1]]
    footprints = footprints_in_threads(layout, queries.centres, sides)[:, 0]
    parts = []
    for back in (False, True):
        is_face = (views[:, 2] < 0) == back
        turn = np.array([1, 1, -1 if back else 1])
        light, view = ((part[is_face] * turn).astype(np.float32) for part in (lights, views))
        hidden = _hidden(encoded, weights, back, light, view, footprints[is_face])
        parts.append((hidden, _densities(encoded, back, light, view), truth[is_face].astype(np.float64)))
    results = [np.concatenate(arrays) for arrays in zip(*parts, strict=True)]
    return results[0], results[1], results[2]


def _densities(
    encoded: EncodedFabric, back: bool, light: NDArray[np.float32], view: NDArray[np.float32]
) -> NDArray[np.float64]:
    """Densities of bundles towards half vectors [n, 2, bundles], 1/sr."""
    bundles = encoded.fibres.bundles(back).astype(np.float64)
    total = (light + view).astype(np.float64)
    inverse = 1 / (np.einsum("nc,nc->n", total, total) + OPPOSITE)
    cosines = np.einsum("nc,fbc->nfb", total, bundles[..., :3])
    return 1 / np.square(bundles[..., 3] + np.square(cosines) * inverse[:, None, None])


def _hidden(
    encoded: EncodedFabric,
    weights: Weights,
    back: bool,
    light: NDArray[np.float32],
    view: NDArray[np.float32],
    footprints: NDArray[np.float32],
) -> NDArray[np.float64]:
    """Inputs of the last layer [n, hidden] in the frame of one face."""
    is_back = np.full(len(light), back, np.float32)
    queries = [*one_square(columns(footprints)), *columns(view), is_back, *columns(light)]
    results = np.empty((weights.table.hidden, len(light)), np.float32)
    compiled_decoder(weights).run("hidden", kernel_table(weights, encoded), queries, [*results])
    return results.T.astype(np.float64)


# --------------------------------------------------------------------------------------------------- encoding


def encode(
    fabric: Fabric,
    weights: Weights,
    float_type: type,
    repeats: tuple[int, int] = (1, 1),
    refined: bool = False,
) -> EncodedFabric:
    """The latents of both faces, from the cache or by the encoder.

    Args:
        float_type: the Dr.Jit Float type that the encoder's maps are computed with.
        repeats: repetitions of the repeat along picks and along ends, for a common repeat of two fabrics.
        refined: fine-tune the last layer for the fabric, which takes seconds (below); ignored
            without a lobe basis or a latent field.

    Raises:
        InputError: a repeat of more than 64 threads a side.
    """
    require_encodable(fabric)
    picks, ends = (count * times for count, times in zip(repeat_threads(fabric), repeats, strict=True))
    warn_outside_ranges(fabric, trained_ranges(weights))
    refined = refined and weights.table.bundles and weights.table.latent == "field"
    key = cache_key(fabric, weights, repeats, refined)
    encoded = read_latents(key, fabric, (picks, ends), weights, refined)
    if encoded is None and refined:
        encoded = _fine_tuned(fabric, weights, float_type, repeats)
    if encoded is None:
        encoded = run_encoder(fabric, weights, float_type, repeats)
    store_latents(key, encoded)
    return encoded


def require_encodable(fabric: Fabric) -> None:
    """Raises InputError unless the encoder takes the fabric: repeats of up to 64 threads a side."""
    picks, ends = repeat_threads(fabric)
    if max(picks, ends) > MAX_THREADS:
        raise InputError(
            f"{fabric.name}: its repeat of {ends} ends × {picks} picks is too large for the model neural, "
            f'which takes up to {MAX_THREADS} a side: use the model "point".'
        )


def encode_pair(
    first: Fabric, second: Fabric, weights: Weights, float_type: type, refined: bool = False
) -> tuple[EncodedFabric, EncodedFabric]:
    """Two fabrics on their common repeat, to be interpolated.

    Raises:
        InputError: a common repeat of more than 64 threads a side.
    """
    threads_of_first, threads_of_second = repeat_threads(first), repeat_threads(second)
    common = [math.lcm(a, b) for a, b in zip(threads_of_first, threads_of_second, strict=True)]
    if max(common) > MAX_THREADS:
        raise InputError(
            f"{first.name} and {second.name} have a common repeat of {common[1]} ends × {common[0]} picks: "
            f"latents are interpolated up to {MAX_THREADS} a side."
        )
    one, other = (
        encode(fabric, weights, float_type, (common[0] // threads[0], common[1] // threads[1]), refined)
        for fabric, threads in ((first, threads_of_first), (second, threads_of_second))
    )
    return one, other


def _fine_tuned(
    fabric: Fabric, weights: Weights, float_type: type, repeats: tuple[int, int]
) -> EncodedFabric:
    """The encoder's latents, and a correction of the last layer for the fabric."""
    single = encode(fabric, weights, float_type)
    correction = fitted_correction(fabric, shortest_repeat(fabric.layout()), single, weights, float_type)
    encoded = single if repeats == (1, 1) else encode(fabric, weights, float_type, repeats)
    return replace(encoded, correction=correction)
