"""Weaving information files: reading, writing, refusals and their messages.

Covers: weave/draft.py, weave/wif_reader.py, weave/wif_text.py
Covers: weave/wif_reader.py, weave/wif_writer.py
"""

import warnings
from collections.abc import Callable
from dataclasses import fields, is_dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as numpy_strategies

from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.weave import (
    Draft,
    Threads,
    named_weave,
    plan_drawdown,
    read_wif,
    weave_names,
    with_palette,
    write_wif,
)
from loomlight.weave.wif_reader import draft_of
from loomlight.weave.wif_text import UNIT_MM, decode_wif, parse_wif_text
from loomlight.weave.wif_writer import decimal_text, wif_text_of

from . import odd_drafts
from .conftest import cases

WifMaker = Callable[..., Path]


def assert_same(first: object, second: object, where: str = "draft") -> None:
    """Equality of drafts through all their fields, to the last bit."""
    if isinstance(first, np.ndarray):
        assert isinstance(second, np.ndarray), where
        assert np.array_equal(first, second), where
    elif is_dataclass(first):
        assert type(first) is type(second), where
        for item in fields(first):
            assert_same(getattr(first, item.name), getattr(second, item.name), f"{where}.{item.name}")
    else:
        assert first == second, where


def read_quietly(path: Path) -> Draft:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return read_wif(path)


def parsed(text: str) -> Draft:
    return draft_of(parse_wif_text(text, "text.wif"))


# -------------------------------------------------------------------------------------------- what is read


def test_treadled_fixture(fixtures: Path) -> None:
    draft = read_quietly(fixtures / "overshot-treadled.wif")
    expected = [  # by hand, pick 1 first: what each pick's treadles lift, over ends on 1 2 3 4 24 3 - 1
        "xx..x..x",
        "x.x..x.x",
        ".xx.xx..",
        ".x.xx...",
        "x.xxxx.x",
        "........",
        "x..xx..x",
        ".x.xx...",
        "xx..x..x",
        "x.x..x.x",
    ]
    assert ["".join("x" if up else "." for up in row) for row in draft.drawdown] == expected
    assert draft.title == "Overshot, four blocks"
    assert draft.notes == ("First line; still the first", "", "Third line = last")
    assert draft.warp.colors is not None
    assert np.allclose(draft.warp.colors[0], srgb_to_linear(np.array([85, 180, 420]) / 999))
    assert np.allclose(draft.warp.colors[[2, 4]], srgb_to_linear(np.array([700, 120, 99]) / 999))
    assert draft.weft.spacing_mm is not None
    assert np.allclose(draft.weft.spacing_mm[:4], np.array([0.05, 0.025, 0.05, 0.025]) * 25.4)
    assert np.allclose(draft.warp.thickness_mm, 0.05 * 25.4)  # thicker than the spacing, and no error
    assert draft.source is not None
    assert dict(draft.source.sections)["PRIVATE SAMPLE BOOK"][1] == ("# not a comment here", None)


def test_sinking_shed_latin1_decimal_comma_and_decipoints(fixtures: Path) -> None:
    draft = read_quietly(fixtures / "sinking-liftplan.wif")
    assert draft.title == "Köper auf drei Schäften"
    assert draft.drawdown[0].tolist() == [True, True, False, True, True, False]
    assert draft.warp.spacing_mm is not None
    assert np.allclose(draft.warp.spacing_mm, [0.5] * 5 + [1.0])
    assert np.allclose(draft.weft.spacing_mm, 16 * 25.4 / 720)
    assert draft.warp.colors is None


def test_utf16_and_both_plans(fixtures: Path) -> None:
    draft = read_quietly(fixtures / "both-plans.wif")
    assert draft.loom is not None
    assert draft.loom.treadling is not None
    assert draft.loom.liftplan is not None
    assert np.array_equal(draft.drawdown, plan_drawdown(draft.loom))


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_line_ends_and_encodings(wif: WifMaker, end: str, encoding: str) -> None:
    path = wif(TEXT="Title=Größe")
    expected = read_quietly(path)
    text = path.read_text().replace("\n", end)
    assert_same(draft_of(parse_wif_text(decode_wif(text.encode(encoding)), "x")), expected)


