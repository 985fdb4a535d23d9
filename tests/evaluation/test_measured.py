"""A fabric beside a measured BRDF: known materials, files of MERL and RGL, bad files.

Covers: evaluation/measured.py, evaluation/isotropic.py
"""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.cli.main import run
from loomlight.core.llvm import require_llvm
from loomlight.evaluation.isotropic import VIEWS, Pairs, lobes_at, mean_over_turns
from loomlight.evaluation.measured import MeasuredComparison, beside_measured, curves_svg
from loomlight.fabric import fabric_from_text
from loomlight.models.texture.queries import Btf
from tests.fuzz.merl import merl_file, rgl_file
from tests.marks import slow

require_llvm()
CLOTH = fabric_from_text('name = "Cloth <a>"\nweave = "twill 2/1"\nwarp.color = "#b03030"')
Floats = NDArray[np.float32]


class Lambert(Btf):
    """A diffuser of albedo 0.3."""

    extent = (1.0, 1.0)

    def values(self, points: Floats, lights: Floats, views: Floats, seed: tuple[int, ...]) -> Floats:
        return np.repeat(0.3 / np.pi * lights[:, 2:], 3, axis=1)


class Same(Btf):
    """The cloth itself, half as bright."""

    extent = (1.0, 1.0)

    def values(self, points: Floats, lights: Floats, views: Floats, seed: tuple[int, ...]) -> Floats:
        at, light = lobes_at(CLOTH, Pairs(lights.astype(float), views.astype(float)))
        return 0.5 * np.asarray(at.value(light)).T


@pytest.fixture(scope="module")
def beside_lambert() -> MeasuredComparison:
    return beside_measured(CLOTH, Lambert(), "lambert", pairs=64, turns=2)


def test_a_diffuser_has_flat_curves(beside_lambert: MeasuredComparison) -> None:
    found = beside_lambert
    measured = found.curves["measured"]
    np.testing.assert_allclose(measured["albedo"], 0.3, rtol=1e-4)
    np.testing.assert_allclose(measured["back"] + measured["mirror"], 0.3 / np.pi, rtol=1e-3)
    assert found.error > 0.1
    assert len(found.table.rows) == 6
    assert all(len(cells) == len(VIEWS) for cells in found.table.rows.values())


def test_the_error_is_a_logarithm_of_both() -> None:
    """Cloth beside itself at half the brightness: all ratios are 2, and errors just below ln 2."""
    found = beside_measured(CLOTH, Same(), "half", pairs=256, turns=3)
    ratio = np.array(found.curves["Cloth <a>"]["albedo"]) / found.curves["measured"]["albedo"]
    np.testing.assert_allclose(ratio, 2, rtol=1e-3)
    # The floor of 0.001 takes a little.
    assert 0.9 * np.log(2) < found.error < np.log(2)


def test_turns_average_what_has_a_direction() -> None:
    pairs = Pairs(np.array([[0.6, 0.0, 0.8]]), np.array([[0.0, 0.0, 1.0]]))
    found = mean_over_turns(lambda turned: turned.light**2, pairs, 12)
    np.testing.assert_allclose(found, [[0.18, 0.18, 0.64]], atol=1e-12)


def test_plots_are_svg_of_two_lines_each(beside_lambert: MeasuredComparison) -> None:
    root = ElementTree.fromstring(curves_svg(beside_lambert.curves))
    lines = [each for each in root if each.tag.endswith("polyline")]
    assert len(lines) == 6
    assert all(len(each.attrib["points"].split()) == len(VIEWS) for each in lines)
    assert any(each.text == "Cloth <a>" for each in root)


@pytest.mark.parametrize("name", ["brass.binary", slow("satin_rgb.bsdf")])
def test_the_command_takes_files_as_downloaded(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / name).write_bytes(rgl_file() if name.endswith("bsdf") else merl_file())
    arguments = ["compare", "plain", "--measured", str(tmp_path / name), "-o", str(tmp_path / "report")]
    assert run(arguments) == 0
    assert "f back to the light, measured" in capsys.readouterr().out
    table = json.loads((tmp_path / "report" / "table.json").read_text())
    assert table["measured"] == name
    assert table["rms"] > 0
    assert (tmp_path / "report" / "pictures" / "curves.svg").is_file()
    assert "curves.svg" in (tmp_path / "report" / "index.html").read_text()


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("a.binary", merl_file()[:1000], "truncated"),
        ("a.bsdf", rgl_file()[:20], "header cannot be read"),
        ("a.toml", b'weave = "plain"', "is no measured BRDF: give a MERL file"),
        ("a.xml", b"<nonsense", "a.xml"),
    ],
)
def test_bad_files_end_in_one_sentence_and_leave_no_report(
    name: str, content: bytes, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / name).write_bytes(content)
    arguments = ["compare", "plain", "--measured", str(tmp_path / name), "-o", str(tmp_path / "report")]
    assert run(arguments) == 2
    error = capsys.readouterr().err
    assert says in error
    assert error.count("\n") == 1
    assert not (tmp_path / "report").exists()


def test_a_folder_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("a.binary", "b.binary"):
        (tmp_path / name).write_bytes(merl_file())
    assert run(["compare", "plain", "--measured", str(tmp_path), "-o", str(tmp_path / "report")]) == 2
    assert "is a folder: give a MERL file" in capsys.readouterr().err
