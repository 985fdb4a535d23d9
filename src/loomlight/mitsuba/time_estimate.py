"""Seconds of a picture: predicted from what is asked for, then corrected by what is measured."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from loomlight.core.parallel_map import core_count
from loomlight.mitsuba.rendering import Progress


@dataclass(frozen=True)
class ModelSeconds:
    """Cost of a model on two cores of a Zen 4 server, seconds.

    Attributes:
        bake: of a process that has not baked before.
        compile: of the rendering kernel.
        million: samples of paths of eight segments, in millions.
    """

    bake: float = 0.0
    compile: float = 2.5
    million: float = 2.0


# A wrong prediction only shows until the first pass is over.
MODEL_SECONDS = {
    "lobes": ModelSeconds(bake=0.4, compile=2.5, million=2.0),
    "point": ModelSeconds(compile=1.1, million=0.9),
    "neural": ModelSeconds(bake=1.5, compile=3.0, million=4.0),
    "samples": ModelSeconds(compile=2.5, million=8.0),
}
# Of setting Mitsuba's variant, which loads LLVM.
START_SECONDS = 0.4
SCENE_SECONDS = 0.5
_CORES_OF_FIGURES = 2
# Weight of the prediction against what is measured, seconds.
_TRUST = 1.0


def sample_seconds(model: str, samples: int) -> float:
    """Predicted seconds of `samples` of paths on this machine's cores; samples of a pixel times pixels."""
    seconds = MODEL_SECONDS.get(model, ModelSeconds()).million * samples / 1e6
    return seconds * _CORES_OF_FIGURES / core_count()


class TimeEstimate:
    """Time passed and time left of a work of several steps, done one after the other."""

    def __init__(
        self,
        predicted: dict[str, float],
        report: Progress | None,
        clock: Callable[[], float] = time.perf_counter,
    ) -> None:
        """Reports at once.

        Args:
            predicted: seconds of each step, in any order.
            report: called with (milliseconds passed, milliseconds in all, as estimated).
            clock: seconds from any origin.
        """
        self._ahead = dict(predicted)
        self._report = report
        self._clock = clock
        self._begun = self._since = clock()
        self._done = 0.0
        self._finished_seconds = 0.0
        self._step, self._fraction = 0.0, 0.0
        self._first: tuple[float, float] | None = None
        self._tell()

    @contextmanager
    def step(self, name: str) -> Iterator[Callable[[int, int], None]]:
        """While a step is worked on; gives the function that takes (parts done, parts in all)."""
        self._step, self._fraction, self._first = self._ahead.pop(name), 0.0, None
        self._since = self._clock()
        yield self._advance
        self._done += self._step
        self._finished_seconds += self._clock() - self._since
        self._step = self._fraction = 0.0
        self._first = None
        self._tell()

    def left(self) -> float:
        """Estimated seconds until all steps are done."""
        pace = (self._finished_seconds + _TRUST) / (self._done + _TRUST)
        return pace * sum(self._ahead.values()) + self._left_of_step(pace)

    def _advance(self, done: int, total: int) -> None:
        self._fraction = done / total
        if self._first is None:
            self._first = self._clock(), self._fraction
        self._tell()

    def _left_of_step(self, pace: float) -> float:
        rest = 1 - self._fraction
        if self._first is None or self._fraction <= self._first[1]:
            return pace * self._step * rest
        # The first part may compile kernels: later ones tell how fast the rest goes.
        seconds = self._clock() - self._first[0]
        return seconds / (self._fraction - self._first[1]) * rest

    def _tell(self) -> None:
        if self._report is not None:
            passed = self._clock() - self._begun
            self._report(round(1000 * passed), round(1000 * (passed + self.left())))
