"""What a training wrote is put into the package whole: weights, encoder and decoder of one network."""

from __future__ import annotations

from pathlib import Path

import onnx
import pytest

from loomlight.models.neural.weights import read_weights

torch = pytest.importorskip("torch")

from tests.helpers.neural_networks import network, written  # noqa: E402 (needs torch)
from tools.fits.neural_network import put_into_package  # noqa: E402 (needs torch)


def test_the_package_has_weights_encoder_and_decoder_of_the_training(tmp_path: Path) -> None:
    trained, package = tmp_path / "run", tmp_path / "package"
    trained.mkdir()
    package.mkdir()
    file = written(network("field", hidden=16), trained / "neural.safetensors", half=True)
    put_into_package(trained, package)
    # The encoder's file says which weights it was exported from.
    assert read_weights(package / "neural.safetensors").sha256 == read_weights(file).sha256
    onnx.checker.check_model(str(package / "neural_decoder.onnx"))
    assert sorted(path.name for path in package.iterdir()) == [
        "neural.onnx",
        "neural.safetensors",
        "neural_decoder.onnx",
    ]
