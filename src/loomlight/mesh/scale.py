"""Millimetres of cloth a unit of uv."""

from __future__ import annotations

import numpy as np

from loomlight.mesh.cloth_mesh import ClothMesh, metric


def uv_size(mesh: ClothMesh, metres_per_unit: float = 1.0) -> tuple[float, float]:
    """Millimetres on the surface per unit of u and of v: the area-weighted RMS of |dp/du| and |dp/dv|.

    `metres_per_unit` is the length of one unit of the mesh's positions.
    """
    area, dp_du, dp_dv = metric(mesh)
    known = np.isfinite(area)
    weight = area[known] / area[known].sum()
    millimetres = 1000 * metres_per_unit
    return (
        float(np.sqrt(weight @ np.sum(dp_du[known] ** 2, axis=1))) * millimetres,
        float(np.sqrt(weight @ np.sum(dp_dv[known] ** 2, axis=1))) * millimetres,
    )
