"""The decoder by SIMD kernels and by cooperative vectors against torch, on one set of queries.

Covers: models/neural/architecture.py, models/neural/codings.py, models/neural/decoder_kernel.py
Covers: models/neural/decoder.py, models/neural/model.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float, UInt32

from loomlight.aggregate.components import COMPONENTS
from loomlight.aggregate.queries import fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.simd import SimdTarget
from loomlight.fabric import fabric_from_text
from loomlight.models.neural import decoder, latent_table
from loomlight.models.neural import model as model_module
from loomlight.models.neural.decoder import Decoder, _compiled, compiled_decoder, decode, kernel_table
from loomlight.models.neural.encoded_fabric import footprints_in_threads
from loomlight.models.neural.encoding import encode
from loomlight.models.neural.model import NeuralModel
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.directions import unit_vectors
from tests.helpers.neural_networks import TABLES, network, weights_of
from tests.helpers.references.neural_decoder import responses
from tests.marks import slow

require_llvm()
COUNT = 4000
TARGETS = [SimdTarget(4, 16), slow(SimdTarget(8, 16)), slow(SimdTarget(4, 32))]
# Unequal setts and a repeat that is no power of two.
CLOTH = 'weave = "twill 2/1"\nends_per_cm = 30\npicks_per_cm = 20\n[warp]\nroughness = 0.3'


@pytest.fixture(params=[False, True], ids=["cooperative", "compiled"])
def either_way(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> bool:
    """Both ways of computing layers: SIMD kernels or cooperative vectors."""
    if not request.param:
        monkeypatch.setattr(Decoder, "uses_kernel", lambda decoder, inputs: False)
    return bool(request.param)


@pytest.mark.quick("compiled-field")
# Where small footprints are read is asked in test_parallax.py.
@pytest.mark.parametrize("name", [*(name for name in TABLES if "parallax" not in name), "field, corrected"])
def test_the_decoder_is_torchs(
    name: str, either_way: bool, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    # The reference takes one square.
    nothing = Array2f(0, 0)
    monkeypatch.setattr(model_module, "taps_of_footprint", lambda f, _: (f.spread_side, nothing, nothing))
    made, fabric = network(name.removesuffix(", corrected")), fabric_from_text(CLOTH)
    weights = weights_of(made, tmp_path)
    encoded = encode(fabric, weights, Float)
    if name.endswith("corrected"):
        correction = np.random.default_rng(3).normal(size=made.table.corrected_shape).astype(np.float32)
        encoded = replace(encoded, correction=correction)
    model = NeuralModel(fabric, encoded, weights)
    rng = np.random.default_rng(2)
    lights, views = unit_vectors(rng, COUNT), unit_vectors(rng, COUNT)
    centres = rng.uniform(-3, 5, (COUNT, 2)) * fabric.repeat_mm
    # From a 500th of a thread to 100 threads, so that both ends of the pyramid are met.
    sides = 0.4 * np.exp(rng.uniform(np.log(0.002), np.log(100), COUNT))
    actual = np.stack(answered(model, lights, views, centres, sides), 1)
    expected = responses(made, encoded, fabric, lights, views, centres, sides)
    scale = expected.max(axis=0)
    assert (scale > 1e-3).all()
    # Positions in float32 are off by 1e-6 of a repeat, 1e-4 of the pyramid's finest texels at worst.
    footprints = footprints_in_threads(fabric.layout(), centres, sides)
    batch = decode(weights, encoded, lights, views, footprints)
    for answers in (actual, batch):
        error = np.abs(answers - expected) / scale
        assert np.percentile(error, 99.5) < 1e-5
        assert error.max() < 1e-3


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_other_processors_answer_alike(
    target: SimdTarget, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    weights, fabric = weights_of(network("field"), tmp_path), fabric_from_text(CLOTH)
    correction = np.random.default_rng(3).normal(size=weights.table.corrected_shape).astype(np.float32)
    encoded = replace(encode(fabric, weights, Float), correction=correction)
    rng = np.random.default_rng(9)
    queries = unit_vectors(rng, 500), unit_vectors(rng, 500), rng.uniform(0.01, 20, (500, 3))
    expected = decode(weights, encoded, *queries)
    caches = _compiled, compiled_decoder, kernel_table
    for module in (decoder, latent_table):
        monkeypatch.setattr(module, "host_target", lambda: target)
    try:
        for cached in caches:
            cached.cache_clear()
        actual = decode(weights, encoded, *queries)
    finally:
        for cached in caches:
            cached.cache_clear()
    # Sums of the same terms, in the same order but for channels of the latents.
    np.testing.assert_allclose(actual, expected, rtol=1e-4, atol=1e-5 * expected.max())


def answered(
    model: NeuralModel, lights: np.ndarray, views: np.ndarray, centres: np.ndarray, sides: np.ndarray
) -> list[np.ndarray]:
    actual = queried(model, lights, views, centres, sides)
    dr.eval(actual)
    return [part.numpy() for part in actual]


def queried(
    model: NeuralModel, lights: np.ndarray, views: np.ndarray, centres: np.ndarray, sides: np.ndarray
) -> list[Any]:
    light, view = (Array3f(np.ascontiguousarray(part.T, np.float32)) for part in (lights, views))
    centre = Array2f(np.ascontiguousarray(centres.T, np.float32))
    side = Float(sides.astype(np.float32))
    return parts_of(model, light, view, Footprint(centre, Array2f(side, 0), Array2f(0, side)))


def parts_of(model: NeuralModel, light: Any, view: Any, footprint: Footprint) -> list[Any]:
    """The four components and the hole."""
    at = model.at(view, footprint)
    components = at.components(light)
    return [*(getattr(components, name) for name in COMPONENTS), at.hole]


@pytest.mark.slow
def test_long_footprints_are_alike_either_way(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    weights, fabric = weights_of(network("field"), tmp_path), fabric_from_text(CLOTH)
    model = NeuralModel(fabric, encode(fabric, weights, Float), weights)
    rng, count = np.random.default_rng(10), 2000
    light, view = (Array3f(np.ascontiguousarray(unit_vectors(rng, count).T)) for _ in range(2))
    edges = rng.normal(size=(2, 2, count)).astype(np.float32) * np.exp(rng.uniform(-3, 1, (2, 1, count)))
    footprint = Footprint(Array2f(rng.uniform(-3, 5, (2, count))), *(Array2f(edge) for edge in edges))

    def answer() -> np.ndarray:
        return np.stack([part.numpy() for part in parts_of(model, light, view, footprint)])

    by_kernel = answer()
    monkeypatch.setattr(Decoder, "uses_kernel", lambda decoder, inputs: False)
    expected = answer()
    error = np.abs(by_kernel - expected) / expected.max(axis=1, keepdims=True)
    # Positions of squares in float32 are off by 1e-6 of a repeat, as above.
    assert np.percentile(error, 99.5) < 1e-5
    assert error.max() < 1e-3


@pytest.mark.slow
def test_long_footprints_of_twill_err_less_in_rows_of_squares(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where squares of the same sum of variances show moiré: rows of a diagonal that are nearly as far apart
    as a footprint is long."""
    fabric = fabric_from_text("twill 4/4")
    layout, model = fabric.layout(), NeuralModel.for_source(fabric)
    queries = query_set(fabric_scale(layout), 60, 16, seed=5, transmits=False, lights=16, views=16)
    pitch = np.array(layout.size) / layout.warp_on_top.shape[::-1]
    # 2.5 threads wide, 7.5 long, along either family.
    turned = np.random.default_rng(0).random(queries.centres.shape[:2]) < 0.5
    boxes = np.where(turned[..., None], [2.5, 7.5], [7.5, 2.5]) * pitch
    slices = FabricSlices(
        YarnScattering(YarnGeometry(layout), fabric.appearance()), Float, 8, shadows="mapped"
    )
    truth = slices.box_means(queries.lights, queries.views, queries.pairs, queries.centres, boxes)
    lights, views = (
        Array3f(np.repeat(part[index], 16, axis=0).T.astype(np.float32))
        for part, index in ((queries.lights, queries.pairs[:, 0]), (queries.views, queries.pairs[:, 1]))
    )
    centre, size = (Array2f(part.reshape(-1, 2).T.astype(np.float32)) for part in (queries.centres, boxes))
    footprint = Footprint(centre, Array2f(size.x, 0), Array2f(0, size.y))

    def error() -> float:
        actual = np.stack([part.numpy() for part in parts_of(model, lights, views, footprint)[:4]], 1)
        expected = truth.reshape(-1, 5)[:, :4]
        return float(np.abs(actual - expected).sum() / expected.sum())

    rows = error()
    monkeypatch.setattr(
        Footprint, "anisotropic_taps", lambda footprint: (footprint.spread_side, Array2f(0, 0))
    )
    # 0.69 when it was written.
    assert rows < 0.85 * error()


