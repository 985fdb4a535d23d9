"""Visibility and parallax of texels: how well lobes follow horizons, and tables of heights the rays.

Covers: models/clustered/gaussians.py, models/clustered/parallax.py
"""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Array4f, Bool, Float, UInt32

from loomlight.core.llvm import require_llvm
from loomlight.models.clustered.gaussians import fitted_gaussians, lobe_value, lobe_values
from loomlight.models.clustered.parallax import PARALLAX_BINS, parallax_offset, parallax_tables
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.visibility import HorizonMap, first_hit
from studies.instruments.tabulated_visibility import unoccluded
from tests.helpers.arrays import vectors
from tests.helpers.directions import directions
from tests.helpers.layouts import TWILL, even_layout

require_llvm()


@pytest.mark.slow
def test_lobes_follow_the_horizons() -> None:
    table = HorizonMap(YarnGeometry(even_layout(TWILL)), (32, 32), Float)
    fitted = fitted_gaussians(table.sine, Float)
    # Steps that a smooth lobe stands for.
    assert max(fitted.error) < 0.09
    rng = np.random.default_rng(0)
    count = 50_000
    width, height = table.size
    column, row = rng.integers(0, 32, (2, count))
    x, y = ((part + 0.5) * extent / 32 for part, extent in ((column, width), (row, height)))
    z, azimuth = rng.uniform(0, 1, count), rng.uniform(0, 2 * math.pi, count)
    radius = np.sqrt(1 - z * z)
    light = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)
    for face in (0, 1):
        lobes = fitted.lobes[face, row, column]
        parts = [Array3f(*(Float(part) for part in lobes[:, first : first + 3].T)) for first in (0, 3, 6)]
        found = lobe_value((parts[0], parts[1], parts[2]), vectors(light)).numpy()
        visible = unoccluded(
            table, Float(x), Float(y), vectors(light), dr.full(Bool, bool(face), count)
        ).numpy()
        assert (found >= 0).all()
        assert (found <= 1).all()
        # The error reported is the one that looking up meets, within its sampling error.
        assert abs(np.abs(found - visible).mean() - fitted.error[face]) < 0.01
        assert abs(found.mean() - visible.mean()) < 0.02
    np.testing.assert_allclose(lobe_values(lobes[:9], light[0]), _one_by_one(lobes[:9], light[0]), rtol=1e-5)


def _one_by_one(lobes: np.ndarray, direction: np.ndarray) -> list[float]:
    found = []
    for c, p, q in lobes.reshape(-1, 3, 3).astype(float):
        value = max(direction @ c, 0) * math.exp(-((direction @ p) ** 2) - (direction @ q) ** 2)
        found.append(min(value, 1.0))
    return found


@pytest.mark.slow
def test_mean_offsets_are_those_of_rays() -> None:
    geometry = YarnGeometry(even_layout(TWILL))
    counts = (32, 32)
    coefficients, heights = parallax_tables(geometry, counts, Float)
    assert coefficients.dtype == np.int8
    rng = np.random.default_rng(1)
    views = directions(rng, 24)
    views[:, 2] = 0.65 + 0.35 * np.abs(views[:, 2])
    views[:, :2] *= (np.sqrt(1 - views[:, 2] ** 2) / np.linalg.norm(views[:, :2], axis=1))[:, None]
    width, height = geometry.size
    row, column = (part.ravel() for part in np.mgrid[:32, :32])
    x, y = Float((column + 0.5) * width / 32), Float((row + 0.5) * height / 32)
    for face in (0, 1):
        mean = Array4f(*coefficients[face].reshape(-1, 4).mean(axis=0).tolist())
        for view in views:
            towards = Array3f(*view.tolist())
            offset = parallax_offset(towards, Float(heights.ravel()), UInt32(face * PARALLAX_BINS**2), mean)
            hit = first_hit(geometry, x, y, towards, dr.full(Bool, bool(face), len(row)))
            moved = dr.select(hit.hole, 0, Array2f(hit.x - x, hit.y - y)).numpy().mean(axis=1)
            # Bins of 16² directions, and four components: a twentieth of a thread.
            assert np.abs(offset.numpy()[:, 0] - moved).max() < 0.05 * geometry.finest[0], (face, view)
