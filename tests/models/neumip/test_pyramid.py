"""Where queries read the pyramid, against interpolation written out, for torch and Dr.Jit alike."""

from __future__ import annotations

import numpy as np
import pytest
import torch
from drjit.llvm.ad import Float, Int32
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.llvm import require_llvm
from loomlight.models.neumip.networks import DrjitFunctions
from loomlight.models.neumip.pyramid import PyramidShape, shifted, trilinear_taps
from loomlight.models.neumip.training.network import TorchFunctions

require_llvm()

SHAPE = PyramidShape(8, 4, 2.0, 1.0, 2)


def interpolated(levels: list[NDArray[np.float64]], u: float, v: float, level: float) -> float:
    """Eq. 3 of one face, point by point."""

    def at(table: NDArray[np.float64]) -> float:
        rows, columns = table.shape
        x, y = u * columns - 0.5, v * rows - 0.5
        left, bottom = int(np.floor(x)), int(np.floor(y))
        total = 0.0
        for up in (0, 1):
            for right in (0, 1):
                weight = (1 - abs(y - bottom - up)) * (1 - abs(x - left - right))
                total += weight * table[(bottom + up) % rows, (left + right) % columns]
        return total

    level = min(max(level, 0.0), len(levels) - 1.0)
    lower = min(int(level), len(levels) - 2)
    share = level - lower
    return (1 - share) * at(levels[lower]) + share * at(levels[lower + 1])


def test_shapes() -> None:
    assert SHAPE.sizes == [(8, 4), (4, 2), (2, 1), (1, 1)]
    assert SHAPE.starts == [0, 32, 40, 42, 43]
    assert SHAPE.texel_mm == pytest.approx(0.25)
    made = PyramidShape.of((3.0, 1.0), 32, 1)
    assert (made.columns, made.rows) == (32, 8)
    assert PyramidShape.of((1.0, 1e-4), 8, 1).sizes[-1] == (1, 1)


@pytest.mark.parametrize("library", ["torch", "drjit"])
def test_taps_interpolate_with_wrap_around(library: str) -> None:
    rng = np.random.default_rng(0)
    levels = [[rng.random((rows, columns)) for columns, rows in SHAPE.sizes] for _ in range(2)]
    table = np.concatenate([level.ravel() for face in levels for level in face])
    u, v = rng.uniform(-2, 2, (2, 200)).astype(np.float32)
    level = rng.uniform(-1, 5, 200).astype(np.float32)
    face = rng.integers(2, size=200)
    if library == "torch":
        arrays = [torch.from_numpy(part) for part in (u, v, level)]
        taps = trilinear_taps(SHAPE, *arrays, torch.from_numpy(face) * SHAPE.texels, TorchFunctions())
    else:
        start = Int32((face * SHAPE.texels).astype(np.int32))
        functions = DrjitFunctions(array_types(Float))
        taps = trilinear_taps(SHAPE, Float(u), Float(v), Float(level), start, functions)
    texels, weights = (
        np.stack([np.asarray(part.numpy()) for part in parts]) for parts in (taps.texels, taps.weights)
    )
    np.testing.assert_allclose(weights.sum(axis=0), 1, atol=1e-5)
    expected = [
        interpolated(levels[face[k]], float(u[k]), float(v[k]), float(level[k])) for k in range(len(u))
    ]
    np.testing.assert_allclose((table[texels] * weights).sum(axis=0), expected, atol=2e-5)


def test_the_shift_is_a_length_and_not_a_share_of_each_side() -> None:
    """Eq. 7: on a repeat twice as wide as high, the same depth is half as many repeats across."""
    u, v = shifted(SHAPE, 0.0, 0.0, 0.1, 0.6, 0.6, 1.0)
    assert u * SHAPE.width_mm == pytest.approx(v * SHAPE.height_mm)
    assert u * SHAPE.width_mm == pytest.approx(0.06 * SHAPE.length_mm)
