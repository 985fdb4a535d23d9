"""One plain training loop: steps, checkpoints, resume."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import torch
from safetensors import SafetensorError, safe_open
from safetensors.torch import save_file
from torch import Tensor, nn

from loomlight.core.errors import InputError, LoomlightError
from loomlight.core.files import replacing
from loomlight.training.parallel import process_number, same_for_all, wait_for_all

# Called with (steps done, steps in all, running mean of the loss).
Report = Callable[[int, int, float], None]
# Gradients are clipped to this length: ten times the usual one is an outlier.
_MAX_GRADIENT = 1.0
_MEMORY = 0.98  # of the mean loss


@dataclass(frozen=True)
class Schedule:
    """Length and learning rates of a training.

    Attributes:
        steps: how many; with `seconds`, at most so many.
        rate: learning rate as a function of the share done, 0 to 1.
        seconds: an end by the clock, 0 for none: for comparisons at equal budget, not reproducible.
        keep_every: seconds between checkpoints.
    """

    steps: int
    rate: Callable[[float], float]
    seconds: float = 0.0
    keep_every: float = 60.0


def require_device(device: str) -> None:
    """Raises InputError if this PyTorch has no such device here.

    Args:
        device: "cpu" or "cuda".
    """
    if device == "cuda" and not torch.cuda.is_available():
        raise InputError(
            'device = "cuda" needs an NVIDIA card and PyTorch with CUDA, and one is missing: leave it out.'
        )


@contextmanager
def _subnormals_flushed() -> Iterator[None]:
    """Flushes denormal numbers to 0 on this thread.

    Gradients of inactive units decay to denormals in the optimiser's state, which make its steps 2.5 times as
    slow.
    """
    torch.set_flush_denormal(True)
    try:
        yield
    finally:
        torch.set_flush_denormal(False)


@contextmanager
def one_thread() -> Iterator[None]:
    """Operations of this thread use no others: an optimiser's are too small for that."""
    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        yield
    finally:
        torch.set_num_threads(threads)


@_subnormals_flushed()
def train(
    network: nn.Module,
    optimiser: torch.optim.Optimizer,
    losses_of: Callable[[int], Iterable[Tensor]],
    schedule: Schedule,
    checkpoint: Path,
    identity: str,
    report: Report | None = None,
) -> int:
    """Trains until the schedule's end, from the checkpoint if there is one.

    A step is one update of the weights for each of the losses that `losses_of(step)` yields. Random numbers
    belong to steps: the losses must depend on the step and the weights alone. Then a training that was
    stopped at any moment ends with the weights of one that was not.

    Args:
        identity: of everything the weights depend on; a checkpoint of another one is refused.

    Returns:
        How many steps were done in all.

    Raises:
        InputError: the checkpoint is damaged or belongs to another configuration.
        LoomlightError: the loss is no number any more.
    """
    step, spent, mean = _restored(network, optimiser, checkpoint, identity)
    wait_for_all()  # before another one writes the checkpoint
    begun = kept = time.monotonic()
    while step < schedule.steps:
        elapsed = spent + time.monotonic() - begun
        progress = step / schedule.steps
        if schedule.seconds:
            progress = same_for_all(max(progress, elapsed / schedule.seconds))
        if progress >= 1:
            break
        for group in optimiser.param_groups:
            group["lr"] = schedule.rate(progress)
        for loss in losses_of(step):
            value = float(loss.detach())
            if value != value:
                raise LoomlightError(f"The loss is no number at step {step}: lower [training] rate.")
            # Weights that a loss does not depend on have no gradient, and stay unchanged.
            optimiser.zero_grad(set_to_none=True)
            loss.backward()
            nn.utils.clip_grad_norm_(network.parameters(), _MAX_GRADIENT)
            optimiser.step()
        step += 1
        mean = value if step == 1 else _MEMORY * mean + (1 - _MEMORY) * value
        if report is not None:
            done = min(schedule.steps, round(progress * schedule.steps))
            report(done if schedule.seconds else step, schedule.steps, mean)
        if time.monotonic() - kept > schedule.keep_every:
            _keep(network, optimiser, checkpoint, identity, step, spent + time.monotonic() - begun, mean)
            kept = time.monotonic()
    _keep(network, optimiser, checkpoint, identity, step, spent + time.monotonic() - begun, mean)
    return step