def test_words_before_the_first_section_and_odd_names(wif: WifMaker) -> None:
    path = wif()
    expected = read_quietly(path)
    text = (
        path.read_text()
        .replace("[COLOR TABLE]", "[color_table]")
        .replace("[THREADING]", "[Threading] ; as drawn")
    )
    path.write_text(
        "garbage = 1\n[half a section\n\n"
        + text.replace("Range", "RANGE").replace("\n2=2\n", "\n02 = 2 ;two\n")
    )
    assert_same(read_quietly(path), expected)


HEADLESS = r"draft\.wif has no section \[WIF\], which every weaving information file begins with; its other"


def test_a_missing_header_warns_once(wif: WifMaker) -> None:
    """Some programs write the keys of [WIF] without that line."""
    path = wif(CONTENTS="WARP=1")
    expected = read_quietly(path)
    text = path.read_text().replace("[WIF]\nVersion=1.1\n", "Version=1.1\nSource Program=a loom\n\n")
    path.write_text("; a comment\nwords = 1\n[half a section\n" + text)
    with pytest.warns(LoomlightWarning, match=HEADLESS) as caught:
        draft = read_wif(path)
    assert len(caught) == 1
    assert draft.source is not None
    # What stood before the first section is written again under its name.
    assert draft.source.entries[0] == ("WIF", (("Version", "1.1"), ("Source Program", "a loom")))
    assert_same(replace(draft, source=None), replace(expected, source=None))
    assert_same(parsed(wif_text_of(draft)), draft)


@pytest.mark.parametrize("first", ["WEAVING", "THREADING", "TEXT", "COLOR_TABLE"])
def test_any_section_may_come_first(wif: WifMaker, first: str) -> None:
    """Sections before [WIF], and without it, are no words to pass over."""
    expected = read_quietly(wif(TEXT="Title=Cloth"))
    sections: dict[str, str | None] = {"WIF": None, first: None}
    rest = wif(**{"TEXT": "Title=Cloth", **sections}).read_text()
    whole = wif(TEXT="Title=Cloth").read_text()
    name = first.replace("_", " ")
    body = whole.split(f"[{name}]\n")[1].split("\n[")[0]
    draft_text = f"[{name}]\n{body}\n{rest}"
    assert_same(
        parsed(draft_text.replace("[WARP]", "[WIF]\nVersion=1.1\n[WARP]")).drawdown, expected.drawdown
    )
    with pytest.warns(LoomlightWarning, match=r"has no section \[WIF\]"):
        draft = parsed(draft_text)
    assert_same(draft.drawdown, expected.drawdown)
    assert draft.title == "Cloth"


def test_scarves_of_thousands_of_picks(wif: WifMaker) -> None:
    picks = "\n".join(f"{pick}={1 + pick % 2}" for pick in range(1, 8209))
    colors = "\n".join(f"{pick}={1 + pick % 3 % 2}" for pick in range(1, 8209))
    draft = read_quietly(wif(WEFT="Threads=8208", TREADLING=picks, WEFT_COLORS=colors))
    assert draft.drawdown.shape == (8208, 4)
    assert_same(parsed(wif_text_of(draft)), draft)
    with pytest.raises(InputError, match=r"\[TREADLING\] 16385=1 is the number of a pick above 16384"):
        read_wif(wif(TREADLING=picks + "\n16385=1"))


def test_sinking_shed_inverts(wif: WifMaker) -> None:
    rising = read_quietly(wif())
    sinking = read_quietly(wif(WEAVING="Shafts=2\nTreadles=2\nRising Shed=no"))
    assert np.array_equal(rising.drawdown, ~sinking.drawdown)


def test_two_shafts_an_end_and_two_treadles_a_pick(wif: WifMaker) -> None:
    draft = read_quietly(wif(THREADING="1=1\n2=2\n3=1,2\n4=0", TREADLING="1=1\n2=1,2"))
    assert draft.drawdown.tolist() == [[True, False, True, False], [True, True, True, False]]


