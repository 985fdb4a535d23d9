"""Exports of networks as ONNX: the decoder of `neural`, all of `latent`; a fabric as tensors, a program."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import save

from loomlight.core.errors import InputError
from loomlight.core.extras import import_extra
from loomlight.core.llvm import llvm_float
from loomlight.fabric.fabric import Fabric
from loomlight.models.networks import Layers
from loomlight.models.neural.encoded_fabric import mean_pitch
from loomlight.models.neural.encoding import shortest_repeat
from loomlight.models.neural.face_maps import face_maps
from loomlight.models.neural.model import NeuralModel
from loomlight.models.neural.weights import shipped_decoder
from loomlight.models.registry import make_model
from loomlight.models.texture.latent import (
    ALBEDO_OFFSET,
    CHANNELS,
    FRAMES,
    MAX_AUXILIARY_SLOPE,
    MAX_EXPONENT,
    MIN_HALF,
    MIN_LIGHT,
    SLOPE_FLOOR,
    VALUE_OFFSET,
    LatentModel,
    Weights,
)
from loomlight.realtime.materials import Material, model_for, source_of
from loomlight.scattering import sheen
from loomlight.scattering.appearance import ALBEDO_NAMES, Appearance, FamilyAppearance
from loomlight.scattering.interreflection import Scattered, scattered, solved_interior
from loomlight.scattering.lobe_mixture import MAX_OUTPUT, MIN_ALPHA
from loomlight.scattering.openness import Openness
from loomlight.scattering.sheen_coefficients import REFLECTANCE, SCALE, SHEAR
from loomlight.yarn.geometry import YarnGeometry

_LANGUAGES = Path(__file__).parent / "languages"
_NEURAL_PAGE, _PROGRAM = _LANGUAGES / "network.md", _LANGUAGES / "colour.py"
_OF_FACES = ("front", "back")


# Texels a thread of the heights, in which programs search where a view meets yarn; and the height of a hole.
_TEXELS, _NOTHING = 16, -6e4


def _heights(model: NeuralModel, back: bool) -> NDArray[np.float16]:
    """Heights of a face over the weave's repeat, millimetres."""
    layout = shortest_repeat(model.fabric.layout())
    picks, ends = layout.warp_on_top.shape
    maps = face_maps(YarnGeometry(layout), back, _TEXELS * picks, _TEXELS * ends, llvm_float())
    is_yarn = np.square(maps[:3]).sum(0) > 0.5
    return np.where(is_yarn, maps[6] * mean_pitch(layout), _NOTHING).astype(np.float16)


def write_onnx(folder: Path, fabric: Fabric, model: str, _distance: float | None = None) -> dict[str, object]:
    """Writes decoder.onnx, tensors, colour.py and README.md, and returns what the manifest says.

    Raises:
        InputError: a repeat of more than 64 threads a side.
        MissingDependencyError: ONNX Runtime is missing, which encodes the fabric.
    """
    from loomlight.core.llvm import require_llvm

    require_llvm()
    made = make_model(model, fabric)
    if not isinstance(made, NeuralModel):
        raise InputError(f"{model} is no network.")
    encoded = made.encoded
    (folder / "decoder.onnx").write_bytes(shipped_decoder())
    hidden = made.weights.table.hidden
    correction = encoded.correction
    tensors: dict[str, NDArray[Any]] = {
        "correction": np.zeros(made.weights.table.corrected_shape, np.float32)
        if correction is None
        else correction
    }
    for number, face in enumerate(_OF_FACES):
        tensors[f"{face}.latents"] = encoded.faces[number]
        tensors[f"{face}.fibres"] = encoded.fibres.face(bool(number))
        tensors[f"{face}.bundles"] = encoded.fibres.bundles(bool(number))
        tensors[f"{face}.heights"] = _heights(made, bool(number))
    content = save({name: np.ascontiguousarray(values) for name, values in tensors.items()})
    (folder / "latents.safetensors").write_bytes(content)
    (folder / "cloth.safetensors").write_bytes(save(_cloth_tensors(made)))
    shutil.copyfile(_PROGRAM, folder / _PROGRAM.name)
    layout, appearance = fabric.layout(), fabric.appearance()
    levels = [
        {"first": level.first, "columns": level.columns, "rows": level.rows, "per_thread": level.per_thread}
        for level in encoded.pyramid
    ]
    (folder / "README.md").write_text(
        _NEURAL_PAGE.read_text(encoding="utf-8").format(
            name=fabric.name, hidden=hidden, pitch=mean_pitch(layout)
        ),
        encoding="utf-8",
    )
    return {
        "files": ["decoder.onnx", "latents.safetensors", "cloth.safetensors", _PROGRAM.name],
        "repeat_mm": list(map(float, layout.size)),
        "picks": encoded.picks,
        "ends": encoded.ends,
        "mean_pitch_mm": float(mean_pitch(layout)),
        "levels": levels,
        "diffuse_blend": appearance.diffuse_blend,
        "grazing_gain": appearance.grazing.gain,
        "grazing_loss": appearance.grazing.loss,
        "sheen_strength": appearance.sheen.strength,
        "multiply_adds": made.multiply_adds,
    }


