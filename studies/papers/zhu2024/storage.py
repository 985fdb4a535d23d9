"""Size and error of compressed fibre densities by clusters and rank, and what taking out the mean does.

    python -m studies.papers.zhu2024.storage [--output papers/zhu2024/results/storage.json]

The error is the mean squared difference of D from its compressed form over the mean of D², over texels of
both faces and half vectors, of maps of 128 texels along the repeat. "without mean" spends one more
component instead of the mean (the effect of zhu2024's normalisation, Fig. 4). Bytes are those of tables of
256 texels: uncompressed, one summed-area table of floats for each cluster and half-vector bin; in a file,
labels, coefficients and basis; on a device, summed-area tables of coefficients.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

import numpy as np
from drjit.llvm.ad import Float

from loomlight.core.llvm import require_llvm
from loomlight.fabric import load_fabric
from loomlight.models.clustered.gaussians import fitted_gaussians
from loomlight.models.clustered.square_map import BINS, bin_centres
from loomlight.models.clustered.tables import (
    FeatureMaps,
    densities,
    density_tables,
    feature_maps,
    label_texels,
    texel_counts,
)
from loomlight.yarn.geometry import YarnGeometry
from studies.instruments.harness import REPOSITORY, Figures, run

FABRICS = ("denim", "silk-satin", "linen", "organza", "wool-houndstooth", "damask")
_TEXELS, _STORED = 128, 256
_MEASURED = 96


def without_mean(maps: FeatureMaps, labels: np.ndarray, roughness: tuple[float, float], rank: int) -> float:
    """Relative error of the best `rank` + 1 components of each cluster without a mean, front face."""
    halves = bin_centres().astype(np.float32)
    rng = np.random.default_rng(1)
    rest = whole = 0.0
    for label in np.unique(labels[0][labels[0] < 255]):
        chosen = np.flatnonzero(labels[0].ravel() == label)
        few = maps.tangent[0].reshape(-1, 3)[rng.permutation(chosen)[:_MEASURED]]
        alpha = roughness[0 if maps.is_warp[0].ravel()[chosen[0]] else 1]
        squares = np.linalg.svd(densities(few, halves, alpha), compute_uv=False).astype(np.float64) ** 2
        rest += float(squares[rank + 1 :].sum()) / len(few) * len(chosen)
        whole += float(squares.sum()) / len(few) * len(chosen)
    return rest / whole


def of_fabric(name: str, options: Namespace) -> Figures:
    """All clusters and ranks of one fabric."""
    fabric = load_fabric(REPOSITORY / f"examples/{name}.toml")
    geometry, appearance = YarnGeometry(fabric.layout()), fabric.appearance()
    roughness = appearance.warp.roughness, appearance.weft.roughness
    maps = feature_maps(geometry, texel_counts(geometry, _TEXELS), Float)
    lobes = fitted_gaussians(maps.horizon, Float).lobes
    columns, rows = texel_counts(geometry, _STORED)
    found: Figures = {}
    for clusters in map(int, options.clusters.split(",")):
        labels = label_texels(maps, lobes, clusters)
        for rank in map(int, options.ranks.split(",")):
            tables = density_tables(labels, maps.tangent, roughness, clusters, rank)
            texels = 2 * columns * rows
            found[f"{clusters} clusters, rank {rank}"] = {
                "relative_squared_error": tables.error,
                "without_mean": without_mean(maps, labels, roughness, rank),
                "uncompressed_bytes": texels * clusters * BINS**2 * 4,
                "file_bytes": texels * (1 + rank) + 2 * BINS**2 * (1 + rank) * clusters * 4,
                "device_bytes": 2 * (columns + 1) * (rows + 1) * clusters * (1 + rank) * 4,
            }
    return found


def add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--clusters", default="4,8,16", help="of a face")
    parser.add_argument("--ranks", default="0,1,2,4")


def measure(options: Namespace) -> Figures:
    """The table of each fabric."""
    require_llvm()
    return {"fabrics": {name: of_fabric(name, options) for name in FABRICS}}


if __name__ == "__main__":
    run(measure, add_options)
