"""Fixtures of tests of Mitsuba, which the conftest.py of their folders import."""

from __future__ import annotations

from pathlib import Path

import pytest

from loomlight.mitsuba import choose_variant
from loomlight.models.neural import model as neural_model
from loomlight.models.neural.encoding import clear_encodings
from loomlight.models.neural.weights import Weights
from tests.helpers.neural_networks import network, weights_of


@pytest.fixture(scope="session")
def variant() -> None:
    """The default variant."""
    choose_variant("llvm_ad_rgb")


@pytest.fixture(scope="session")
def narrow_weights(tmp_path_factory: pytest.TempPathFactory) -> Weights:
    """Random weights of a network that compiles quickly."""
    return weights_of(network("field", hidden=16), tmp_path_factory.mktemp("weights"))


@pytest.fixture
def narrow_network(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, narrow_weights: Weights) -> None:
    """Those weights in the place of the ones that ship, and no encodings."""
    monkeypatch.setattr(neural_model, "shipped_weights", lambda: narrow_weights)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    clear_encodings()