def test_inside_a_symbolic_loop_it_is_the_same(tmp_path: Path) -> None:
    made, fabric = network("field"), fabric_from_text("plain")
    weights = weights_of(made, tmp_path)
    model = NeuralModel(fabric, encode(fabric, weights, Float), weights)
    rng = np.random.default_rng(3)
    queries = (
        unit_vectors(rng, 200),
        unit_vectors(rng, 200),
        rng.uniform(0, 1, (200, 2)) * fabric.repeat_mm,
        np.full(200, 0.1),
    )

    def step(number: UInt32, total: Float) -> tuple[UInt32, Float]:
        return number + 1, total + queried(model, *queries)[0]

    _, total = dr.while_loop(
        (UInt32(0), dr.zeros(Float, 200)), lambda number, total: number < 2, step, mode="symbolic"
    )
    np.testing.assert_allclose(total.numpy(), 2 * answered(model, *queries)[0], rtol=1e-4, atol=1e-8)


def test_new_fabrics_need_no_new_code(tmp_path: Path) -> None:
    weights = weights_of(network("field"), tmp_path)
    rng = np.random.default_rng(4)
    misses = []
    for text in ("plain", "satin 5/2", "twill 2/1"):
        fabric = fabric_from_text(text)
        model = NeuralModel(fabric, encode(fabric, weights, Float), weights)
        directions = unit_vectors(rng, 100), unit_vectors(rng, 100)
        answered(model, *directions, rng.uniform(0, 1, (100, 2)), np.full(100, 0.1))
        misses.append(_compiled.cache_info().misses)
    assert misses[0] == misses[-1]


