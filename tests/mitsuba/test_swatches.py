"""Contact sheets of fabrics.

Covers: cli/pictures.py, core/contact_sheet.py
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.contact_sheet import Card, sheet_page, sheet_picture
from loomlight.core.errors import InputError
from loomlight.core.picture_settings import SwatchSettings
from loomlight.fabric.read import fabric_from_text
from loomlight.mitsuba.swatches import fabric_cards, fact_lines

SMALL = ["--size", "32", "--spp", "1", "--model", "point"]


def card(title: str, shade: int) -> Card:
    pictures = {what: np.full((64, 64, 3), shade, np.uint8) for what in ("drawdown", "draped")}
    return Card(title, ["one line", "another < line ×²"], pictures)


def test_a_sheet_shows_every_picture_whole() -> None:
    sheet = sheet_picture([card(str(shade), shade) for shade in (10, 20, 30, 40, 60)])
    for shade in (10, 20, 30, 40, 60):
        # Text has other shades: antialiased, it may hit one now and then.
        assert 2 * 64 * 64 <= (sheet == shade).all(axis=2).sum() <= 2 * 64 * 64 + 20
    assert 1 < sheet.shape[1] / sheet.shape[0] < 2.5


def test_long_titles_stay_on_their_card() -> None:
    short, long = (sheet_picture([card(title, 9)]) for title in ("A", "A very long name of cloth " * 9))
    assert short.shape == long.shape
    assert (long[:, -3:] == long[0, 0]).all()


def test_a_sheet_may_be_too_large() -> None:
    pictures = {what: np.zeros((2048, 2048, 3), np.uint8) for what in "abc"}
    with pytest.raises(InputError, match="give a smaller size"):
        sheet_picture([Card("a", [], pictures)] * 30)


def test_a_page_needs_no_other_file() -> None:
    page = sheet_page([card("Fish & <chips>", 50)], "Autumn")
    assert "Fish &amp; &lt;chips&gt;" in page
    assert "another &lt; line ×²" in page
    assert not re.search(r'(?:src|href)="(?!data:)', page)
    assert page.count('alt="') == 2


def test_facts_of_a_card() -> None:
    lines = fact_lines(fabric_from_text('weave = "twill 3/1"\n[warp]\ncount = "30 tex"\n'))
    assert lines[0].startswith("twill 3/1; 4 ends and 4 picks")
    assert "20 ends/cm of 30 tex" in lines[1]
    striped = fabric_from_text('weave = "twill 3/1"\nwarp.color = "5 #223355, 2 #ffffff"\n')
    assert fact_lines(striped)[0] == (
        "twill 3/1; 28 ends and 4 picks, 14 × 2 mm, of which the weave is 4 and 4"
    )


@pytest.mark.slow
def test_a_sheet_grows(tmp_path: Path) -> None:
    settings = SwatchSettings(size=32, model="point", spp=1, variant="llvm_ad_rgb", denoise="off")
    seen: list[list[Card]] = []
    cards = fabric_cards(["plain", "twill 2/1"], settings, tmp_path, partial=seen.append)
    assert [[each.title for each in found] for found in seen] == [[cards[0].title]]
    # What is there already is shown at once, before anything is rendered.
    fabric_cards(["plain", "satin 5/2"], settings, tmp_path, partial=seen.append)
    assert [each.title for each in seen[1]] == [cards[0].title]


def test_the_command(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("broken.toml").write_text('weave = "satin 8/2"')
    assert run(["swatches", "plain", "broken.toml", "damask 480", "-o", "a.png", *SMALL]) == 0
    captured = capsys.readouterr()
    assert captured.out.strip() == "a.png"
    assert "broken.toml" in captured.err
    assert "left out" in captured.err
    with Image.open("a.png") as sheet:
        assert np.asarray(sheet).std() > 20
    assert run(["swatches", "broken.toml", "-o", "b.html", *SMALL]) == 2
    assert run(["swatches", "plain", "-o", "b.pdf", *SMALL]) == 2
    assert run(["swatches", "plain", "-o", "b.html", "--size", "9"]) == 2
    assert not Path("b.html").exists()
