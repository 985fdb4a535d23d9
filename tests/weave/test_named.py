"""Named weaves: their structures, and messages for unknown names.

Covers: weave/named.py, weave/structures.py
"""

from math import gcd

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from loomlight.core.errors import InputError
from loomlight.weave import longest_floats, named_weave, unbound_threads, weave_names

counts = st.integers(1, 9)


def picture(text: str) -> list[str]:
    """Rows from the top pick to the first, x where the warp is up."""
    return ["".join("x" if up else "." for up in row) for row in named_weave(text).drawdown[::-1]]


def test_structures_drawn_by_hand() -> None:
    assert picture("plain") == [".x", "x."]
    assert picture("twill 2/1") == ["x.x", ".xx", "xx."]
    assert picture("twill 3/1 s") == [".xxx", "x.xx", "xx.x", "xxx."]
    assert picture("sateen 5/2") == ["...x.", ".x...", "....x", "..x..", "x...."]
    assert picture("basket 2/2") == ["..xx", "..xx", "xx..", "xx.."]
    assert picture("warp rib 2/2") == [".x", ".x", "x.", "x."]
    assert picture("weft rib 2/2") == ["xx..", "..xx"]
    assert picture("herringbone 2/2 4") == ["x..x.xx.", "..xx..xx", ".xx.x..x", "xx..xx.."]


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("Tabby", "plain"),
        ("  TWILL   2 / 2  S ", "twill 2/2 s"),
        ("twill2/2z", "twill 2/2"),
        ("Satin 8 / 3", "satin 8/3"),
        ("satin 5", "satin 5/2"),
        ("basket 3", "basket 3/3"),
        ("rib", "warp rib 2/2"),
        ("log-cabin 6", "log cabin 6"),
        ("shepherd’s check 8", "shepherd's check 8"),
        ("dogtooth", "houndstooth 4"),
    ],
)
def test_spellings(text: str, same: str) -> None:
    assert np.array_equal(named_weave(text).drawdown, named_weave(same).drawdown)


@given(parts=st.lists(counts, min_size=2, max_size=6).filter(lambda parts: len(parts) % 2 == 0))
@settings(deadline=None)
def test_twill_diagonals_and_counts(parts: list[int]) -> None:
    name = "twill " + "/".join(map(str, parts))
    z, s = named_weave(name).drawdown, named_weave(name + " s").drawdown
    assert np.array_equal(z[1], np.roll(z[0], 1))  # the next pick is one end further right
    assert np.array_equal(s[1], np.roll(s[0], -1))
    assert np.array_equal(s[0], z[0])
    assert z[0].tolist() == [turn % 2 == 0 for turn, count in enumerate(parts) for _ in range(count)]
    assert np.all(z.sum(axis=0) == sum(parts[::2]))


@given(ends=st.integers(5, 40), step=st.integers(0, 45))
@settings(deadline=None)
def test_satins_bind_once_or_are_refused(ends: int, step: int) -> None:
    valid = gcd(step, ends) == 1 and 1 < step < ends - 1
    if not valid:
        with pytest.raises(InputError, match=r"ends|step|0"):
            named_weave(f"satin {ends}/{step}")
        return
    satin, sateen = named_weave(f"satin {ends}/{step}"), named_weave(f"sateen {ends}/{step}")
    assert np.array_equal(satin.drawdown, ~sateen.drawdown)
    assert np.all(sateen.drawdown.sum(axis=0) == 1)
    assert np.all(sateen.drawdown.sum(axis=1) == 1)
    bound = np.argmax(sateen.drawdown, axis=1)
    assert np.all(np.diff(bound) % ends == step)


def test_wrong_satin_step_names_the_right_ones() -> None:
    with pytest.raises(InputError, match=r'weave = "satin 8/2": 2 is no step for 8 ends.*: 3, 5;'):
        named_weave("satin 8/2")
    with pytest.raises(InputError, match="no regular satin has 6 ends"):
        named_weave("satin 6/5")


def test_herringbone_legs_mirror_and_cut() -> None:
    weave = named_weave("herringbone 2/2 8").drawdown
    left, right = weave[:, :8], weave[:, 8:]
    assert np.array_equal(left[1], np.roll(left[0], 1))
    assert np.array_equal(right[1], np.roll(right[0], -1))
    assert np.array_equal(weave[:, 7], ~weave[:, 8])
    assert np.array_equal(weave[:, 15], ~weave[:, 0])