def _cloth_tensors(model: NeuralModel) -> dict[str, NDArray[Any]]:
    """What makes colours of the network's components: albedos of threads, light between yarns, sheen."""
    layout, appearance = model.fabric.layout(), model.fabric.appearance()
    tensors: dict[str, NDArray[Any]] = {"warp_on_top": layout.warp_on_top.astype(np.uint8)}
    families = (("warp", appearance.warp), ("weft", appearance.weft))
    for (name, family), threads in zip(families, YarnGeometry(layout).families, strict=True):
        tensors[f"{name}.albedos"] = np.stack([getattr(family, albedo) for albedo in ALBEDO_NAMES], axis=1)
        edges = threads.centre[:, None] + threads.half_width[:, None] * [-1, 1]
        tensors[f"{name}.edges"] = edges
        tensors[f"{name}.cells"] = np.stack([threads.lower, threads.upper], axis=1)
    if appearance.openness is not None:
        tensors |= _between_yarns(appearance, appearance.openness)
    if appearance.sheen.strength > 0:
        powers = (3 * max(appearance.sheen.roughness, sheen.MIN) ** 0.25 - 2) ** np.arange(6)
        for name, rows in {"scale": SCALE, "shear": SHEAR, "reflectance": REFLECTANCE}.items():
            tensors[f"sheen.{name}"] = np.array(rows) @ powers
    return {
        name: np.ascontiguousarray(values, values.dtype if values.dtype == np.uint8 else np.float32)
        for name, values in tensors.items()
    }


def _between_yarns(appearance: Appearance, openness: Openness) -> dict[str, NDArray[Any]]:
    """Blocked shares of the sky by view, and the radiances between the yarns of both faces."""
    layers = openness.layers.tolist()
    warp, weft = map(_scattered, (appearance.warp, appearance.weft), layers)
    faces = solved_interior(warp, weft, openness.interior, openness.meets, openness.blocks)
    radiance = [
        [own.warp, own.weft, own.leaked, other.mean, other.leaked] for own, other in (faces, faces[::-1])
    ]
    return {
        "between.by_view": openness.by_view,
        "between.warp_seen": openness.warp_seen,
        "between.layers": openness.layers,
        "between.radiance": np.array(radiance),
    }


def _scattered(family: FamilyAppearance, layer: list[float]) -> Scattered:
    """R and T of the mean of a family's threads."""
    reflect, transmit, specular_reflect, specular_transmit = (
        getattr(family, name).mean(axis=0) for name in ALBEDO_NAMES
    )
    return scattered(reflect, transmit, specular_reflect, specular_transmit, layer)


# ----------------------------------------------------------------------------------------------------- latent
# Export of `latent`: frames and decoder as one ONNX graph, with the latents of a material as tensors.


