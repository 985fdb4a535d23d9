"""Layers of drafts against the definition, strong connection of "lies above"; and the sentence about them."""

import warnings
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as numpy_strategies
from numpy.typing import NDArray

from loomlight.core.errors import LoomlightWarning
from loomlight.weave import load_draft, named_weave, weave_names
from loomlight.weave.draft import layer_sizes

from .conftest import cases, corpus


def connected_sizes(warp_up: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Ends and picks of the strongly connected parts that have both, by walking over all threads."""
    picks, ends = warp_up.shape
    above = np.zeros((ends + picks, ends + picks), dtype=int)
    above[:ends, ends:] = warp_up.T
    above[ends:, :ends] = ~warp_up
    reach = above + np.eye(ends + picks, dtype=int)
    for _ in range(ends + picks):
        reach = np.minimum(reach @ reach, 1)
    mutual = (reach & reach.T).astype(bool)
    parts = {tuple(row) for row in mutual.tolist()}
    # What lies higher reaches more.
    ordered = sorted(parts, key=lambda part: -int(reach[part.index(True)].sum()))
    sizes = [(sum(part[:ends]), sum(part[ends:])) for part in ordered]
    return [size for size in sizes if min(size) > 0]


@given(numpy_strategies.arrays(bool, st.tuples(st.integers(1, 6), st.integers(1, 6))))
def test_any_drawdown_has_the_layers_of_its_connected_parts(warp_up: NDArray[np.bool_]) -> None:
    assert layer_sizes(warp_up) == connected_sizes(warp_up)


@given(st.lists(st.integers(0, 4), min_size=1, max_size=4), st.integers(0, 99))
def test_stacked_layers_are_counted_in_any_order_of_threads(kinds: list[int], seed: int) -> None:
    """Layers of plain weave and of twill, and loose ends and picks, one upon the other."""
    blocks = [
        np.eye(2, dtype=bool),
        named_weave("twill 2/1").drawdown,
        named_weave("sateen 5/2").drawdown,
        np.zeros((0, 1), dtype=bool),
        np.zeros((1, 0), dtype=bool),
    ]
    warp_up = np.zeros((0, 0), dtype=bool)
    for kind in kinds:
        under = blocks[kind]
        # Ends above pass over the picks below; picks above lie over the ends below.
        warp_up = np.block(
            [
                [warp_up, np.zeros((warp_up.shape[0], under.shape[1]), dtype=bool)],
                [np.ones((under.shape[0], warp_up.shape[1]), dtype=bool), under],
            ]
        )
    if 0 not in warp_up.shape:
        rng = np.random.default_rng(seed)
        warp_up = warp_up[rng.permutation(len(warp_up))][:, rng.permutation(warp_up.shape[1])]
        wanted = [blocks[kind].shape[::-1] for kind in kinds if kind < 3]
        assert layer_sizes(warp_up) == wanted == connected_sizes(warp_up)


def test_stitches_bind_layers() -> None:
    double = sateen_double()
    assert layer_sizes(double) == [(5, 5), (5, 5)]
    double[0, 1] = True  # one end of the lower layer rises over one pick of the upper one
    assert layer_sizes(double) == [(10, 10)]


def sateen_double() -> NDArray[np.bool_]:
    sateen = named_weave("sateen 5/2").drawdown
    double = np.zeros((10, 10), dtype=bool)
    double[::2, ::2], double[1::2, 1::2] = sateen, sateen
    double[1::2, ::2] = True
    return double


@pytest.mark.parametrize("case", cases("d1*.wif"))
def test_a_double_weave_warns_in_one_sentence(case: Path) -> None:
    with pytest.warns(LoomlightWarning) as caught:
        load_draft(case)
    assert [str(warning.message) for warning in caught] == [
        f"{case} holds 2 layers of cloth that no thread binds together (2 ends and 2 picks lie above 2 ends "
        "and 2 picks); they are drawn in a single plane."
    ]


@pytest.mark.parametrize("file", [*corpus("good"), *corpus("warn")])
def test_real_drafts_of_one_layer_give_no_warning(file: Path) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        draft = load_draft(file)
    assert not [warning for warning in caught if "layers" in str(warning.message)]
    assert len(layer_sizes(draft.drawdown)) == 1


@pytest.mark.parametrize("name", weave_names())
def test_named_weaves_are_one_layer(name: str) -> None:
    assert len(layer_sizes(named_weave(name).drawdown)) == 1


def test_large_layers_are_found_by_sums_of_rows_and_columns() -> None:
    double = np.zeros((4096, 4096), dtype=bool)
    double[1::2, ::2] = True
    double[::4, ::4] = double[2::4, 2::4] = double[1::4, 1::4] = double[3::4, 3::4] = True
    assert layer_sizes(double) == [(2048, 2048), (2048, 2048)]
