"""The default variant for all tests here, and a network that compiles quickly."""

from __future__ import annotations

from pathlib import Path

import pytest

from loomlight.mitsuba import choose_variant
from loomlight.models.neural import model as neural_model
from loomlight.models.neural.encoding import clear_encodings
from loomlight.models.neural.weights import Weights
from tests.helpers.neural_networks import network, weights_of


@pytest.fixture(autouse=True, scope="session")
def _variant() -> None:
    choose_variant("llvm_ad_rgb")


@pytest.fixture(scope="session")
def narrow_weights(tmp_path_factory: pytest.TempPathFactory) -> Weights:
    return weights_of(network("field", hidden=16), tmp_path_factory.mktemp("weights"))


@pytest.fixture
def narrow_network(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, narrow_weights: Weights) -> None:
    """A narrow network of random weights in the place of the one that ships, and no encodings."""
    monkeypatch.setattr(neural_model, "shipped_weights", lambda: narrow_weights)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    clear_encodings()
