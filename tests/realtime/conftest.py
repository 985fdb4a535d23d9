"""An adapter for the tests of this folder."""

from __future__ import annotations

import pytest

from tests.helpers.graphics import require_graphics


@pytest.fixture(scope="session", autouse=True)
def graphics() -> None:
    require_graphics()
