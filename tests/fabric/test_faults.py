"""Whatever is wrong with a fabric ends in one clear sentence.

Covers: fabric/read.py
"""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from loomlight.core.errors import InputError
from loomlight.fabric import fabric_from_text, load_fabric

PLAIN = 'weave = "plain"\n'

FAULTS = {
    "": "empty",
    "  \n": "empty",
    "= 3": "no valid TOML",
    "weave = ": "no valid TOML",
    PLAIN + PLAIN: "no valid TOML",
    "weave = 3": "weave = 3 cannot be used: write text in quotes",
    'weave = ""': "weave",
    'weave = "twil 3/1"': 'did you mean "twill"',
    'weave = "satin 6/2"': "satin 6/2",
    "gap = 0.2": "no weave",
    PLAIN + 'draft = "a.wif"': "keep one of them",
    PLAIN + 'image = "a.png"': "keep one of them",
    'draft = "none.wif"': "none.wif",
    'image = "none.png"': "none.png",
    'draft = "\\u0000.wif"': "draft",
    PLAIN + "gap = nan": "gap = nan cannot be used: write a number from 0 to 0.95",
    PLAIN + "gap = -inf": "gap = -inf",
    PLAIN + "gap = 1": "write a number from 0 to 0.95",
    PLAIN + "gap = true": "gap = true",
    PLAIN + "gap = " + "9" * 400: "gap = 9999",
    PLAIN + "gap = 1" + "0" * 5000: "no valid TOML",
    PLAIN + 'gap = "0.2"': 'gap = "0.2"',
    PLAIN + "gap = 2024-01-01": "gap = 2024-01-01",
    PLAIN + "gaps = 0.2": "did you mean gap",
    PLAIN + "seed = 2": "belongs under [variation]",
    PLAIN + "roughness = 0.2": "belongs under [warp] or [weft] or [sheen]",
    PLAIN + "[warp]\nends_per_cm = 3": "belongs at the top",
    PLAIN + "[warp]\ncolour = '#fff'": "did you mean color",
    PLAIN + "[wrap]\ncolor = '#fff'": "did you mean warp",
    PLAIN + "warp = 3": "warp = 3 cannot be used: it is a table",
    PLAIN + "[[warp]]\ngap = 0.1": "warp",
    PLAIN + "[warp]\ncolor = '#ffg'": 'warp.color = "#ffg" is no colour',
    PLAIN + "[warp]\ncolor = []": "warp.color = [] holds no colour",
    PLAIN + "[warp]\ncolor = ['#fff', 3]": "warp.color = 3",
    PLAIN + "[warp]\ncolor = [[0.1, 0.2]]": "warp.color",
    PLAIN + "[warp]\ncolor = [0.1, 0.2]": "warp.color",
    PLAIN + "[warp]\ncolor = [0.1, 0.2, 1.5]": "between 0 and 1",
    PLAIN + "[warp]\nroughness = 0": "warp.roughness = 0 cannot be used: write a number from 0.01 to 1",
    PLAIN + "[warp]\nheight_scale = 2.1": "warp.height_scale = 2.1",
    PLAIN + "[weft]\ninclination_deg = 81": "weft.inclination_deg = 81",
    PLAIN + "[weft]\ntwist_deg = -90": "from -89 to 89",
    PLAIN + "[weft]\nspecular = 1.0001": "weft.specular = 1.0001",
    PLAIN + "[weft]\ncount = 'some'": "weft.count",
    PLAIN + "[weft]\ncount = '0 tex'": "weft.count",
    PLAIN + "[weft]\ngap = 0.3\nwidth_mm = 0.2": "keep one of them",
    PLAIN + "[weft]\ngap = 0.3\ncount = 'some'": "weft.count",
    PLAIN + "yarn = 'wol'": 'yarn = "wol" is no kind of yarn that has a name: write "cotton"',
    PLAIN + "[warp]\nyarn = 3": "warp.yarn = 3",
    PLAIN + "[warp]\nplies = 2.5": "warp.plies = 2.5 cannot be used: write a whole number from 1 to 12",
    PLAIN + "[warp]\nply_twist_deg = 61": "from -60 to 60",
    PLAIN + "[weft]\nfibre_tilt_deg = 31": "weft.fibre_tilt_deg = 31",
    PLAIN + "[weft]\nhairiness = -0.1": "weft.hairiness = -0.1",
    PLAIN + "[weft]\nslub = 2": "weft.slub = 2",
    PLAIN + "[sheen]\nstrength = 2": "sheen.strength = 2",
    PLAIN + "[variation]\nseed = 1.5": "write a whole number from 0 to 4294967295",
    PLAIN + "[variation]\nseed = -1": "variation.seed = -1",
    PLAIN + "ends_per_cm = 20\nepi = 50": "keep one of them",
    PLAIN + "ends_per_cm = 0": "ends_per_cm = 0",
    "a = " + "[" * 3000: "nested too deeply",
}


def one_sentence(error: InputError) -> str:
    text = str(error)
    assert "\n" not in text
    assert text.endswith((".", "?", "!"))
    assert len(text) < 700
    return text


@pytest.mark.parametrize("text", FAULTS, ids=lambda text: text[:40].replace("\n", " "))
def test_a_fault_names_the_file_the_field_and_the_remedy(tmp_path: Path, text: str) -> None:
    path = tmp_path / "cloth.toml"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        load_fabric(path)
    sentence = one_sentence(caught.value)
    assert FAULTS[text] in sentence
    assert str(tmp_path) in sentence


def test_a_byte_order_mark_is_no_fault(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_bytes(b'\xef\xbb\xbfweave = "plain"\r\n')
    assert load_fabric(tmp_path / "a.toml").draft.ends == 2


@pytest.mark.parametrize("name", ["cloth.yaml", "cloth.txt", "cloth.obj", "cloth.loom"])
def test_other_suffixes_are_refused(name: str) -> None:
    with pytest.raises(InputError, match=r"fabric file \(\.toml\)"):
        load_fabric(name)


def test_a_name_is_a_path_too() -> None:
    assert load_fabric("satin 5/2").draft.ends == 5
    with pytest.raises(InputError, match="no weave"):
        load_fabric("no such thing")


@settings(max_examples=200, deadline=None)
@given(st.text(max_size=60))
def test_any_text_is_a_fabric_or_one_sentence(text: str) -> None:
    try:
        fabric_from_text(text)
    except InputError as error:
        one_sentence(error)


VALUES = st.recursive(
    st.sampled_from(["1", "-1", "0.5", "1e999", "nan", "true", '"x"', "2024-01-01", '"#123456"', "{}"]),
    lambda inner: st.lists(inner, max_size=3).map(lambda parts: "[" + ", ".join(parts) + "]"),
    max_leaves=4,
)
FIELDS = st.sampled_from(
    [
        "gap",
        "ends_per_cm",
        "name",
        "warp",
        "warp.color",
        "weft.specular",
        "sheen.strength",
        "variation.seed",
        "x.y",
    ]
)


@settings(max_examples=200, deadline=None)
@given(st.dictionaries(FIELDS, VALUES, max_size=3))
def test_any_values_are_a_fabric_or_one_sentence(values: dict[str, str]) -> None:
    try:
        fabric_from_text(PLAIN + "\n".join(f"{key} = {value}" for key, value in values.items()))
    except InputError as error:
        one_sentence(error)
