"""Fine-tuning of the last layer: its error is lower than without, it is cached, and it can be turned off."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from drjit.llvm.ad import Float

from loomlight import fabric_from_text
from loomlight.aggregate.queries import fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.core.llvm import require_llvm
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.decoder import decode
from loomlight.models.neural.encoded_fabric import EncodedFabric, footprints_in_threads
from loomlight.models.neural.encoding import _solution, clear_encodings, encode, encode_pair
from loomlight.models.neural.model import NeuralModel
from loomlight.models.neural.weights import shipped_weights
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.neural_networks import counted_runs, network, weights_of

require_llvm()
SATIN = (
    'weave = "satin 5/2"\ngap = 0.05\n[warp]\nroughness = 0.1\ninclination_deg = 15\n[weft]\nroughness = 0.2'
)


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[str]:
    """Names of the fabrics that were fitted, with empty caches."""
    return counted_runs(monkeypatch, tmp_path / "cache", "_fine_tuned")


def _errors(fabric: Fabric, encoded: EncodedFabric) -> np.ndarray:
    """nMAE of components [4] over footprints of more than two threads, both faces, that were not fitted."""
    layout = fabric.layout()
    queries = query_set(fabric_scale(layout), 160, 16, seed=91, transmits=False, lights=40, views=40)
    slices = FabricSlices(
        YarnScattering(YarnGeometry(layout), fabric.appearance()), Float, 16, shadows="mapped"
    )
    truth = slices.box_means(queries.lights, queries.views, queries.pairs, queries.centres, queries.boxes)
    lights, views = (
        np.repeat(part[index], 16, axis=0).astype(np.float32)
        for part, index in ((queries.lights, queries.pairs[:, 0]), (queries.views, queries.pairs[:, 1]))
    )
    places = footprints_in_threads(layout, queries.centres, queries.sizes).reshape(-1, 3)
    actual = decode(shipped_weights(), encoded, lights, views, places)
    far = places[:, 2] > 2
    expected = truth.reshape(-1, 5)[far, :4]
    return np.abs(actual[far, :4] - expected).mean(0) / expected.mean(0)


@pytest.mark.slow
def test_a_layer_of_its_own_errs_less() -> None:
    fabric, weights = fabric_from_text(SATIN, folder="."), shipped_weights()
    shared = _errors(fabric, encode(fabric, weights, Float))
    own = _errors(fabric, encode(fabric, weights, Float, refined=True))
    # Highlights of the family that covers both faces in turn; 0.6 of the shared layer's when it was written.
    assert (own[2:] < 0.8 * shared[2:]).all(), (shared, own)
    # Diffuse components are the network's: ONNX Runtime multiplies other rows beside them.
    np.testing.assert_allclose(own[:2], shared[:2], rtol=1e-4)


def test_it_is_fitted_once_and_the_same_again(runs: list[str]) -> None:
    fabric, weights = fabric_from_text(SATIN, folder="."), shipped_weights()
    first = encode(fabric, weights, Float, refined=True)
    assert encode(fabric, weights, Float, refined=True) is first
    clear_encodings()
    kept = encode(fabric, weights, Float, refined=True)
    np.testing.assert_array_equal(kept.correction, first.correction)
    assert runs == [fabric.name]
    # Without, it is the layer of all fabrics; latents are the same.
    plain = encode(fabric, weights, Float)
    assert plain.correction is None
    np.testing.assert_array_equal(plain.faces[0], first.faces[0])
    assert np.abs(first.correction).max() > 0.01


def test_a_material_holds_it() -> None:
    model = NeuralModel.for_source(fabric_from_text(SATIN, folder="."))
    again = NeuralModel.from_loom(model.to_loom())
    np.testing.assert_array_equal(again.encoded.correction, model.encoded.correction)


@pytest.mark.slow
def test_layers_of_two_fabrics_are_mixed(runs: list[str]) -> None:
    satin, twill, weights = (
        fabric_from_text(SATIN, folder="."),
        fabric_from_text("twill 2/2"),
        shipped_weights(),
    )
    one, other = encode_pair(satin, twill, weights, Float, refined=True)
    assert sorted(runs) == sorted([satin.name, twill.name])
    np.testing.assert_allclose(
        one.mixed(other, 0.5).correction, 0.5 * (one.correction + other.correction), atol=1e-6
    )


def test_networks_that_mix_no_bundles_have_none(tmp_path: Path) -> None:
    weights = weights_of(network("field, no bundles"), tmp_path)
    assert encode(fabric_from_text("plain"), weights, Float, refined=True).correction is None


@pytest.mark.slow
def test_long_repeats_are_fitted_too() -> None:
    fabric = fabric_from_text("satin 33/10")
    encoded = encode(fabric, shipped_weights(), Float, refined=True)
    assert np.isfinite(encoded.correction).all()


@pytest.mark.parametrize("count", [1, 63, 64, 65, 300])
def test_systems_are_solved_as_numpy_solves_them(count: int) -> None:
    rng = np.random.default_rng(count)
    slopes, inputs, errors = (rng.normal(size=shape) for shape in ((count, 5), (count, 9), count))
    likeness = inputs @ inputs.T
    kernel = slopes @ slopes.T * likeness
    kernel += 0.003 * np.trace(kernel) / count * np.eye(count)
    expected = np.linalg.solve(kernel, errors)
    actual = _solution(slopes, likeness, errors, np.empty_like(likeness))
    # Rounding of 2e-16 times the condition number, which is below count / 0.003.
    np.testing.assert_allclose(actual, expected, atol=1e-10 * np.abs(expected).max())
