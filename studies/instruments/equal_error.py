"""Times of runs in turns, and errors without the truth's own noise, for pictures of equal error."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from studies.instruments.timing import timed


@dataclass(frozen=True)
class Spent:
    """The time of a run.

    Attributes:
        seconds: by the wall clock.
        cpu_seconds: of all threads of this process; other programs do not lengthen them.
    """

    seconds: float
    cpu_seconds: float


def least_times(runs: Sequence[Callable[[], object]], turns: int) -> list[Spent]:
    """The least times of each run; they take turns, so that all see the same machine."""
    taken = [[_spent(run) for run in runs] for _ in range(turns)]
    return [
        Spent(min(turn[number].seconds for turn in taken), min(turn[number].cpu_seconds for turn in taken))
        for number in range(len(runs))
    ]


def _spent(run: Callable[[], object]) -> Spent:
    before = time.process_time()
    _, seconds = timed(run)
    return Spent(seconds, time.process_time() - before)


@dataclass(frozen=True, eq=False)
class HalvedTruth:
    """A noisy truth in two independent halves, whose own noise no mean squared error contains.

    The mean of (p − a)(p − b) over pixels is the squared error of p against what a and b estimate, if p, a
    and b are independent: the noise of a and b is on average 0 in it.

    Attributes:
        halves: two pictures of linear RGB [height, width, 3].
    """

    halves: tuple[NDArray[np.float32], NDArray[np.float32]]

    @property
    def picture(self) -> NDArray[np.float32]:
        """The mean of both halves."""
        one, other = self.halves
        return ((one + other) * np.float32(0.5)).astype(np.float32)

    def squared_error(self, picture: NDArray[np.float32], counted: NDArray[np.bool_]) -> float:
        """Mean squared error of a picture over a mask [height, width]; about 0 it may be negative."""
        one, other = (picture[counted].astype(np.float64) - half[counted] for half in self.halves)
        return float((one * other).mean())
