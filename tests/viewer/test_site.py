"""`--export`: a folder for any web server, whole or not at all."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from loomlight.core.errors import InputError
from loomlight.viewer import client
from loomlight.viewer.client import export_site


@pytest.fixture(autouse=True)
def two_files(page: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(client, "client_folder", lambda: page)


def test_folder_holds_the_page_and_its_session(tmp_path: Path) -> None:
    for weave in ("satin 5/2", "twill 3/1"):  # the second takes the place of the first
        export_site(tmp_path / "site", weave)
    session = json.loads((tmp_path / "site" / "session.json").read_text())
    assert (session["has_python"], session["token"]) == (False, None)
    assert session["fabric"]["fields"] == {"weave": "twill 3/1"}
    assert 'content="session.json"' in (tmp_path / "site" / "index.html").read_text()
    assert (tmp_path / "site" / "assets" / "page.js").is_file()


def test_nothing_is_left_of_what_fails(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        export_site(tmp_path / "site", "missing.toml")
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "file").touch()
    with pytest.raises(InputError, match="holds other files"):
        export_site(tmp_path / "mine", "twill 3/1")
    assert [each.name for each in tmp_path.iterdir()] == ["mine"]
