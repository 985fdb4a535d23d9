"""An adapter for the tests of this folder: a machine without one fails them with one sentence."""

from __future__ import annotations

import pytest

from loomlight.core.errors import MissingDependencyError
from loomlight.realtime.device import default_adapter
from loomlight.realtime.slangc import find_slangc


@pytest.fixture(scope="session", autouse=True)
def tools() -> None:
    """The graphics adapter and the compiler that `make` installs."""
    try:
        default_adapter()
    except MissingDependencyError as error:
        pytest.fail(str(error), pytrace=False)
    if find_slangc() is None:
        pytest.fail("slangc is missing: pip install --no-deps slangtorch", pytrace=False)
