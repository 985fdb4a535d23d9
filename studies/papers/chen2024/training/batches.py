"""Batches of a training: random faces and queries for each step, and their losses."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional

from loomlight.models.neural.architecture import NetworkTable
from loomlight.models.neural.encoded_fabric import footprint_coordinates, levels_of, near_weight, taps
from loomlight.training.parallel import SideBySide, process_count
from studies.papers.chen2024.training.config import TrainingConfig
from studies.papers.chen2024.training.dataset import Face
from studies.papers.chen2024.training.losses import LOSSES
from studies.papers.chen2024.training.network import ClothNetwork, FieldEncoder

_Floats = NDArray[np.float32]
_LARGE = 2.0  # threads; all footprints of at least this size are used
_DECODER_FACES = 4  # times as many faces in a step of the decoder alone, with a quarter of the queries each
# Keys that separate the random numbers of batches from those of the dataset.
_STREAM, _DECODER_STREAM = 7, 11
# Parts of a batch on CPUs: the same on every machine, as the weights depend on it.
_PARTS = 2


@dataclass
class _Part:
    """Some of a step's faces.

    Attributes:
        numbers: of faces; the total size of their maps is about the same for every part.
        rng: of their queries.
        latents: of each, once they are encoded [texels, latent_size].
    """

    numbers: list[int]
    rng: np.random.Generator
    latents: list[Tensor] = field(default_factory=list)


class Batches:
    """Losses of steps; the faces and queries of a step depend on the seed and its number alone."""

    def __init__(
        self, config: TrainingConfig, faces: list[Face], network: ClothNetwork, device: torch.device
    ) -> None:
        self._config = config
        self._faces = faces
        self._network = network
        self._device = device
        self._latents: list[Tensor] = []
        self._side_by_side = SideBySide(max(_PARTS if device.type == "cpu" else 1, process_count()))

    def losses(self, step: int) -> Iterator[Tensor]:
        """The losses of one step: of encoder and decoder, then of the decoder alone on the same latents."""
        training, network = self._config.training, self._network
        parts = self._parts(training.fabrics, [training.seed, _STREAM, step])

        def encoded(part: _Part) -> Tensor:
            latents = self._encoded([self._faces[k] for k in part.numbers])
            part.latents = [table.detach() for table in latents]
            return self._loss_of(training.loss, part, latents, training.queries)

        def decoded(part: _Part) -> Tensor:
            return self._loss_of(training.loss, part, part.latents, training.queries)

        yield self._loss(encoded, parts, network)
        for _ in range(training.updates - 1):
            yield self._loss(decoded, parts, network.decoder)

    def _parts(self, count: int, seed: list[int]) -> list[_Part]:
        """`count` random faces, dealt to parts from the largest on, always to the smallest part with room."""
        faces = self._faces
        count = min(count, len(faces))
        chosen = np.random.default_rng(seed).choice(len(faces), count, replace=False).tolist()
        parts = [
            _Part([], np.random.default_rng([*seed, number]))
            for number in range(min(self._side_by_side.parts, count))
        ]
        most = -(-count // len(parts))
        for number in sorted(chosen, key=lambda number: -faces[number].maps.size):
            allowed = [part for part in parts if len(part.numbers) < most]
            smallest = min(allowed, key=lambda part: sum(faces[k].maps.size for k in part.numbers))
            smallest.numbers.append(number)
        return parts

    def _loss(self, loss: Callable[[_Part], Tensor], parts: list[_Part], network: nn.Module) -> Tensor:
        faces = sum(len(part.numbers) for part in parts)
        weights = [len(part.numbers) / faces for part in parts]
        return self._side_by_side.loss([partial(loss, part) for part in parts], weights, network)

    def _loss_of(self, loss: str, part: _Part, latents: list[Tensor], queries: int) -> Tensor:
        small, chosen = self._config.training.small_footprints, [self._faces[k] for k in part.numbers]
        parallax = self._config.network.parallax
        drawn = [_draw(face, part.rng, queries, small, parallax) for face in chosen]
        coordinate_arrays = [
            coordinate_rows(self._config.network, face.threads[0], face.threads[1], sample[0])
            for face, sample in zip(chosen, drawn, strict=True)
        ]
        # Queries of all faces, face by face.
        light, view, truth = (
            self._tensor(np.concatenate([sample[part] for sample in drawn])) for part in (1, 2, 3)
        )
        coordinates = self._tensor(np.concatenate(coordinate_arrays))
        fibres = self._tensor(np.repeat(np.stack([face.fibres for face in chosen]), queries, axis=0))
        bundles = self._tensor(np.stack([face.bundles for face in chosen]))
        latent = self._fetched(chosen, latents, [sample[0] for sample in drawn])
        with self._half_precision():
            output, hole = self._network.decoder(latent, coordinates, light, view, fibres, bundles)
        return LOSSES[loss](output.float(), hole.float(), truth, light)

    def keep_latents(self) -> None:
        """Stores the current latents of all faces for `decoder_losses`."""
        with torch.no_grad():
            self._latents = [self._encoded([face])[0].half() for face in self._faces]

    def decoder_losses(self, step: int) -> Iterator[Tensor]:
        """The loss of one step of the decoder alone, on the stored latents.

        Stored latents cost nothing, so a step has more faces, with fewer queries each.
        """
        training = self._config.training
        seed = [training.seed, _DECODER_STREAM, step]
        queries = -(-training.queries // _DECODER_FACES)

        def loss(part: _Part) -> Tensor:
            latents = [self._latents[k].float() for k in part.numbers]
            return self._loss_of(training.decoder_loss, part, latents, queries)

        parts = self._parts(_DECODER_FACES * training.fabrics, seed)
        yield self._loss(loss, parts, self._network.decoder)

    def _half_precision(self) -> torch.autocast:
        """bfloat16 where the processor supports it: on others it takes four times as long as float32."""
        capabilities: dict[str, Any] = getattr(torch.cpu, "get_capabilities", dict)()
        enabled = self._device.type != "cpu" or capabilities.get("avx512_bf16", False)
        return torch.autocast(self._device.type, torch.bfloat16, enabled=enabled)

    def _encoded(self, faces: list[Face]) -> list[Tensor]:
        """The latents of each face [texels, latent_size]."""
        encoder = self._network.encoder
        parameters = [self._tensor(face.parameters) for face in faces]
        with self._half_precision():
            if isinstance(encoder, FieldEncoder):
                tables = [
                    encoder(self._tensor(face.maps), values)[0]
                    for face, values in zip(faces, parameters, strict=True)
                ]
            else:
                maps = torch.stack([self._tensor(face.maps) for face in faces])
                tables = list(encoder(maps, torch.stack(parameters)).split(1))
        return [table.float() for table in tables]

    def _fetched(self, faces: list[Face], tables: list[Tensor], footprints: list[_Floats]) -> Tensor:
        """The latent of each query [n, latent_size]."""
        if not isinstance(self._network.encoder, FieldEncoder):
            return torch.cat(tables).repeat_interleave(len(footprints[0]), 0)
        texels, weights, first = [], [], 0
        for face, table, footprint in zip(faces, tables, footprints, strict=True):
            index, weight = taps(levels_of(*face.threads), *footprint.T)
            texels.append(index + first)
            weights.append(weight)
            first += len(table)
        return functional.embedding_bag(
            self._tensor(np.concatenate(texels)),
            torch.cat(tables),
            per_sample_weights=self._tensor(np.concatenate(weights)),
            mode="sum",
        )

    def _tensor(self, array: NDArray[Any]) -> Tensor:
        return torch.from_numpy(np.ascontiguousarray(array)).to(self._device)


def coordinate_rows(table: NetworkTable, picks: int, ends: int, footprints: _Floats) -> _Floats:
    """`footprint_coordinates` [n, 3] of footprints [n, 3]: position x and y and side, in threads."""
    return np.stack(footprint_coordinates(table, picks, ends, *footprints.T), -1).astype(np.float32)


def _draw(
    face: Face, rng: np.random.Generator, count: int, small: float, parallax: bool
) -> tuple[_Floats, ...]:
    """Footprints, lights, views and truths of random queries of a face.

    Args:
        small: probability of accepting the smallest footprints.
        parallax: small footprints are where their view ray meets yarn.
    """
    pairs, footprints, _ = face.places.shape
    all_footprints = face.places.reshape(-1, 3)
    index = np.empty(0, np.int64)
    while len(index) < count:
        drawn = rng.integers(pairs * footprints, size=2 * count)
        accepted = rng.random(2 * count) < np.clip(np.sqrt(all_footprints[drawn, 2] / _LARGE), small, 1)
        index = np.concatenate([index, drawn[accepted]])
    index = index[:count]
    pair = index // footprints
    drawn_footprints = all_footprints[index]
    if parallax:
        to_yarn = face.seen.reshape(-1, 2)[index] - drawn_footprints[:, :2]
        drawn_footprints[:, :2] += near_weight(drawn_footprints[:, 2:]) * to_yarn
    return (
        drawn_footprints,
        face.lights[pair],
        face.views[pair],
        face.truth.reshape(-1, 5)[index].astype(np.float32),
    )
