"""Training of the universal network from a configuration, dataset included; resumes from checkpoints."""

from __future__ import annotations

import hashlib
import json
import math
import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import torch
from torch import distributed

from loomlight.core.errors import InputError
from loomlight.core.files import replacing
from loomlight.core.llvm import llvm_float
from loomlight.core.provenance import provenance
from loomlight.models.neural.architecture import FIELD_MAP, VECTOR_MAP
from loomlight.models.neural.learned_truth import ENTRY, moved_since, truth_numbers
from loomlight.models.neural.weights import shipped_weights
from loomlight.models.options import DEVICES
from loomlight.training.loop import Report, Schedule, read_checkpoint, require_device, train, write_checkpoint
from loomlight.training.parallel import process_count, process_number, wait_for_all
from loomlight.training.soap import Soap
from studies.papers.chen2024.dataset_store import QueryStore
from studies.papers.chen2024.training.batches import AnyFace, Batches, portion_size
from studies.papers.chen2024.training.config import TrainingConfig, TrainingTable
from studies.papers.chen2024.training.curve import NAME as CURVE
from studies.papers.chen2024.training.curve import LearningCurve
from studies.papers.chen2024.training.dataset import Face, dataset_faces, read_faces, write_faces
from studies.papers.chen2024.training.export import export_encoder
from studies.papers.chen2024.training.losses import is_published
from studies.papers.chen2024.training.network import ClothNetwork, Decoder
from studies.papers.chen2024.training.stored import StoredFaces, held_out_faces
from studies.papers.chen2024.training.weights_file import write_weights

# Called with (fabrics made, fabrics in all).
DatasetReport = Callable[[int, int], None]
_WARM_UP = 0.01
# Of what the dataset's files hold: a folder of another version is left alone.
_DATASET_VERSION = 6
_TRUTH = "truth.json"
_ENCODER = "encoder."


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
    if device not in DEVICES:
        raise InputError(f'--device "{device}" is none: write {" or ".join(DEVICES)}.')
    require_device(device)
    _require_work_for_all(config)
    faces, truth = _faces_and_truth(config, folder, dataset_report)
    torch.manual_seed(config.training.seed)
    network = ClothNetwork(config.network).to(device)
    training = config.training
    batches = Batches(config, faces, network, torch.device(device))
    if training.encoder == "shipped":
        take_shipped_encoder(network)
        steps = 0
    else:
        steps = _train_both(config, folder, batches, network, report, keep_every)
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
            training_identity(config),
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
            ENTRY: truth,
        },
    )
    export_encoder(weights)
    return weights


def take_shipped_encoder(network: ClothNetwork) -> None:
    """Gives a network the encoder of the one that ships.

    Raises:
        InputError: the encoders differ in shape.
    """
    ours = network.encoder.state_dict()
    shipped = {
        name.removeprefix(_ENCODER): torch.from_numpy(values)
        for name, values in shipped_weights().tensors.items()
        if name.startswith(_ENCODER)
    }
    # A weights file keeps scalars as arrays of one number.
    if {name: values.squeeze().shape for name, values in ours.items()} != {
        name: values.squeeze().shape for name, values in shipped.items()
    }:
        raise InputError(
            '[training] encoder = "shipped" is of another shape than [network] describes: write what '
            "[network] in neural.toml has."
        )
    network.encoder.load_state_dict({name: shipped[name].reshape(ours[name].shape) for name in ours})


def _train_both(
    config: TrainingConfig,
    folder: Path,
    batches: Batches,
    network: ClothNetwork,
    report: Report | None,
    keep_every: float,
) -> int:
    """The first stage, encoder and decoder together; returns its steps."""
    training = config.training
    schedule = Schedule(
        steps=training.steps,
        rate=lambda progress: training.rate * rate_factor(training, progress),
        seconds=60 * training.minutes,
        keep_every=keep_every,
    )
    checkpoint = folder / "checkpoint.safetensors"
    identity = first_stage_identity(config)
    _rename_checkpoint(checkpoint, training_identity(config), identity)
    return train(
        network,
        _optimiser(network, training),
        batches.losses,
        schedule,
        checkpoint,
        identity,
        _with_curve(config, folder, batches, report),
    )