def test_threads_beyond_the_threading_are_placeholders(wif: WifMaker) -> None:
    draft = read_quietly(wif(WARP="Threads=40\nColor=1", WEFT="Threads=30\nColor=2"))
    assert draft.drawdown.shape == (2, 4)
    assert "Threads=40" in wif_text_of(draft)


def test_no_colours_at_all(wif: WifMaker) -> None:
    draft = read_quietly(
        wif(COLOR_TABLE=None, COLOR_PALETTE=None, WARP="Threads=4", WEFT="Threads=2"),
    )
    assert draft.warp.colors is None
    assert draft.palette is None


def test_default_colour_as_rgb_without_a_table(wif: WifMaker) -> None:
    draft = read_quietly(
        wif(COLOR_TABLE=None, COLOR_PALETTE=None, WARP="Threads=4\nColor=1,255,0,51", WEFT="Threads=2")
    )
    assert draft.warp.colors is not None
    assert np.allclose(draft.warp.colors, srgb_to_linear([1, 0, 0.2]))


@pytest.mark.parametrize("unit", ["Inches", "CENTIMETERS", "decipoints ", "cm", "Inch", "mm"])
def test_units(wif: WifMaker, unit: str) -> None:
    draft = read_quietly(wif(WARP=f"Threads=4\nColor=1\nUnits={unit}\nSpacing=0.5"))
    factor = {"i": 25.4, "c": 10.0, "d": 25.4 / 720, "m": 1.0}[unit.lower()[0]]
    assert draft.warp.spacing_mm is not None
    assert np.allclose(draft.warp.spacing_mm, 0.5 * factor)
    assert_same(parsed(wif_text_of(draft)), draft)


@pytest.mark.parametrize("content", odd_drafts.SILENT.values(), ids=odd_drafts.SILENT)
def test_what_does_not_matter_is_read_in_silence(content: bytes, tmp_path: Path) -> None:
    (tmp_path / "odd.wif").write_bytes(content)
    assert_read_as_base(read_quietly(tmp_path / "odd.wif"))


def assert_read_as_base(draft: Draft) -> None:
    """Structure, title and colours are those of the draft that odd ones are made of; and they are kept."""
    expected = parsed(odd_drafts.BASE)
    for part in ("drawdown", "warp", "weft", "title"):
        assert_same(getattr(draft, part), getattr(expected, part))
    assert_same(parsed(wif_text_of(draft)), draft)


@pytest.mark.parametrize("case", cases("a*.wif"))
@pytest.mark.filterwarnings("ignore::loomlight.core.errors.LoomlightWarning")
def test_files_of_other_programs_are_the_twill_that_they_draw(case: Path) -> None:
    draft = read_wif(case)
    assert draft.drawdown.astype(int).tolist() == [[1, 1, 0, 0], [0, 1, 1, 0], [0, 0, 1, 1], [1, 0, 0, 1]]
    assert draft.warp.color_index is not None
    assert draft.warp.color_index.tolist() == ([0, 1, 0, 0] if case.name.startswith("a08") else [0] * 4)


# --------------------------------------------------------------------------------------------- what warns


@pytest.mark.parametrize(("content", "message"), odd_drafts.WARNED.values(), ids=odd_drafts.WARNED)
def test_what_does_not_matter_is_passed_over(content: bytes, message: str, tmp_path: Path) -> None:
    (tmp_path / "odd.wif").write_bytes(content)
    with pytest.warns(LoomlightWarning) as caught:
        draft = read_wif(tmp_path / "odd.wif")
    assert [message in str(warning.message) for warning in caught] == [True]
    assert_read_as_base(draft)


