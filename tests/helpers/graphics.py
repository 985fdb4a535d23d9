"""The graphics adapter and the compiler that `make test` installs."""

from __future__ import annotations

import pytest

from loomlight.core.errors import MissingDependencyError
from loomlight.realtime.device import default_adapter
from loomlight.realtime.slangc import find_slangc


def require_graphics() -> None:
    """Fails the test with one sentence on a machine without either."""
    try:
        default_adapter()
    except MissingDependencyError as error:
        pytest.fail(str(error), pytrace=False)
    if find_slangc() is None:
        pytest.fail("slangc is missing: pip install --no-deps slangtorch", pytrace=False)