def _require_work_for_all(config: TrainingConfig) -> None:
    """Raises InputError if steps have less work than there are processes, or a curve has no steps."""
    training = config.training
    if training.encoder == "shipped" and not training.decoder_steps:
        raise InputError(
            '[training] encoder = "shipped" leaves nothing to train: give decoder_steps, such as 4000.'
        )
    shares = training.fabrics
    if config.data.store:
        shares *= training.queries // portion_size(training.queries)
    if shares < process_count():
        raise InputError(
            f"[training] fabrics = {training.fabrics} gives {shares} shares a step, fewer than the "
            f"{process_count()} processes: start fewer processes."
        )
    if training.curve and training.minutes:
        raise InputError(
            f"[training] curve = true and minutes = {training.minutes:g}: a curve is of steps; leave one out."
        )


def _faces_and_truth(
    config: TrainingConfig, folder: Path, report: DatasetReport | None
) -> tuple[Sequence[AnyFace], list[float]]:
    """The faces that a training draws from, and `truth_numbers` of when their data were begun."""
    folder.mkdir(parents=True, exist_ok=True)
    if not config.data.store:
        parts = (_DATASET_VERSION, _facts(config)["data"], config.network.latent)
        pool = folder / f"pool-{_digest(*parts)[:8]}"
        return make_dataset(config, pool, report), read_truth(pool)
    Float = llvm_float()
    stored = StoredFaces(config, truth_numbers(Float), Float)
    return stored, [float(number) for number in stored.store.attributes["made_with"][ENTRY]]


def _with_curve(
    config: TrainingConfig, folder: Path, batches: Batches, report: Report | None
) -> Report | None:
    """`report`, and the learning curve if the configuration asks for one."""
    if not config.training.curve or process_number() != 0:
        return report
    held_out = held_out_faces(config.network, config.data.seed, llvm_float())
    curve = LearningCurve(folder / CURVE, lambda: batches.reflection_nmae(held_out))

    def both(done: int, total: int, loss: float) -> None:
        curve(done, total, loss)
        if report is not None:
            report(done, total, loss)

    return both


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
    Float = llvm_float()
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


# Fields that came after trainings had checkpoints: at these values they are no part of identities.
_LATER: dict[str, dict[str, Any]] = {
    "network": {"heights": True},
    "data": {"store": ""},
    "training": {"encoder": "trained"},
}


def _facts(config: TrainingConfig) -> dict[str, dict[str, Any]]:
    """All that weights depend on: tables of the configuration; of a store, what it is and not where."""
    facts = config.model_dump()
    for table, fields in _LATER.items():
        for name, value in fields.items():
            if facts[table][name] == value:
                del facts[table][name]
    if config.data.store:
        settings = QueryStore(config.data.store).settings
        facts["data"]["store"] = settings.attributes()
    else:
        del facts["data"]["store_queries"]
    del facts["training"]["curve"]
    if config.training.encoder == "shipped":
        facts["training"]["encoder"] = shipped_weights().sha256
    return facts


def training_identity(config: TrainingConfig) -> str:
    """Of all that the weights in the end depend on."""
    return _digest(_facts(config))


def first_stage_identity(config: TrainingConfig) -> str:
    """Of all that the weights depend on before the last decoder is trained: decoders may share them."""
    facts = _facts(config)
    facts["training"] = {
        name: value for name, value in facts["training"].items() if not name.startswith("decoder_")
    }
    return _digest(facts)


def _rename_checkpoint(checkpoint: Path, before: str, identity: str) -> None:
    """Gives a checkpoint that names the whole configuration, as all did once, the first stage's identity.

    Raises:
        InputError: the checkpoint is damaged.
    """
    if checkpoint.exists() and process_number() == 0:
        tensors, facts = read_checkpoint(checkpoint)
        if facts.get("identity") == before:
            kept = {name: facts[name] for name in ("step", "seconds", "loss")}
            write_checkpoint(checkpoint, tensors, {"identity": identity, **kept})
    wait_for_all()


def _digest(*parts: Any) -> str:
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()
