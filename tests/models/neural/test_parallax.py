"""Small footprints are read where their view ray meets yarn, large ones where it crosses the plane."""

from __future__ import annotations

from pathlib import Path

import drjit as dr
import numpy as np
import pytest

from loomlight.core.backend import array_types
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float
from loomlight.fabric import fabric_from_text
from loomlight.models.neural.encoded_fabric import NEAR_SIZES, near_weight
from loomlight.yarn.geometry import YarnGeometry

pytest.importorskip("torch")

from loomlight.models.neural.model import NeuralModel, NeuralOptions
from tests.helpers.neural_networks import network, weights_of

FABRIC = """
weave = "twill 2/2"
[warp]
gap = 0.3
[weft]
gap = 0.1
"""


def test_the_weight_falls_from_a_quarter_thread_to_two() -> None:
    sizes = np.array([0.0, 0.1, NEAR_SIZES[0], 2**-0.5, NEAR_SIZES[1], 40.0])
    np.testing.assert_allclose(near_weight(sizes), [1, 1, 1, 0.5, 0, 0], atol=1e-12)


@pytest.mark.parametrize("side", [1, -1])
def test_taps_lie_on_the_yarn_that_is_seen(side: int, tmp_path: Path) -> None:
    """The place that is read and the ray through the footprint meet at the yarn's own height."""
    fabric, weights = fabric_from_text(FABRIC), weights_of(network("field, parallax"), tmp_path)
    model = NeuralModel.for_source(fabric, NeuralOptions(weights=weights, refined=False))
    types = array_types(llvm_float())
    model.upload(types)
    rng, count = np.random.default_rng(1), 2000
    z = rng.uniform(0.3, 0.95, count)
    turn = rng.uniform(0, 2 * np.pi, count)
    slope = np.sqrt(1 - z * z) / z * np.stack([np.cos(turn), np.sin(turn)])
    view = types.Vector3(*(z * slope).astype(np.float32), (side * z).astype(np.float32))
    centre = rng.uniform(0, 5, (2, count)).astype(np.float32)

    def read(millimetres: float) -> tuple[np.ndarray, np.ndarray]:
        edges = types.Vector2(millimetres, 0), types.Vector2(0, millimetres)
        taps, _, back = model.query(view, Footprint(types.Vector2(*centre), *edges))
        assert (back.numpy() == (side < 0)).all()
        per_mm = np.array(model._threads_per_mm)[:, None]
        return np.stack([taps.x.numpy(), taps.y.numpy()]), per_mm

    far, per_mm = read(10.0)
    np.testing.assert_allclose(far, centre * per_mm, rtol=1e-5, atol=1e-5)
    near, _ = read(0.001)
    at = near / per_mm
    geometry = YarnGeometry(fabric.layout())
    surface = geometry.surface(*(types.Float(row.astype(np.float32)) for row in at), types.Bool(side < 0))
    heights = surface.height.numpy()
    # Along the ray the place says a height; rays that end at a yarn's side or pass through say others.
    along = ((at - centre) * slope).sum(0) / np.square(slope).sum(0)
    thread = 1 / per_mm.min()
    assert np.mean(np.abs(along - heights) < 0.02 * thread) > 0.8
    assert np.mean(np.abs(along) > 0.05 * thread) > 0.5


@pytest.mark.parametrize("symbolic", [False, True], ids=["evaluated", "symbolic"])
def test_small_footprints_among_large_ones_move_as_they_do_alone(symbolic: bool, tmp_path: Path) -> None:
    """On either face: from afar the search runs for the few lanes that are near."""
    fabric, weights = fabric_from_text(FABRIC), weights_of(network("field, parallax"), tmp_path)
    model = NeuralModel.for_source(fabric, NeuralOptions(weights=weights, refined=False))
    types = array_types(llvm_float())
    model.upload(types)
    rng, count = np.random.default_rng(2), 500
    x, y = rng.uniform(0, 5, (2, count)).astype(np.float32)
    z = rng.uniform(0.4, 0.9, count) * rng.choice([-1, 1], count)
    is_near = rng.random(count) < 0.1

    def places(side: np.ndarray, lanes: np.ndarray) -> np.ndarray:
        numbers = [np.sqrt(1 - z * z), 0 * z, z, side, x, y]
        inputs = [types.Float(row[lanes].astype(np.float32)) for row in numbers]

        def read(*rows: object) -> tuple[object, object]:
            view, zero = types.Vector3(*rows[:3]), types.Float(0)
            edges = types.Vector2(rows[3], zero), types.Vector2(zero, rows[3])
            taps, _, _ = model.query(view, Footprint(types.Vector2(*rows[4:]), *edges))
            return taps.x, taps.y

        if symbolic:
            # A switch between one function and itself.
            chosen = dr.zeros(types.UInt32, len(inputs[0]))
            return np.array(dr.switch(chosen, [read, lambda *rows: read(*rows)], *inputs, mode="symbolic"))
        return np.array(read(*inputs))

    every = np.full(count, True)
    mixed = places(np.where(is_near, 0.001, 10.0), every)
    alone, far = places(np.full(count, 0.001), is_near), places(np.full(count, 10.0), every)
    np.testing.assert_array_equal(mixed[:, ~is_near], far[:, ~is_near])
    # Threads; kernels of other widths may round otherwise.
    np.testing.assert_allclose(mixed[:, is_near], alone, atol=1e-5)
    assert np.abs(mixed - far)[:, is_near].max() > 0.05