def test_a_tieup_that_is_unused_may_be_wrong(wif: WifMaker) -> None:
    liftplan = wif(TREADLING=None, TIEUP="1=one", LIFTPLAN="1=1\n2=2")
    with pytest.warns(LoomlightWarning, match=r"\[TIEUP\] 1=one .*, since no pick presses a treadle\.$"):
        assert read_wif(liftplan).drawdown.shape == (2, 4)
    no_table = wif(COLOR_TABLE=None, COLOR_PALETTE="Range=255,0", WARP="Threads=4", WEFT="Threads=2")
    with pytest.warns(LoomlightWarning, match=r"\[COLOR PALETTE\] Range=255,0 is passed over, since"):
        assert read_wif(no_table).palette is None


@pytest.mark.parametrize(
    ("sections", "message"),
    [
        (
            {"WARP": "Threads=4\nColor=9", "WARP_COLORS": "1=1\n2=1\n3=2\n4=1"},
            r"\[WARP\] Color=9 is not in \[COLOR TABLE\], which holds 1 to 2; it is passed over",
        ),
        ({"LIFTPLAN": "1=1\n2=1"}, r"\[LIFTPLAN\] 2=1 differs from \[TREADLING\] 2=2"),
        ({"WEAVING": "Shafts=1\nTreadles=2"}, r"\[WEAVING\] Shafts=1 is too low: the draft uses shaft 2"),
        ({"WARP": "Threads=3\nColor=1"}, r"\[WARP\] Threads=3 is too low: \[THREADING\] goes up to 4"),
        ({"WARP": "Threads=4\nColor=1\nSpacing=0.1"}, r"\[WARP\] Units= is missing"),
        (
            {"WARP": "Threads=4\nColor=1\nUnits=cm\nSpacing=0"},
            r"\[WARP\] Spacing=0 is no length and is passed over",
        ),
        (
            {"WARP": "Threads=4\nColor=1\nUnits=cm", "WARP_SPACING": "2=0.1"},
            r"\[WARP SPACING\] 2=0.1 and the rest",
        ),
        (
            {
                "WARP": "Threads=4\nColor=1\nUnits=cm\nSpacing=.0185\nThickness=.0213",
                "WEFT": "Threads=2\nColor=1\nUnits=cm\nSpacing=.02\nThickness=.021",
            },
            r"read are 54\.1 ends/cm, 0\.185 mm apart and 0\.213 mm thick and 50 picks/cm, 0\.2 mm apart",
        ),
        ({"COLOR_PALETTE": None}, r"\[COLOR PALETTE\] Range= is missing"),
        ({"COLOR_PALETTE": "Range=0,255\nForm=HSV"}, r"\[COLOR PALETTE\] Form=HSV is not known"),
        ({"THREADING": "1=1\n2=2\n3=1\n4=2\n1=2"}, r"\[THREADING\] 1 is there twice, as '1' and as '2'"),
    ],
)
def test_oddities_warn_and_load(wif: WifMaker, sections: dict[str, str], message: str) -> None:
    with pytest.warns(LoomlightWarning, match=message):
        draft = read_wif(wif(**sections))
    assert draft.drawdown.shape == (2, 4)


def test_treadling_wins_over_a_liftplan_that_differs(wif: WifMaker) -> None:
    with pytest.warns(LoomlightWarning):
        both = read_wif(wif(LIFTPLAN="1=1\n2=1"))
    assert np.array_equal(both.drawdown, read_quietly(wif()).drawdown)


def test_the_liftplan_lifts_where_the_treadling_presses_nothing(wif: WifMaker) -> None:
    file = wif(WEFT="Threads=4", LIFTPLAN="1=1\n2=2\n3=1\n4=2")
    with pytest.warns(LoomlightWarning, match=r"\[LIFTPLAN\] 3=1 is woven, as \[TREADLING\] presses nothing"):
        draft = read_wif(file)
    two = read_quietly(wif()).drawdown
    np.testing.assert_array_equal(draft.drawdown, np.concatenate([two, two]))
    assert draft.loom is not None
    assert draft.loom.treadling is None
    assert draft.loom.liftplan == (frozenset({1}), frozenset({2})) * 2


