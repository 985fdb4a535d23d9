"""Training of the universal network from a configuration, dataset included; resumes from checkpoints."""

from __future__ import annotations

import hashlib
import json
import math
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import torch
from torch import distributed

from loomlight.core.errors import InputError
from loomlight.core.files import replacing
from loomlight.core.provenance import provenance
from loomlight.models.neural.architecture import FIELD_MAP, VECTOR_MAP
from loomlight.models.neural.learned_truth import ENTRY, moved_since, truth_numbers
from loomlight.training.loop import Report, Schedule, train
from loomlight.training.parallel import process_count, process_number, wait_for_all
from loomlight.training.soap import Soap
from studies.papers.chen2024.training.batches import Batches
from studies.papers.chen2024.training.config import TrainingConfig, TrainingTable
from studies.papers.chen2024.training.dataset import Face, dataset_faces, read_faces, write_faces
from studies.papers.chen2024.training.export import export_encoder
from studies.papers.chen2024.training.losses import is_published
from studies.papers.chen2024.training.network import ClothNetwork, Decoder
from studies.papers.chen2024.training.weights_file import write_weights

# Called with (fabrics made, fabrics in all).
DatasetReport = Callable[[int, int], None]
_WARM_UP = 0.01
# Of what the dataset's files hold: a folder of another version is left alone.
_DATASET_VERSION = 6
_TRUTH = "truth.json"


@contextmanager
def process_group() -> Iterator[None]:
    """In the group that torchrun's variables name, for the block; by gloo, on processors."""
    if "WORLD_SIZE" not in os.environ or "RANK" not in os.environ or distributed.is_initialized():
        yield
        return
    distributed.init_process_group("gloo")
    try:
        yield
        # The one that keeps the store must be the last to leave.
        distributed.barrier()
    finally:
        distributed.destroy_process_group()


def train_neural(
    config: TrainingConfig,
    folder: Path,
    dataset_report: DatasetReport | None = None,
    report: Report | None = None,
    device: str = "cpu",
    keep_every: float = 60.0,
) -> Path:
    """Trains a network and writes `neural.safetensors`, which it returns, and its encoder `neural.onnx`.

    Args:
        folder: holds the dataset (`pool-…/`) and the checkpoint; made if need be, and used again to go on.
        device: of torch, "cpu" or "cuda".
        keep_every: seconds between checkpoints.

    Raises:
        InputError: the folder belongs to another configuration, or a file in it is damaged.
    """
    if config.training.fabrics < process_count():
        raise InputError(
            f"[training] fabrics = {config.training.fabrics} is fewer than the {process_count()} processes, "
            "which share the fabrics of each step: start fewer processes."
        )
    pool = folder / f"pool-{_identity(_DATASET_VERSION, config.data, config.network.latent)[:8]}"
    faces = make_dataset(config, pool, dataset_report)
    torch.manual_seed(config.training.seed)
    network = ClothNetwork(config.network).to(device)
    training = config.training
    schedule = Schedule(
        steps=training.steps,
        rate=lambda progress: training.rate * rate_factor(training, progress),
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
                rate=lambda progress: training.decoder_rate * rate_factor(training, progress),
                keep_every=keep_every,
            ),
            folder / "decoder.safetensors",
            _identity(config),
            report,
        )
    weights = folder / "neural.safetensors"
    if process_number() != 0:
        return weights
    write_weights(
        weights,
        network.decoder.table,
        {name: tensor.cpu().numpy() for name, tensor in network.state_dict().items()},
        linear_diffuse=is_published(training),
        recipe=config.model_dump(),
        provenance={
            **provenance("python -m studies.papers.chen2024.training", Path(__file__).parent),
            "steps": steps,
            ENTRY: read_truth(pool),
        },
    )
    export_encoder(weights)
    return weights


def last_decoder(config: TrainingConfig, before: Decoder) -> Decoder:
    """The decoder of the last stage, which trains alone: that of the first stage, or a new one."""
    training, table = config.training, config.network
    changes: dict[str, Any] = {"hidden": training.decoder_hidden or table.hidden}
    if training.decoder_bundles:
        changes["bundles"] = True
    requested = table.model_copy(update=changes)
    if requested == table:
        return before
    torch.manual_seed(training.seed)
    return Decoder(requested)


def make_dataset(config: TrainingConfig, folder: Path, report: DatasetReport | None = None) -> list[Face]:
    """The faces of all fabrics of the dataset; fabrics already in the folder are read."""
    from drjit.llvm.ad import Float

    from loomlight.core.llvm import require_llvm

    require_llvm()
    folder.mkdir(parents=True, exist_ok=True)
    _require_same_truth(folder, truth_numbers(Float))
    per_thread = config.network.latent == "field"
    side = FIELD_MAP if per_thread else VECTOR_MAP
    faces: list[Face] = []
    for number in range(config.data.fabrics):
        path = folder / f"{number:06d}.safetensors"
        if number % process_count() == process_number() and not path.exists():
            write_faces(path, dataset_faces(config.data, number, side, per_thread, Float))
        if report is not None:
            report(number + 1, config.data.fabrics)
    wait_for_all()
    for number in range(config.data.fabrics):
        faces += read_faces(folder / f"{number:06d}.safetensors")
    return faces


def read_truth(folder: Path) -> list[float]:
    """What the dataset's fabrics looked like when it was begun: `truth_numbers` of that day."""
    return [float(number) for number in json.loads((folder / _TRUTH).read_text())]


def _require_same_truth(folder: Path, now: list[float]) -> None:
    """Keeps the truth of the first data beside them, and refuses to add others to them.

    Raises:
        InputError: the folder has data of other yarns.
    """
    file = folder / _TRUTH
    if not file.exists() and process_number() == 0:
        with replacing(file) as temporary:
            temporary.write_text(json.dumps(now))
    wait_for_all()
    if moved_since({ENTRY: read_truth(folder)}, now) is not None:
        raise InputError(
            f"{folder} has data of yarns that this version computes otherwise: remove it, and its "
            "checkpoints, to train on today's."
        )


def rate_factor(training: TrainingTable, progress: float) -> float:
    """The learning rate over the largest, 0 to 1, at a progress of the training from 0 to 1."""
    if training.schedule == "steps":
        return 0.2 ** sum(progress >= drop for drop in (0.6, 0.9))
    return min(1.0, (progress + 1e-9) / _WARM_UP) * 0.5 * (1 + math.cos(math.pi * progress))


def _optimiser(network: torch.nn.Module, training: TrainingTable) -> torch.optim.Optimizer:
    parameters = network.parameters()
    if training.optimiser == "sgd":
        return torch.optim.SGD(parameters, training.rate, weight_decay=training.regularisation)
    if training.optimiser == "soap":
        return Soap(parameters, training.rate, training.regularisation)
    return torch.optim.AdamW(
        parameters, training.rate, betas=(0.9, 0.99), weight_decay=training.regularisation
    )


def _identity(*parts: Any) -> str:
    """A hash of tables of a configuration."""
    dumped = [part.model_dump() if hasattr(part, "model_dump") else part for part in parts]
    return hashlib.sha256(json.dumps(dumped, sort_keys=True).encode()).hexdigest()
