"""Data from outside: `outside_data` of `studies/harness/study.py`."""

from __future__ import annotations

from pathlib import Path

import pytest

from loomlight.core.errors import InputError
from studies.harness.study import outside_data


def test_data_from_outside_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LOOMLIGHT_DATA", "folder")
    assert outside_data("wif", "good") == Path("folder/wif/good")
    monkeypatch.delenv("LOOMLIGHT_DATA")
    with pytest.raises(InputError, match="LOOMLIGHT_DATA"):
        outside_data("wif")