TWO_COLOURS = {"COLOR_TABLE": "1=255,255,255\n2=0,0,0", "COLOR_PALETTE": "Range=0,255"}


def test_default_colours_that_count_from_zero(wif: WifMaker) -> None:
    none = {"WARP_COLORS": None, "WEFT_COLORS": None}
    file = wif(WARP="Threads=4\nColor=0", WEFT="Threads=2\nColor=1", **TWO_COLOURS, **none)
    with pytest.warns(
        LoomlightWarning, match=r"\[WARP\] Color=0 counts the colours of \[COLOR TABLE\] from 0"
    ):
        draft = read_wif(file)
    assert draft.warp.color_index is not None
    assert draft.weft.color_index is not None
    assert (draft.warp.color_index == 0).all()
    assert (draft.weft.color_index == 1).all()
    # 2 is no colour of a table of two that is counted from 0.
    with pytest.raises(InputError, match=r"\[WARP\] Color=0 is not in \[COLOR TABLE\]"):
        read_quietly(wif(WARP="Threads=4\nColor=0", WEFT="Threads=2\nColor=2", **TWO_COLOURS, **none))


@pytest.mark.parametrize("case", [*cases("turn4/w02*.wif"), *cases("turn4/w12*.wif")])
def test_cases_that_are_read_with_a_warning(case: Path) -> None:
    with pytest.warns(LoomlightWarning):
        draft = read_wif(case)
    np.testing.assert_array_equal(draft.drawdown, np.eye(2)[np.arange(len(draft.drawdown)) % 2])


@pytest.mark.parametrize("case", [*cases("turn4/w08*.wif"), *cases("turn4/w14*.wif")])
@pytest.mark.filterwarnings("ignore::loomlight.core.errors.LoomlightWarning")
def test_cases_that_are_refused_by_section(case: Path) -> None:
    with pytest.raises(InputError, match=r"\[THREADING\]"):
        read_wif(case)


# ------------------------------------------------------------------------------------------ what is refused


