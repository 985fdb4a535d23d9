"""Size and error of compressed fibre densities by clusters and rank, and what taking out the mean does.

The error is the mean squared difference of D from its compressed form over the mean of D², over texels of
both faces and half vectors. "without mean" spends one more component instead of the mean (the effect of
zhu2024's normalisation, Fig. 4). Bytes are those of tables of 256 texels: uncompressed, one summed-area table
of floats for each cluster and half-vector bin; in a file, labels, coefficients and basis; on a device,
summed-area tables of coefficients.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np
from drjit.llvm.ad import Float

from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
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
from studies.harness.study import Figures, Found, Run, Study, example, listed, listed_counts, names

FABRICS = ("denim", "silk-satin", "linen", "organza", "wool-houndstooth", "damask")
_STORED = 256
_MEASURED = 96


@dataclass(frozen=True)
class Storage(Settings):
    """What is compressed, and how."""

    fabrics: str = names(",".join(FABRICS), "Examples whose densities are compressed.")
    clusters: str = setting("4,8,16", "Of a face.", metavar="N,…")
    texels: int = setting(128, "Of maps, along the repeat.", low=8, high=1024)
    ranks: str = setting("0,1,2,4", "Components beside the mean.", metavar="N,…")


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


def of_fabric(name: str, settings: Storage) -> Figures:
    """All clusters and ranks of one fabric."""
    all_clusters = listed_counts("--clusters", settings.clusters, 1, 64)
    ranks = listed_counts("--ranks", settings.ranks, 0, 16)
    fabric = load_fabric(example(name))
    geometry, appearance = YarnGeometry(fabric.layout()), fabric.appearance()
    roughness = appearance.warp.roughness, appearance.weft.roughness
    maps = feature_maps(geometry, texel_counts(geometry, settings.texels), Float)
    lobes = fitted_gaussians(maps.horizon, Float).lobes
    columns, rows = texel_counts(geometry, _STORED)
    found: Figures = {}
    for clusters in all_clusters:
        labels = label_texels(maps, lobes, clusters)
        for rank in ranks:
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


def measure(settings: Storage, run: Run) -> Found:
    """The table of each fabric."""
    require_llvm()
    return Found(
        {"fabrics": run.each({name: partial(of_fabric, name, settings) for name in listed(settings.fabrics)})}
    )


def tables(figures: Figures) -> list[Table]:
    """A table a fabric."""
    columns = ("relative squared error", "without mean", "uncompressed bytes", "file bytes", "device bytes")
    return [
        Table(
            name,
            list(columns),
            {row: [cells[c.replace(" ", "_")] for c in columns] for row, cells in rows.items()},
        )
        for name, rows in figures["fabrics"].items()
    ]


STUDY = Study(
    "papers/zhu2024/storage",
    "bytes and errors of compressed fibre densities by clusters and rank",
    Storage(),
    measure,
    tables,
    stands_on=("clustered",),
    small={"fabrics": "denim", "clusters": "4", "ranks": "0,1", "texels": 32},
)
