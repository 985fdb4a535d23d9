"""Fabric files whose image is an artwork: `[weaves]` and `[artwork]`."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import edited_fabric, fabric_from_text, load_fabric
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom
from loomlight.weave import named_weave, write_wif

TWO = 'image = "art.png"\n[weaves]\n"#C00000" = "satin 8/3"\n"#fff" = "sateen 8/3"\n'
BROCADE = """
image = "art.png"
ends_per_cm = 30
picks_per_cm = 24
[weft]
color = ["#efe7d6", "#c08020"]
[weaves]
"#c00000" = ["plain", "sateen 8/3"]
"#ffffff" = ["plain", "back"]
[artwork]
regulator = 2
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with an artwork of 16 x 24 pixels: a red square on white."""
    pixels = np.full((24, 16, 3), 255, np.uint8)
    pixels[8:16, 4:12] = 192, 0, 0
    Image.fromarray(pixels).save(tmp_path / "art.png")
    return tmp_path


def test_colours_are_weaves(folder: Path) -> None:
    (folder / "cloth.toml").write_text(TWO)
    fabric = load_fabric(folder / "cloth.toml")
    assert (fabric.draft.ends, fabric.draft.picks) == (16, 24)
    inside, outside = named_weave("satin 8/3").drawdown, named_weave("sateen 8/3").drawdown
    np.testing.assert_array_equal(fabric.draft.drawdown[8:16, 4:12], np.tile(inside, (1, 2))[:, 4:12])
    np.testing.assert_array_equal(fabric.draft.drawdown[:8, :8], outside)


def test_a_weave_may_be_a_draft_file(folder: Path) -> None:
    (folder / "weaves").mkdir()
    write_wif(named_weave("satin 8/3"), folder / "weaves" / "s.wif")
    with_file = TWO.replace('"satin 8/3"', '"weaves/s.wif"')
    np.testing.assert_array_equal(
        fabric_from_text(with_file, folder).draft.drawdown, fabric_from_text(TWO, folder).draft.drawdown
    )


def test_colours_of_wefts_are_listed_in_their_order(folder: Path) -> None:
    draft = fabric_from_text(BROCADE, folder).draft
    assert draft.picks == 24 + 8
    assert draft.weft.colors is not None
    extra = draft.weft.colors[:, 2] < 0.1  # of gold, blue is low
    assert extra.tolist() == [False] * 8 + [False, True] * 8 + [False] * 8


def test_picks_per_cm_are_those_that_take_up_cloth(folder: Path) -> None:
    fabric = fabric_from_text(BROCADE, folder)
    for picks_per_cm, each in ((24, fabric), (12, edited_fabric(fabric, {"picks_per_cm": 12}))):
        assert each.repeat_mm[1] == pytest.approx(24 / picks_per_cm * 10)
        spacing = each.layout().weft.spacing
        assert spacing[0] == pytest.approx(10 / picks_per_cm)
        assert spacing[9] == pytest.approx(5 / picks_per_cm)
    # Without a sett in the file cloth is square.
    square = fabric_from_text(BROCADE.replace("picks_per_cm = 24\n", ""), folder)
    assert square.repeat_mm == pytest.approx((16 / 3, 8))


def same(one: Fabric, other: Fabric) -> None:
    np.testing.assert_array_equal(one.draft.drawdown, other.draft.drawdown)
    np.testing.assert_array_equal(one.draft.weft.colors, other.draft.weft.colors)
    assert one.repeat_mm == other.repeat_mm


@pytest.mark.parametrize("text", [TWO, BROCADE])
def test_it_is_written_and_read_again(folder: Path, tmp_path: Path, text: str) -> None:
    fabric = fabric_from_text(text, folder)
    (folder / "again.toml").write_text(fabric.to_toml(folder))
    same(load_fabric(folder / "again.toml"), fabric)
    (folder / "below").mkdir()
    (folder / "below" / "cloth.toml").write_text(fabric.to_toml(folder / "below"))
    same(load_fabric(folder / "below" / "cloth.toml"), fabric)
    write_loom(tmp_path / "a.loom", LoomFile("point", fabric))
    (folder / "art.png").unlink()
    loom = read_loom(tmp_path / "a.loom").source
    assert isinstance(loom, Fabric)
    same(loom, fabric)
    same(edited_fabric(loom, {"warp.roughness": 0.2}), fabric)


def test_edits_weave_the_artwork_anew_or_leave_it(folder: Path) -> None:
    fabric = fabric_from_text(TWO, folder)
    twill = edited_fabric(fabric, {"weaves": {"#c00000": "twill 3/1", "#ffffff": "sateen 8/3"}})
    assert not np.array_equal(twill.draft.drawdown, fabric.draft.drawdown)
    assert edited_fabric(fabric, {"weave": "plain"}).fields.weaves == {}
    tight = edited_fabric(fabric, {"artwork.longest_float": 8})
    assert tight.fields.artwork.longest_float == 8
    np.testing.assert_array_equal(
        edited_fabric(fabric, {"ends_per_cm": 30}).draft.drawdown, fabric.draft.drawdown
    )


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (TWO.replace("art.png", "no.png"), r'image = "no\.png" names no draft: .*no\.png does not exist'),
        (TWO.replace("satin 8/3", "satan 8/3"), r'weaves\."#c00000": .*satan'),
        (TWO.replace("satin 8/3", "a.wif"), r'weaves\."#c00000" = "a\.wif" names no draft'),
        (TWO.replace('"#fff" = "sateen 8/3"\n', ""), r'320 pixels of "#ffffff"; weaves names no such colour'),
        (TWO.replace("#fff", "white"), r'weaves\."white" is no colour of a picture: write it as "#c00000"'),
        (TWO + '"#ffffff" = "plain"\n', r'weaves\."#ffffff" is there twice'),
        (TWO.replace('"sateen 8/3"', "8"), r'weaves\."#fff" names no weave: write one in quotes'),
        (TWO.replace('"sateen 8/3"', "[]"), r'weaves\."#fff" lists 0 weaves'),
        (
            TWO.replace('"sateen 8/3"', '["plain", "back"]'),
            r'weaves\."#fff" has 2 weaves and "#c00000" 1: each colour has one a weft',
        ),
        (TWO.replace("image", "draft"), r'weaves say what the colours of an artwork are: write image = "'),
        ('weave = "plain"\n[artwork]\nlongest_float = 5\n', r"\[artwork\] says how \[weaves\] are woven"),
        (TWO + "[artwork]\nlongest_float = 1\n", r"artwork\.longest_float = 1 .* from 2 to 16384"),
        (TWO + '[artwork]\norder = "a"\n', r'artwork\.order "a" is not understood'),
        (TWO + '[artwork]\norder = "1 2"\n', r'artwork\.order = "1 2" does not fit 1 weft'),
        (
            TWO + "[artwork]\nlongest = 9\n",
            r"longest.* is no field that \[artwork\] has: did you mean longest_float",
        ),
        ('image = "art.png"\nweaves = "satin"\n', r"weaves is no table"),
    ],
)
def test_faults_are_sentences(folder: Path, text: str, says: str) -> None:
    with pytest.raises(InputError, match=says) as caught:
        fabric_from_text(text, folder)
    assert "\n" not in str(caught.value)


def test_too_many_colours_are_refused(folder: Path) -> None:
    many = "\n".join(f'"#{number:06x}" = "plain"' for number in range(256))
    with pytest.raises(InputError, match=r"weaves has 256 colours; an artwork has at most 255"):
        fabric_from_text(f'image = "art.png"\n[weaves]\n{many}\n', folder)
