"""The exported encoder is torch's for every shape, and what ships is what the shipped weights export.

Covers: studies/papers/chen2024/training/network.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import onnxruntime
import pytest
import torch

from loomlight.models.neural.encoded_fabric import levels_of
from loomlight.models.neural.encoding import encoder_session
from loomlight.models.neural.weights import encoder_path, read_weights, shipped_weights
from studies.papers.chen2024.training.export import encoder_model, export_encoder
from tests.helpers.neural_networks import TABLES, network, weights_of, written

PARAMETERS = np.array([0.2, 0.3, 0.5, 0.8], np.float32)


@pytest.mark.quick("field")
@pytest.mark.parametrize("name", TABLES)
def test_the_encoder_is_torchs(name: str, tmp_path: Path) -> None:
    made = network(name)
    run = encoder_session(weights_of(made, tmp_path))
    field = made.table.latent == "field"
    for picks, ends in ((2, 2), (1, 3), (12, 5), (3, 64)) if field else ((8, 8),):
        maps = np.random.default_rng(0).normal(size=(1, 7, 16 * picks, 16 * ends)).astype(np.float32)
        with torch.no_grad():
            if field:
                expected, levels = made.encoder(torch.tensor(maps[0]), torch.tensor(PARAMETERS))
                assert levels == levels_of(picks, ends)
            else:
                expected = made.encoder(torch.tensor(maps), torch.tensor(PARAMETERS)[None])
        (actual,) = run.run(None, {"maps": maps, "parameters": PARAMETERS})
        # Sums of up to 576 products in another order.
        np.testing.assert_allclose(actual, expected.numpy(), atol=1e-5 * float(expected.abs().max()))


def test_the_shipped_encoder_is_exported_from_the_shipped_weights() -> None:
    weights = shipped_weights()
    shipped = encoder_session(weights)
    again = onnxruntime.InferenceSession(encoder_model(weights), providers=["CPUExecutionProvider"])
    maps = np.random.default_rng(1).normal(size=(1, 7, 16 * 5, 16 * 4)).astype(np.float32)
    inputs = {"maps": maps, "parameters": PARAMETERS}
    # Another version of torch may order nodes in another way: sums of float32, as above.
    (expected,), (actual,) = shipped.run(None, inputs), again.run(None, inputs)
    np.testing.assert_allclose(actual, expected, atol=1e-5 * np.abs(expected).max())


def test_an_encoder_is_exported_the_same_again(tmp_path: Path) -> None:
    path = written(network("field"), tmp_path / "a.safetensors", half=True)
    first = encoder_path(path).read_bytes()
    assert export_encoder(path) == encoder_path(path)
    assert encoder_path(path).read_bytes() == first


def test_half_precision_is_kept_where_it_is_exact(tmp_path: Path) -> None:
    half, single = (
        len(read_weights(written(network("field"), tmp_path / f"{half}.safetensors", half=half)).encoder)
        for half in (True, False)
    )
    parameters = sum(values.numel() for values in network("field").encoder.parameters())
    assert single - half == pytest.approx(2 * parameters, rel=0.1)
