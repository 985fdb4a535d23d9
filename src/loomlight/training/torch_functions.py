"""torch for formulas that take the array library as an argument: `TORCH` as `backend.DRJIT`, and textures."""

from __future__ import annotations

from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any

import torch
from torch import Tensor
from torch.nn import functional


def _sincos(angle: Tensor) -> tuple[Tensor, Tensor]:
    return torch.sin(angle), torch.cos(angle)


TORCH: Any = SimpleNamespace(
    abs=torch.abs,
    clip=torch.clamp,
    exp=torch.exp,
    log=torch.log,
    maximum=lambda value, bound: value.clamp(min=bound),
    select=torch.where,
    sincos=_sincos,
    sqrt=torch.sqrt,
)


class TorchTextures:
    """`ArrayFunctions` of `models/mip_pyramid.py` for torch."""

    def floor(self, value: Tensor) -> Tensor:
        return torch.floor(value)

    def clip(self, value: Tensor, low: float, high: float) -> Tensor:
        return value.clamp(low, high)

    def to_index(self, value: Tensor) -> Tensor:
        return value.detach().long()

    def gather(self, table: Sequence[int], index: Tensor) -> Tensor:
        return torch.tensor(list(table), device=index.device)[index]

    def wrap(self, index: Tensor, count: Any) -> Tensor:
        return index % count


def fetched(table: Tensor, taps: Any) -> Tensor:
    """Interpolated rows [n, channels] of a table, at `Taps` of `models/mip_pyramid.py`."""
    found: Tensor = _Gather.apply(torch.stack(taps.texels, dim=1), torch.stack(taps.weights, dim=1), table)
    return found


class _Gather(torch.autograd.Function):
    """`embedding_bag` of weighted sums, whose own gradient sorts the texels and takes four times as long."""

    @staticmethod
    def forward(ctx: Any, texels: Tensor, weights: Tensor, table: Tensor) -> Tensor:
        ctx.save_for_backward(texels, weights, table)
        return functional.embedding_bag(texels, table, per_sample_weights=weights, mode="sum")

    @staticmethod
    def backward(ctx: Any, *outer: Any) -> Any:
        texels, weights, table = ctx.saved_tensors
        (gradient,) = outer
        of_weights = of_table = None
        if ctx.needs_input_grad[1]:
            of_weights = torch.bmm(table[texels], gradient[:, :, None])[:, :, 0]
        if ctx.needs_input_grad[2]:
            of_table = torch.zeros_like(table)
            rows = (weights[:, :, None] * gradient[:, None]).flatten(0, 1)
            of_table.index_put_((texels.flatten(),), rows, accumulate=True)
        return None, of_weights, of_table
