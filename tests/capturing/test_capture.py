"""A fabric file from a photograph, whole; and photographs that show no cloth are refused in a sentence.

Covers: capturing/captured.py, capturing/yarn_fit.py, capturing/tile.py, capturing/aligned.py
Covers: capturing/sheet.py, capturing/photographer.py, cli/capture.py
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import loomlight
from loomlight.capturing.captured import Captured
from loomlight.capturing.thread_grid import blurred
from loomlight.cli.main import run
from loomlight.core.colour import delta_e_2000, lab_of_linear, linear_to_srgb, parse_colour
from loomlight.core.errors import InputError
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.weave.named import named_weave
from tests.capturing.pictures import TWILL, WIDTH_MM, knitted, photographed_twill, save, woven


@pytest.fixture(scope="module")
def photo(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A photograph of a twill."""
    return photographed_twill(tmp_path_factory.mktemp("capture") / "photo.png")


@pytest.mark.slow
def test_a_photograph_becomes_its_fabric(photo: Path, tmp_path: Path) -> None:
    steps: list[tuple[int, int]] = []
    kept: list[Captured] = []
    output, sheet = tmp_path / "fabric.toml", tmp_path / "sheet.png"
    found = loomlight.capture(
        photo,
        output,
        width_mm=WIDTH_MM,
        sheet=sheet,
        report=lambda done, total: steps.append((done, total)),
        kept=kept.append,
    )
    assert found.weave == "twill 2/1 z"
    assert found.doubts == []
    # The bars of studies/accuracy/capture.py.
    for sett, true in zip(found.setts, (16, 14), strict=True):
        assert sett.value == pytest.approx(true, rel=0.02)
    fabric = load_fabric(output)
    for family, true in ((fabric.resolved.warp, "#3a5a86"), (fabric.resolved.weft, "#cfc3a8")):
        off = delta_e_2000(lab_of_linear(family.colours[0]), lab_of_linear(parse_colour(true, "color")))
        assert float(off) < 3
    # It gets better, and says how far it is.
    assert kept[-1].fit.cost <= kept[0].fit.cost
    assert steps[-1] == (100, 100)
    assert [done for done, _ in steps] == sorted(done for done, _ in steps)
    with Image.open(sheet) as drawn:
        assert min(drawn.size) > 900
    # The render shows the cloth where the photograph does.
    render, shown = linear_to_srgb(found.render()), linear_to_srgb(found.linear)
    light = np.corrcoef(render.mean(axis=-1).ravel(), shown.mean(axis=-1).ravel())[0, 1]
    assert light > 0.8
    # Each number that was fitted lies within the bounds beside it.
    lines = [line for line in output.read_text().splitlines() if line.startswith(("roughness", "specular"))]
    assert len(lines) == 4
    for line in lines:
        value, low, high = (float(text) for text in re.findall(r"\d+\.\d+|\d+", line)[:3])
        assert low < value < high
    # So does what it was woven with.
    for number, family in enumerate(
        (fabric_from_text(TWILL).resolved.warp, fabric_from_text(TWILL).resolved.weft)
    ):
        low, high = found.fit.bounds("roughness", number)
        assert low < family.roughness < high


@pytest.mark.slow
def test_the_command_says_what_it_wrote(
    photo: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "fabric.toml"
    words = ["capture", str(photo), "--width-mm", str(WIDTH_MM), "-o", str(output)]
    assert run([*words, "--weave", "twill 2/1"]) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed[0] == str(output)
    assert printed[1].startswith(f"{tmp_path / 'fabric-sheet.png'} (twill 2/1, as given; ")
    assert load_fabric(output).fields.weave == "twill 2/1"


@pytest.mark.slow
def test_an_interruption_keeps_the_last_fit(photo: Path, tmp_path: Path) -> None:
    output = tmp_path / "fabric.toml"

    def interrupt(found: Captured) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        loomlight.capture(photo, output, width_mm=WIDTH_MM, weave="twill 2/1", kept=interrupt)
    assert load_fabric(output).fields.weave == "twill 2/1"
    assert [path.name for path in tmp_path.iterdir()] == ["fabric.toml"]


PLAIN = woven(named_weave("plain").drawdown)


@pytest.mark.parametrize(
    ("picture", "said"),
    [
        (knitted(), "look all alike, as loops of a knit"),
        (np.random.default_rng(0).uniform(0.2, 0.8, (300, 300, 3)), "no threads that repeat"),
        (np.stack([blurred(channel, 14.0) for channel in np.moveaxis(PLAIN, -1, 0)], -1), "sharp"),
        (woven(named_weave("plain").drawdown, px=(4.3, 4.3), noise=0.0), "too coarse"),
        (woven(named_weave("plain").drawdown, px=(70.0, 70.0)), "no threads that repeat|step back"),
        (woven(named_weave("twill 2/2").drawdown, light=0.7), "unevenly lit"),
        (np.ones((300, 300, 3)), "overexposed"),
    ],
    ids=["knit", "noise", "blurred", "coarse", "near", "uneven", "white"],
)
def test_what_shows_no_weave_is_refused(
    picture: np.ndarray, said: str, tmp_path: Path, refused: Callable[..., str]
) -> None:
    """One sentence with what to do, and no file."""
    path = save(tmp_path / "photo.png", picture)
    sentence = refused(["capture", str(path), "--width-mm", "20", "-o", str(tmp_path / "a.toml")])
    assert any(part in sentence for part in said.split("|"))
    assert [each.name for each in tmp_path.iterdir()] == ["photo.png"]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"weave": "plian"}, 'did you mean "plain"'),
        ({"weave": "plain", "draft": "a.wif"}, "give one of them"),
        ({"draft": "a.wif"}, "a.wif does not exist"),
        ({"light": "sun"}, 'light = "sun" is unknown: write flash or window'),
        ({"width_mm": 0.0}, "width_mm = 0 is out of range"),
        ({"back": "none.png"}, "none.png does not exist"),
        ({"white": "#ff"}, "is no colour"),
    ],
)
def test_options_that_cannot_be_are_said(options: dict[str, object], said: str, tmp_path: Path) -> None:
    path = save(tmp_path / "photo.png", PLAIN)
    with pytest.raises(InputError, match=said):
        loomlight.capture(path, **{"width_mm": 20.0, **options})  # type: ignore[arg-type]