_LATENT_PAGE = Path(__file__).parent / "languages" / "latent_network.md"
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
    (folder / "auxiliary.onnx").write_bytes(latent_auxiliary(made.weights))
    texels = made.weights.latents.reshape(shape.faces, shape.texels, CHANNELS)
    (folder / "latents.safetensors").write_bytes(save({"latents": np.ascontiguousarray(texels)}))
    source = source_of(material)
    text = _LATENT_PAGE.read_text(encoding="utf-8")
    (folder / "README.md").write_text(
        text.format(name=source.name, faces=shape.faces, texel=shape.texel_mm), encoding="utf-8"
    )
    levels = [
        {"first": first, "columns": columns, "rows": rows}
        for first, (columns, rows) in zip(shape.starts, shape.sizes, strict=False)
    ]
    return {
        "files": ["decoder.onnx", "auxiliary.onnx", "latents.safetensors"],
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
    values = graph.layers(values, weights.layers["decoder"])
    exponent = graph.add("Sub", values, graph.constant(np.float32(VALUE_OFFSET)))
    bounded = graph.add("Min", exponent, graph.constant(np.float32(MAX_EXPONENT)))
    height = graph.add("Gather", "light", graph.constant(np.array([2])), axis=1)
    above = graph.add("Greater", height, graph.constant(np.float32(0)))
    graph.add("Where", above, graph.add("Exp", bounded), graph.constant(np.float32(0)), output="value")
    return graph.serialised({"latent": CHANNELS, "light": 3, "view": 3}, {"value": 3})


def latent_auxiliary(weights: Weights) -> bytes:
    """The graph: latent [n, 8] → albedo [n, 3], roughness [n, 1], normal [n, 3] in the frame of the face.

    Raises:
        MissingDependencyError: the package onnx is missing.
    """
    graph = _Graph()
    outputs = graph.layers("latent", weights.layers["auxiliary"])
    one = graph.constant(np.float32(1))
    exponent = graph.add("Sub", graph.columns(outputs, range(3)), graph.constant(np.float32(ALBEDO_OFFSET)))
    zero = graph.constant(np.float32(0))
    graph.add("Clip", graph.add("Exp", graph.add("Min", exponent, one)), zero, one, output="albedo")
    x = graph.clipped(graph.columns(outputs, [3]), MAX_OUTPUT)
    root = graph.add("Sqrt", graph.add("Add", graph.add("Mul", x, x), one))
    half = graph.add("Mul", graph.add("Div", x, root), graph.constant(np.float32(0.5)))
    alpha = graph.add("Add", half, graph.constant(np.float32(0.5 + MIN_ALPHA)))
    graph.add("Min", alpha, one, output="roughness")
    slopes = graph.clipped(graph.columns(outputs, [4, 5]), MAX_AUXILIARY_SLOPE)
    # (−slopes, 1): the third column is 1.
    level = graph.add("MatMul", slopes, graph.constant(np.array([[-1, 0, 0], [0, -1, 0]], np.float32)))
    up = graph.add("Add", level, graph.constant(np.array([[0, 0, 1]], np.float32)))
    graph.add("Div", up, graph.add("ReduceL2", up, axes=[1], keepdims=1), output="normal")
    return graph.serialised({"latent": CHANNELS}, {"albedo": 3, "roughness": 1, "normal": 3})


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

    def layers(self, values: str, layers: Layers) -> str:
        """Dense layers with ReLU between them."""
        for number, (matrix, bias) in enumerate(layers):
            values = self.add("Gemm", values, self.constant(matrix), self.constant(bias), transB=1)
            if number + 1 < len(layers):
                values = self.add("Relu", values)
        return values

    def clipped(self, values: str, most: float) -> str:
        low, high = (self.constant(np.float32(bound)) for bound in (-most, most))
        return self.add("Clip", values, low, high)

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

    def serialised(self, inputs: dict[str, int], outputs: dict[str, int]) -> bytes:
        """The model as bytes, checked; inputs and outputs with their numbers of columns."""
        helper, kind = self._onnx.helper, self._onnx.TensorProto.FLOAT
        graph = helper.make_graph(
            self._nodes,
            "latent",
            [helper.make_tensor_value_info(name, kind, ["n", width]) for name, width in inputs.items()],
            [helper.make_tensor_value_info(name, kind, ["n", width]) for name, width in outputs.items()],
            self._constants,
        )
        model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", _OPSET)])
        model.ir_version = _IR
        self._onnx.checker.check_model(model)
        content: bytes = model.SerializeToString()
        return content
