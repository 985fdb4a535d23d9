"""Yarn counts against a table of cases."""

import contextlib
import json
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from loomlight.core.errors import InputError
from loomlight.weave import yarn_tex

# Read by a test of the page too, so that both take the same counts for the same yarns.
COUNTS = json.loads((Path(__file__).parents[1] / "cases" / "yarn_counts.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize(("count", "tex"), COUNTS["tex"].items())
def test_yarn_counts(count: str, tex: float) -> None:
    assert yarn_tex(count) == pytest.approx(tex, rel=1e-6)  # the table has eight digits


@pytest.mark.parametrize(("count", "sentence"), COUNTS["refused"].items())
def test_bad_yarn_counts(count: str, sentence: str) -> None:
    with pytest.raises(InputError) as refusal:
        yarn_tex(count)
    assert str(refusal.value) == sentence


@given(st.text("0123456789./,xfs dentkcmNM×", max_size=16))
@settings(deadline=None)
def test_any_text_is_a_count_or_refused(text: str) -> None:
    with contextlib.suppress(InputError):
        assert 0.1 <= yarn_tex(text) <= 100_000
