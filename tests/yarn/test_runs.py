"""Run words against a walk along each thread."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.yarn.threads import MAX_NEIGHBOUR, MAX_OFFSET, pack_runs


def _walk(sides: NDArray[np.bool_], start: int, step: int) -> int:
    """Crossings from `start` in direction `step` that stay on its side, itself not counted."""
    count = 0
    while sides[(start + step * (count + 1)) % sides.size] == sides[start]:
        count += 1
    return count


@pytest.mark.parametrize("shape", [(5, 7), (3, 2), (40, 300), (300, 3), (2, 1000)])
def test_words_say_what_a_walk_along_the_thread_finds(shape: tuple[int, int]) -> None:
    rng = np.random.default_rng(sum(shape))
    # Long runs as well as short ones: flip sides rarely.
    on_top = (rng.random(shape) < rng.uniform(0.01, 0.5)).cumsum(axis=1) % 2 == 1
    words = pack_runs(on_top.T).T
    for thread, crossing in zip(rng.integers(0, shape[0], 200), rng.integers(0, shape[1], 200), strict=True):
        sides, word = on_top[thread], int(words[thread, crossing])
        assert (word & 1) == sides[crossing]
        if (sides == sides[0]).all():
            assert word >> 27 == 1
            continue
        behind, ahead = _walk(sides, crossing, -1), _walk(sides, crossing, 1)
        previous = (crossing - behind - 1) % sides.size
        following = (crossing + ahead + 1) % sides.size
        assert word >> 27 == 0
        assert (word >> 1) & 127 == min(behind, MAX_OFFSET)
        assert (word >> 8) & 127 == min(ahead, MAX_OFFSET)
        assert (word >> 15) & 63 == min(_walk(sides, previous, -1) + 1, MAX_NEIGHBOUR)
        assert (word >> 21) & 63 == min(_walk(sides, following, 1) + 1, MAX_NEIGHBOUR)