def _keep(
    network: nn.Module,
    optimiser: torch.optim.Optimizer,
    checkpoint: Path,
    identity: str,
    step: int,
    spent: float,
    mean: float,
) -> None:
    if process_number() != 0:
        return
    tensors = {f"weights.{name}": tensor for name, tensor in network.state_dict().items()}
    tensors |= {f"optimiser.{name}": tensor for name, tensor in optimiser_tensors(optimiser).items()}
    facts = {"identity": identity, "step": step, "seconds": spent, "loss": mean}
    write_checkpoint(checkpoint, tensors, facts)


def _restored(
    network: nn.Module, optimiser: torch.optim.Optimizer, checkpoint: Path, identity: str
) -> tuple[int, float, float]:
    """Restores weights and optimiser; returns steps done, seconds spent and the mean loss."""
    if not checkpoint.exists():
        return 0, 0.0, 0.0
    tensors, facts = read_checkpoint(checkpoint)
    if facts.get("identity") != identity:
        raise InputError(
            f"{checkpoint} belongs to another configuration: give another folder, or remove it to begin anew."
        )
    parts: dict[str, dict[str, Tensor]] = {"weights": {}, "optimiser": {}}
    for key, tensor in tensors.items():
        part, name = key.split(".", 1)
        parts[part][name] = tensor
    network.load_state_dict(parts["weights"])
    restore_optimiser(optimiser, parts["optimiser"])
    return int(facts["step"]), float(facts["seconds"]), float(facts["loss"])


# ------------------------------------------------------------------------------------------------ checkpoints

SCHEMA = 1


def write_checkpoint(path: Path, tensors: dict[str, Tensor], facts: dict[str, Any]) -> None:
    """Writes tensors and facts (any JSON values)."""
    header = {"loomlight": json.dumps({"schema": SCHEMA, "kind": "checkpoint", **facts})}
    # safetensors rejects tensors that share memory, and views.
    separate = {name: tensor.detach().contiguous().clone() for name, tensor in tensors.items()}
    with replacing(path) as temporary:
        save_file(separate, temporary, metadata=header)


def read_checkpoint(path: Path) -> tuple[dict[str, Tensor], dict[str, Any]]:
    """The tensors and facts of a checkpoint.

    Raises:
        InputError: the file is damaged, or something else.
    """
    try:
        with safe_open(path, "pt") as file:
            facts = json.loads((file.metadata() or {}).get("loomlight", "{}"))
            if facts.get("kind") != "checkpoint" or facts.get("schema") != SCHEMA:
                raise InputError(f"{path} is no checkpoint of this version; remove it to begin anew.")
            tensors = {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118 (no mapping)
    except (SafetensorError, OSError, ValueError) as error:
        raise InputError(f"{path} is damaged ({error}); remove it to begin anew.") from error
    return tensors, facts


def optimiser_tensors(optimiser: torch.optim.Optimizer) -> dict[str, Tensor]:
    """The state of an optimiser by names that depend on the order of its parameters alone."""
    state = optimiser.state_dict()["state"]
    return {
        f"{number}.{name}": torch.as_tensor(value)
        for number, entries in state.items()
        for name, value in entries.items()
        if value is not None
    }


def restore_optimiser(optimiser: torch.optim.Optimizer, tensors: dict[str, Tensor]) -> None:
    """Restores the state of an optimiser from `optimiser_tensors`."""
    state: dict[int, dict[str, Tensor]] = {}
    for key, tensor in tensors.items():
        number, name = key.split(".", 1)
        state.setdefault(int(number), {})[name] = tensor
    optimiser.load_state_dict({**optimiser.state_dict(), "state": state})
