"""Export of `latent`: frames and decoder as one ONNX graph, with the latents of a material as tensors."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import save

from loomlight.core.extras import import_extra
from loomlight.models.texture.latent import (
    CHANNELS,
    FRAMES,
    MAX_EXPONENT,
    MIN_HALF,
    MIN_LIGHT,
    SLOPE_FLOOR,
    VALUE_OFFSET,
    LatentModel,
    Weights,
)
from loomlight.realtime.materials import Material, model_for, source_of

_PAGE = Path(__file__).parent / "languages" / "latent_network.md"
_OPSET, _IR = 17, 8
# Columns of a cross product.
_FOLLOWING, _PRECEDING = [1, 2, 0], [2, 0, 1]


def write_latent_onnx(
    folder: Path, material: Material, model: str, _distance: float | None = None
) -> dict[str, object]:
    """Writes decoder.onnx, latents.safetensors and README.md, and returns what the manifest says.

    Raises:
        InputError: a material that is not trained.
        MissingDependencyError: the package onnx is missing.
    """
    made = model_for(material, model)
    assert isinstance(made, LatentModel)  # what `latent` needs
    shape = made.weights.shape
    (folder / "decoder.onnx").write_bytes(latent_decoder(made.weights))
    texels = made.weights.latents.reshape(shape.faces, shape.texels, CHANNELS)
    (folder / "latents.safetensors").write_bytes(save({"latents": np.ascontiguousarray(texels)}))
    source = source_of(material)
    text = _PAGE.read_text(encoding="utf-8")
    (folder / "README.md").write_text(
        text.format(name=source.name, faces=shape.faces, texel=shape.texel_mm), encoding="utf-8"
    )
    levels = [
        {"first": first, "columns": columns, "rows": rows}
        for first, (columns, rows) in zip(shape.starts, shape.sizes, strict=False)
    ]
    return {
        "files": ["decoder.onnx", "latents.safetensors"],
        "repeat_mm": [shape.width_mm, shape.height_mm],
        "texel_mm": shape.texel_mm,
        "levels": levels,
        "is_apart": shape.is_apart,
        "multiply_adds": made.multiply_adds,
    }


def latent_decoder(weights: Weights) -> bytes:
    """The graph: latent [n, 8], light and view [n, 3] in the frame of the face → value [n, 3], 1/sr.

    Raises:
        MissingDependencyError: the package onnx is missing.
    """
    graph = _Graph()
    directions = ("view", "light")
    inputs: list[str] = []
    totals: list[str] = []
    if weights.frames is None:
        inputs += directions
        totals.append(graph.add("Add", *directions))
    else:
        sums = graph.add("MatMul", "latent", graph.constant(weights.frames.T))
        for first in range(0, 6 * FRAMES, 6):
            normal = graph.axis(sums, first, (0.0, 0.0, 1.0))
            tangent = graph.axis(sums, first + 3, (1.0, 0.0, 0.0))
            bitangent = graph.cross(normal, tangent)
            seen = [
                graph.add("Concat", *(graph.dot(each, axis) for axis in (tangent, bitangent, normal)), axis=1)
                for each in directions
            ]
            inputs += seen
            totals.append(graph.add("Add", *seen))
    if weights.with_features:
        inputs += [graph.half_vector_feature(total) for total in totals]
        inputs += graph.light_features(*directions)
    values = graph.add("Concat", *inputs, "latent", axis=1)
    layers = weights.layers["decoder"]
    for number, (matrix, bias) in enumerate(layers):
        values = graph.add("Gemm", values, graph.constant(matrix), graph.constant(bias), transB=1)
        if number + 1 < len(layers):
            values = graph.add("Relu", values)
    exponent = graph.add("Sub", values, graph.constant(np.float32(VALUE_OFFSET)))
    bounded = graph.add("Min", exponent, graph.constant(np.float32(MAX_EXPONENT)))
    height = graph.add("Gather", "light", graph.constant(np.array([2])), axis=1)
    above = graph.add("Greater", height, graph.constant(np.float32(0)))
    graph.add("Where", above, graph.add("Exp", bounded), graph.constant(np.float32(0)), output="value")
    return graph.serialised({"latent": CHANNELS, "light": 3, "view": 3}, "value")


class _Graph:
    """An ONNX graph that grows node by node; every method returns the name of a result."""

    def __init__(self) -> None:
        self._onnx: Any = import_extra("onnx", "train", "Export of latent to ONNX")
        self._nodes: list[Any] = []
        self._constants: list[Any] = []

    def constant(self, values: NDArray[Any] | np.floating) -> str:
        name = f"constant_{len(self._constants)}"
        array = np.ascontiguousarray(values) if np.ndim(values) else np.asarray(values)
        self._constants.append(self._onnx.numpy_helper.from_array(array, name))
        return name

    def add(self, kind: str, *inputs: str, output: str | None = None, **attributes: Any) -> str:
        name = output or f"result_{len(self._nodes)}"
        self._nodes.append(self._onnx.helper.make_node(kind, list(inputs), [name], **attributes))
        return name

    def columns(self, values: str, chosen: Sequence[int]) -> str:
        return self.add("Gather", values, self.constant(np.array(chosen)), axis=1)

    def axis(self, sums: str, first: int, offset: tuple[float, ...]) -> str:
        """The unit vector of three columns plus an offset."""
        moved = self.add(
            "Add", self.columns(sums, range(first, first + 3)), self.constant(np.array([offset], np.float32))
        )
        return self.add("Div", moved, self.add("ReduceL2", moved, axes=[1], keepdims=1))

    def dot(self, first: str, second: str) -> str:
        product = self.add("Mul", first, second)
        return self.add("ReduceSum", product, self.constant(np.array([1])), keepdims=1)

    def half_vector_feature(self, total: str) -> str:
        """¼ log(tan² θ_h + a little) of the sum of view and light in a frame."""
        level, up = self.columns(total, [0, 1]), self.columns(total, [2])
        slope = self.add("Div", self.add("ReduceL2", level, axes=[1], keepdims=1), self.above(up, MIN_HALF))
        square = self.add("Add", self.add("Mul", slope, slope), self.constant(np.float32(SLOPE_FLOOR)))
        return self.add("Mul", self.add("Log", square), self.constant(np.float32(0.25)))

    def light_features(self, view: str, light: str) -> list[str]:
        """(1 − cos θ_d)^5 and log cos θ_light."""
        total = self.add("Add", view, light)
        cosine = self.add(
            "Mul", self.constant(np.float32(0.5)), self.add("ReduceL2", total, axes=[1], keepdims=1)
        )
        rest = self.add("Sub", self.constant(np.float32(1)), self.above(cosine, 1e-4))
        fifth = self.add("Pow", rest, self.constant(np.float32(5)))
        return [fifth, self.add("Log", self.above(self.columns(light, [2]), MIN_LIGHT))]

    def above(self, values: str, least: float) -> str:
        return self.add("Max", values, self.constant(np.float32(least)))

    def cross(self, first: str, second: str) -> str:
        following, preceding = (
            self.add("Mul", self.columns(first, one), self.columns(second, other))
            for one, other in ((_FOLLOWING, _PRECEDING), (_PRECEDING, _FOLLOWING))
        )
        return self.add("Sub", following, preceding)

    def serialised(self, inputs: dict[str, int], output: str) -> bytes:
        """The model as bytes, checked; inputs by their number of columns."""
        helper, kind = self._onnx.helper, self._onnx.TensorProto.FLOAT
        graph = helper.make_graph(
            self._nodes,
            "latent",
            [helper.make_tensor_value_info(name, kind, ["n", width]) for name, width in inputs.items()],
            [helper.make_tensor_value_info(output, kind, ["n", 3])],
            self._constants,
        )
        model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", _OPSET)])
        model.ir_version = _IR
        self._onnx.checker.check_model(model)
        content: bytes = model.SerializeToString()
        return content
