"""Losses of the parts of a batch, each on a thread of its own.

No single operation of a small network occupies several cores: parts on a core each are faster than operations
split over cores.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import torch
from torch import Tensor, nn

from loomlight.training.processes import own_share, sum_over_processes

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

        Under torchrun each process computes its share of the parts (`processes.py`), at least one.

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
