"""Trainings of textures and networks: queries of a folder, batches of them, and phases with checkpoints.

Everything depends on the settings and the source alone, so a training that was stopped goes on from its
folder to the same weights. This module and the two beside it, of each model, are all that needs torch.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from loomlight.models.texture.queries import Progress, Queries, QueryFiles, QueryStream, stored_queries
from loomlight.models.texture.settings import TrainingSettings
from loomlight.training.loop import Schedule, train
from loomlight.training.parallel import SideBySide

# Thousandths of the progress that taking queries is counted as.
QUERIES_DONE, WHOLE = 300, 1000
# Key that separates the random numbers of batches from those of queries.
_BATCHES = 5


def half_cosine(progress: float, last: float = 0.0) -> float:
    """The learning rate over the largest, at a progress from 0 to 1: a half cosine down to `last`."""
    return last + 0.5 * (1 - last) * (1 + math.cos(math.pi * progress))


def folder_queries(
    stream: QueryStream, folder: Path, identity: str, total: int, progress: Progress | None = None
) -> Queries:
    """All queries of a training; parts that the folder holds are read.

    Args:
        folder: made if need be.
        identity: of all that the queries depend on.
        progress: see `TrainingFolder`.
    """
    folder.mkdir(parents=True, exist_ok=True)

    def report(done: int, parts: int) -> None:
        if progress is not None:
            progress(QUERIES_DONE * done // parts, WHOLE)

    return stored_queries(stream, QueryFiles(folder, identity), total, report)


@dataclass(frozen=True, eq=False)
class TrainingFolder:
    """The folder of a training, which holds the checkpoint of each phase.

    Attributes:
        path: used again to go on.
        identity: of all that the weights depend on.
        progress: called with (done, in all) of the whole training, in thousandths.
        keep_every: seconds between checkpoints.
    """

    path: Path
    identity: str
    progress: Progress | None = None
    keep_every: float = 30.0

    def train(
        self,
        name: str,
        network: nn.Module,
        optimiser: torch.optim.Optimizer,
        losses: Callable[[int], Iterable[Tensor]],
        schedule: tuple[int, Callable[[float], float]],
        span: tuple[int, int] | None = None,
    ) -> None:
        """Trains through one phase.

        Args:
            name: of its checkpoint.
            losses: see `loop.train`.
            schedule: steps, and the learning rate at a progress from 0 to 1.
            span: progress at the start and at the end, thousandths; None of a phase that does not count.

        Raises:
            InputError: a damaged checkpoint, or one of another training.
        """
        steps, rate = schedule
        first, last = span or (WHOLE, WHOLE)
        train(
            network,
            optimiser,
            losses,
            Schedule(steps, rate, keep_every=self.keep_every),
            self.path / f"{name}.safetensors",
            self.identity,
            None
            if span is None
            else lambda step, total, _: self._report(first + (last - first) * step // total),
        )

    def _report(self, done: int) -> None:
        if self.progress is not None:
            self.progress(done, WHOLE)


class Batches(ABC):
    """Losses of steps: each pass over the queries is in an order of its own."""

    def __init__(self, network: nn.Module, queries: Queries, settings: TrainingSettings, device: str) -> None:
        """
        Args:
            device: of torch, "cpu" or "cuda".
        """
        self._network, self._queries, self._seed, self._device = network, queries, settings.seed, device
        self._batch = settings.batch
        self._side_by_side = SideBySide.for_batch(device, settings.batch)
        self._order_passes(range(len(queries)))

    def _order_passes(self, over: range) -> None:
        """Makes passes go over some of the queries alone."""
        self._over, self._per_pass = over, max(1, len(over) // self._batch)
        self._order: tuple[int, NDArray[np.intp]] | None = None

    def losses(self, step: int) -> Iterator[Tensor]:
        """The loss of one step."""
        parts = np.array_split(self._chosen(step), self._side_by_side.parts)
        losses = [partial(self._loss_of, part, step) for part in parts]
        yield self._side_by_side.loss(losses, [1 / len(parts)] * len(parts), self._network)

    def _loss_of(self, chosen: NDArray[np.intp], step: int) -> Tensor:
        return self._loss(self._queries[chosen], step)

    @abstractmethod
    def _loss(self, batch: Queries, step: int) -> Tensor:
        """The loss of some queries."""

    def _tensors(self, *parts: NDArray[np.generic]) -> list[Tensor]:
        """Columns of a batch on the device."""
        return [torch.from_numpy(part).to(self._device) for part in parts]

    def _chosen(self, step: int) -> NDArray[np.intp]:
        """The queries of a step."""
        number, place = divmod(step, self._per_pass)
        if self._order is None or self._order[0] != number:
            rng = np.random.default_rng([self._seed, _BATCHES, number])
            self._order = number, self._over.start + rng.permutation(len(self._over))
        return self._order[1][place * self._batch : (place + 1) * self._batch]
