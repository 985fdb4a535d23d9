"""Training of one material: queries of its source, then the paper's loop (kuznetsov2021 section 4).

Everything depends on the settings and the source alone, so a training that was stopped goes on from its
folder to the same weights.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional

from loomlight.assets.sources import Source
from loomlight.models.neumip.btf import BTFS, Queries, QueryStream, light_density
from loomlight.models.neumip.networks import EXPOSURE, Weights
from loomlight.models.neumip.settings import NeumipSettings
from loomlight.models.neumip.training.network import NeumipNetwork
from loomlight.models.neumip.training.sampler_fit import trained_sampler
from loomlight.models.query_parts import FileStore, Progress, stored_queries
from loomlight.training.loop import Schedule, one_thread, train
from loomlight.training.parallel import SideBySide
from loomlight.training.soap import Soap

_WARM_UP = 0.02
# Mean of π f·cos that dark sources are scaled to while they are trained, and the largest factor.
_MEAN, _MAX_GAIN = 0.15, 1e3
# Weight of the cross-entropy of holes, beside errors of colours.
_OF_HOLES = 0.05
# Key that separates the random numbers of batches from those of queries.
_BATCHES = 5
# Thousandths of the progress that taking queries is counted as.
_OF_QUERIES, _WHOLE = 300, 1000


def train_neumip(
    source: Source,
    settings: NeumipSettings,
    folder: Path,
    progress: Progress | None = None,
    device: str = "cpu",
    keep_every: float = 30.0,
) -> Weights:
    """The weights of a material.

    Args:
        folder: holds queries and the checkpoint; made if need be, and used again to go on.
        device: of torch, "cpu" or "cuda".
        keep_every: seconds between checkpoints.

    Raises:
        InputError: a source of which no queries can be taken, or a damaged checkpoint.
    """
    report = progress or (lambda done, total: None)
    folder.mkdir(parents=True, exist_ok=True)
    queries = taken_queries(source, settings, folder, report)
    btf, shape = BTFS.of(source), settings.shape(source)
    torch.manual_seed(settings.seed)
    scale = settings.texture_rate / settings.rate
    gains = gains_of(queries)
    network = NeumipNetwork(shape, settings.offset, scale, btf.transmits, btf.has_holes, gains).to(device)
    batches = Batches(network, gains, queries, settings, device)
    parts = dict(network.named_parameters())
    textures = [parts.pop(name) for name in ("features", "offset_texture") if name in parts]
    # Texels are seldom seen: the squares of their gradients are remembered longer, and no axes are turned.
    unturned = {"params": textures, "largest_side": 1, "memory": (0.9, 0.99)}
    optimiser = Soap([{"params": [*parts.values()]}, unturned], settings.rate)
    with one_thread():
        train(
            network,
            optimiser,
            batches.losses,
            Schedule(settings.steps, lambda done: settings.rate * rate_factor(done), keep_every=keep_every),
            folder / "checkpoint.safetensors",
            settings.identity(source),
            lambda step, steps, _: report(_OF_QUERIES + (_WHOLE - _OF_QUERIES) * step // steps, _WHOLE),
        )
    density = light_density(queries, hasattr(btf, "measured"))
    weights = network.weights(reflectances(queries, shape.faces, density))
    weights = replace(weights, open_area=float(queries.holes.mean()))
    with one_thread():
        identity, file = settings.identity(source), folder / "sampler.safetensors"
        return replace(weights, sampler=trained_sampler(network, settings, file, identity))


def taken_queries(source: Source, settings: NeumipSettings, folder: Path, report: Progress) -> Queries:
    """All queries of a training; parts that the folder holds are read."""
    samples = settings.fine_samples, settings.samples
    stream = QueryStream(BTFS.of(source), settings.shape(source), samples, settings.seed)
    kept = FileStore(Queries, folder, settings.query_identity(source))
    return stored_queries(
        stream.part, kept, settings.queries, lambda done, parts: report(_OF_QUERIES * done // parts, _WHOLE)
    )


def reflectances(queries: Queries, faces: int, density: NDArray[np.float32]) -> NDArray[np.float32]:
    """Mean albedo of each face [faces, 3], of light on the side of the view.

    Args:
        density: of the lights on their side [n], 1/sr.
    """
    near = queries.is_transmission == 0
    weighted = queries.values / density[:, None]
    means = [weighted[near & (queries.faces == face)].mean(axis=0) for face in range(faces)]
    return np.clip(np.stack(means), 0, 1).astype(np.float32)


def gains_of(queries: Queries) -> tuple[float, float]:
    """Factors of π f·cos for training: of lights on the view's side, and on the other one.

    Dark values are scaled up to a mean of `_MEAN`. Without that the first weights, which are about 1, give
    colours below 0 almost everywhere, errors are too small to pull them up, and dark cloth stays black.
    """
    near = queries.is_transmission == 0
    means = [float(queries.values[side].mean()) if side.any() else 0.0 for side in (near, ~near)]
    first, second = (min(max(_MEAN / max(EXPOSURE * mean, 1e-9), 1.0), _MAX_GAIN) for mean in means)
    return first, second


def rate_factor(progress: float) -> float:
    """The learning rate over the largest, at a progress from 0 to 1: a short rise, then a half cosine."""
    return min(1.0, (progress + 1e-9) / _WARM_UP) * 0.5 * (1 + math.cos(math.pi * progress))


class Batches:
    """Losses of steps: each pass over the queries is in an order of its own."""

    def __init__(
        self,
        network: nn.Module,
        gains: tuple[float, float],
        queries: Queries,
        settings: NeumipSettings,
        device: str,
        error: Callable[[Tensor, Tensor], Tensor] = functional.mse_loss,
    ) -> None:
        """
        Args:
            network: of the outputs of `NeumipNetwork.forward`.
            gains: see `gains_of`.
            device: of torch, "cpu" or "cuda".
            error: of predicted and true π f·cos times the gains [n, 3].
        """
        self._error = error
        self._network, self._queries, self._settings = network, queries, settings
        self._device, self._gains = device, gains
        self._side_by_side = SideBySide.for_batch(device, settings.batch)
        self._per_pass = max(1, len(queries) // settings.batch)
        self._order: tuple[int, NDArray[np.intp]] | None = None

    def losses(self, step: int) -> Iterator[Tensor]:
        """The loss of one step."""
        frozen = step >= self._settings.offset_share * self._settings.steps
        parts = np.array_split(self._chosen(step), self._side_by_side.parts)
        losses = [partial(self._loss, part, frozen) for part in parts]
        yield self._side_by_side.loss(losses, [1 / len(parts)] * len(parts), self._network)

    def _loss(self, chosen: NDArray[np.intp], offset_frozen: bool) -> Tensor:
        batch = self._queries[chosen]
        positions, levels, lights, views, values = (
            torch.from_numpy(part).to(self._device)
            for part in (batch.positions, batch.levels, batch.lights, batch.views, batch.values)
        )
        faces = torch.from_numpy(batch.faces.astype(np.int64)).to(self._device)
        is_transmission = torch.from_numpy(batch.is_transmission.astype(bool)).to(self._device)
        predicted, opacity = self._network(
            positions, levels, lights, views, faces, offset_frozen, is_transmission
        )
        near, far = (values.new_tensor(gain) for gain in self._gains)
        gains = torch.where(is_transmission, far, near)
        loss = self._error(predicted, EXPOSURE * gains[:, None] * values)
        if opacity is None:
            return loss
        holes = torch.from_numpy(batch.holes).to(self._device)
        return loss + _OF_HOLES * functional.binary_cross_entropy_with_logits(opacity, holes)

    def _chosen(self, step: int) -> NDArray[np.intp]:
        number, place = divmod(step, self._per_pass)
        if self._order is None or self._order[0] != number:
            rng = np.random.default_rng([self._settings.seed, _BATCHES, number])
            self._order = number, rng.permutation(len(self._queries))
        first = place * self._settings.batch
        return self._order[1][first : first + self._settings.batch]
