"""All tables of one fabric, and how they are baked."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.errors import InputError
from loomlight.models.clustered.clusters import NO_CLUSTER, label_texels
from loomlight.models.clustered.density_tables import density_tables
from loomlight.models.clustered.features import DEFAULT_TEXELS, FeatureMaps, feature_maps, texel_counts
from loomlight.models.clustered.gaussians import fitted_gaussians
from loomlight.models.clustered.light_tables import light_tables
from loomlight.models.clustered.parallax import PARALLAX_BINS, PARALLAX_RANK, parallax_tables
from loomlight.models.clustered.square_map import BINS
from loomlight.sources.loom_file import LoomFile
from loomlight.yarn.geometry import YarnGeometry

# Numbers of a cluster: mean normal and mean fibre direction, each of unit length, roughness of its lobe for
# sampling, and that of its family.
NUMBERS = 8
# Numbers of a texel: its lobe of visibility, its thread modulo `THREAD_BASE` and over it, and one unused.
TEXEL_NUMBERS = 12
# Half precision has the whole numbers up to 2048.
THREAD_BASE = 1024
# What a coefficient of 1 of a normal is.
NORMAL_UNIT = 1 / 127


@dataclass(frozen=True, eq=False)
class ClusterTables:
    """The tables of one fabric, both faces.

    Attributes:
        labels: cluster of each texel [2, rows, columns], 255 in holes.
        coefficients: of the principal components of D, and x, y and z of the normal in units of 1/127
            [2, rows, columns, rank + 3].
        basis: means and principal components of D, 1/sr [2, half-vector bins, 1 + rank, clusters].
        moments: numbers of each cluster [2, clusters, 8]; see `NUMBERS`.
        texels: lobe of visibility (`Gaussians`) and thread; see `TEXEL_NUMBERS` [2, rows, columns, 12].
        light: see `light_tables`.
        parallax: coefficients of heights [2, rows, columns, 4].
        heights: means and components of heights, millimetres [2, view bins, 5]; see `parallax.py`.
    """

    labels: NDArray[np.uint8]
    coefficients: NDArray[np.int8]
    basis: NDArray[np.float32]
    moments: NDArray[np.float32]
    texels: NDArray[np.float16]
    light: NDArray[np.float32]
    parallax: NDArray[np.int8]
    heights: NDArray[np.float32]

    @property
    def clusters(self) -> int:
        """Clusters of a face."""
        return self.moments.shape[1]

    @property
    def rank(self) -> int:
        """Principal components of a cluster."""
        return self.coefficients.shape[3] - 3

    @property
    def counts(self) -> tuple[int, int]:
        """Columns and rows of texels."""
        return self.labels.shape[2], self.labels.shape[1]

    @property
    def nbytes(self) -> int:
        """Size in a file."""
        return sum(part.nbytes for part in self.arrays().values())

    @property
    def device_bytes(self) -> int:
        """Size on a device, where summed-area tables take the place of coefficients."""
        columns, rows = self.counts
        sums = 2 * (columns + 1) * (rows + 1) * (self.clusters * (4 + self.rank) + PARALLAX_RANK) * 4
        spread = 3 * (self.labels.nbytes + self.coefficients.nbytes) + self.texels.nbytes
        return self.nbytes - self.parallax.nbytes + sums + spread

    def arrays(self) -> dict[str, NDArray[np.generic]]:
        """The tables by name."""
        return {part.name: getattr(self, part.name) for part in fields(self)}


def bake_tables(
    geometry: YarnGeometry,
    roughness: tuple[float, float],
    clusters: int,
    rank: int,
    float_type: FloatType,
    texels: int = DEFAULT_TEXELS,
) -> ClusterTables:
    """Bakes the tables of a fabric: the same bytes every time.

    Args:
        roughness: of warp and weft.
        clusters: of a face, a multiple of 4.
        rank: principal components of the densities of a cluster.
        texels: along the longer side of the repeat.

    Raises:
        InputError: a repeat that is too large.
    """
    counts = texel_counts(geometry, texels)
    maps = feature_maps(geometry, counts, float_type)
    lobes = fitted_gaussians(maps.horizon, float_type).lobes
    labels = label_texels(maps, lobes, clusters)
    densities = density_tables(labels, maps.tangent, roughness, clusters, rank)
    parallax, heights = parallax_tables(geometry, counts, float_type)
    return ClusterTables(
        labels=labels,
        coefficients=np.concatenate([densities.coefficients, _normals(maps)], axis=3),
        basis=densities.basis,
        moments=_moments(maps, labels, roughness, clusters),
        texels=_texels(maps, lobes),
        light=light_tables(lobes, labels, clusters),
        parallax=parallax,
        heights=heights,
    )


def _texels(maps: FeatureMaps, lobes: NDArray[np.float32]) -> NDArray[np.float16]:
    above, below = np.divmod(maps.thread, THREAD_BASE)
    numbers = np.stack([below, above, np.zeros_like(below)], axis=-1)
    return np.nan_to_num(np.concatenate([lobes, numbers], axis=3)).astype(np.float16)


def _normals(maps: FeatureMaps) -> NDArray[np.int8]:
    return np.rint(np.nan_to_num(maps.normal) / NORMAL_UNIT).astype(np.int8)


def _moments(
    maps: FeatureMaps, labels: NDArray[np.uint8], roughness: tuple[float, float], clusters: int
) -> NDArray[np.float32]:
    moments = np.zeros((2, clusters, NUMBERS), np.float32)
    for face in (0, 1):
        for cluster in range(clusters):
            chosen = labels[face] == cluster
            alpha = roughness[0] if cluster < clusters // 2 else roughness[1]
            normal, tangent = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0])
            wide = alpha
            if chosen.any():
                normal = maps.normal[face][chosen].mean(axis=0, dtype=np.float64)
                tangent = maps.tangent[face][chosen].mean(axis=0, dtype=np.float64)
                length = float(np.linalg.norm(tangent))
                wide = min(1.0, (alpha**2 + max(0.0, 1 - length**2)) ** 0.5)
            parts = (normal / np.linalg.norm(normal), tangent / np.linalg.norm(tangent), [wide, alpha])
            moments[face, cluster] = np.concatenate(parts)
    return moments


def tables_of_loom(loom: LoomFile) -> ClusterTables:
    """The tables in a `.loom` file.

    Raises:
        InputError: tensors that are missing, of another kind, or do not belong together.
    """
    labels = loom.tensor("labels", (2, None, None), np.uint8)
    _, rows, columns = labels.shape
    coefficients = loom.tensor("coefficients", (2, rows, columns, None), np.int8)
    moments = loom.tensor("moments", (2, None, NUMBERS), np.float32)
    clusters, rank = moments.shape[1], coefficients.shape[3] - 3
    if rank < 0:
        raise InputError(f"{loom.file}: the tensor model.coefficients has no normals.")
    if clusters == 0 or clusters % 4 or labels.size == 0:
        raise InputError(
            f"{loom.file}: the tensor model.moments has {clusters} clusters a face: it should have a "
            "multiple of four."
        )
    if ((labels >= clusters) & (labels != NO_CLUSTER)).any():
        raise InputError(f"{loom.file}: the tensor model.labels names clusters that there are not.")
    return ClusterTables(
        labels=labels,
        coefficients=coefficients,
        basis=loom.tensor("basis", (2, BINS**2, 1 + rank, clusters), np.float32),
        moments=moments,
        texels=loom.tensor("texels", (2, rows, columns, TEXEL_NUMBERS), np.float16),
        light=loom.tensor("light", (2, 2, BINS**2, clusters), np.float32),
        parallax=loom.tensor("parallax", (2, rows, columns, PARALLAX_RANK), np.int8),
        heights=loom.tensor("heights", (2, PARALLAX_BINS**2, 1 + PARALLAX_RANK), np.float32),
    )
