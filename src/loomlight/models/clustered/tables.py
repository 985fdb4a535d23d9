"""All tables of one fabric, and how they are baked."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.tables import Tables, computed, derived, flag, given, size, table
from loomlight.models.clustered.clusters import NO_CLUSTER, label_texels
from loomlight.models.clustered.density_tables import density_tables
from loomlight.models.clustered.features import DEFAULT_TEXELS, FeatureMaps, feature_maps, texel_counts
from loomlight.models.clustered.footprint_sums import summed_areas
from loomlight.models.clustered.gaussians import fitted_gaussians
from loomlight.models.clustered.light_tables import light_tables
from loomlight.models.clustered.parallax import PARALLAX_BINS, PARALLAX_RANK, parallax_tables
from loomlight.models.clustered.square_map import BINS
from loomlight.yarn.geometry import YarnGeometry

# Numbers of a cluster (`ClusterTables.moments`) and of a texel (`ClusterTables.texels`).
NUMBERS, TEXEL_NUMBERS = 8, 12
# Half precision has the whole numbers up to 2048.
THREAD_BASE = 1024
# What a coefficient of 1 of a normal is.
NORMAL_UNIT = 1 / 127


class ClusterTables(Tables):
    """The tables of one fabric, both faces: in files, on devices and in shaders."""

    # What tables mean; to be raised when older ones no longer fit the formulas.
    version = 3
    record = "clustered"

    is_baked = flag("0 where the fabric has no tables of clusters")
    clusters = size(
        "of a face; the first half is the warp's",
        of="moments",
        counted="clusters a face",
        expected="a multiple of four",
        multiple=4,
    )
    rank = size(
        "principal components of the densities of a cluster",
        of="coefficients",
        counted="numbers a texel",
        expected="three of the normal, and those of the components before them",
        low=0,
    )

    @computed("clusters · (4 + rank) + 4")
    def channels(self) -> int:
        """Of the summed areas of a texel."""
        return self.clusters * (4 + self.rank) + PARALLAX_RANK

    columns = size("texels of the repeat", of="labels")
    rows = size("", of="labels")
    texel_width = given("float", "millimetres")
    texel_height = given("float", "")
    samples = given("uint", "texels of the residual of a footprint")

    @derived(
        "summed areas, signed; see `summed_areas`",
        ("2 faces", "rows + 1", "columns + 1", "channels"),
        words="words",
        device="UInt32",
    )
    def sums(self) -> NDArray[np.uint32]:
        """Summed-area tables of coefficients, whose sums they are too, and of those of parallax."""
        faces = zip(self.labels, self.coefficients, self.parallax, strict=True)
        return np.stack([summed_areas(*face, self.clusters) for face in faces]).view(np.uint32)

    labels: NDArray[np.uint8] = table(
        "cluster of each texel; 255 in holes",
        ("2 faces", "rows", "columns"),
        words="bytes",
        device="UInt32",
        low=0,
        high="clusters - 1",
        beside=NO_CLUSTER,
    )
    coefficients: NDArray[np.int8] = table(
        "of the principal components of densities, and x, y and z of the normal in units of 1/127",
        ("2 faces", "rows", "columns", "rank + 3"),
        words="bytes",
        device="Float",
    )
    basis: NDArray[np.float32] = table(
        "means and principal components of densities, 1/sr, by half vector",
        ("2 faces", f"{BINS**2} bins", "1 + rank", "clusters"),
        words="words",
        device="Float",
    )
    moments: NDArray[np.float32] = table(
        "of each cluster: mean normal and mean fibre direction, unit vectors, roughness of its lobe for "
        "sampling, and that of its family",
        ("2 faces", "clusters", NUMBERS),
        words="words",
        device="Float",
    )
    texels: NDArray[np.float16] = table(
        "lobe of visibility of each texel (`Gaussians`), its thread modulo `THREAD_BASE` and over it, and "
        "one that is unused",
        ("2 faces", "rows", "columns", TEXEL_NUMBERS),
        words="words",
        device="Float",
    )
    light: NDArray[np.float32] = table(
        "mean visibility of each cluster by light; see `light_tables`",
        ("2 faces", "2 sides", f"{BINS**2} bins", "clusters"),
        words="words",
        device="Float",
    )
    parallax: NDArray[np.int8] = table(
        "coefficients of heights", ("2 faces", "rows", "columns", PARALLAX_RANK)
    )
    heights: NDArray[np.float32] = table(
        "means and components of heights by view, millimetres; see `parallax.py`",
        ("2 faces", f"{PARALLAX_BINS**2} bins", 1 + PARALLAX_RANK),
        words="words",
        device="Float",
    )

    @property
    def counts(self) -> tuple[int, int]:
        """Columns and rows of texels."""
        return self.columns, self.rows

    @property
    def device_bytes(self) -> int:
        """Size on a device, where summed-area tables take the place of coefficients."""
        sums = 2 * (self.columns + 1) * (self.rows + 1) * self.channels * 4
        spread = 3 * (self.labels.nbytes + self.coefficients.nbytes) + self.texels.nbytes
        return self.nbytes - self.parallax.nbytes + sums + spread


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
