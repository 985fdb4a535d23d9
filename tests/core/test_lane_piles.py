"""Lanes put aside are given back once each, the last first."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest

from loomlight.core.lane_code import Code, Vectors
from loomlight.core.lane_piles import Pile
from loomlight.core.lane_values import FLOAT, INDEX, TRUTH, WHOLE
from loomlight.core.machine_code import MachineCode

from .lanes import WIDTHS


@dataclass
class Parcel:
    """What tests put on piles.

    Attributes:
        query: its number in the block.
        rounds: how often it is put back yet.
        number: a float.
        flags: what is true, beside a whole number.
    """

    query: Any
    rounds: Any
    number: Any
    flags: tuple[Any, Any, Any]


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_piles_give_back_once_what_was_put_on_them(wide: Vectors) -> None:
    """In rounds: some are put back, with another number, before what lies deeper is taken."""
    code = Code("pile", wide)
    whole, number, no = (code.converted(0, kind) for kind in (WHOLE, FLOAT, TRUTH))
    pile = Pile(code, Parcel(whole, whole, number, (no, no, no)), wide.block)
    with code.blocks():
        pile.clear()
        with code.each_vector():
            rounds, bits = code.converted(code.given(0), WHOLE), code.converted(code.given(1), WHOLE)
            flags = (bits & 1) > 0, (bits & 2) > 0, (bits & 4) > 0
            pile.put(Parcel(code.numbered(code.lane), rounds, code.given(2), flags), rounds > 0)
        with code.as_long_as(pile.is_left):
            parcel, there = pile.take()
            query = code.select(there, parcel.query, 0)
            a, b, c = parcel.flags
            more = replace(parcel, rounds=parcel.rounds - 1, number=parcel.number + 1, flags=(b, c, a))
            pile.put(more, there & (parcel.rounds > 1))
            last = there & (parcel.rounds == 1)
            flags = code.select(a, 1.0, 0.0) + code.select(b, 2.0, 0.0) + code.select(c, 4.0, 0.0)
            for answer, lanes in ((3, parcel.number), (4, flags)):
                code.scatter_to(code.queries(answer), query, lanes, last)
            # How often each was taken.
            times = code.gathered_from(code.queries(5), query) + 1
            code.scatter_to(code.queries(5), query, times, there)
    rng = np.random.default_rng(9)
    rounds, bits, numbers = rng.integers(0, 6, 1003), rng.integers(0, 8, 1003), rng.normal(size=1003)
    # Blocks of which all or none is put on the pile.
    rounds[: wide.block] = 3
    rounds[wide.block : 2 * wide.block] = 0
    given = [part.astype(np.float32) for part in (rounds, bits, numbers)]
    found = [np.zeros(1003, np.float32) for _ in range(3)]
    MachineCode(code).run(1003, given, found, [])
    put, turns = rounds > 0, np.maximum(rounds - 1, 0)
    wanted = given[2].copy()
    for turn in range(turns.max()):
        wanted[turns > turn] += np.float32(1)
    turned = ((bits >> turns % 3) | (bits << (3 - turns % 3))) & 7
    np.testing.assert_array_equal(found[0], np.where(put, wanted, 0))
    np.testing.assert_array_equal(found[1], np.where(put, turned, 0))
    np.testing.assert_array_equal(found[2], rounds)


def test_piles_are_taken_from_the_top_without_gaps() -> None:
    wide = Vectors(8, 16)
    code = Code("top", wide)
    pile, turn = Pile(code, code.converted(0, WHOLE), wide.block), code.variable(INDEX)
    with code.blocks():
        pile.clear()
        code.builder.store(INDEX(0), turn)
        with code.each_vector():
            pile.put(code.numbered(code.lane), code.given(0) > 0)
        with code.as_long_as(pile.is_left):
            query, there = pile.take()
            code.builder.store(code.builder.add(code.builder.load(turn), INDEX(1)), turn)
            query = code.select(there, query, 0)
            code.scatter_to(code.queries(1), query, code.counted(code.builder.load(turn)), there)
    chosen = np.random.default_rng(10).random(5 * wide.block) < 0.7
    found = np.zeros(len(chosen), np.float32)
    MachineCode(code).run(len(chosen), [chosen.astype(np.float32)], [found], [])
    for block, turns in zip(chosen.reshape(5, -1), found.reshape(5, -1), strict=True):
        wanted = np.arange(block.sum())[::-1] // wide.lanes + 1
        np.testing.assert_array_equal(turns[block], wanted)
        np.testing.assert_array_equal(turns[~block], 0)
