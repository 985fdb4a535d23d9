"""Drafts and widths that no cloth can have: refused or warned of in one sentence."""

from __future__ import annotations

import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.weave import named_weave, write_wif
from loomlight.weave.wif_writer import wif_text_of


def all_on_one_side(path: Path, rising: bool) -> Path:
    """A draft whose every pick lifts (or lowers) both shafts."""
    text = wif_text_of(named_weave("plain")).replace(
        "1=1\r\n2=2\r\n\r\n[TREADLING]", "1=1,2\r\n2=1,2\r\n\r\n[TREADLING]"
    )
    path.write_text(text if rising else text.replace("Rising Shed=true", "Rising Shed=false"))
    return path


@pytest.mark.parametrize(("rising", "family"), [(True, "warp"), (False, "weft")])
def test_a_draft_that_never_interlaces_is_no_cloth(tmp_path: Path, rising: bool, family: str) -> None:
    file = all_on_one_side(tmp_path / "flat.wif", rising)
    sentence = (
        rf"flat\.wif: none of its 2 ends and 2 picks interlaces: the {family} is on top at every crossing"
    )
    with pytest.raises(InputError, match=sentence):
        load_fabric(file)
    (tmp_path / "flat.toml").write_text('draft = "flat.wif"')
    with pytest.raises(InputError, match=r"flat\.toml: none of its 2 ends"):
        load_fabric(tmp_path / "flat.toml")


@pytest.mark.parametrize("family", ["ends", "picks"])
def test_a_family_that_never_interlaces_warns(tmp_path: Path, family: str) -> None:
    drawdown = np.array([[True, False], [True, False], [True, False]])
    plain = named_weave("plain")
    draft = replace(plain, drawdown=drawdown if family == "ends" else drawdown.T)
    write_wif(draft, tmp_path / "loose.wif")
    with pytest.warns(LoomlightWarning, match=rf"loose\.wif: none of its 2 {family} interlaces") as caught:
        load_fabric(tmp_path / "loose.wif")
    assert len(caught) == 1


@pytest.mark.parametrize("line", ["width_mm = 0.45", "gap = 0", 'count = "Ne 20"', 'count = "60 tex"'])
def test_single_loose_threads_and_dense_yarns_are_silent(line: str, tmp_path: Path) -> None:
    drawdown = np.array([[True, False, False], [False, True, False]])
    write_wif(replace(named_weave("plain"), drawdown=drawdown), tmp_path / "one.wif")
    (tmp_path / "one.toml").write_text(f'draft = "one.wif"\n[warp]\n{line}\n')
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        load_fabric(tmp_path / "one.toml")


@pytest.mark.parametrize(
    ("line", "says"),
    [
        (
            "width_mm = 500",
            "width_mm = 500 is wider than a thread's spacing of 0.5 mm: 0.497 mm of it are shown",
        ),
        (
            'count = "Nm 0.5"',
            'count = "Nm 0.5", a yarn of 1.67 mm, is wider than a thread\'s spacing of 0.5 mm',
        ),
    ],
)
def test_yarns_wider_than_their_spacing_warn(line: str, says: str) -> None:
    with pytest.warns(LoomlightWarning) as caught:
        fabric = fabric_from_text(f'weave = "plain"\n[weft]\n{line}\n')
    assert len(caught) == 1
    assert f"the fabric: weft.{says}" in str(caught[0].message)
    # It is used all the same.
    assert fabric.layout().weft.open_share == pytest.approx(0.005)


def test_a_draft_of_too_many_crossings_is_refused_with_its_size(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("loomlight.fabric.resolve.MAXIMUM_CROSSINGS", 2_000_000)
    with pytest.raises(
        InputError, match=r"1500 ends and 1500 picks has 2 million crossings, and at most 2 m"
    ):
        fabric_from_text("twill 1499/1")
