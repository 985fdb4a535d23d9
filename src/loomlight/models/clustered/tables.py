"""The tables of one fabric, and how they are baked: features, clusters, densities and visibility of texels.

`ClusterTables` at the end declares all tables; `bake_tables` makes them of what stands before.
"""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.backend import array_types
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.parallel_map import parallel_map
from loomlight.core.tables import Tables, computed, derived, flag, given, size, table
from loomlight.models.clustered.footprint_sums import summed_areas
from loomlight.models.clustered.gaussians import LOBE_NUMBERS, fitted_gaussians, lobe_values
from loomlight.models.clustered.parallax import (
    PARALLAX_BINS,
    PARALLAX_RANK,
    compressed,
    parallax_tables,
)
from loomlight.models.clustered.square_map import BINS, bin_centres
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.visibility import HorizonMap

# --------------------------------------------------------------------------------------------------- features
# Feature maps: what is at the middle of every texel of one repeat, on both faces (zhu2024 3.1).


_Number = TypeVar("_Number", bound=np.generic)
# Texels along the longer side of small repeats (zhu2024 6), and texels across the finest thread.
DEFAULT_TEXELS = 256
_PER_THREAD, _MIN_PER_THREAD = 6, 2
# Of one face, whatever `texels` asks for: the bake stays under two minutes and 4 GB.
MAX_TEXELS = 1 << 21
# Of one face, for the sake of threads: files stay below 15 MB, at 36 bytes a texel of a face.
_MAX_FOR_THREADS, _FILE_BYTES = 208_000, 2 * 36


@dataclass(frozen=True, eq=False)
class FeatureMaps:
    """Texels of both faces, in the frame of the face; row 0 lies at y = 0, column 0 at x = 0.

    Attributes:
        hole, is_warp: [2 faces, rows, columns]; nothing else means anything in holes.
        thread: index of the thread that shows [2, rows, columns].
        normal, tangent: unit normal and unit fibre direction [2, rows, columns, 3].
        horizon: sines of elevation in steps of 1/255 [2, rows, columns, 16 azimuths].
    """

    hole: NDArray[np.bool_]
    is_warp: NDArray[np.bool_]
    thread: NDArray[np.int32]
    normal: NDArray[np.float32]
    tangent: NDArray[np.float32]
    horizon: NDArray[np.uint8]


def texel_counts(geometry: YarnGeometry, longest: int) -> tuple[int, int]:
    """Columns and rows: `longest` along the longer side, or more where threads would have under 6 texels.

    Threads of large repeats have fewer, at least 2: a warning says so.

    Raises:
        InputError: the repeat is too large; the message says how large its file would be.
    """
    width, height = geometry.size
    side = max(width, height) / longest

    def counts(per_thread: float) -> tuple[int, int]:
        columns, rows = (
            max(4, math.ceil(extent / side - 1e-6), math.ceil(per_thread * extent / fine - 1e-6))
            for extent, fine in zip(geometry.size, geometry.finest, strict=True)
        )
        return columns, rows

    found, asked, least = (counts(per_thread) for per_thread in (_PER_THREAD, 0, _MIN_PER_THREAD))
    most = min(max(_MAX_FOR_THREADS, asked[0] * asked[1]), MAX_TEXELS)
    if found[0] * found[1] <= most:
        return found
    if least[0] * least[1] > most:
        raise InputError(
            f"The repeat of {width:.4g} × {height:.4g} mm needs {least[0]} × {least[1]} texels, "
            f"{_file_megabytes(least):.0f} MB in a file: clustered takes up to "
            f"{_MAX_FOR_THREADS * _FILE_BYTES / 1e6:.0f} MB; use lobes for this draft."
        )
    # Rounding up adds a column and a row.
    per_thread = _PER_THREAD * math.sqrt(most / ((found[0] + 2) * (found[1] + 2)))
    fewer = counts(max(per_thread, _MIN_PER_THREAD))
    warnings.warn(
        f"The repeat of {width:.4g} × {height:.4g} mm is large: {fewer[0]} × {fewer[1]} texels, "
        f"{max(per_thread, _MIN_PER_THREAD):.1f} across the finest thread instead of {_PER_THREAD}, take "
        f"{_file_megabytes(fewer):.0f} MB in a file; use lobes where yarns are seen close up.",
        LoomlightWarning,
        stacklevel=2,
    )
    return fewer


