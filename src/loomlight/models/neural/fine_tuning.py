"""Fine-tuning of the network's last layer for one fabric: seconds of linear algebra in place of training.

Latents of fabrics outside the training set have small errors, which are visible in highlights of smooth
fibres. The last layer outputs weights of the lobe basis, and specular components are linear in positive
weights. So the layer is fitted to exact means of the fabric over whole repeats: regularized least squares of
errors weighted between absolute and relative, by Gauss–Newton steps in the dual (kernel) form, as there are
fewer queries than weights. The correction applies to reflection alone, and fades out for footprints towards
a thread, as means over repeats do not determine them.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from loomlight.aggregate.queries import fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.architecture import BUNDLE_UNIT, BUNDLES, LEAKY_SLOPE, OPPOSITE
from loomlight.models.neural.compiled import columns, compiled_decoder, kernel_table, one_square
from loomlight.models.neural.encoded_fabric import EncodedFabric
from loomlight.models.neural.footprint_coding import footprints_in_threads
from loomlight.models.neural.weights import Weights
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout

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
