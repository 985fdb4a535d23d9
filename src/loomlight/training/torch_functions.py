"""torch for formulas that take the array library as an argument: `TORCH` as `backend.DRJIT`, and textures."""

from __future__ import annotations

from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any

import torch
from torch import Tensor


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