def _file_megabytes(counts: tuple[int, int]) -> float:
    return counts[0] * counts[1] * _FILE_BYTES / 1e6


def feature_maps(geometry: YarnGeometry, counts: tuple[int, int], float_type: FloatType) -> FeatureMaps:
    """The maps of one repeat with so many columns and rows."""
    types = array_types(float_type)
    columns, rows = counts
    index = dr.arange(types.UInt32, columns * rows)
    row = index // columns
    x = (types.Float(index - row * columns) + 0.5) * (geometry.size[0] / columns)
    y = (types.Float(row) + 0.5) * (geometry.size[1] / rows)
    points = [geometry.surface(x, y, dr.full(types.Bool, back, len(x))) for back in (False, True)]
    dr.eval(points)
    horizons = HorizonMap(geometry, counts, float_type)

    def both(*parts: NDArray[_Number]) -> NDArray[_Number]:
        return np.stack([part.reshape(rows, columns, *part.shape[1:]) for part in parts])

    return FeatureMaps(
        hole=both(*(np.array(point.hole.numpy(), bool) for point in points)),
        is_warp=both(*(np.array(point.is_warp.numpy(), bool) for point in points)),
        thread=both(
            *(
                dr.select(point.is_warp, point.warp_thread, point.weft_thread).numpy().astype(np.int32)
                for point in points
            )
        ),
        normal=both(*(point.normal.numpy().T for point in points)),
        tangent=both(*(point.tangent.numpy().T for point in points)),
        horizon=horizons.sine,
    )


# --------------------------------------------------------------------------------------------------- clusters
# Clusters of texels whose visibility is alike: k-means (zhu2024 4.2).


NO_CLUSTER = 255
_TRAINING = 1 << 13
_ROUNDS = 24
# Bins of directions a side.
_DIRECTIONS = 8


def label_texels(maps: FeatureMaps, lobes: NDArray[np.float32], per_face: int) -> NDArray[np.uint8]:
    """The cluster of every texel [2 faces, rows, columns]; `NO_CLUSTER` in holes.

    Visibility decides, by the values of the lobes towards directions all over the hemisphere: the paper takes
    their parameters, whose distance says less of it. The first half of the clusters of a face is the warp's.

    Args:
        lobes: see `Gaussians`.
        per_face: clusters, an even number.
    """
    labels = np.full(maps.hole.shape, NO_CLUSTER, np.uint8)
    half = per_face // 2
    for face in (0, 1):
        for first, family in ((0, maps.is_warp[face]), (half, ~maps.is_warp[face])):
            of_family = family & ~maps.hole[face]
            if of_family.any():
                labels[face][of_family] = first + _k_means(_features(maps, lobes, face, of_family), half)
    return labels


def _features(
    maps: FeatureMaps, lobes: NDArray[np.float32], face: int, chosen: NDArray[np.bool_]
) -> NDArray[np.float32]:
    """Vectors whose squared distance is the dissimilarity of texels [n, 16]."""
    of_family = lobes[face][chosen]
    seen = [lobe_values(of_family, direction) for direction in bin_centres(_DIRECTIONS)]
    return np.stack(seen, axis=1)


