"""The decoder in Dr.Jit and in ONNX Runtime against torch, on one set of queries."""

from __future__ import annotations

from dataclasses import astuple, replace
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float, UInt32

from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.evaluation.reproduce.cost import runs_layers
from loomlight.fabric import fabric_from_text
from loomlight.models.interface import Response
from loomlight.models.woven.batch import decode
from loomlight.models.woven.decoder import Decoder, decoder_of
from loomlight.models.woven.encoding import encode
from loomlight.models.woven.model import WovenModel
from loomlight.models.woven.pool import places_of

from .networks import TABLES, network, unit_vectors, weights_of
from .reference import responses

require_llvm()
COUNT = 4000
# Unequal setts and a repeat that is no power of two.
CLOTH = 'weave = "twill 2/1"\nends_per_cm = 30\npicks_per_cm = 20\n[warp]\nroughness = 0.3'


@pytest.fixture(params=[False, True], ids=["cooperative", "unrolled"])
def either_way(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> bool:
    """Both ways of computing layers: whether that is in kernels of their own."""
    if not request.param:
        monkeypatch.setattr(Decoder, "unrolls", lambda decoder, asked: False)
    return bool(request.param)


@pytest.mark.parametrize("name", [*TABLES, "field, corrected"])
def test_the_decoder_is_torchs(name: str, either_way: bool, tmp_path: Path) -> None:
    made, fabric = network(name.removesuffix(", corrected")), fabric_from_text(CLOTH)
    weights = weights_of(made, tmp_path)
    encoded = encode(fabric, weights, Float)
    if name.endswith("corrected"):
        correction = np.random.default_rng(3).normal(size=made.table.corrected_shape).astype(np.float32)
        encoded = replace(encoded, correction=correction)
    model = WovenModel(fabric, encoded, weights)
    rng = np.random.default_rng(2)
    lights, views = unit_vectors(rng, COUNT), unit_vectors(rng, COUNT)
    centres = rng.uniform(-3, 5, (COUNT, 2)) * fabric.repeat_mm
    # From a 500th of a thread to 100 threads, so that both ends of the pyramid are met.
    sides = 0.4 * np.exp(rng.uniform(np.log(0.002), np.log(100), COUNT))
    found = np.stack(answered(model, lights, views, centres, sides), 1)
    wanted = responses(made, encoded, fabric, lights, views, centres, sides)
    scale = wanted.max(axis=0)
    assert (scale > 1e-3).all()
    # Positions in float32 are off by 1e-6 of a repeat, 1e-4 of the pyramid's finest texels at worst.
    footprints = places_of(fabric.layout(), centres, sides)
    batch = decode(weights, encoded, lights, views, footprints)
    for answers in (found, batch):
        error = np.abs(answers - wanted) / scale
        assert np.percentile(error, 99.5) < 1e-5
        assert error.max() < 1e-3


def answered(
    model: WovenModel, lights: np.ndarray, views: np.ndarray, centres: np.ndarray, sides: np.ndarray
) -> list[np.ndarray]:
    response = asked(model, lights, views, centres, sides)
    dr.eval(response)
    return [part.numpy() for part in astuple(response)]


def asked(
    model: WovenModel, lights: np.ndarray, views: np.ndarray, centres: np.ndarray, sides: np.ndarray
) -> Response:
    light, view = (Array3f(np.ascontiguousarray(part.T, np.float32)) for part in (lights, views))
    centre = Array2f(np.ascontiguousarray(centres.T, np.float32))
    side = Float(sides.astype(np.float32))
    return model.evaluate(light, view, Footprint(centre, Array2f(side, 0), Array2f(0, side)))


def test_inside_a_symbolic_loop_it_is_the_same(tmp_path: Path) -> None:
    made, fabric = network("field"), fabric_from_text("plain")
    weights = weights_of(made, tmp_path)
    model = WovenModel(fabric, encode(fabric, weights, Float), weights)
    rng = np.random.default_rng(3)
    queries = (
        unit_vectors(rng, 200),
        unit_vectors(rng, 200),
        rng.uniform(0, 1, (200, 2)) * fabric.repeat_mm,
        np.full(200, 0.1),
    )

    def step(number: UInt32, total: Float) -> tuple[UInt32, Float]:
        return number + 1, total + asked(model, *queries).diffuse_warp

    _, total = dr.while_loop(
        (UInt32(0), dr.zeros(Float, 200)), lambda number, total: number < 2, step, mode="symbolic"
    )
    np.testing.assert_allclose(total.numpy(), 2 * answered(model, *queries)[0], rtol=1e-4, atol=1e-8)


def test_new_fabrics_need_no_new_kernels(either_way: bool, tmp_path: Path) -> None:
    weights = weights_of(network("field"), tmp_path)
    rng = np.random.default_rng(4)
    directions = unit_vectors(rng, 100), unit_vectors(rng, 100)
    hashes = []
    for text in ("plain", "satin 5/2"):
        fabric = fabric_from_text(text)
        model = WovenModel(fabric, encode(fabric, weights, Float), weights)
        with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
            dr.kernel_history_clear()
            answered(model, *directions, rng.uniform(0, 1, (100, 2)), np.full(100, 0.1))
            kernels = [k for k in dr.kernel_history() if k["type"] == dr.KernelType.JIT]
        of_layers = [kernel for kernel in kernels if runs_layers(kernel)]
        assert len(of_layers) == 1
        hashes.append(of_layers[0]["hash"])
    assert hashes[0] == hashes[1]


@pytest.mark.parametrize("count", [1, 1000])
def test_unrolled_layers_take_what_all_lanes_share(
    count: int, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    weights, fabric = weights_of(network("field"), tmp_path), fabric_from_text("plain")
    model = WovenModel(fabric, encode(fabric, weights, Float), weights)
    light = Array3f(np.ascontiguousarray(unit_vectors(np.random.default_rng(5), count).T))

    def answer() -> np.ndarray:
        # One footprint and view, of which parts are literals, for many lights.
        centre, edge = Array2f(0.1, dr.opaque(Float, 0.2)), dr.opaque(Float, 0.3)
        footprint = Footprint(centre, Array2f(edge, 0), Array2f(0, edge))
        response = model.evaluate(light, Array3f(0.6, 0, 0.8), footprint)
        seen = model.seen(Array3f(0.6, 0, 0.8), footprint)
        again = model.lit(seen, light, Array3f(0.6, 0, 0.8))
        # In one kernel or in two: the same operations.
        np.testing.assert_allclose(again.specular_warp, response.specular_warp, rtol=1e-5)
        assert dr.width(response) == count
        return np.stack(np.broadcast_arrays(*(part.numpy() for part in astuple(response))))

    unrolled = answer()
    monkeypatch.setattr(Decoder, "unrolls", lambda decoder, asked: False)
    assert unrolled[:4].max() > 1e-3
    # Sums of the same terms in much the same order.
    np.testing.assert_allclose(unrolled, answer(), rtol=1e-4, atol=1e-6)


def test_kernels_of_their_own_are_compiled_and_traced_once(tmp_path: Path) -> None:
    weights = weights_of(network("field"), tmp_path)
    rng, hashes = np.random.default_rng(7), set()
    decoder = decoder_of(weights, Float)
    for count, text in ((100, "plain"), (1, "satin 5/2"), (2500, "plain"), (70, "twill 2/1")):
        fabric = fabric_from_text(text)
        model = WovenModel(fabric, encode(fabric, weights, Float), weights)
        directions = unit_vectors(rng, count), unit_vectors(rng, count)
        with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
            dr.kernel_history_clear()
            answered(model, *directions, rng.uniform(0, 1, (count, 2)), np.full(count, 0.1))
            kernels = [k for k in dr.kernel_history() if k["type"] == dr.KernelType.JIT]
        hashes |= {kernel["hash"] for kernel in kernels if runs_layers(kernel)}
    assert len(hashes) == 1
    assert decoder.recordings == 1


def test_recordings_make_no_arrays_of_their_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Calls that chose their function by an array of the recording's own took another one some time later."""
    opaque, flag = dr.opaque, dr.JitFlag.FreezingScope

    def checked(*arguments: Any) -> Any:
        assert not dr.flag(flag)
        return opaque(*arguments)

    weights = weights_of(network("field"), tmp_path)
    fabric, rng = fabric_from_text("plain"), np.random.default_rng(8)
    model = WovenModel(fabric, encode(fabric, weights, Float), weights)
    decoder = decoder_of(weights, Float)
    monkeypatch.setattr(dr, "opaque", checked)
    directions = unit_vectors(rng, 50), unit_vectors(rng, 50)
    answered(model, *directions, rng.uniform(0, 1, (50, 2)), np.full(50, 0.1))
    assert decoder.recordings == 1


def test_holes_alone_are_those_of_all(either_way: bool, tmp_path: Path) -> None:
    weights, fabric = weights_of(network("field"), tmp_path), fabric_from_text("plain")
    model = WovenModel(fabric, encode(fabric, weights, Float), weights)
    rng = np.random.default_rng(6)
    view = Array3f(np.ascontiguousarray(unit_vectors(rng, 500).T))
    side = Float(rng.uniform(0.05, 0.5, 500).astype(np.float32))
    footprint = Footprint(Array2f(side, 0.1), Array2f(side, 0), Array2f(0, side))
    holes = model.hole(view, footprint).numpy()
    assert holes.std() > 1e-3
    # The same operations, in another kernel.
    np.testing.assert_allclose(holes, model.seen(view, footprint).hole.numpy(), rtol=0, atol=1e-6)


def test_derivatives_go_by_cooperative_vectors(tmp_path: Path) -> None:
    weights, fabric = weights_of(network("field"), tmp_path), fabric_from_text("plain")
    model = WovenModel(fabric, encode(fabric, weights, Float), weights)
    x = Float(0.1, 0.2, 0.3)
    dr.enable_grad(x)
    light = dr.normalize(Array3f(x, 0.2, 1))
    footprint = Footprint(Array2f(0.1, 0.2), Array2f(0.3, 0), Array2f(0, 0.3))
    dr.backward(model.evaluate(light, Array3f(0, 0, 1), footprint).diffuse_warp)
    assert (dr.grad(x).numpy() != 0).all()