@pytest.mark.parametrize(
    ("sections", "place"),
    [
        ({"THREADING": None}, "[THREADING] is missing"),
        ({"THREADING": "1=0\n2="}, "[THREADING] puts no end on a shaft"),
        ({"THREADING": "1=one"}, "[THREADING] 1=one "),
        ({"THREADING": "1=-1"}, "[THREADING] 1=-1 "),
        ({"THREADING": "0=1"}, "[THREADING] 0=1 "),
        ({"THREADING": "16385=1"}, "[THREADING] 16385=1 is the number of an end above 16384, the highest"),
        ({"THREADING": "1=16385"}, "[THREADING] 1=16385 is no list of shafts: whole numbers from 0 to 16384"),
        ({"THREADING": "1=1e999"}, "[THREADING] 1=1e999 "),
        ({"THREADING": "1=99999999999999999999999"}, "[THREADING] 1=99999999999999999999999 "),
        ({"TIEUP": None}, "[TREADLING] 1=1 needs the section [TIEUP], which is missing"),
        ({"TIEUP": ""}, "[TREADLING] 1=1 needs the section [TIEUP], which is empty"),
        ({"TREADLING": None}, "[TIEUP] 1=1 needs the section [TREADLING], which is missing"),
        ({"TREADLING": None, "TIEUP": None}, "[LIFTPLAN] is missing"),
        ({"TREADLING": "1=1\n2=1,7"}, "[TREADLING] 2=1,7 presses treadle 7"),
        ({"WARP": "Threads=0"}, "[WARP] Threads=0 "),
        ({"WARP": "Threads=-4"}, "[WARP] Threads=-4 "),
        ({"WARP": "Threads=16385"}, "[WARP] Threads=16385 is above 16384, and at most so many can be used"),
        ({"WARP": "Threads=nan"}, "[WARP] Threads=nan "),
        ({"WEFT": "Threads=1e999"}, "[WEFT] Threads=1e999 "),
        ({"WEAVING": "Shafts=99999999"}, "[WEAVING] Shafts=99999999 "),
        ({"WEAVING": "Treadles=two"}, "[WEAVING] Treadles=two "),
        ({"WEAVING": "Rising Shed=perhaps"}, "[WEAVING] Rising Shed=perhaps "),
        ({"WARP": "Color=3"}, "[WARP] Color=3 is not in [COLOR TABLE]"),
        ({"WARP": "", "WARP_COLORS": "2=1"}, "[WARP] Color= is missing"),
        ({"WARP_COLORS": "2=3"}, "[WARP COLORS] 2=3 is not in [COLOR TABLE]"),
        ({"WEFT_COLORS": "2=0"}, "[WEFT COLORS] 2=0 is not in [COLOR TABLE]"),
        ({"WEFT_COLORS": "2=1", "COLOR_TABLE": None, "WARP": ""}, "[WEFT COLORS] 2=1 names a colour"),
        ({"COLOR_TABLE": "1=0,0,0\n2=256,0,0"}, "[COLOR TABLE] 2=256,0,0 leaves the range"),
        ({"COLOR_TABLE": "1=0,0\n2=0,0,0"}, "[COLOR TABLE] 1=0,0 "),
        ({"COLOR_TABLE": "1=0,0,0\n3=0,0,0"}, "[COLOR TABLE] lacks the colour 2"),
        ({"COLOR_PALETTE": "Range=255,0"}, "[COLOR PALETTE] Range=255,0 "),
        ({"COLOR_PALETTE": "Range=0"}, "[COLOR PALETTE] Range=0 "),
        ({"COLOR_PALETTE": None, "COLOR_TABLE": "1=0,0,0\n2=999,0,0"}, "[COLOR PALETTE] Range= is missing"),
        ({"WARP": "Color=1\nUnits=furlongs\nSpacing=1"}, "[WARP] Units=furlongs "),
        ({"WARP": "Color=1\nUnits=cm\nSpacing=-1"}, "[WARP] Spacing=-1 "),
        ({"WARP": "Color=1\nUnits=cm\nSpacing=nan"}, "[WARP] Spacing=nan "),
        ({"WARP": "Color=1\nUnits=cm\nThickness=1e999"}, "[WARP] Thickness=1e999 "),
        ({"WARP": "Color=1\nUnits=cm\nSpacing=1e-300"}, "[WARP] Spacing=1e-300 "),
        ({"WARP": "Color=1\nUnits=cm", "WARP_THICKNESS": "3=thick"}, "[WARP THICKNESS] 3=thick "),
    ],
)
def test_refusals_name_section_key_and_value(wif: WifMaker, sections: dict[str, str], place: str) -> None:
    path = wif(**sections)
    with pytest.raises(InputError) as caught:
        read_wif(path)
    message = str(caught.value)
    assert message.startswith(str(path))
    assert place in message
    assert "\n" not in message
    assert message.endswith(".")


