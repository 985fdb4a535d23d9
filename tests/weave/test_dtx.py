"""Fiberworks files, written and read again."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import LoomlightWarning
from loomlight.weave import Draft, load_draft, named_weave, read_wif, write_dtx
from loomlight.weave.draft import Threads

from .conftest import corpus


def test_the_file_is_laid_out_as_fiberworks_does(tmp_path: Path) -> None:
    write_dtx(named_weave("twill 3/1"), tmp_path / "a.dtx")
    content = (tmp_path / "a.dtx").read_bytes()
    lines = content.decode().split("\r\n")
    assert lines[0] == "@@StartDTX"
    assert lines[-2] == "@@EndDTX"
    assert b"\n" not in content.replace(b"\r\n", b"")
    tied = lines.index("@@Tieup") + 1
    # A line a shaft, the last shaft first; a column a treadle. Pick 1 lifts shafts 1 to 3.
    assert [line[0] for line in lines[tied : tied + 4]] == ["0", "1", "1", "1"]
    assert lines[lines.index("@@Info") + 1 :][:4] == ["%%shafts 4", "%%treadles 4", "%%ends 4", "%%picks 4"]
    listed = lines[lines.index("@@Contents") + 1 : lines.index("")] or lines[lines.index("@@Contents") + 1 :]
    assert {f"@@{name}" for name in listed if name and not name.startswith("@")} >= {"@@Tieup", "@@EndDTX"}


@pytest.mark.parametrize("name", ["houndstooth", "waffle 8", "crepe", "tartan B/24 W4 B24 R2", "damask 160"])
def test_named_weaves_come_back(tmp_path: Path, name: str) -> None:
    draft = named_weave(name)
    write_dtx(draft, tmp_path / "a.dtx")
    again = load_draft(tmp_path / "a.dtx")
    np.testing.assert_array_equal(again.drawdown, draft.drawdown)
    assert again.title == draft.title
    for one, other in ((draft.warp.colors, again.warp.colors), (draft.weft.colors, again.weft.colors)):
        if one is not None:
            assert other is not None
            # Eight bits of sRGB: steps of 1/255, or less than 0.01 in linear light.
            np.testing.assert_allclose(other, one, atol=0.01)


@pytest.mark.filterwarnings("ignore::loomlight.core.errors.LoomlightWarning")
@pytest.mark.parametrize("name", ["sinking-liftplan", "both-plans", "overshot-treadled"])
def test_plans_of_every_kind_come_back(tmp_path: Path, fixtures: Path, name: str) -> None:
    draft = read_wif(fixtures / f"{name}.wif")
    write_dtx(draft, tmp_path / "a.dtx")
    again = load_draft(tmp_path / "a.dtx")
    np.testing.assert_array_equal(again.drawdown, draft.drawdown)
    assert draft.loom is not None
    assert again.loom is not None
    assert (again.loom.rising_shed, again.loom.treadling is None) == (
        draft.loom.rising_shed,
        draft.loom.treadling is None,
    )


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::loomlight.core.errors.LoomlightWarning")
@pytest.mark.parametrize("file", corpus("good"))
def test_drafts_of_other_programs_come_back(tmp_path: Path, file: Path) -> None:
    draft = read_wif(file)
    write_dtx(draft, tmp_path / "a.dtx")
    np.testing.assert_array_equal(load_draft(tmp_path / "a.dtx").drawdown, draft.drawdown)


def test_ends_on_several_shafts_get_a_plan_of_one_shaft_an_end(tmp_path: Path) -> None:
    twill = read_wif_of_two_shafts(tmp_path)
    write_dtx(twill, tmp_path / "a.dtx")
    again = load_draft(tmp_path / "a.dtx")
    np.testing.assert_array_equal(again.drawdown, twill.drawdown)
    assert again.loom is not None
    assert all(len(shafts) == 1 for shafts in again.loom.threading)


def test_threads_that_nothing_lifts_come_back_at_the_end_too(tmp_path: Path) -> None:
    """Readers take what names no shaft there for blanks, so each has a shaft, or a treadle, of its own."""
    for seed in range(20):
        picks, ends = np.random.default_rng(seed).integers(2, 30, 2)
        drawdown = np.random.default_rng(seed).random((picks, ends)) < 0.5
        drawdown[-1], drawdown[:, -1] = False, False
        drawdown[0, 0] = True
        write_dtx(Draft(drawdown), tmp_path / "a.dtx")
        np.testing.assert_array_equal(load_draft(tmp_path / "a.dtx").drawdown, drawdown)


def read_wif_of_two_shafts(folder: Path) -> Draft:
    (folder / "two.wif").write_text(
        "[WIF]\nVersion=1.1\n[WEAVING]\nShafts=2\nTreadles=2\nRising Shed=true\n[WARP]\nThreads=3\n[WEFT]\n"
        "Threads=2\n[THREADING]\n1=1\n2=2\n3=1,2\n[TIEUP]\n1=1\n2=2\n[TREADLING]\n1=1\n2=2\n"
    )
    return read_wif(folder / "two.wif")


def test_what_the_format_has_no_place_for_is_said(tmp_path: Path) -> None:
    plain = named_weave("plain")
    warp = Threads(spacing_mm=np.array([0.53, 0.8]), thickness_mm=np.array([0.3, 0.3]))
    draft = replace(plain, warp=warp, weft=Threads(spacing_mm=np.array([1.06, 1.06])))
    with pytest.warns(LoomlightWarning) as caught:
        write_dtx(draft, tmp_path / "a.dtx")
    said = sorted(str(warning.message) for warning in caught)
    assert len(said) == 2
    assert "0.8 mm of the warp is written as 1.06 mm" in said[0]
    assert "the thickness of the warp is left out" in said[1]
    again = load_draft(tmp_path / "a.dtx")
    assert again.weft.spacing_mm is not None
    np.testing.assert_allclose(again.weft.spacing_mm, 1.06)


@pytest.mark.filterwarnings("error")
def test_titles_and_notes_are_no_marks_of_the_format(tmp_path: Path) -> None:
    draft = replace(named_weave("plain"), title="@@Tieup\n%%x", notes=("@@EndDTX", "%%shafts 9", "a\nb", "ü"))
    write_dtx(draft, tmp_path / "a.dtx")
    again = load_draft(tmp_path / "a.dtx")
    assert again.title == "- @@Tieup %%x"
    assert again.notes == ("- @@EndDTX", "- %%shafts 9", "a b", "ü")
    np.testing.assert_array_equal(again.drawdown, draft.drawdown)
