"""Drafts there and back as JSON, and what is refused."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.viewer.messages import draft_json, draft_of_json
from loomlight.weave.load import load_draft
from loomlight.weave.named import named_weave

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def test_drafts_come_back_as_they_were() -> None:
    for draft in (
        load_draft(EXAMPLES / "undulating-twill.wif"),
        named_weave("houndstooth 4"),
        named_weave("crepe"),
    ):
        back = draft_of_json(json.loads(json.dumps(draft_json(draft))))
        np.testing.assert_array_equal(back.drawdown, draft.drawdown)
        assert back.title == draft.title
        assert (back.loom and vars(back.loom)) == (draft.loom and vars(draft.loom))
        for family in ("warp", "weft"):
            for name in ("colors", "spacing_mm", "thickness_mm", "color_index"):
                given, got = getattr(getattr(draft, family), name), getattr(getattr(back, family), name)
                assert (given is None) == (got is None)
                if given is not None:
                    np.testing.assert_array_equal(got, given)


def test_bits_are_row_by_row_without_padding() -> None:
    # Three ends and three picks, nine bits: 110 101 011 and seven bits of padding.
    values = {"ends": 3, "picks": 3, "drawdown": "1YA="}
    assert draft_of_json(values).drawdown.astype(int).tolist() == [[1, 1, 0], [1, 0, 1], [0, 1, 1]]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"drawdown": "1Y"}, "base64"),
        ({"drawdown": "1Y²="}, "base64"),
        ({"drawdown": "1YAA"}, "holds 3 bytes"),
        ({"ends": 0}, "ends"),
        ({"ends": 99999}, "ends"),
        ({"picks": "three"}, "picks"),
        ({"warp": {"colors": [[0, 0, 0]]}}, "holds 1 threads"),
        ({"warp": {"colors": [[0, 0, 2]] * 3}}, "warp.colors"),
        ({"weft": {"spacing_mm": [1, 1, float("nan")]}}, "weft.spacing_mm"),
        ({"loom": {"shafts": 2, "threading": [[1], [2], [3]]}}, "loom.threading"),
        ({"loom": {"shafts": 2, "threading": [[1], [2]]}}, "loom.threading"),
    ],
)
def test_what_makes_no_draft_is_named(change: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said):
        draft_of_json({"ends": 3, "picks": 3, "drawdown": "1YA=", **change})


def test_crossings_are_counted_before_they_are_unpacked() -> None:
    # The drawdown is no base64, which its reader would say.
    with pytest.raises(InputError, match="16384 ends and 16384 picks, 268,435,456 crossings"):
        draft_of_json({"ends": 16384, "picks": 16384, "drawdown": "?"})