def test_no_file_and_no_wif(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        read_wif(tmp_path / "none.wif")
    with pytest.raises(InputError, match="is a folder"):
        read_wif(tmp_path)
    (tmp_path / "other.wif").write_bytes(bytes(range(256)) * 4)
    with pytest.raises(InputError, match=r"has none of the sections of one, such as \[WIF\]"):
        read_wif(tmp_path / "other.wif")


# ------------------------------------------------------------------------------------- what is written again


@pytest.mark.parametrize("name", ["overshot-treadled", "sinking-liftplan", "both-plans"])
def test_fixtures_survive_writing(fixtures: Path, tmp_path: Path, name: str) -> None:
    draft = read_wif(fixtures / f"{name}.wif")
    write_wif(draft, tmp_path / "again.wif")
    assert_same(read_quietly(tmp_path / "again.wif"), draft)


@pytest.mark.parametrize("name", [name for name in weave_names() if not name.startswith("damask")])
def test_named_weaves_survive_writing(name: str) -> None:
    draft = named_weave(name)
    again = parsed(wif_text_of(draft))
    assert np.array_equal(again.drawdown, draft.drawdown)
    assert again.title == draft.title
    for one, other in ((again.warp, draft.warp), (again.weft, draft.weft)):
        assert_same(one.colors, other.colors)


def test_new_colours_are_written_instead_of_the_old(fixtures: Path) -> None:
    draft = with_palette(read_wif(fixtures / "overshot-treadled.wif"), [[0.5, 0.25, 0.125]], None)
    again = parsed(wif_text_of(draft))
    assert again.warp.colors is not None
    assert np.allclose(again.warp.colors, [0.5, 0.25, 0.125], atol=2e-5)
    assert draft.weft.colors is not None
    assert np.allclose(again.weft.colors, draft.weft.colors, atol=2e-5)


def test_a_changed_drawdown_gets_a_plan_of_its_own(fixtures: Path) -> None:
    draft = read_wif(fixtures / "overshot-treadled.wif")
    changed = replace(draft, drawdown=~draft.drawdown)
    assert np.array_equal(parsed(wif_text_of(changed)).drawdown, changed.drawdown)


lengths = st.floats(0.001, 900, allow_subnormal=False)


@given(
    drawdown=numpy_strategies.arrays(bool, st.tuples(st.integers(1, 12), st.integers(1, 12))),
    data=st.data(),
    title=st.text(max_size=20),
    notes=st.lists(st.text(max_size=20), max_size=3),
)
@settings(max_examples=60, deadline=None)
def test_any_draft_survives_writing(
    drawdown: np.ndarray, data: st.DataObject, title: str, notes: list[str]
) -> None:
    drawdown[0, 0] = True  # a plan must lift something
    picks, ends = drawdown.shape

    def threads(count: int) -> Threads:
        palette = np.array(data.draw(st.lists(st.tuples(*[st.integers(0, 255)] * 3), min_size=1, max_size=4)))
        index = np.array(
            data.draw(st.lists(st.integers(0, len(palette) - 1), min_size=count, max_size=count))
        )
        spacing = data.draw(st.none() | st.lists(lengths, min_size=count, max_size=count))
        return Threads(
            colors=srgb_to_linear(palette / 255)[index] if data.draw(st.booleans()) else None,
            spacing_mm=None if spacing is None else np.array(spacing),
        )

    draft = Draft(drawdown, threads(ends), threads(picks), title=title, notes=tuple(notes))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        text = wif_text_of(draft)
        again = parsed(text)
    assert np.array_equal(again.drawdown, drawdown)
    assert len(again.notes) == len(notes)
    for one, other in ((again.warp, draft.warp), (again.weft, draft.weft)):
        for name in ("colors", "spacing_mm"):
            first, second = getattr(one, name), getattr(other, name)
            assert (first is None) == (second is None)
            assert first is None or np.allclose(first, second, rtol=1e-14, atol=1e-12)
    assert_same(parsed(wif_text_of(again)), again)


@given(hundredths=st.integers(1, 10**6), unit=st.sampled_from(sorted(UNIT_MM)))
@settings(deadline=None)
def test_decimals_stay_as_they_were_written(hundredths: int, unit: str) -> None:
    written = f"{hundredths / 10**5:.5f}".rstrip("0").rstrip(".")
    length = float(written) * UNIT_MM[unit]
    assert float(decimal_text(length, UNIT_MM[unit])) * UNIT_MM[unit] == length
    assert len(decimal_text(length, UNIT_MM[unit])) <= len(written) + 4


def test_a_failed_write_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        write_wif(named_weave("plain"), tmp_path / "none" / "draft.wif")
    assert list(tmp_path.iterdir()) == []


def test_long_values_are_shortened_in_every_message(tmp_path: Path) -> None:
    file = tmp_path / "long.wif"
    file.write_text(f"[WIF]\nVersion=1.1\n[CONTENTS]\nLIFTPLAN={'1' * 5000}\n[THREADING]\n1=1\n2=2\n")
    with pytest.raises(InputError, match=r"\[CONTENTS\] says LIFTPLAN=1+…\)") as refusal:
        read_wif(file)
    assert len(str(refusal.value)) < 600
