"""Training of one material: queries of its source, then encoder, textures and sampler, one after another.

Section 1 of the supplemental of zeltner2024, in three phases that each have a checkpoint: encoder and
decoder; textures, which begin as what the encoder gives, and decoder; sampler and albedo, which change
nothing of the others. Everything depends on the settings and the source alone, so a training that was stopped
goes on from its folder to the same weights.
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

from loomlight.assets.sources import Source, kind_of_source
from loomlight.models.latent.networks import Weights
from loomlight.models.latent.queries import REFLECTANCES, Reflectance
from loomlight.models.latent.query_stream import Queries, QueryStream, draw_levels
from loomlight.models.latent.settings import AUTO, DECODERS, FEATURES, LatentSettings, loss_of_kind
from loomlight.models.latent.training.network import LatentNetwork, loss_of, texel_inputs
from loomlight.models.mip_pyramid import PyramidShape
from loomlight.models.query_parts import FileStore, Progress, draw_directions, stored_queries
from loomlight.training.direction_sampler import sampler_loss
from loomlight.training.loop import Schedule, one_thread, train
from loomlight.training.parallel import SideBySide
from loomlight.training.soap import Soap

# The smallest rate over the largest (eq. 1).
_LAST_RATE = 0.1
# Lights of a view in a step of the sampler.
_LIGHTS = 16
# Of libraries, steps are so many times as many, with batches so many times as small: in equal time their
# error is three quarters. Of others a step costs too much, whose textures have thousands of texels.
_SMALL = 4
# Keys that separate the random numbers of batches, of the sampler and of albedos from those of queries.
_BATCHES, _SAMPLER, _ALBEDOS = 5, 6, 7
# Thousandths of the progress after queries, and after textures.
_QUERIES_DONE, _TEXTURES_DONE, _WHOLE = 300, 850, 1000
# Views and places of which a face's mean albedo is taken.
_ALBEDO_VIEWS = 4096


def train_latent(
    source: Source,
    settings: LatentSettings,
    folder: Path,
    progress: Progress | None = None,
    device: str = "cpu",
    keep_every: float = 30.0,
) -> Weights:
    """The weights of a material.

    Args:
        folder: holds queries and checkpoints; made if need be, and used again to go on.
        device: of torch, "cpu" or "cuda".
        keep_every: seconds between checkpoints.

    Raises:
        InputError: a source of which no queries can be taken, or a damaged checkpoint.
    """
    report = progress or (lambda done, total: None)
    folder.mkdir(parents=True, exist_ok=True)
    reflectance = REFLECTANCES.of(source, settings.resolution)
    shape = PyramidShape(*reflectance.resolution, *source.repeat_mm, reflectance.faces, reflectance.is_apart)
    queries = taken_queries(source, settings, reflectance, shape.levels, folder, report)
    torch.manual_seed(settings.seed)
    network = LatentNetwork(
        shape,
        texel_inputs(reflectance, shape),
        DECODERS[settings.decoder],
        # Measured BRDFs are about the normal of their face.
        settings.rung == "frames" and not reflectance.is_apart,
        settings.features == FEATURES[0],
        settings.texture_rate / settings.rate,
    ).to(device)
    identity = settings.identity(source)
    if settings.loss == AUTO:
        settings = replace(settings, loss=loss_of_kind(kind_of_source(source)))
    if reflectance.is_apart:
        settings = replace(settings, steps=_SMALL * settings.steps, batch=max(1, settings.batch // _SMALL))
    with one_thread():
        _train_phases(network, queries, settings, identity, folder, report, keep_every)
        return network.weights(_face_albedos(network, settings.seed))


def _train_phases(
    network: LatentNetwork,
    queries: Queries,
    settings: LatentSettings,
    identity: str,
    folder: Path,
    report: Progress,
    keep_every: float,
) -> None:
    with_encoder = settings.rung != "mlp"
    encoder_steps = round(settings.encoder_share * settings.steps) if with_encoder else 0
    batches = _Batches(network, queries, settings)
    common = [network.decoder, *([network.frames] if network.frames is not None else [])]

    def run(
        name: str,
        parts: list[nn.Parameter],
        losses: _Losses,
        steps: int,
        first: int,
        span: int,
        optimiser: str = settings.optimiser,
        done: tuple[float, float] = (0.0, 1.0),
    ) -> None:
        rate, (begin, end) = settings.rate, done
        train(
            network,
            Soap(parts, rate) if optimiser == "soap" else torch.optim.Adam(parts, rate, eps=1e-7),
            losses,
            Schedule(
                steps, lambda share: rate * rate_factor(begin + (end - begin) * share), keep_every=keep_every
            ),
            folder / f"{name}.safetensors",
            identity,
            lambda step, total, _: report(first + span * step // total, _WHOLE),
        )

    def parameters(*modules: nn.Module) -> list[nn.Parameter]:
        return [parameter for module in modules for parameter in module.parameters()]

    span = _TEXTURES_DONE - _QUERIES_DONE
    # One cosine over both phases.
    share = encoder_steps / settings.steps
    middle = round(span * share)
    if encoder_steps:
        losses = partial(batches.losses, encoded=True, first=0)
        trained = parameters(network.encoder, *common)
        run("encoder", trained, losses, encoder_steps, _QUERIES_DONE, middle, done=(0.0, share))
        network.encode_texels()
    losses = partial(batches.losses, encoded=False, first=encoder_steps)
    steps = max(1, settings.steps - encoder_steps)
    trained = [network.latents, *parameters(*common)]
    run("textures", trained, losses, steps, _QUERIES_DONE + middle, span - middle, done=(share, 1.0))
    sampler = _SamplerLosses(network, settings)
    trained = parameters(network.sampler, network.albedo)
    last = _WHOLE - _TEXTURES_DONE
    run("sampler", trained, sampler.losses, settings.sampler_steps, _TEXTURES_DONE, last, "adam")


_Losses = Callable[[int], Iterator[Tensor]]


def taken_queries(
    source: Source,
    settings: LatentSettings,
    reflectance: Reflectance,
    levels: int,
    folder: Path,
    report: Progress,
) -> Queries:
    """All queries of a training; parts that the folder holds are read."""
    stream = QueryStream(reflectance, levels, settings.samples, settings.seed)
    store = FileStore(Queries, folder, settings.identity(source))

    def done(number: int, parts: int) -> None:
        report(_QUERIES_DONE * number // parts, _WHOLE)

    return stored_queries(stream.part, store, settings.queries, done)


def rate_factor(progress: float) -> float:
    """The learning rate over the largest, at a progress from 0 to 1 (eq. 1)."""
    return _LAST_RATE + 0.5 * (1 - _LAST_RATE) * (1 + math.cos(math.pi * progress))


class _Batches:
    """Losses of steps: each pass over the queries is in an order of its own."""

    def __init__(self, network: LatentNetwork, queries: Queries, settings: LatentSettings) -> None:
        self._network, self._queries, self._settings = network, queries, settings
        self._device = network.latents.device
        self._side_by_side = SideBySide.for_batch(self._device.type, settings.batch)
        self._order: tuple[int, NDArray[np.intp]] | None = None

    def losses(self, step: int, encoded: bool, first: int) -> Iterator[Tensor]:
        """The loss of one step.

        Args:
            encoded: whether latents are the encoder's.
            first: steps before this phase.
        """
        parts = np.array_split(self._chosen(first + step), self._side_by_side.parts)
        losses = [partial(self._loss, part, encoded) for part in parts]
        yield self._side_by_side.loss(losses, [1 / len(parts)] * len(parts), self._network)

    def _loss(self, chosen: NDArray[np.intp], encoded: bool) -> Tensor:
        batch = self._queries[chosen]
        positions, lights, views, values = (
            torch.from_numpy(part).to(self._device)
            for part in (batch.positions, batch.lights, batch.views, batch.values)
        )
        levels, faces = (
            torch.from_numpy(part.astype(np.int64)).to(self._device) for part in (batch.levels, batch.faces)
        )
        latent = self._network.latent(positions, levels, faces, encoded)
        return loss_of(self._network(latent, lights, views), values, self._settings.loss)

    def _chosen(self, step: int) -> NDArray[np.intp]:
        batch = self._settings.batch
        number, place = divmod(step, max(1, len(self._queries) // batch))
        if self._order is None or self._order[0] != number:
            rng = np.random.default_rng([self._settings.seed, _BATCHES, number])
            self._order = number, rng.permutation(len(self._queries))
        return self._order[1][place * batch : (place + 1) * batch]


class _SamplerLosses:
    """Losses of the sampler: it learns what the trained decoder scatters, at places drawn anew each step."""

    def __init__(self, network: LatentNetwork, settings: LatentSettings) -> None:
        self._network, self._settings = network, settings

    def losses(self, step: int) -> Iterator[Tensor]:
        """The loss of one step."""
        network, settings = self._network, self._settings
        rng = np.random.default_rng([settings.seed, _SAMPLER, step])
        latent, views = _places(network, rng, settings.sampler_batch)
        generator = torch.Generator().manual_seed(int(rng.integers(2**62)))

        def reflected(lights: Tensor) -> Tensor:
            # Each view and latent is that of a row of lights.
            latents, seen = (part[:, None].expand(-1, lights.shape[1], -1) for part in (latent, views))
            values: Tensor = network(latents, lights, seen)
            return values

        yield sampler_loss(*network.sampler_outputs(latent, views), views, reflected, _LIGHTS, generator)


@torch.no_grad()
def _places(
    network: LatentNetwork, rng: np.random.Generator, count: int, face: int | None = None
) -> tuple[Tensor, Tensor]:
    """Latents and views at random places of all levels."""
    shape, device = network.shape, network.latents.device
    levels = draw_levels(rng, count, shape.levels).astype(np.int64)
    faces = rng.integers(shape.faces, size=count) if face is None else np.full(count, face)
    positions = torch.from_numpy(rng.random((count, 2), np.float32)).to(device)
    latent = network.latent(
        positions, torch.from_numpy(levels).to(device), torch.from_numpy(faces).to(device), encoded=False
    )
    return latent, torch.from_numpy(draw_directions(rng, count)).to(device)


@torch.no_grad()
def _face_albedos(network: LatentNetwork, seed: int) -> NDArray[np.float32]:
    """Mean albedo of each face [faces, 3], by the trained network."""
    means = []
    for face in range(network.shape.faces):
        rng = np.random.default_rng([seed, _ALBEDOS, face])
        _, log_albedo = network.sampler_outputs(*_places(network, rng, _ALBEDO_VIEWS, face))
        means.append(torch.exp(log_albedo).mean(dim=0).clamp(0, 1).cpu().numpy())
    return np.stack(means).astype(np.float32)
