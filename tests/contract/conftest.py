"""What some suites need: an adapter for shaders, a variant of Mitsuba, a network that compiles quickly."""

from __future__ import annotations

import pytest

from tests.helpers.fixtures import narrow_network, narrow_weights, variant
from tests.helpers.graphics import require_graphics

__all__ = ["narrow_network", "narrow_weights", "variant"]


@pytest.fixture(scope="session")
def graphics() -> None:
    require_graphics()
