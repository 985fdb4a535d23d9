"""Fibre densities D by half vector, compressed by clustered principal components (zhu2024 4.3 and 4.4).

In cluster k, the density of the texel p at half vector h is

    D(p, h) ≈ μ_k(h) + Σ_r a_r(p) B_kr(h)

The summed-area tables of the coefficients a_r over each cluster are the summed-area tables of the compressed
densities: sums are linear. So the bake never makes the uncompressed tables, and takes no averages out of
them. Coefficients are whole numbers of −127 to 127 whose unit is within B, so sums of them are exact.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.models.clustered.square_map import bin_centres

# Texels of a cluster that the components are computed of.
_TRAINING = 2048
_POWERS = 3
_MAX = 127
# Texels whose densities are computed at once.
_BATCH = 8192


@dataclass(frozen=True, eq=False)
class DensityTables:
    """Compressed densities of both faces.

    Attributes:
        basis: μ and B, 1/sr [2 faces, bins, 1 + rank, clusters].
        coefficients: whole numbers [2 faces, rows, columns, rank].
        error: mean squared difference from D, over the mean of D².
    """

    basis: NDArray[np.float32]
    coefficients: NDArray[np.int8]
    error: float


def density_tables(
    labels: NDArray[np.uint8],
    tangent: NDArray[np.float32],
    roughness: tuple[float, float],
    clusters: int,
    rank: int,
) -> DensityTables:
    """Compresses the densities of texels.

    Args:
        labels: [2 faces, rows, columns].
        tangent: unit fibre directions [2 faces, rows, columns, 3].
        roughness: of warp and weft.
        rank: principal components of each cluster, beside the mean.
    """
    halves = bin_centres().astype(np.float32)
    basis = np.zeros((2, len(halves), 1 + rank, clusters), np.float32)
    coefficients = np.zeros((*labels.shape, rank), np.int8)
    squared_error = squares = 0.0
    rng = np.random.default_rng(0)
    for face in (0, 1):
        for cluster in range(clusters):
            chosen = np.flatnonzero(labels[face].ravel() == cluster)
            if not len(chosen):
                continue
            alpha = roughness[0] if cluster < clusters // 2 else roughness[1]
            fibres = tangent[face].reshape(-1, 3)[chosen]
            training = densities(fibres[rng.permutation(len(fibres))[:_TRAINING]], halves, alpha)
            mean = training.mean(axis=0)
            components = _principal_components(training - mean, rank, rng)
            values = (
                np.concatenate(
                    [
                        (densities(fibres[first : first + _BATCH], halves, alpha) - mean) @ components.T
                        for first in range(0, len(fibres), _BATCH)
                    ]
                )
                if rank
                else np.zeros((len(fibres), 0), np.float32)
            )
            unit = np.maximum(np.abs(values).max(axis=0, initial=0) / _MAX, 1e-20)
            whole = np.rint(values / unit)
            coefficients[face].reshape(labels[face].size, rank)[chosen] = whole.astype(np.int8)
            basis[face, :, 0, cluster] = mean
            basis[face, :, 1:, cluster] = (components * unit[:, None]).T
            few = rng.permutation(len(fibres))[:256]
            exact = densities(fibres[few], halves, alpha)
            rest = exact - mean - whole[few].astype(np.float32) @ (components * unit[:, None])
            squared_error += float(np.square(rest).mean()) * len(fibres)
            squares += float(np.square(exact).mean()) * len(fibres)
    return DensityTables(basis, coefficients, squared_error / max(squares, 1e-30))


def densities(
    tangent: NDArray[np.float32], halves: NDArray[np.float32], roughness: float
) -> NDArray[np.float32]:
    """D(h) of fibres [n, bins], 1/sr; see `scattering.fibre.density`."""
    squared = np.float32(roughness * roughness)
    along = tangent @ halves.T
    p = along * along * (1 - squared) + squared
    return (squared * (roughness / np.pi) / (p * p)).astype(np.float32, copy=False)


def _principal_components(
    rows: NDArray[np.float32], rank: int, rng: np.random.Generator
) -> NDArray[np.float32]:
    """The first principal axes of rows [n, d], orthonormal [rank, d], by subspace iteration."""
    space = rng.standard_normal((rows.shape[1], rank + 4)).astype(np.float32)
    for _ in range(_POWERS):
        space, _ = np.linalg.qr(rows.T @ (rows @ space))
    _, _, axes = np.linalg.svd(rows @ space, full_matrices=False)
    found: NDArray[np.float32] = (axes[:rank] @ space.T).astype(np.float32)
    return found
