"""ONNX graphs of the network's parts, node by node (ONNX opset 21), without torch."""

from __future__ import annotations

from typing import Any

import numpy as np
import onnx
from numpy.typing import ArrayLike, NDArray
from onnx import TensorProto, helper, numpy_helper

from loomlight.models.woven.architecture import SLOPE
from loomlight.models.woven.weights import Weights

_OPSET, _IR = 21, 10
FLOAT = TensorProto.FLOAT


class Graph:
    """Nodes and constants as they come; values are called by their names.

    Attributes:
        weights: the network.
    """

    def __init__(self, weights: Weights) -> None:
        self.weights = weights
        self._nodes: list[Any] = []
        self._constants: dict[str, NDArray[Any]] = {}

    def add(self, operator: str, *inputs: str, output: str | None = None, **attributes: Any) -> str:
        """The result of one node."""
        name = output or f"value_{len(self._nodes)}"
        self._nodes.append(helper.make_node(operator, list(inputs), [name], **attributes))
        return name

    def constant(self, values: NDArray[Any]) -> str:
        """An array."""
        name = f"constant_{len(self._constants)}"
        self._constants[name] = values
        return name

    def number(self, value: ArrayLike) -> str:
        """A float32 number or array."""
        return self.constant(np.asarray(value, np.float32))

    def integers(self, values: ArrayLike) -> str:
        """An int64 array, as shapes and axes are."""
        return self.constant(np.asarray(values, np.int64))

    def weight(self, name: str) -> str:
        """A tensor of the network."""
        self._constants.setdefault(name, self.weights.tensor(name))
        return name

    def linear(self, name: str, value: str) -> str:
        """A linear layer [n, inputs] to [n, outputs]."""
        return self.add("Gemm", value, self.weight(f"{name}.weight"), self.weight(f"{name}.bias"), transB=1)

    def leaky(self, value: str) -> str:
        """Leaky ReLU."""
        return self.add("LeakyRelu", value, alpha=SLOPE)

    def convolution(self, name: str, value: str, stride: int = 1) -> str:
        """A convolution over a periodic map."""
        size = self.weights.tensor(f"{name}.weight").shape[-1]
        edge = size // 2
        if edge:
            pads = self.integers([0, 0, edge, edge, 0, 0, edge, edge])
            value = self.add("Pad", value, pads, mode="wrap")
        weight, bias = self.weight(f"{name}.weight"), self.weight(f"{name}.bias")
        return self.add("Conv", value, weight, bias, strides=[stride, stride], kernel_shape=[size, size])

    def model(self, name: str, inputs: dict[str, Any], outputs: dict[str, Any]) -> onnx.ModelProto:
        """The finished model."""
        graph = helper.make_graph(
            self._nodes,
            name,
            [helper.make_tensor_value_info(key, FLOAT, shape) for key, shape in inputs.items()],
            [helper.make_tensor_value_info(key, FLOAT, shape) for key, shape in outputs.items()],
            [numpy_helper.from_array(values, key) for key, values in self._constants.items()],
        )
        operators = [helper.make_opsetid("", _OPSET)]
        model = helper.make_model(graph, opset_imports=operators, ir_version=_IR, producer_name="loomlight")
        helper.set_model_props(model, {"network": self.weights.sha256})
        return model
