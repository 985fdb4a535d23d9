"""The ONNX graphs against the torch module, and what is encoded, kept and refused."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import onnx
import onnxruntime
import pytest
import torch
from drjit.llvm.ad import Float

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import cache_folder
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.woven.architecture import BUNDLES
from loomlight.models.woven.encoding import clear_encodings, encode, encode_pair, shortest_repeat
from loomlight.models.woven.losses import unmapped
from loomlight.models.woven.onnx_decoder import decoder_graph
from loomlight.models.woven.onnx_encoder import encoder_graph
from loomlight.models.woven.pyramid import levels_of
from loomlight.models.woven.weights import read_weights

from .networks import TABLES, counted_runs, linear_diffuse, network, unit_vectors, weights_of, written

require_llvm()

every_shape = pytest.mark.parametrize("name", TABLES)
PARAMETERS = np.array([0.2, 0.3, 0.5, 0.8], np.float32)


def session(model: onnx.ModelProto) -> onnxruntime.InferenceSession:
    onnx.checker.check_model(model, full_check=True)
    return onnxruntime.InferenceSession(model.SerializeToString(), providers=["CPUExecutionProvider"])


@every_shape
def test_the_encoder_is_torchs(name: str, tmp_path: Path) -> None:
    made = network(name)
    run = session(encoder_graph(weights_of(made, tmp_path)))
    field = made.table.latent == "field"
    for picks, ends in ((2, 2), (1, 3), (12, 5)) if field else ((8, 8),):
        maps = np.random.default_rng(0).normal(size=(1, 7, 16 * picks, 16 * ends)).astype(np.float32)
        with torch.no_grad():
            if field:
                wanted, levels = made.encoder(torch.tensor(maps[0]), torch.tensor(PARAMETERS))
                assert levels == levels_of(picks, ends)
            else:
                wanted = made.encoder(torch.tensor(maps), torch.tensor(PARAMETERS)[None])
        (found,) = run.run(None, {"maps": maps, "parameters": PARAMETERS})
        # Sums of up to 576 products in another order.
        np.testing.assert_allclose(found, wanted.numpy(), atol=1e-5 * float(wanted.abs().max()))


@every_shape
def test_the_decoder_is_torchs(name: str, tmp_path: Path) -> None:
    made = network(name)
    run = session(decoder_graph(weights_of(made, tmp_path)))
    rng, count = np.random.default_rng(1), 3000
    latent = rng.normal(size=(count, 64)).astype(np.float32)
    place = rng.random((count, 3), np.float32)
    light, view = unit_vectors(rng, count), unit_vectors(rng, count)
    view[:, 2] = np.abs(view[:, 2])
    angles, roughness = rng.uniform(-np.pi, np.pi, (count, 2)), rng.uniform(0.05, 1, (count, 2))
    fibres = np.stack([np.cos(angles), np.sin(angles), roughness], axis=2).astype(np.float32)
    bundles = rng.uniform(0.1, 2, (count, 2, BUNDLES, 4)).astype(np.float32)
    with torch.no_grad():
        correction = None
        if made.table.bundles:
            correction = rng.normal(size=made.table.corrected_shape).astype(np.float32)
        given = latent, place, light, view, fibres, bundles, correction
        output, hole = made.decoder(*(None if part is None else torch.tensor(part) for part in given))
        wanted = unmapped(output, torch.tensor(light), linear_diffuse(made)).numpy()
    names = {given.name for given in run.get_inputs()}
    named = zip(("latent", "place", "light", "view", "fibres", "bundles", "correction"), given, strict=True)
    found, share = run.run(None, {name: values for name, values in named if name in names})
    assert wanted.max() > 1e-3
    np.testing.assert_allclose(found, wanted, atol=1e-5 * wanted.max())
    np.testing.assert_allclose(share, hole.clamp(0, 1).numpy(), atol=1e-5)


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[str]:
    """Names of the fabrics that the encoder was run for, with empty caches."""
    return counted_runs(monkeypatch, tmp_path / "cache", "_run")


def test_a_fabric_is_encoded_once(runs: list[str], tmp_path: Path) -> None:
    weights, twill = weights_of(network("field"), tmp_path), fabric_from_text("twill 2/1")
    first = encode(twill, weights, Float)
    assert encode(twill, weights, Float) is first
    clear_encodings()
    kept = encode(twill, weights, Float)
    assert len(runs) == 1
    for mine, yours in zip(first.faces, kept.faces, strict=True):
        np.testing.assert_array_equal(mine, yours)
    # Front and back of a twill 2/1 are different cloth.
    assert np.abs(first.faces[0] - first.faces[1]).max() > 1e-2


def test_what_the_encoder_sees_is_encoded_anew(runs: list[str], tmp_path: Path) -> None:
    weights = weights_of(network("field"), tmp_path)
    base = "[warp]\nroughness = {}\nheight_scale = {}\ntwist_deg = {}\ninclination_deg = {}\ncolor = '{}'"
    values = [0.3, 0.8, 0.0, 20.0, "#ff0000"]
    edits = [{}, {0: 0.4}, {1: 0.7}, {2: 10.0}, {3: 25.0}, {4: "#00ff00"}]
    for edit in edits:
        text = base.format(*(edit.get(k, value) for k, value in enumerate(values)))
        encode(fabric_from_text(f'weave = "plain"\n{text}'), weights, Float)
    # All but the colour.
    assert len(runs) == 5


def test_damaged_caches_are_made_again(runs: list[str], tmp_path: Path) -> None:
    weights, plain = weights_of(network("field"), tmp_path), fabric_from_text("plain")
    encode(plain, weights, Float)
    (file,) = cache_folder("woven").iterdir()
    file.write_bytes(file.read_bytes()[:100])
    clear_encodings()
    encode(plain, weights, Float)
    assert len(runs) == 2


def test_colours_do_not_lengthen_the_repeat() -> None:
    striped = fabric_from_text(
        'weave = "twill 2/1"\n[warp]\ncolor = ["#ff0000", "#00ff00", "#0000ff", "#000000", "#ffffff"]'
    )
    assert striped.layout().warp_on_top.shape == (3, 15)
    short = shortest_repeat(striped.layout())
    np.testing.assert_array_equal(short.warp_on_top, fabric_from_text("twill 2/1").layout().warp_on_top)
    assert short.warp.spacing.shape == (3,)


def test_large_repeats_are_refused(tmp_path: Path) -> None:
    weights = weights_of(network("field"), tmp_path)
    large = fabric_from_text('weave = "satin 67"')
    with pytest.raises(InputError, match=r'67 ends × 67 picks .* up to 64 a side: use the model "point"'):
        encode(large, weights, Float)


def test_fabrics_outside_the_box_warn(runs: list[str], tmp_path: Path) -> None:
    weights = weights_of(network("field"), tmp_path)
    odd = fabric_from_text('weave = "plain"\ngap = 0.4\noptical_depth = 3.0\n[weft]\ntwist_deg = 60')
    with pytest.warns(
        LoomlightWarning, match=r"optical_depth = 3 \(2\), .*weft.twist_deg = 60 \(-45 to 45\)"
    ):
        encode(odd, weights, Float)


@pytest.mark.parametrize(("layouts", "warned"), [("paper", True), ("varied", False)])
def test_layouts_warn_where_training_had_none(
    runs: list[str], tmp_path: Path, layouts: str, warned: bool
) -> None:
    recipe = {"data": {"layouts": layouts}}
    weights = read_weights(written(network("field"), tmp_path / "a.safetensors", recipe=recipe))
    cloth = fabric_from_text(
        'weave = "plain"\nends_per_cm = 30\npicks_per_cm = 18\n[warp]\ngap = 0.03\n[weft]\ngap = 0.5'
    )
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        encode(cloth, weights, Float)
    said = " ".join(str(warning.message) for warning in found)
    assert ("warp.gap = 0.03 (0.2)" in said) == warned
    assert ("ends per pick = 1.667 (1)" in said) == warned


def test_latents_are_mixed_on_a_common_repeat(runs: list[str], tmp_path: Path) -> None:
    weights = weights_of(network("field"), tmp_path)
    plain, twill = fabric_from_text("plain"), fabric_from_text("twill 2/1")
    one, other = encode_pair(plain, twill, weights, Float)
    assert (one.picks, one.ends) == (other.picks, other.ends) == (6, 6)
    # Laid side by side, a repeat's finest latents are its own.
    own = encode(plain, weights, Float).faces[0][: 16 * 16].reshape(16, 16, 64)
    laid = one.faces[0][: 48 * 48].reshape(48, 48, 64)
    np.testing.assert_allclose(laid, np.tile(own, (3, 3, 1)), atol=2e-3)  # half precision
    np.testing.assert_array_equal(one.mixed(other, 0.0).faces[0], one.faces[0])
    beyond = one.mixed(other, 1.5).faces[0].astype(np.float64)
    expected = 1.5 * other.faces[0].astype(np.float64) - 0.5 * one.faces[0].astype(np.float64)
    np.testing.assert_allclose(beyond, expected, atol=2e-3 * np.abs(expected).max())
    with pytest.raises(InputError, match="common repeat of 77 ends × 77 picks"):
        encode_pair(fabric_from_text("satin 7"), fabric_from_text("satin 11"), weights, Float)
