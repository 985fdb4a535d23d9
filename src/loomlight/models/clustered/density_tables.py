"""Fibre densities D by half vector, compressed by clustered principal components (zhu2024 4.3 and 4.4).

In cluster k, the density of the texel p at half vector h is

    D(p, h) ≈ μ_k(h) + Σ_r a_r(p) B_kr(h)

The summed-area tables of the coefficients a_r over each cluster are the summed-area tables of the compressed
densities, as sums are linear: the bake never makes the uncompressed ones, and takes no averages out of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from loomlight.models.clustered.principal_components import compressed
from loomlight.models.clustered.square_map import bin_centres

# Texels whose compression error is measured, of each cluster.
_MEASURED = 256


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
            rows_of = partial(_rows, fibres, halves, alpha)
            found = compressed(rows_of, len(chosen), rank, rng)
            coefficients[face].reshape(labels[face].size, rank)[chosen] = found.coefficients
            basis[face, :, :, cluster] = found.basis.T
            few = rng.permutation(len(chosen))[:_MEASURED]
            exact = rows_of(few)
            rest = exact - found.basis[0] - found.coefficients[few].astype(np.float32) @ found.basis[1:]
            squared_error += float(np.square(rest).mean()) * len(chosen)
            squares += float(np.square(exact).mean()) * len(chosen)
    return DensityTables(basis, coefficients, squared_error / max(squares, 1e-30))


def _rows(
    fibres: NDArray[np.float32], halves: NDArray[np.float32], roughness: float, numbers: NDArray[np.intp]
) -> NDArray[np.float32]:
    return densities(fibres[numbers], halves, roughness)


def densities(
    tangent: NDArray[np.float32], halves: NDArray[np.float32], roughness: float
) -> NDArray[np.float32]:
    """D(h) of fibres [n, bins], 1/sr; see `scattering.fibre.density`."""
    squared = np.float32(roughness * roughness)
    along = tangent @ halves.T
    p = along * along * (1 - squared) + squared
    return (squared * (roughness / np.pi) / (p * p)).astype(np.float32, copy=False)
