"""Parallax: heights at which view rays meet the cloth, a table by texel and direction (zhu2024 eq. 2, 5.2).

A ray towards o that crosses the plane of the crown lines at u meets the cloth at u + r/o.z · (o.x, o.y), at
the height r. The table has r of every texel for `PARALLAX_BINS`² directions of equal solid angle with o.z >
0.6; flatter views have the r of o.z = 0.6. It is kept as principal components, r(u, o) ≈ μ(o) + Σ a_k(u)
B_k(o): sums of a_k over a footprint give its mean r, as those of densities do.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Array, Float, FloatType, UInt, Vec2, Vec3
from loomlight.core.backend import array_types, maximum, upload, upload_vector
from loomlight.models.clustered.square_map import bin_centres, bin_taps
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.visibility import first_hit

# --------------------------------------------------------------------------------------- principal components
# Rows of numbers as a mean and a few principal components with whole coefficients (zhu2024 4.4).
#
# The unit of a coefficient is within its component, so sums of coefficients are exact.


# Rows that the components are computed of.
_TRAINING = 2048
# Rows that are held at once.
_BATCH = 8192
_POWERS = 3
_MAX = 127


@dataclass(frozen=True, eq=False)
class Compressed:
    """Compressed rows: coefficients @ basis[1:] + basis[0].

    Attributes:
        basis: the mean, and components times units [1 + rank, d].
        coefficients: whole numbers of −127 to 127 [n, rank].
    """

    basis: NDArray[np.float32]
    coefficients: NDArray[np.int8]


def compressed(
    rows_of: Callable[[NDArray[np.intp]], NDArray[np.float32]],
    count: int,
    rank: int,
    rng: np.random.Generator,
) -> Compressed:
    """Compresses rows with `rank` components, of which the first explain the most.

    Args:
        rows_of: the rows of so many numbers [n, d].
        count: of all rows.
    """
    training = rows_of(rng.permutation(count)[:_TRAINING])
    mean = training.mean(axis=0)
    axes = principal_axes(training - mean, rank, rng)
    numbers = np.arange(count)
    parts = [(rows_of(numbers[first : first + _BATCH]) - mean) @ axes.T for first in range(0, count, _BATCH)]
    values = np.concatenate(parts)
    unit = np.maximum(np.abs(values).max(axis=0, initial=0) / _MAX, 1e-20)
    basis = np.concatenate([mean[None], axes * unit[:, None]]).astype(np.float32)
    return Compressed(basis, np.rint(values / unit).astype(np.int8))


def principal_axes(rows: NDArray[np.float32], rank: int, rng: np.random.Generator) -> NDArray[np.float32]:
    """The first principal axes of rows [n, d], orthonormal [rank, d], by subspace iteration."""
    space = rng.standard_normal((rows.shape[1], rank + 4)).astype(np.float32)
    for _ in range(_POWERS):
        space, _ = np.linalg.qr(rows.T @ (rows @ space))
    _, _, axes = np.linalg.svd(rows @ space, full_matrices=False)
    found: NDArray[np.float32] = (axes[:rank] @ space.T).astype(np.float32)
    return found


# --------------------------------------------------------------------------------------------------- parallax


PARALLAX_BINS = 16
# A packet of numbers a texel.
PARALLAX_RANK = 4
# Lowest cosine of the views in the table.
MIN_VIEW_COSINE = 0.6


def parallax_tables(
    geometry: YarnGeometry, counts: tuple[int, int], float_type: FloatType
) -> tuple[NDArray[np.int8], NDArray[np.float32]]:
    """Coefficients [2 faces, rows, columns, 4], and mean and components, millimetres [2, bins, 5]."""
    columns, rows = counts
    types = array_types(float_type)
    directions = upload_vector(types.Vector3, side_views().T)

    def heights(back: bool, texels: NDArray[np.intp]) -> NDArray[np.float32]:
        """r by texel and direction [n, bins]; 0 where a ray passes through."""
        lane = dr.arange(types.UInt32, len(texels) * PARALLAX_BINS**2)
        texel = lane // PARALLAX_BINS**2
        index = dr.gather(types.UInt32, upload(types.UInt32, texels), texel)
        towards = dr.gather(types.Vector3, directions, lane - texel * PARALLAX_BINS**2)
        row = index // columns
        x = (types.Float(index - row * columns) + 0.5) * (geometry.size[0] / columns)
        y = (types.Float(row) + 0.5) * (geometry.size[1] / rows)
        hit = first_hit(geometry, x, y, towards, dr.opaque(types.Bool, back))
        found = dr.select(hit.hole, 0, hit.height).numpy()
        return found.reshape(len(texels), PARALLAX_BINS**2).astype(np.float32)

    rng = np.random.default_rng(0)
    faces = [compressed(partial(heights, back), columns * rows, PARALLAX_RANK, rng) for back in (False, True)]
    coefficients = np.stack([face.coefficients for face in faces])
    basis = np.stack([np.ascontiguousarray(face.basis.T) for face in faces])
    return coefficients.reshape(2, rows, columns, PARALLAX_RANK), basis


def side_views() -> NDArray[np.float64]:
    """Directions of the middles of the bins [bins, 3]: those of the hemisphere, drawn up to the cap."""
    directions = bin_centres(PARALLAX_BINS)
    z = MIN_VIEW_COSINE + (1 - MIN_VIEW_COSINE) * directions[:, 2]
    scale = np.sqrt((1 - z * z) / np.maximum(1 - directions[:, 2] ** 2, 1e-12))
    return np.stack([directions[:, 0] * scale, directions[:, 1] * scale, z], axis=1)


def parallax_offset(view: Vec3, table: Float, first: UInt, mean: Array) -> Vec2:
    """Mean offset of footprints, millimetres [2].

    Args:
        view: in the frame of the face that is seen [3].
        table: mean and components of both faces, five numbers a bin.
        first: the first bin of the face.
        mean: of the coefficients over the footprint, Vector4.
    """
    types = array_types(view.x)
    flat = maximum(1 - view.z * view.z, 1e-12)
    z = maximum(view.z, MIN_VIEW_COSINE)
    slope = dr.sqrt((1 - z * z) / flat) / z
    raised = (z - MIN_VIEW_COSINE) * (1 / (1 - MIN_VIEW_COSINE))
    scale = dr.sqrt(maximum(1 - raised * raised, 0) / flat)
    around = bin_taps(types.Vector3(view.x * scale, view.y * scale, raised), PARALLAX_BINS)
    height = around.read(types.Float, table, first, 1 + PARALLAX_RANK, types.UInt32(0))
    for number in range(PARALLAX_RANK):
        part = around.read(types.Float, table, first, 1 + PARALLAX_RANK, types.UInt32(1 + number))
        height += mean[number] * part
    return types.Vector2(view.x * slope * height, view.y * slope * height)
