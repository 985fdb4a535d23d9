"""Thread colours by role and in thread order."""

from dataclasses import replace

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.weave import named_weave, repeat_draft, with_palette

RED, BLUE, GREEN = [0.8, 0, 0], [0, 0, 0.8], [0, 0.8, 0]


def test_two_colours_go_in_the_order_of_the_effect() -> None:
    draft = with_palette(named_weave("houndstooth"), [RED, BLUE], [BLUE, GREEN])
    assert draft.warp.colors is not None
    assert draft.weft.colors is not None
    assert draft.warp.colors.tolist() == [RED] * 4 + [BLUE] * 4
    assert draft.weft.colors.tolist() == [BLUE] * 4 + [GREEN] * 4
    assert draft.drawdown.shape == (8, 8)


def test_none_leaves_the_colours() -> None:
    before = named_weave("denim")
    after = with_palette(before, [RED], None)
    assert np.array_equal(after.weft.colors, before.weft.colors)
    assert after.warp.colors is not None
    assert np.all(after.warp.colors == RED)


def test_colours_in_thread_order_let_the_repeat_grow() -> None:
    draft = with_palette(named_weave("twill 2/2"), [RED, BLUE, GREEN], None)
    assert draft.drawdown.shape == (4, 12)
    assert np.array_equal(draft.drawdown[:, :4], draft.drawdown[:, 8:])
    assert draft.warp.colors is not None
    assert draft.warp.colors.tolist() == [RED, BLUE, GREEN] * 4
    assert draft.weft.colors is None


@pytest.mark.parametrize(
    ("colors", "fault"),
    [
        ([], "warp.color"),
        ([[0.1, 0.2]], "RGB triples"),
        ([[0, 0, 2]], "outside 0 to 1"),
        ([[0, 0, float("nan")]], "outside 0 to 1"),
        (["#fff"], "no list of linear RGB"),
    ],
)
def test_bad_lists_are_named(colors: list, fault: str) -> None:
    with pytest.raises(InputError, match=fault):
        with_palette(named_weave("plain"), colors, None)


def test_too_few_colours_for_the_roles() -> None:
    draft = named_weave("houndstooth")
    assert draft.warp.color_index is not None
    three = replace(draft, warp=replace(draft.warp, color_index=np.arange(8) % 3))
    with pytest.raises(InputError, match=r"warp\.color has 2 colours, but .* uses 3; give 3, or one"):
        with_palette(three, [RED, BLUE], None)
    one = with_palette(three, [RED], None)
    assert one.warp.colors is not None
    assert np.all(one.warp.colors == RED)


def test_too_long_a_repeat_is_refused() -> None:
    with pytest.raises(InputError, match="repeat only after 32762 threads"):
        with_palette(named_weave("plain"), np.zeros((16381, 3)), None)
    with pytest.raises(InputError, match="20000 ends"):
        repeat_draft(named_weave("plain"), 10_000, 1)
