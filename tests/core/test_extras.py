"""Packages that only some features need."""

from __future__ import annotations

import sys
import types
from pathlib import Path

import pytest

from loomlight.core.errors import MissingDependencyError
from loomlight.core.extras import import_extra


def test_what_is_installed_is_imported() -> None:
    assert import_extra("json.decoder", "data", "It") is sys.modules["json.decoder"]


def test_what_is_not_is_named_with_the_way_to_install_it() -> None:
    with pytest.raises(MissingDependencyError) as caught:
        import_extra("no_such_package.part", "data", "Writing data sets")
    assert str(caught.value) == ("Writing data sets needs no_such_package: pip install 'loomlight[data]'.")


def test_a_broken_installation_is_not_taken_for_a_missing_one(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (tmp_path / "half_a_package.py").write_text("import no_such_package\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    with pytest.raises(ModuleNotFoundError, match="no_such_package"):
        import_extra("half_a_package", "data", "It")
    assert not isinstance(sys.modules.get("half_a_package"), types.ModuleType)
