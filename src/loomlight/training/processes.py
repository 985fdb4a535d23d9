"""Training by several processes that torchrun starts: each has a share of every batch, gradients add up.

    torchrun --nproc-per-node 2 -m papers.chen2024.training experiments/neural.toml

Without torchrun there is one process, and nothing here does anything.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import torch
from torch import Tensor, distributed

_Part = TypeVar("_Part")


def process_count() -> int:
    """Processes of the group that this one is in."""
    return distributed.get_world_size() if distributed.is_initialized() else 1


def process_number() -> int:
    """Which of them this one is; number 0 writes files."""
    return distributed.get_rank() if distributed.is_initialized() else 0


def own_share(parts: Sequence[_Part]) -> Sequence[_Part]:
    """The parts that are this process's: every n-th."""
    return parts[process_number() :: process_count()]


def wait_for_all() -> None:
    """Returns when all processes are here."""
    if process_count() > 1:
        distributed.barrier()


def sum_over_processes(value: Tensor, gradients: Sequence[Tensor | None]) -> None:
    """Adds up a loss and gradients over all processes, in place.

    Args:
        gradients: None of parameters that no part uses, the same in all processes.
    """
    if process_count() == 1:
        return
    # One message: [loss, gradients].
    parts = [value.reshape(1), *(g.reshape(-1) for g in gradients if g is not None)]
    flat = torch.cat(parts)
    distributed.all_reduce(flat)
    first = 0
    for part in (value, *(g for g in gradients if g is not None)):
        part.copy_(flat[first : first + part.numel()].reshape(part.shape))
        first += part.numel()


def same_for_all(value: float) -> float:
    """The value of process 0, such as a time that others would measure otherwise."""
    if process_count() == 1:
        return value
    shared = torch.tensor([value], dtype=torch.float64)
    distributed.broadcast(shared, 0)
    return float(shared)
