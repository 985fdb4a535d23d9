"""The default variant for all tests here, and a network that compiles quickly."""

from __future__ import annotations

import pytest

from tests.helpers.fixtures import narrow_network, narrow_weights, variant

__all__ = ["narrow_network", "narrow_weights", "variant"]


@pytest.fixture(autouse=True, scope="session")
def _variant(variant: None) -> None:
    """For all."""
