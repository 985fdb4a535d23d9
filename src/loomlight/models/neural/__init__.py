"""The universal network of chen2024: one small network for all woven fabrics at any footprint."""

from __future__ import annotations

from typing import Any

__all__ = ["NeuralModel"]


def __getattr__(name: str) -> Any:
    # Training imports this package too and needs no decoder.
    if name == "NeuralModel":
        from loomlight.models.neural.model import NeuralModel

        return NeuralModel
    raise AttributeError(name)
