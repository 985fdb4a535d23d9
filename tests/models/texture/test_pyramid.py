"""Texels that queries of a pyramid read: against interpolation written out with NumPy.

Covers: models/texture/pyramid.py, training/layers.py
"""

from __future__ import annotations

import numpy as np
import pytest
import torch
from drjit.llvm.ad import Float, Int32

from loomlight.core.backend import array_types
from loomlight.core.llvm import require_llvm
from loomlight.models.texture.pyramid import DrjitFunctions, PyramidShape, Taps, level_taps, trilinear_taps
from loomlight.training.layers import TorchTextures

require_llvm()

SHAPE = PyramidShape(8, 4, 2.0, 1.0, 2)
TEXELS = np.random.default_rng(1).random(2 * SHAPE.texels).astype(np.float32)


def interpolated(u: float, v: float, level: int, face: int) -> float:
    columns, rows = SHAPE.sizes[level]
    first = face * SHAPE.texels + SHAPE.starts[level]
    grid = TEXELS[first : first + columns * rows].reshape(rows, columns)
    x, y = u * columns - 0.5, v * rows - 0.5
    left, low = int(np.floor(x)), int(np.floor(y))
    corners = grid[np.ix_([low % rows, (low + 1) % rows], [left % columns, (left + 1) % columns])]
    across, along = np.array([1 - x + left, x - left]), np.array([1 - y + low, y - low])
    return float(along @ corners @ across)


def fetched(taps: Taps) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    rows = [np.asarray(part) for part in taps.texels]
    return sum(np.asarray(w, np.float64) * TEXELS[row] for row, w in zip(rows, taps.weights, strict=True))  # type: ignore[return-value]


@pytest.mark.parametrize("library", ["drjit", "torch"])
def test_taps_interpolate_with_wrap_around(library: str) -> None:
    rng = np.random.default_rng(2)
    count = 50
    u, v = rng.random((2, count)).astype(np.float32)
    levels, faces = rng.integers(SHAPE.levels, size=count), rng.integers(2, size=count)
    wanted = [interpolated(*each) for each in zip(u, v, levels, faces, strict=True)]
    if library == "drjit":
        arguments = Float(u), Float(v), Int32(levels.astype(np.int32)), Int32(faces.astype(np.int32))
        functions: DrjitFunctions | TorchTextures = DrjitFunctions(array_types(Float))
    else:
        arguments = tuple(torch.from_numpy(part) for part in (u, v, levels, faces))
        functions = TorchTextures()
    x, y, level, face = arguments
    taps = level_taps(SHAPE, x, y, level, face * SHAPE.texels, functions)
    np.testing.assert_allclose(fetched(taps), wanted, atol=1e-5)
    # Halfway between two levels, the mean of both; beyond the ends, the ends.
    between = trilinear_taps(SHAPE, x, y, level + Float(0.5) if library == "drjit" else level + 0.5,
                             face * SHAPE.texels, functions)  # fmt: skip
    above = np.minimum(levels + 1, SHAPE.levels - 1)
    upper = [interpolated(*each) for each in zip(u, v, above, faces, strict=True)]
    np.testing.assert_allclose(fetched(between), (np.array(wanted) + upper) / 2, atol=1e-5)


def test_shapes() -> None:
    assert SHAPE.sizes == [(8, 4), (4, 2), (2, 1), (1, 1)]
    assert SHAPE.texels == 32 + 8 + 2 + 1
    assert PyramidShape.of((2.0, 1.1), 16, 1).sizes[0] == (16, 8)
    assert SHAPE.texel_mm == pytest.approx(0.25)
    assert PyramidShape.of((1.0, 1e-4), 8, 1).sizes[-1] == (1, 1)


@pytest.mark.parametrize("library", ["drjit", "torch"])
def test_texels_apart_are_the_nearest_ones(library: str) -> None:
    shape = PyramidShape(8, 4, 2.0, 1.0, 1, is_apart=True)
    assert (shape.levels, shape.texels) == (1, 32)
    u, v = np.random.default_rng(3).random((2, 50)).astype(np.float32)
    wanted = TEXELS[:32].reshape(4, 8)[np.int32(v * 4), np.int32(u * 8)]
    if library == "drjit":
        level, start = Int32(np.zeros(50, np.int32)), Int32(np.zeros(50, np.int32))
        taps = level_taps(shape, Float(u), Float(v), level, start, DrjitFunctions(array_types(Float)))
    else:
        none = torch.zeros(50).long()
        taps = level_taps(shape, torch.from_numpy(u), torch.from_numpy(v), none, none, TorchTextures())
    np.testing.assert_array_equal(fetched(taps), wanted)
