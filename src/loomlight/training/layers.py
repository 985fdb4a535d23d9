"""Parts of networks in torch: dense layers, their numbers, neural textures, and torch for shared formulas."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional


def relu_layers(widths: Sequence[int]) -> nn.Sequential:
    """Dense layers with ReLU between them.

    Args:
        widths: of the layers, inputs first.
    """
    layers: list[nn.Module] = []
    for inputs, outputs in pairwise(widths):
        layers += [nn.Linear(inputs, outputs), nn.ReLU()]
    return nn.Sequential(*layers[:-1])


def numbers_of_layers(perceptron: nn.Sequential) -> list[tuple[NDArray[np.float32], NDArray[np.float32]]]:
    """Weights [outputs, inputs] and biases of each layer."""
    linear = [layer for layer in perceptron if isinstance(layer, nn.Linear)]
    return [(numbers_of(layer.weight), numbers_of(layer.bias)) for layer in linear]


def numbers_of(tensor: Tensor) -> NDArray[np.float32]:
    """The numbers of a tensor."""
    return np.ascontiguousarray(tensor.detach().cpu().numpy(), np.float32)


# -------------------------------------------------------------------------------------- formulas and textures


def _sincos(angle: Tensor) -> tuple[Tensor, Tensor]:
    return torch.sin(angle), torch.cos(angle)


# torch for formulas that take the library of array functions as an argument, as `backend.DRJIT` is Dr.Jit.
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
    """`ArrayFunctions` of `models/texture/pyramid.py` for torch."""

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
    """Interpolated rows [n, channels] of a table, at `Taps` of `models/texture/pyramid.py`."""
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
