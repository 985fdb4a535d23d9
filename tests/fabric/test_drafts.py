"""Drafts and pictures as fabrics: their own colours and spacing, paths beside the fabric file.

Covers: fabric/write.py
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loomlight.core.errors import InputError
from loomlight.fabric import load_fabric
from loomlight.weave.named import named_weave

DATA = os.environ.get("LOOMLIGHT_DATA")

WIF = """[WIF]
Version=1.1
Date=April 20, 1997
Developers=us
Source Program=loomlight
[CONTENTS]
COLOR PALETTE=true
COLOR TABLE=true
THREADING=true
TIEUP=true
TREADLING=true
WEAVING=true
WARP=true
WEFT=true
WARP COLORS=true
WARP SPACING=true
WARP THICKNESS=true
[COLOR PALETTE]
Range=0,255
Entries=2
[COLOR TABLE]
1=255,0,0
2=0,0,255
[WEAVING]
Rising Shed=true
Treadles=2
Shafts=2
[WARP]
Threads=2
Units=centimeters
Color=1
Spacing=0.1
Thickness=0.05
[WEFT]
Threads=2
Units=centimeters
Color=2
Spacing=0.2
[WARP COLORS]
2=2
[WARP SPACING]
2=0.3
[WARP THICKNESS]
1=0.5
[THREADING]
1=1
2=2
[TIEUP]
1=1
2=2
[TREADLING]
1=1
2=2
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "drafts").mkdir()
    (tmp_path / "drafts" / "two.wif").write_text(WIF)
    picture = np.where(named_weave("twill 3/1").drawdown[::-1], 0, 255).astype(np.uint8)
    Image.fromarray(picture).save(tmp_path / "drafts" / "twill.png")
    return tmp_path


def test_a_wif_file_alone_is_a_fabric(folder: Path) -> None:
    fabric = load_fabric(folder / "drafts" / "two.wif")
    np.testing.assert_array_equal(fabric.draft.warp.colors, [[1, 0, 0], [0, 0, 1]])
    np.testing.assert_allclose(fabric.layout().warp.spacing, [1, 3])
    np.testing.assert_allclose(fabric.layout().weft.spacing, [2, 2])
    # The draft's thickness, even above the spacing: the geometry takes at most 0.995 of it.
    np.testing.assert_allclose(fabric.layout().warp.width, [5, 0.5])
    np.testing.assert_allclose(fabric.layout().weft.width, [1.6, 1.6])


def test_a_picture_alone_is_a_fabric(folder: Path) -> None:
    fabric = load_fabric(folder / "drafts" / "twill.png")
    np.testing.assert_array_equal(fabric.draft.drawdown, named_weave("twill 3/1").drawdown)


def test_paths_are_relative_to_the_fabric_file(folder: Path) -> None:
    (folder / "cloth.toml").write_text('draft = "drafts/two.wif"\nends_per_cm = 20\n[warp]\ngap = 0.5')
    fabric = load_fabric(folder / "cloth.toml")
    # Threads/cm are a mean: the draft's 1 : 3 stays.
    np.testing.assert_allclose(fabric.layout().warp.spacing, [0.25, 0.75])
    np.testing.assert_allclose(fabric.layout().warp.width, [0.125, 0.375])
    (folder / "picture.toml").write_text('image = "drafts/twill.png"')
    assert load_fabric(folder / "picture.toml").draft.ends == 4


def test_a_missing_draft_names_both_files(folder: Path) -> None:
    (folder / "cloth.toml").write_text('draft = "none.wif"')
    with pytest.raises(InputError) as caught:
        load_fabric(folder / "cloth.toml")
    assert "cloth.toml" in str(caught.value)
    assert "none.wif" in str(caught.value)


def test_text_round_trips(folder: Path) -> None:
    text = (
        'name = "a \\"cloth\\"\\u0007"\ndraft = "drafts/two.wif"\nends_per_cm = 28.5\n'
        '[warp]\ncolor = ["#123", [0.1, 0.2, 0.3]]\nspecular = 1\n[variation]\nseed = 7\n'
    )
    (folder / "cloth.toml").write_text(text)
    fabric = load_fabric(folder / "cloth.toml")
    (folder / "again.toml").write_text(fabric.to_toml())
    (folder / "deeper").mkdir()
    (folder / "deeper" / "again.toml").write_text(fabric.to_toml(folder / "deeper"))
    for path in (folder / "again.toml", folder / "deeper" / "again.toml"):
        again = load_fabric(path)
        assert again.name == fabric.name == 'a "cloth"\a'
        np.testing.assert_array_equal(again.draft.warp.colors, fabric.draft.warp.colors)
        assert again.repeat_mm == fabric.repeat_mm
        assert again.to_toml(folder) == fabric.to_toml(folder)


needs_data = pytest.mark.skipif(not DATA, reason="LOOMLIGHT_DATA does not name the folder of outside data")


@needs_data
@pytest.mark.filterwarnings("ignore::loomlight.core.errors.LoomlightWarning")
def test_drafts_of_others_are_fabrics() -> None:
    files = sorted(Path(str(DATA), "wif", "good").glob("*.wif"))
    assert files
    for path in files:
        fabric = load_fabric(path)
        assert min(fabric.repeat_mm) > 0
        assert len(fabric.appearance().warp.diffuse_reflect) == fabric.draft.ends


@needs_data
@pytest.mark.filterwarnings("ignore::loomlight.core.errors.LoomlightWarning")
def test_broken_drafts_of_others_are_refused_by_name() -> None:
    files = sorted(Path(str(DATA), "wif", "bad").glob("*.wif"))
    assert files
    for path in files:
        with pytest.raises(InputError, match=path.name):
            load_fabric(path)