def _k_means(points: NDArray[np.float32], count: int) -> NDArray[np.uint8]:
    """The nearest of `count` means for each point [n]; the same for the same points."""
    rng = np.random.default_rng(0)
    training = points[rng.permutation(len(points))[:_TRAINING]]
    # k-means++: each further mean is drawn in proportion to the squared distance from those before.
    means = training[:1]
    while len(means) < min(count, len(training)):
        distance = _squared_distances(training, means).min(axis=1)
        total = float(distance.sum())
        if total <= 0:
            break
        means = np.concatenate([means, training[[rng.choice(len(training), p=distance / total)]]])
    for _ in range(_ROUNDS):
        label = _squared_distances(training, means).argmin(axis=1)
        for number in range(len(means)):
            if (label == number).any():
                means[number] = training[label == number].mean(axis=0)
    found: NDArray[np.uint8] = _squared_distances(points, means).argmin(axis=1).astype(np.uint8)
    return found


def _squared_distances(points: NDArray[np.float32], means: NDArray[np.float32]) -> NDArray[np.float64]:
    """[n, k], never negative."""
    products = points @ means.T
    squares = np.square(points).sum(axis=1)[:, None] + np.square(means).sum(axis=1) - 2 * products
    return np.maximum(squares.astype(np.float64), 0)


# --------------------------------------------------------------------------------------------- density tables
# Fibre densities D by half vector, compressed by clustered principal components (zhu2024 4.3 and 4.4).
#
# In cluster k, the density of the texel p at half vector h is
#
#     D(p, h) ≈ μ_k(h) + Σ_r a_r(p) B_kr(h)
#
# The summed-area tables of the coefficients a_r over each cluster are the summed-area tables of the
# compressed densities, as sums are linear: the bake never makes the uncompressed ones, and takes no
# averages out of them.


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


# ----------------------------------------------------------------------------------------------- light tables
# Visibility of each cluster by the direction of the light: means over its texels (zhu2024 4.2).


# Texels of a cluster that stand for all.
_TEXELS = 1024


def light_tables(lobes: NDArray[np.float32], labels: NDArray[np.uint8], clusters: int) -> NDArray[np.float32]:
    """v̄, the mean visibility of clusters [2 faces, 2 sides, bins, clusters]; side 1 is light from behind.

    Args:
        lobes: see `Gaussians`.
    """
    directions = bin_centres()
    table = np.zeros((2, 2, len(directions), clusters), np.float32)
    rng = np.random.default_rng(0)
    for face in (0, 1):
        flat = labels[face].ravel()
        order = rng.permutation(flat.size)
        parts = [order[flat[order] == cluster][:_TEXELS] for cluster in range(clusters)]
        sizes = np.array([len(part) for part in parts])
        texels = np.concatenate(parts)
        present = np.flatnonzero(sizes)
        starts = (np.cumsum(sizes) - sizes)[present]
        for side in (0, 1):
            # Light from the other side falls on the other face, whose lobes are in its own frame.
            seen = lobes[face ^ side].reshape(-1, LOBE_NUMBERS)[texels]

            def of_direction(
                direction: NDArray[np.float64],
                seen: NDArray[np.float32] = seen,
                starts: NDArray[np.intp] = starts,
            ) -> NDArray[np.float32]:
                return np.add.reduceat(lobe_values(seen, direction), starts)

            sums = np.stack(parallel_map(of_direction, directions))
            table[face, side][:, present] = sums / sizes[present]
    return table


# ----------------------------------------------------------------------------------------------------- tables


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
        expected="three or more, those of the normal behind those of the components",
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
    saturating: bool = True,
) -> ClusterTables:
    """Bakes the tables of a fabric: the same bytes every time.

    Args:
        roughness: of warp and weft.
        clusters: of a face, a multiple of 4.
        rank: principal components of the densities of a cluster.
        texels: along the longer side of the repeat.
        saturating: see `fitted_gaussians`; False for comparisons alone.

    Raises:
        InputError: a repeat that is too large.
    """
    counts = texel_counts(geometry, texels)
    maps = feature_maps(geometry, counts, float_type)
    lobes = fitted_gaussians(maps.horizon, float_type, saturating).lobes
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
