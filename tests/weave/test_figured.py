"""Figured cloth: the motif shows, and nothing floats too far.

Covers: weave/figured.py
"""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from loomlight.core.errors import InputError
from loomlight.weave import Draft, bind_floats, figured_structure, longest_floats, named_weave
from loomlight.weave.figured import argyle, lozenges, ogee_damask
from loomlight.weave.structures import sateen, satin


@pytest.mark.parametrize("ends", [160, 240])
def test_the_damask_shows_its_motif_and_binds(ends: int) -> None:
    draft = named_weave(f"damask {ends}")
    mask = ogee_damask(ends, draft.picks)
    assert draft.drawdown.shape == (ends * 3 // 2, ends)
    # Within a structure 7 of 8 crossings agree with the motif.
    assert np.mean(draft.drawdown == mask) == pytest.approx(7 / 8, abs=0.01)
    assert longest_floats(draft).longest <= 10
    assert 0.3 < mask.mean() < 0.6


def test_motifs_keep_their_symmetries() -> None:
    damask = ogee_damask(160, 240)
    assert np.array_equal(damask, damask[:, ::-1])
    half_drop = np.roll(damask, (120, 80), axis=(0, 1))
    assert np.mean(half_drop == damask) > 0.99
    for motif in (argyle(96, 144), lozenges(96, 96)):
        assert np.array_equal(motif, motif[:, ::-1])
        assert np.array_equal(motif, motif[::-1])
        assert 0.2 < motif.mean() < 0.8


@given(seed=st.integers(0, 2**32 - 1), limit=st.integers(9, 14))
@settings(max_examples=20, deadline=None)
def test_floats_are_bound_for_any_motif(seed: int, limit: int) -> None:
    coarse = np.random.default_rng(seed).random((6, 6)) < 0.5
    mask = np.kron(coarse, np.ones((8, 8), dtype=bool)).astype(bool)
    bound = figured_structure(mask, satin(8, 3), sateen(8, 3), float_limit=limit)
    assert longest_floats(Draft(bound)).longest <= limit


def test_binding_splits_a_long_float_in_its_middle() -> None:
    cloth = np.zeros((12, 12), dtype=bool)
    cloth[::2, ::2] = True
    cloth[1::2, 1::2] = True
    cloth[:, 4] = True
    cloth[11, 4] = False
    bound = bind_floats(cloth, 6)
    assert longest_floats(Draft(bound)).longest <= 6
    assert np.sum(bound != cloth) == 1
    assert np.array_equal(bind_floats(bound, 6), bound)


def test_what_cannot_be_woven_is_refused() -> None:
    with pytest.raises(InputError, match="figure structure has 8 ends and 8 picks, which do not divide"):
        figured_structure(np.ones((12, 16), dtype=bool), satin(8, 3), sateen(8, 3), float_limit=10)
    with pytest.raises(InputError, match="No binding keeps"):
        bind_floats(np.ones((3, 3), dtype=bool), 1)
