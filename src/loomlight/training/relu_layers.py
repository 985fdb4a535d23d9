"""Dense layers with ReLU between them in torch, and their numbers."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from torch import Tensor, nn


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