@pytest.mark.quick("1000")
@pytest.mark.parametrize("count", [1, 1000])
def test_kernels_take_inputs_of_width_one(
    count: int, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    weights, fabric = weights_of(network("field"), tmp_path), fabric_from_text("plain")
    model = NeuralModel(fabric, encode(fabric, weights, Float), weights)
    light = Array3f(np.ascontiguousarray(unit_vectors(np.random.default_rng(5), count).T))

    def answer() -> np.ndarray:
        # One footprint and view, of which parts are literals, for many lights.
        centre, edge = Array2f(0.1, dr.opaque(Float, 0.2)), dr.opaque(Float, 0.3)
        footprint = Footprint(centre, Array2f(edge, 0), Array2f(0, edge))
        actual = parts_of(model, light, Array3f(0.6, 0, 0.8), footprint)
        assert dr.width(actual) == count
        return np.stack(np.broadcast_arrays(*(part.numpy() for part in actual)))

    by_kernel = answer()
    monkeypatch.setattr(Decoder, "uses_kernel", lambda decoder, inputs: False)
    assert by_kernel[:4].max() > 1e-3
    # Sums of the same terms in much the same order.
    np.testing.assert_allclose(by_kernel, answer(), rtol=1e-4, atol=1e-6)


def test_queries_that_are_still_computed_are_waited_for(tmp_path: Path) -> None:
    weights, fabric = weights_of(network("field"), tmp_path), fabric_from_text("plain")
    model = NeuralModel(fabric, encode(fabric, weights, Float), weights)
    rng, count = np.random.default_rng(8), 1 << 18
    light = Array3f(np.ascontiguousarray(unit_vectors(rng, count).T))
    footprint = Footprint(Array2f(0.1, 0.2), Array2f(0.3, 0), Array2f(0, 0.3))
    expected = parts_of(model, light, Array3f(0.6, 0, 0.8), footprint)[0].numpy()
    # Launched, and far from done, when the answers are asked for.
    slow = light.x
    for _ in range(200):
        slow = dr.sin(slow)
    dr.eval(slow)
    turned = Array3f(light.x + 0 * slow, light.y, light.z)
    actual = parts_of(model, turned, Array3f(0.6, 0, 0.8), footprint)[0]
    later = actual + 0
    dr.eval(later)
    np.testing.assert_array_equal(later.numpy(), expected)


@pytest.mark.quick("compiled")
def test_holes_alone_are_those_of_all(either_way: bool, tmp_path: Path) -> None:
    weights, fabric = weights_of(network("field"), tmp_path), fabric_from_text("plain")
    model = NeuralModel(fabric, encode(fabric, weights, Float), weights)
    rng = np.random.default_rng(6)
    view = Array3f(np.ascontiguousarray(unit_vectors(rng, 500).T))
    side = Float(rng.uniform(0.05, 0.5, 500).astype(np.float32))
    footprint = Footprint(Array2f(side, 0.1), Array2f(side, 0), Array2f(0, side))
    holes = model.at(view, footprint).hole.numpy()
    assert holes.std() > 1e-3
    # The same operations, among others.
    at = model.at(view, footprint)
    at.components(view)
    np.testing.assert_allclose(holes, at.hole.numpy(), rtol=0, atol=1e-6)


def test_derivatives_go_by_cooperative_vectors(tmp_path: Path) -> None:
    weights, fabric = weights_of(network("field"), tmp_path), fabric_from_text("plain")
    model = NeuralModel(fabric, encode(fabric, weights, Float), weights)
    x = Float(0.1, 0.2, 0.3)
    dr.enable_grad(x)
    light = dr.normalize(Array3f(x, 0.2, 1))
    footprint = Footprint(Array2f(0.1, 0.2), Array2f(0.3, 0), Array2f(0, 0.3))
    dr.backward(parts_of(model, light, Array3f(0, 0, 1), footprint)[0])
    assert (dr.grad(x).numpy() != 0).all()
