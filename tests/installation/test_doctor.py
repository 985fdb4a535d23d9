"""What the doctor says of an installation that lacks something.

Covers: cli/doctor.py, viewer/client.py
"""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError
from pathlib import Path

import pytest

from loomlight.cli import doctor
from loomlight.cli.main import run
from loomlight.realtime import slangc
from loomlight.viewer import client


def test_missing_packages_of_an_extra_are_named_with_what_they_are_for() -> None:
    found = doctor._extra("viewer", ["numpy", "no-such-package"], "the live editor")
    assert found.subject == "[viewer]"
    assert found.found.startswith("numpy 2.")
    assert found.found.endswith("; no-such-package not installed")
    assert found.remedy == "for the live editor: python -m pip install 'loomlight[viewer]'"
    assert not found.needed


def test_a_package_that_every_picture_needs_is_fatal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    packages = {name: ["numpy"] for name in ("", *doctor.EXTRAS)}
    monkeypatch.setattr(doctor, "required_packages", lambda: packages | {"": ["numpy", "no-such-package"]})
    assert run(["doctor"]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert "missing no-such-package not installed" in lines
    assert (
        "python -m pip install no-such-package"
        in lines[lines.index("missing no-such-package not installed") + 1]
    )


def test_a_folder_without_metadata_is_no_installation(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def gone() -> dict[str, list[str]]:
        raise PackageNotFoundError("loomlight")

    monkeypatch.setattr(doctor, "required_packages", gone)
    assert run(["doctor"]) == 1
    assert "only its folder is there" in capsys.readouterr().out


def test_a_wheel_without_page_and_shaders_says_how_to_get_them(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(client, "_PACKAGE", tmp_path / "lib" / "loomlight" / "viewer")
    monkeypatch.setattr(slangc, "LIBRARIES", tmp_path / "none")
    monkeypatch.setattr(slangc, "find_slangc", lambda: None)
    page, shaders = doctor._page(), next(doctor._shaders())
    assert page.found == "missing"
    assert page.remedy is not None
    assert "nodejs.org" in page.remedy
    assert shaders.found == "not compiled, and slangc is missing"
    assert shaders.remedy is not None
    assert "pip install --no-deps slangtorch" in shaders.remedy
    assert not page.needed
    assert not shaders.needed
    monkeypatch.setattr(slangc, "find_slangc", lambda: tmp_path / "slangc")
    assert [finding.found for finding in doctor._shaders()] == [
        "compiled when it is exported",
        str(tmp_path / "slangc"),
    ]
