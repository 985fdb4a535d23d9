"""Batches of a training: random faces and queries for each step, and their losses."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional

from loomlight.evaluation.query_benchmark import DIFFUSE_ALBEDO, SPECULAR_ALBEDO
from loomlight.models.neural.architecture import NetworkTable
from loomlight.models.neural.encoded_fabric import footprint_coordinates, levels_of, near_weight, taps
from loomlight.training.parallel import SideBySide, process_count
from studies.papers.chen2024.training.config import TrainingConfig
from studies.papers.chen2024.training.dataset import Face
from studies.papers.chen2024.training.losses import GROUP, LOSSES, is_published, unmapped
from studies.papers.chen2024.training.network import ClothNetwork, FieldEncoder
from studies.papers.chen2024.training.stored import QueriedFace

_Floats = NDArray[np.float32]
AnyFace = Face | QueriedFace
_LARGE = 2.0  # threads; all footprints of at least this size are used
_DECODER_FACES = 4  # times as many faces in a step of the decoder alone, with a quarter of the queries each
# Keys that separate the random numbers of batches from those of the dataset.
_STREAM, _DECODER_STREAM = 7, 11
# Parts of a batch on CPUs: the same on every machine, as the weights depend on it.
_PARTS = 2
# Albedos of the diffuse and specular components, as in the query benchmark.
_GREY = np.array([DIFFUSE_ALBEDO, DIFFUSE_ALBEDO, SPECULAR_ALBEDO, SPECULAR_ALBEDO], np.float32)


@dataclass
class _Part:
    """Some of a step's portions: queries of one face each.

    Attributes:
        numbers: the face of each portion; the total size of their maps is about the same for every part.
        streams: random numbers of each portion's queries.
        latents: of each portion's face, once they are encoded [texels, latent_size].
    """

    numbers: list[int]
    streams: list[np.random.Generator]
    latents: list[Tensor] = field(default_factory=list)


class Batches:
    """Losses of steps; the faces and queries of a step depend on the seed and its number alone.

    Of drawn fabrics a part has a stream of random numbers, so batches depend on the number of parts too. Of a
    store each portion has one, and what a step draws is the same for any number of processes.
    """

    def __init__(
        self,
        config: TrainingConfig,
        faces: Sequence[AnyFace],
        network: ClothNetwork,
        device: torch.device,
    ) -> None:
        self._config = config
        self._faces = faces
        self._network = network
        self._device = device
        self._latents: list[Tensor] = []
        threads = _PARTS if device.type == "cpu" else 1
        if config.data.store:
            # Two threads would encode a single face twice.
            threads = min(threads, config.training.fabrics)
        self._side_by_side = SideBySide(max(threads, process_count()))

    def losses(self, step: int) -> Iterator[Tensor]:
        """The losses of one step: of encoder and decoder, then of the decoder alone on the same latents."""
        training, network = self._config.training, self._network
        portion = self._portion(training.queries)
        parts = self._parts(training.fabrics, training.queries, [training.seed, _STREAM, step])

        def encoded(part: _Part) -> Tensor:
            numbers = list(dict.fromkeys(part.numbers))
            tables = dict(zip(numbers, self._encoded([self._faces[k] for k in numbers]), strict=True))
            latents = [tables[k] for k in part.numbers]
            part.latents = [table.detach() for table in latents]
            return self._loss_of(training.loss, part, latents, portion)

        def decoded(part: _Part) -> Tensor:
            return self._loss_of(training.loss, part, part.latents, portion)

        yield self._loss(encoded, parts, network)
        for _ in range(training.updates - 1):
            yield self._loss(decoded, parts, network.decoder)

    def _portion(self, queries: int) -> int:
        """Queries of a portion of `queries` of one face."""
        return portion_size(queries) if self._config.data.store else queries

    def _parts(self, count: int, queries: int, seed: list[int]) -> list[_Part]:
        """`count` random faces, dealt to parts from the largest on, always to the smallest part with room.

        Where there are fewer faces than parts, the parts share their portions.
        """
        # Once: faces of a store are read by this, on the thread that may compute their maps.
        count = min(count, len(self._faces))
        chosen = np.random.default_rng(seed).choice(len(self._faces), count, replace=False).tolist()
        sizes = {number: self._faces[number].maps.size for number in chosen}
        parts = min(self._side_by_side.parts, count)
        most = -(-count // parts)
        dealt: list[list[int]] = [[] for _ in range(parts)]
        for number in sorted(chosen, key=lambda number: -sizes[number]):
            allowed = [numbers for numbers in dealt if len(numbers) < most]
            min(allowed, key=lambda numbers: sum(sizes[k] for k in numbers)).append(number)
        if not self._config.data.store:
            streams = [np.random.default_rng([*seed, number]) for number in range(parts)]
            return [
                _Part(numbers, [stream] * len(numbers))
                for numbers, stream in zip(dealt, streams, strict=True)
            ]
        each = queries // self._portion(queries)
        portions = [
            [(number, np.random.default_rng([*seed, number, k])) for number in numbers for k in range(each)]
            for numbers in dealt
        ]
        wanted = min(self._side_by_side.parts, count * each)
        if wanted > parts:
            flat = [portion for some in portions for portion in some]
            bounds = [len(flat) * k // wanted for k in range(wanted + 1)]
            portions = [flat[first:end] for first, end in pairwise(bounds)]
        return [_Part([face for face, _ in some], [stream for _, stream in some]) for some in portions]

    def _loss(self, loss: Callable[[_Part], Tensor], parts: list[_Part], network: nn.Module) -> Tensor:
        portions = sum(len(part.numbers) for part in parts)
        weights = [len(part.numbers) / portions for part in parts]
        return self._side_by_side.loss([partial(loss, part) for part in parts], weights, network)

    def _loss_of(self, loss: str, part: _Part, latents: list[Tensor], queries: int) -> Tensor:
        small, chosen = self._config.training.small_footprints, [self._faces[k] for k in part.numbers]
        parallax = self._config.network.parallax
        drawn = [
            _draw(face, stream, queries, small, parallax)
            for face, stream in zip(chosen, part.streams, strict=True)
        ]
        output, hole, truth, light = self._answers(chosen, drawn, latents)
        return LOSSES[loss](output, hole, truth, light)

    def reflection_nmae(self, faces: Sequence[AnyFace]) -> float:
        """Mean error over mean of f·cos at grey albedos, of all queries of faces with the light in front."""
        error = total = 0.0
        published = is_published(self._config.training)
        with torch.no_grad():
            for face in faces:
                index = np.arange(face.count)
                drawn = _looked_up(face, index, self._config.network.parallax)
                output, _, truth, light = self._answers([face], [drawn], self._encoded([face]))
                found = unmapped(output, light, published)
                in_front = light[:, 2] > 0
                values = [part[in_front, :4] @ self._tensor(_GREY) for part in (found, truth)]
                error += float((values[0] - values[1]).abs().sum())
                total += float(values[1].sum())
        return error / total

    def _answers(
        self, chosen: list[AnyFace], drawn: list[tuple[_Floats, ...]], latents: list[Tensor]
    ) -> tuple[Tensor, Tensor, Tensor, Tensor]:
        """Outputs of the decoder, holes, truths and lights of queries, equally many of each face."""
        queries = len(drawn[0][0])
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
        return output.float(), hole.float(), truth, light

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
            return self._loss_of(training.decoder_loss, part, latents, self._portion(queries))

        parts = self._parts(_DECODER_FACES * training.fabrics, queries, seed)
        yield self._loss(loss, parts, self._network.decoder)

    def _half_precision(self) -> torch.autocast:
        """bfloat16 where the processor supports it: on others it takes four times as long as float32."""
        capabilities: dict[str, Any] = getattr(torch.cpu, "get_capabilities", dict)()
        enabled = self._device.type != "cpu" or capabilities.get("avx512_bf16", False)
        return torch.autocast(self._device.type, torch.bfloat16, enabled=enabled)

    def _encoded(self, faces: Sequence[AnyFace]) -> list[Tensor]:
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

    def _fetched(self, faces: list[AnyFace], tables: list[Tensor], footprints: list[_Floats]) -> Tensor:
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


def portion_size(queries: int) -> int:
    """Queries of one portion of a face's: whole groups that losses take means over, or all."""
    return GROUP if queries % GROUP == 0 else queries


def _draw(
    face: AnyFace, rng: np.random.Generator, count: int, small: float, parallax: bool
) -> tuple[_Floats, ...]:
    """Footprints, lights, views and truths of random queries of a face.

    Args:
        small: probability of accepting the smallest footprints.
        parallax: small footprints are where their view ray meets yarn.
    """
    index = np.empty(0, np.int64)
    while len(index) < count:
        drawn = rng.integers(face.count, size=2 * count)
        sizes = face.footprints_of(drawn)[:, 2]
        accepted = rng.random(2 * count) < np.clip(np.sqrt(sizes / _LARGE), small, 1)
        index = np.concatenate([index, drawn[accepted]])
    return _looked_up(face, index[:count], parallax)


def _looked_up(face: AnyFace, index: NDArray[np.int64], parallax: bool) -> tuple[_Floats, ...]:
    """Footprints, lights, views and truths of queries of a face by their numbers."""
    footprints = face.footprints_of(index)
    if parallax:
        to_yarn = face.seen_of(index) - footprints[:, :2]
        footprints[:, :2] += near_weight(footprints[:, 2:]) * to_yarn
    return (footprints, *face.answers_of(index))
