"""Losses of the parts of a batch, each on a thread of its own.

Small networks keep several cores busy through no one operation: what one part does on one core while another
computes on the next is faster than both sharing every operation.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import torch
from torch import Tensor, nn


class SideBySide:
    """Computes losses and gradients of parts at once, as many as there are threads.

    Parts are always added in one order, so gradients do not depend on which is done first.
    """

    def __init__(self, parts: int) -> None:
        """
        Args:
            parts: threads; with 1, parts are computed in a row where they are asked for.
        """
        cores = max(1, torch.get_num_threads() // parts)
        self._threads = ThreadPoolExecutor(parts, initializer=_begin, initargs=(cores,))
        self.parts = parts

    def loss(
        self, losses: Sequence[Callable[[], Tensor]], shares: Sequence[float], network: nn.Module
    ) -> Tensor:
        """The sum of losses times shares, whose gradients are known already.

        Args:
            losses: of the parts; each may use the network's parameters and nothing else that has a gradient.
        """
        parameters = [parameter for parameter in network.parameters() if parameter.requires_grad]

        def found(loss: Callable[[], Tensor], share: float) -> tuple[Tensor, tuple[Tensor | None, ...]]:
            value = share * loss()
            return value.detach(), torch.autograd.grad(value, parameters, allow_unused=True)

        apply = map if self.parts == 1 else self._threads.map
        values, gradients = zip(*apply(found, losses, shares), strict=True)
        sums = [_sum(parts) for parts in zip(*gradients, strict=True)]
        loss: Tensor = _Known.apply(sum(values), sums, *parameters)
        return loss


def _begin(cores: int) -> None:
    torch.set_num_threads(cores)
    # See `loop.train`; it holds for one thread.
    torch.set_flush_denormal(True)


def _sum(gradients: Sequence[Tensor | None]) -> Tensor | None:
    """The sum of a parameter's gradients; None where no part used it."""
    used = [gradient for gradient in gradients if gradient is not None]
    return torch.stack(used).sum(0) if used else None


class _Known(torch.autograd.Function):
    """A number whose gradients were worked out beforehand."""

    @staticmethod
    def forward(ctx: Any, value: Tensor, gradients: list[Tensor | None], *parameters: Tensor) -> Tensor:
        del parameters
        ctx.gradients = gradients
        return value.clone()

    @staticmethod
    def backward(ctx: Any, *outer: Any) -> Any:
        (factor,) = outer
        return None, None, *(part if part is None else factor * part for part in ctx.gradients)
