"""Work on a batch by several processes, and by several threads of each: gradients add up in a fixed order.

Processes are those that torchrun starts, each with a share of every batch:

    torchrun --nproc-per-node 2 -m studies.papers.chen2024.training studies/papers/chen2024/neural.toml

Without torchrun there is one process, and none of the functions for processes does anything. Threads take
parts of a batch each: no single operation of a small network occupies several cores, so parts on a core each
are faster than operations split over cores.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypeVar

import torch
from torch import Tensor, distributed, nn

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


# ---------------------------------------------------------------------------------------------------- threads

# Threads that share a batch, and the smallest shared one: of less, they wait longer than they compute.
_PARTS, _MIN_SHARED_BATCH = 2, 1 << 13


class SideBySide:
    """Computes losses and gradients of parts on a thread each.

    Gradients are summed in a fixed order, so they do not depend on which part is done first.
    """

    def __init__(self, parts: int) -> None:
        """
        Args:
            parts: threads; with 1, parts are computed one after another on the calling thread.
        """
        cores = max(1, torch.get_num_threads() // parts)
        self._threads = ThreadPoolExecutor(parts, initializer=_begin, initargs=(cores,))
        self.parts = parts

    @classmethod
    def for_batch(cls, device: str, size: int) -> SideBySide:
        """Two threads on CPUs, of any machine, as weights depend on it, and one for small batches or GPUs.

        Args:
            device: of torch, "cpu" or "cuda".
        """
        return cls(_PARTS if device == "cpu" and size >= _MIN_SHARED_BATCH else 1)

    def loss(
        self, losses: Sequence[Callable[[], Tensor]], weights: Sequence[float], network: nn.Module
    ) -> Tensor:
        """The weighted sum of losses, with gradients computed already.

        Under torchrun each process computes its share of the parts, at least one.

        Args:
            losses: of the parts; each may use the network's parameters and nothing else that has a gradient.
        """
        parameters = [parameter for parameter in network.parameters() if parameter.requires_grad]

        def backward(loss: Callable[[], Tensor], weight: float) -> tuple[Tensor, tuple[Tensor | None, ...]]:
            value = weight * loss()
            return value.detach(), torch.autograd.grad(value, parameters, allow_unused=True)

        apply = map if self.parts == 1 else self._threads.map
        values, gradients = zip(*apply(backward, own_share(losses), own_share(weights)), strict=True)
        sums = [_sum(parts) for parts in zip(*gradients, strict=True)]
        total = torch.stack(values).sum()
        sum_over_processes(total, sums)
        loss: Tensor = _Known.apply(total, sums, *parameters)
        return loss


def _begin(cores: int) -> None:
    torch.set_num_threads(cores)
    # Per thread; see `loop.train`.
    torch.set_flush_denormal(True)


def _sum(gradients: Sequence[Tensor | None]) -> Tensor | None:
    """The sum of a parameter's gradients; None where no part used it."""
    used = [gradient for gradient in gradients if gradient is not None]
    return torch.stack(used).sum(0) if used else None


class _Known(torch.autograd.Function):
    """A number with precomputed gradients."""

    @staticmethod
    def forward(ctx: Any, value: Tensor, gradients: list[Tensor | None], *parameters: Tensor) -> Tensor:
        del parameters
        ctx.gradients = gradients
        return value.clone()

    @staticmethod
    def backward(ctx: Any, *outer: Any) -> Any:
        (factor,) = outer
        return None, None, *(part if part is None else factor * part for part in ctx.gradients)
