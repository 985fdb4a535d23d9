"""Baking launched from recordings gives the bytes of baking traced anew, whatever was baked before."""

from __future__ import annotations

import gc
from typing import Any

import pytest

from loomlight.core.frozen import FrozenArg, FrozenFunction
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.models.lobes import coverage, rays
from loomlight.models.lobes.model import tables_of
from loomlight.models.lobes.tables import LobeTables
from tests.marks import slow

from .cloths import random_cloth

# What the next baking differs in from the one before, and back: a weave, the warp's height scale, groups.
STEPS = [
    ("twill 3/1", 0.3, 8),
    ("twill 3/1", 0.7, 8),
    ("plain", 0.7, 8),
    ("satin 8/3", 0.7, 8),
    ("satin 8/3", 0.7, 3),
    ("houndstooth", 0.4, 3),
    ("houndstooth", 0.4, 8),
    ("twill 3/1", 0.3, 8),
]
RECORDED: list[FrozenFunction] = [
    rays._sample_top_down,
    rays._start_in_gaps,
    rays._trace_shadows,
    rays._trace_views,
    rays._trace_null,
    rays._trace_gaps,
    coverage._count_all,
]


def _fabric_of(weave: str, scale: float) -> Fabric:
    """A weave whose warp is so much higher than wide."""
    return fabric_from_text(f'weave = "{weave}"\n[warp]\nheight_scale = {scale}\n')


def _traced(fabric: Fabric, per_family: int, monkeypatch: pytest.MonkeyPatch) -> LobeTables:
    """The tables of a fabric, baked without recordings."""

    def call(recorded: FrozenFunction, *arguments: Any) -> Any:
        return recorded.traced(*(part.value if isinstance(part, FrozenArg) else part for part in arguments))

    with monkeypatch.context() as patched:
        patched.setattr(FrozenFunction, "__call__", call)
        return tables_of(fabric, per_family)


def _assert_same(actual: LobeTables, expected: LobeTables) -> None:
    assert actual.base_size == expected.base_size
    for name, values in expected.arrays().items():
        assert actual.arrays()[name].tobytes() == values.tobytes(), name


@pytest.mark.slow
def test_recordings_give_the_bytes_of_traces(monkeypatch: pytest.MonkeyPatch) -> None:
    for weave, scale, per_family in STEPS:
        fabric = _fabric_of(weave, scale)
        _assert_same(tables_of(fabric, per_family), _traced(fabric, per_family, monkeypatch))


@pytest.mark.slow
@pytest.mark.parametrize(("ends", "uneven"), [(12, True), (12, False), slow(641, True)])
def test_uneven_and_large_drafts(ends: int, uneven: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Threads that differ are read from tables, and texels of large drafts are counted in batches."""
    cloth = random_cloth(ends, ends, uneven)
    _assert_same(tables_of(cloth, 2), _traced(cloth, 2, monkeypatch))


@pytest.mark.slow
def test_edits_of_heights_are_launched_from_recordings() -> None:
    """Otherwise they would be no faster than tracing."""
    tables_of(_fabric_of("twill 3/1", 0.5), 8)
    before = [function.recordings for function in RECORDED]
    for number in range(3):
        tables_of(_fabric_of("twill 3/1", 0.6 + 0.1 * number), 8)
    assert [function.recordings for function in RECORDED] == before


@pytest.mark.slow
def test_recordings_are_bounded() -> None:
    for per_family in range(1, 12):
        tables_of(_fabric_of("plain", 0.5), per_family)
    for function in RECORDED:
        assert 1 <= function.kept <= 8, function


@pytest.mark.slow
def test_collecting_garbage_at_every_turn_does_no_harm() -> None:
    """Arrays and cloths that are freed at any time: what was baked before and after is the same."""
    threshold = gc.get_threshold()
    expected = [tables_of(_fabric_of(weave, scale), per_family) for weave, scale, per_family in STEPS]
    gc.set_threshold(1)
    try:
        for (weave, scale, per_family), tables in zip(STEPS, expected, strict=True):
            _assert_same(tables_of(_fabric_of(weave, scale), per_family), tables)
    finally:
        gc.set_threshold(*threshold)
