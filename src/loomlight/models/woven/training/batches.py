"""What the steps of a training learn from: faces and queries drawn by chance, and their losses."""

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

from loomlight.models.woven.footprint_coding import levels_of, network_places, taps
from loomlight.models.woven.training.config import TrainingConfig
from loomlight.models.woven.training.dataset import Face
from loomlight.models.woven.training.losses import LOSSES
from loomlight.models.woven.training.network import FieldEncoder, WovenNetwork
from loomlight.training.side_by_side import SideBySide

_Floats = NDArray[np.float32]
_LARGE = 2.0  # threads; footprints from here on are all learnt from
_DECODER_FACES = 4  # times as many faces in a step of the decoder alone, of that part of the queries each
# They keep the random numbers of batches apart from those of the dataset.
_STREAM, _DECODER_STREAM = 7, 11
# Parts of a batch on CPUs: a number that no machine changes, as the weights depend on it.
_PARTS = 2


@dataclass
class _Part:
    """Some of a step's faces.

    Attributes:
        numbers: of faces, whose maps are about as large together as those of every other part.
        rng: of their queries.
        latents: of each, once they are encoded [texels, latent_size].
    """

    numbers: list[int]
    rng: np.random.Generator
    latents: list[Tensor] = field(default_factory=list)


class Batches:
    """Losses of steps: which faces and queries a step sees depends on the seed and its number alone."""

    def __init__(
        self, config: TrainingConfig, faces: list[Face], network: WovenNetwork, device: torch.device
    ) -> None:
        self._config = config
        self._faces = faces
        self._network = network
        self._device = device
        self._kept: list[Tensor] = []
        self._side_by_side = SideBySide(_PARTS if device.type == "cpu" else 1)

    def losses(self, step: int) -> Iterator[Tensor]:
        """The losses of one step: of encoder and decoder, then of the decoder, the latents as they were."""
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
        """So many faces, dealt out from the largest on to who has least and may have more."""
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
            least = min(allowed, key=lambda part: sum(faces[k].maps.size for k in part.numbers))
            least.numbers.append(number)
        return parts

    def _loss(self, loss: Callable[[_Part], Tensor], parts: list[_Part], network: nn.Module) -> Tensor:
        faces = sum(len(part.numbers) for part in parts)
        shares = [len(part.numbers) / faces for part in parts]
        return self._side_by_side.loss([partial(loss, part) for part in parts], shares, network)

    def _loss_of(self, loss: str, part: _Part, latents: list[Tensor], queries: int) -> Tensor:
        small, chosen = self._config.training.small_footprints, [self._faces[k] for k in part.numbers]
        drawn = [_draw(face, part.rng, queries, small) for face in chosen]
        places = [
            network_places(self._config.network, face.threads[0], face.threads[1], asked[0])
            for face, asked in zip(chosen, drawn, strict=True)
        ]
        # The queries of all faces, one face after another.
        light, view, truth = (
            self._tensor(np.concatenate([asked[part] for asked in drawn])) for part in (1, 2, 3)
        )
        place = self._tensor(np.concatenate(places))
        fibres = self._tensor(np.repeat(np.stack([face.fibres for face in chosen]), queries, axis=0))
        bundles = self._tensor(np.stack([face.bundles for face in chosen]))
        latent = self._fetched(chosen, latents, [asked[0] for asked in drawn])
        with self._half_precision():
            output, hole = self._network.decoder(latent, place, light, view, fibres, bundles)
        return LOSSES[loss](output.float(), hole.float(), truth, light)

    def keep_latents(self) -> None:
        """Keeps the latents of all faces as they are now, for `decoder_losses`."""
        with torch.no_grad():
            self._kept = [self._encoded([face])[0].half() for face in self._faces]

    def decoder_losses(self, step: int) -> Iterator[Tensor]:
        """The loss of one step of the decoder alone, with the latents that were kept.

        As these cost nothing, a step takes more faces, with fewer queries each.
        """
        training = self._config.training
        seed = [training.seed, _DECODER_STREAM, step]
        queries = -(-training.queries // _DECODER_FACES)

        def loss(part: _Part) -> Tensor:
            latents = [self._kept[k].float() for k in part.numbers]
            return self._loss_of(training.decoder_loss, part, latents, queries)

        parts = self._parts(_DECODER_FACES * training.fabrics, seed)
        yield self._loss(loss, parts, self._network.decoder)

    def _half_precision(self) -> torch.autocast:
        """Where the machine computes with it: on other processors it takes four times as long as without."""
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

    def _fetched(self, faces: list[Face], tables: list[Tensor], places: list[_Floats]) -> Tensor:
        """The latent of each query [n, latent_size]."""
        if not isinstance(self._network.encoder, FieldEncoder):
            return torch.cat(tables).repeat_interleave(len(places[0]), 0)
        texels, weights, first = [], [], 0
        for face, table, place in zip(faces, tables, places, strict=True):
            index, weight = taps(levels_of(*face.threads), place[:, 0], place[:, 1], place[:, 2])
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


def _draw(face: Face, rng: np.random.Generator, count: int, small: float) -> tuple[_Floats, ...]:
    """Places, lights, views and truths of random queries of a face.

    Args:
        small: share of the smallest footprints that is kept.
    """
    pairs, footprints, _ = face.places.shape
    places = face.places.reshape(-1, 3)
    index = np.empty(0, np.int64)
    while len(index) < count:
        drawn = rng.integers(pairs * footprints, size=2 * count)
        kept = rng.random(2 * count) < np.clip(np.sqrt(places[drawn, 2] / _LARGE), small, 1)
        index = np.concatenate([index, drawn[kept]])
    index = index[:count]
    pair = index // footprints
    return (
        places[index],
        face.lights[pair],
        face.views[pair],
        face.truth.reshape(-1, 5)[index].astype(np.float32),
    )