def test_diamond_is_symmetric_about_its_points() -> None:
    weave = named_weave("diamond 2/2 8").drawdown
    assert np.array_equal(np.roll(weave[:, ::-1], 1, axis=1), weave)
    assert weave.shape == (16, 16)


def test_houndstooth_orders_its_colours_by_role() -> None:
    draft = named_weave("houndstooth")
    assert draft.warp.color_index is not None
    assert draft.palette is not None
    assert draft.warp.color_index.tolist() == [0, 0, 0, 0, 1, 1, 1, 1]
    assert np.array_equal(draft.warp.colors, draft.palette[draft.warp.color_index])
    assert draft.palette[0].sum() < draft.palette[1].sum()  # dark first


def test_hairline_covers_each_end_with_its_own_colour() -> None:
    draft = named_weave("hairline")
    up = draft.drawdown[..., None]
    assert draft.warp.colors is not None
    assert draft.weft.colors is not None
    face = np.where(up, draft.warp.colors[None], draft.weft.colors[:, None])
    assert np.array_equal(face[0], face[1])
    assert not np.array_equal(face[0, 0], face[0, 1])


@pytest.mark.parametrize("name", weave_names())
def test_every_named_weave_holds_together(name: str) -> None:
    draft = named_weave(name)
    assert unbound_threads(draft) == ([], [])
    assert longest_floats(draft).longest <= 10
    assert draft.title


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("", "no weave that is known"),
        ("twil 2/1", 'did you mean "twill"'),
        ("twill", "even number of counts"),
        ("twill 2", "even number of counts"),
        ("twill 2/1/3", "even number of counts"),
        ("twill 0/1", "at least 1"),
        ("twill 2/1 q", '"q" is not understood'),
        ("twill 4000/4000", "8000 ends"),
        ("twill " + "9" * 100_000 + "/1", "more than 4096"),
        ("herringbone 2/2 4000", "8000 ends"),
        ("houndstooth -4", '"-4" is not understood'),
        ("houndstooth 2000", "from 1 to 1024"),
        ("waffle 7", "odd"),
        ("waffle 1000", "from 4 to 64"),
        ("damask 500", "496 would do"),
        ("damask 4096", "2720 would do"),
        ("argyle 33", "32 would do"),
        ("plain 3", '"3" is not understood'),
    ],
)
def test_bad_names_get_one_clear_sentence(text: str, fault: str) -> None:
    with pytest.raises(InputError) as caught:
        named_weave(text)
    message = str(caught.value)
    assert fault in message
    assert "\n" not in message
    assert len(message) < 500


@given(st.text(max_size=40))
@settings(deadline=None)
def test_any_text_is_a_weave_or_an_input_error(text: str) -> None:
    try:
        draft = named_weave(text)
    except InputError:
        return
    assert draft.drawdown.any()


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("2/2 twill", "twill 2/2"),
        ("s 3/1 twill", "twill 3/1 s"),
        ("5-end satin", "satin 5"),
        ("8 shaft weft-faced satin", "sateen 8"),
        ("plain weave", "plain"),
        ("gabardine s", "twill 2/2 s"),
        ("gabardine 2/1", "twill 2/1"),
        ("oxford", "basket 2/1"),
    ],
)
def test_words_in_either_order_and_names_of_cloths(text: str, same: str) -> None:
    assert np.array_equal(named_weave(text).drawdown, named_weave(same).drawdown)


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("tartan K/1 R2 K3 Y/2", "KRRKKKYYKKKRR"),
        ("tartan K1 R2 K3 Y2", "KRRKKKYYKKKRR"),
        ("tartan ...K1 R2 G1...", "KRRG"),
        ("Tartan k1r2", "KRR"),
    ],
)
def test_a_tartan_turns_back_at_its_pivots(text: str, order: str) -> None:
    """The pivots stand once."""
    draft = named_weave(text)
    letters = list(dict.fromkeys(order))
    repeat = [letters.index(letter) for letter in order]
    for threads in (draft.warp, draft.weft):
        assert threads.color_index is not None
        assert threads.color_index.tolist() == repeat * (draft.ends // len(order))
    assert np.array_equal(draft.drawdown[:4, :4], named_weave("twill 2/2").drawdown)
    assert draft.ends % 4 == 0
