"""Training of the universal network from a configuration, data included; it goes on where it was stopped."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor
from torch.nn import functional

from loomlight.core.provenance import provenance
from loomlight.models.woven.architecture import FIELD_MAP, VECTOR_MAP
from loomlight.models.woven.config import TrainingConfig, TrainingTable
from loomlight.models.woven.losses import LOSSES, is_published
from loomlight.models.woven.network import Decoder, FieldEncoder, WovenNetwork
from loomlight.models.woven.places import network_places
from loomlight.models.woven.pool import Face, pool_faces, read_faces, write_faces
from loomlight.models.woven.pyramid import levels_of, taps
from loomlight.models.woven.weights import write_weights
from loomlight.training.loop import Report, Schedule, train
from loomlight.training.soap import Soap

# Called with (fabrics made, fabrics in all).
PoolReport = Callable[[int, int], None]
_Floats = NDArray[np.float32]
_WARM_UP = 0.01
_LARGE = 2.0  # threads; footprints from here on are all learnt from
_DECODER_FACES = 4  # times as many faces in a step of the decoder alone, of that part of the queries each
# Of what the pool's files hold: a folder of another version is left alone.
_POOL_VERSION = 4
# They keep the random numbers of batches apart from those of the pool.
_STREAM, _DECODER_STREAM = 7, 11


def train_woven(
    config: TrainingConfig,
    folder: Path,
    pool_report: PoolReport | None = None,
    report: Report | None = None,
    device: str = "cpu",
    keep_every: float = 60.0,
) -> Path:
    """Trains a network and writes `woven.safetensors`, which it names.

    Args:
        folder: holds the pool (`pool/`) and the checkpoint; made if need be, and used again to go on.
        device: of torch, "cpu" or "cuda".
        keep_every: seconds between checkpoints.

    Raises:
        InputError: the folder belongs to another configuration, or a file in it is damaged.
    """
    faces = make_pool(
        config,
        folder / f"pool-{_identity(_POOL_VERSION, config.data, config.network.latent)[:8]}",
        pool_report,
    )
    torch.manual_seed(config.training.seed)
    network = WovenNetwork(config.network).to(device)
    training = config.training
    schedule = Schedule(
        steps=training.steps,
        rate=lambda share: training.rate * rate_share(training, share),
        seconds=60 * training.minutes,
        keep_every=keep_every,
    )
    batches = Batches(config, faces, network, torch.device(device))
    steps = train(
        network,
        _optimiser(network, training),
        batches.losses,
        schedule,
        folder / "checkpoint.safetensors",
        _identity(config),
        report,
    )
    if training.decoder_steps:
        batches.keep_latents()
        network.decoder = last_decoder(config, network.decoder).to(device)
        steps += train(
            network.decoder,
            _optimiser(network.decoder, training),
            batches.decoder_losses,
            Schedule(
                steps=training.decoder_steps,
                rate=lambda share: training.decoder_rate * rate_share(training, share),
                keep_every=keep_every,
            ),
            folder / "decoder.safetensors",
            _identity(config),
            report,
        )
    weights = folder / "woven.safetensors"
    write_weights(
        weights,
        network.decoder.table,
        {name: tensor.cpu().numpy() for name, tensor in network.state_dict().items()},
        linear_diffuse=is_published(training),
        recipe=config.model_dump(),
        provenance={**provenance("loomlight train woven", Path(__file__).parent), "steps": steps},
    )
    return weights


def last_decoder(config: TrainingConfig, before: Decoder) -> Decoder:
    """The decoder that is trained alone: that of the training before, or a new one."""
    training, table = config.training, config.network
    changes: dict[str, Any] = {"hidden": training.decoder_hidden or table.hidden}
    if training.decoder_bundles:
        changes["bundles"] = True
    wanted = table.model_copy(update=changes)
    if wanted == table:
        return before
    torch.manual_seed(training.seed)
    return Decoder(wanted)


def make_pool(config: TrainingConfig, folder: Path, report: PoolReport | None = None) -> list[Face]:
    """The faces of all fabrics of the pool; what the folder has is not made again."""
    from drjit.llvm.ad import Float

    from loomlight.core.llvm import require_llvm

    require_llvm()
    folder.mkdir(parents=True, exist_ok=True)
    per_thread = config.network.latent == "field"
    side = FIELD_MAP if per_thread else VECTOR_MAP
    faces: list[Face] = []
    for number in range(config.data.fabrics):
        path = folder / f"{number:06d}.safetensors"
        if not path.exists():
            write_faces(path, pool_faces(config.data, number, side, per_thread, Float))
        faces += read_faces(path)
        if report is not None:
            report(number + 1, config.data.fabrics)
    return faces


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

    def losses(self, step: int) -> Iterator[Tensor]:
        """The losses of one step: of encoder and decoder, then of the decoder, the latents as they were."""
        training = self._config.training
        rng = np.random.default_rng([training.seed, _STREAM, step])
        count = min(training.fabrics, len(self._faces))
        chosen = [self._faces[k] for k in rng.choice(len(self._faces), count, replace=False)]
        latents = self._encoded(chosen)
        yield self._loss_of(training.loss, chosen, latents, rng, training.queries)
        kept = [table.detach() for table in latents]
        for _ in range(training.updates - 1):
            yield self._loss_of(training.loss, chosen, kept, rng, training.queries)

    def _loss_of(
        self, loss: str, chosen: list[Face], latents: list[Tensor], rng: np.random.Generator, queries: int
    ) -> Tensor:
        small = self._config.training.small_footprints
        drawn = [_draw(face, rng, queries, small) for face in chosen]
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
        count = min(_DECODER_FACES * training.fabrics, len(self._faces))
        rng = np.random.default_rng([training.seed, _DECODER_STREAM, step])
        chosen = rng.choice(len(self._faces), count, replace=False)
        latents = [self._kept[k].float() for k in chosen]
        some = [self._faces[k] for k in chosen]
        yield self._loss_of(training.decoder_loss, some, latents, rng, -(-training.queries // _DECODER_FACES))

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


def rate_share(training: TrainingTable, share: float) -> float:
    """The learning rate as a share of the largest, after a share of the training."""
    if training.schedule == "steps":
        return 0.2 ** sum(share >= drop for drop in (0.6, 0.9))
    return min(1.0, (share + 1e-9) / _WARM_UP) * 0.5 * (1 + math.cos(math.pi * share))


def _optimiser(network: torch.nn.Module, training: TrainingTable) -> torch.optim.Optimizer:
    parameters = network.parameters()
    if training.optimiser == "sgd":
        return torch.optim.SGD(parameters, training.rate, weight_decay=training.regularisation)
    if training.optimiser == "soap":
        return Soap(parameters, training.rate, training.regularisation)
    return torch.optim.AdamW(
        parameters, training.rate, betas=(0.9, 0.99), weight_decay=training.regularisation
    )


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


def _identity(*parts: Any) -> str:
    """A hash of tables of a configuration."""
    dumped = [part.model_dump() if hasattr(part, "model_dump") else part for part in parts]
    return hashlib.sha256(json.dumps(dumped, sort_keys=True).encode()).hexdigest()
