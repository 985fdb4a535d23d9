"""Commands in the tests write no lines of progress: how many there are is a matter of the machine's load."""

from __future__ import annotations

import math

import pytest


@pytest.fixture(autouse=True)
def no_lines_of_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("loomlight.cli.progress.LINE_SECONDS", math.inf)
