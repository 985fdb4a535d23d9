"""Binding points in floats that are too long."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from loomlight.core.errors import InputError
from loomlight.weave import Draft, bind_floats, longest_floats


def runs(row: list[bool]) -> list[int]:
    """Lengths of the runs of a row that repeats, counted thread by thread."""
    if len(set(row)) == 1:
        return [len(row)]
    first = next(at for at in range(len(row)) if row[at] != row[at - 1])
    turned = row[first:] + row[:first]
    found = [1]
    for before, after in pairwise(turned):
        found = [*found[:-1], found[-1] + 1] if before == after else [*found, 1]
    return found


@given(
    seed=st.integers(0, 2**32 - 1),
    limit=st.integers(3, 9),
    block=st.integers(1, 5),
    size=st.tuples(st.integers(2, 7), st.integers(2, 7)),
)
@settings(max_examples=30, deadline=None)
def test_no_float_passes_the_limit(seed: int, limit: int, block: int, size: tuple[int, int]) -> None:
    coarse = np.random.default_rng(seed).random(size) < 0.5
    cloth = np.kron(coarse, np.ones((block, block), bool)).astype(bool)
    try:
        bound = bind_floats(cloth, limit)
    except InputError:  # a cloth of few threads may leave no room
        return
    for rows in (bound.tolist(), bound.T.tolist()):
        assert all(max(runs(row)) <= max(limit, 1) or len(row) <= limit for row in rows)
    if all(max(runs(row)) <= limit for rows in (cloth.tolist(), cloth.T.tolist()) for row in rows):
        np.testing.assert_array_equal(bound, cloth)


def test_a_long_float_is_bound_in_its_middle_and_few_crossings_change() -> None:
    cloth = np.indices((24, 24)).sum(axis=0) % 2 == 0
    cloth[:, 5] = True
    cloth[23, 5] = False
    bound = bind_floats(cloth, 6)
    changed = np.argwhere(bound != cloth)
    # A float of 23 takes three: in its middle, and in the middles of its halves.
    assert changed.tolist() == [[5, 5], [11, 5], [17, 5]]


def test_a_float_is_halved_until_it_is_short_enough() -> None:
    cloth = np.indices((4, 4000)).sum(axis=0) % 2 == 0
    cloth[1] = True
    cloth[1, 0] = False
    assert longest_floats(Draft(bind_floats(cloth, 8))).longest <= 8


def test_what_lies_loose_on_the_back_is_left_alone() -> None:
    """A pick of an extra weft: on the back it is not bound, and it binds no end."""
    cloth = np.indices((12, 12)).sum(axis=0) % 2 == 0
    cloth[6] = True
    cloth[:, 3] = True
    loose = np.zeros_like(cloth)
    loose[6] = True
    bound = bind_floats(cloth, 4, loose=loose)
    assert bound[6].all()
    assert max(runs(bound[:, 3].tolist())) <= 4
    assert not bind_floats(cloth, 4)[6].all()
