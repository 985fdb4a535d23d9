"""The decoder for Dr.Jit arrays, on any backend.

Layers that do not depend on the light (latents, fusion, the view's part of the first angular layer, holes)
are evaluated once a footprint and view (`Decoder.view_activations`), the others for every light
(`Decoder.components`). The first layer is linear, so latents are multiplied by its weights beforehand and
interpolated afterwards.

On CPUs a SIMD kernel evaluates queries (`compiled`); on GPUs, for derivatives, and in symbolic calls and
loops cooperative vectors do. On CPUs these are four times slower, in symbolic calls seventy times, as Dr.Jit
then passes weights lane by lane: evaluate outside symbolic calls.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Any, ClassVar, TypeAlias

import drjit as dr
import drjit.nn as nn
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Array, Float, FloatType, Mask, Vec3
from loomlight.core.backend import array_types, clip, maximum
from loomlight.core.errors import InputError
from loomlight.core.simd import CompiledKernel, Floats, call_kernel, can_use_kernel, host_target
from loomlight.core.tables import Layer, Shared
from loomlight.models.neural.architecture import BUNDLES, LEAKY_SLOPE, VIEW_FEATURES, NetworkTable
from loomlight.models.neural.codings import DIFFUSE, fibre_features, mixed_bundles, one_blob, unmapped
from loomlight.models.neural.decoder_kernel import EntryPoint, decoder_kernel, packed_layers
from loomlight.models.neural.encoded_fabric import (
    AnisotropicTaps,
    EncodedFabric,
    fine_tuning_weight,
    footprint_coordinates,
)
from loomlight.models.neural.latent_table import LatentTable
from loomlight.models.neural.weights import Weights, shipped_weights

# ----------------------------------------------------------------------------------------------------- layers
# Dense layers by Dr.Jit's cooperative vectors.
#
# Cooperative vectors work in symbolic calls, differentiate, and use the tensor cores of GPUs. On CPUs Dr.Jit
# emits loops that load and store a sum for every multiply-add, a third of a core's peak at best: there,
# `core.simd` replaces them.


Matrices: TypeAlias = dict[str, NDArray[np.float32]]
Vector: TypeAlias = Any


class CooperativeLayers:
    """Matrices and biases on one backend. A vector is a `CoopVec`, or a sequence of Floats."""

    def __init__(self, matrices: Matrices, float_type: FloatType) -> None:
        tensor_type: Any = dr.tensor_t(float_type)
        tensors = [tensor_type(np.ascontiguousarray(values)) for values in matrices.values()]
        views: Any = nn.pack(tensors, layout="inference")
        self._parts: dict[str, Any] = dict(zip(matrices, views, strict=True))

    def product(self, matrix: str, vector: Vector, bias: str | None = None) -> Vector:
        """The named matrix times a vector, plus the named bias."""
        return nn.matvec(
            self._parts[matrix], _cooperative(vector), None if bias is None else self._parts[bias]
        )

    def added(self, one: Vector, other: Vector) -> Vector:
        """The sum of two vectors."""
        return _cooperative(one) + _cooperative(other)

    def leaky(self, vector: Vector) -> Vector:
        """Leaky ReLU of every number."""
        return maximum(vector, vector * LEAKY_SLOPE)


def _cooperative(vector: Vector) -> Vector:
    return vector if isinstance(vector, nn.CoopVec) else nn.CoopVec(*vector)


# --------------------------------------------------------------------------------------------------- compiled
# The decoder compiled for this processor from `decoder_kernel`, for numpy arrays of queries.


class CompiledDecoder:
    """The decoder of some weights on this processor; all fabrics share its code.

    Attributes:
        seconds, cpu_seconds: time that all decoders have spent on queries so far, without compiling, by the
            wall clock and of all threads of the process.
    """

    seconds: ClassVar[float] = 0.0
    cpu_seconds: ClassVar[float] = 0.0

    def __init__(self, weights: Weights) -> None:
        self._weights = weights
        self._layers = packed_layers(weights, host_target()).weights()

    def run(
        self,
        entry_point: EntryPoint,
        fabric: LatentTable,
        inputs: Sequence[Floats],
        outputs: Sequence[Floats],
    ) -> None:
        """Computes outputs of queries; `decoder_kernel` lists inputs and outputs of each entry point."""
        weights = self._weights
        kernel = _compiled(
            entry_point,
            weights.table,
            weights.linear_diffuse,
            fabric.has_correction,
            fabric.repeat,
            _Shape(weights),
        )
        start, cpu_start = time.perf_counter(), time.process_time()
        kernel.launch(len(outputs[0]), inputs, outputs, [self._layers, *fabric.uniforms])
        CompiledDecoder.seconds += time.perf_counter() - start
        CompiledDecoder.cpu_seconds += time.process_time() - cpu_start


class _Shape:
    """Weights as a cache key that ignores their values: code depends on the network's shape alone."""

    def __init__(self, weights: Weights) -> None:
        self.weights = weights

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Shape)

    def __hash__(self) -> int:
        return 0


@cache
def _compiled(
    entry_point: EntryPoint,
    _table: NetworkTable,
    _linear_diffuse: bool,
    has_correction: bool,
    repeat: tuple[int, int],
    shape: _Shape,
) -> CompiledKernel:
    kernel = decoder_kernel(entry_point, shape.weights, has_correction, repeat, host_target())
    return CompiledKernel(kernel)


@cache
def compiled_decoder(weights: Weights) -> CompiledDecoder:
    """The decoder of some weights."""
    return CompiledDecoder(weights)


# Fabrics whose tables are cached.
_KEPT = 2


def decode(
    weights: Weights,
    encoded: EncodedFabric,
    lights: NDArray[np.float32],
    views: NDArray[np.float32],
    footprints: NDArray[np.float32],
) -> NDArray[np.float32]:
    """Components, 1/sr, and hole fraction [n, 5] of n queries, on all cores.

    Args:
        lights, views: unit vectors [n, 3]; z < 0 is behind the cloth.
        footprints: position x and y and side [n, 3], in threads; see `footprints_in_threads`.
    """
    light, view, footprint = (columns(rows) for rows in (lights, views, footprints))
    back = view[2] < 0
    turn = np.where(back, np.float32(-1), np.float32(1))
    light[2] *= turn
    view[2] *= turn
    outputs = np.empty((5, len(lights)), np.float32)
    table = kernel_table(weights, encoded)
    inputs = [*one_square(footprint), *view, back.astype(np.float32), *light]
    compiled_decoder(weights).run("components_and_hole", table, inputs, [*outputs])
    return outputs.T


def one_square(footprints: NDArray[np.float32]) -> list[NDArray[np.float32]]:
    """The numbers of `AnisotropicTaps` of footprints [3, n], position x and y and side."""
    zero = np.zeros(footprints.shape[1], np.float32)
    return [*footprints, zero, zero, zero, zero]


def columns(rows: NDArray[np.floating]) -> NDArray[np.float32]:
    """Rows [n, k] transposed to contiguous columns [k, n], float32."""
    return rows.T.astype(np.float32, order="C")


@lru_cache(_KEPT)
def kernel_table(weights: Weights, encoded: EncodedFabric) -> LatentTable:
    """The tables of a fabric for kernels alone."""
    return LatentTable(weights, encoded)


# ---------------------------------------------------------------------------------------------------- decoder


@dataclass
class ViewActivations:
    """The part of the decoder's activations that depends on footprint and view, not on the light.

    Attributes:
        angular: the first angular layer without the light's part, one Float a channel.
        hole: fraction of the view rays that pass through, 0 to 1.
        correction_weight: weight of the fabric's correction of the last layer, 0 to 1.
        view: unit vector [3] in the frame of the face that is seen.
        back: the back is seen.
        table: the fabric's latents.
    """

    angular: list[Float]
    hole: Float
    correction_weight: Float
    view: Vec3
    back: Mask
    table: LatentTable


class Decoder:
    """The network of some weights on one backend."""

    def __init__(self, weights: Weights, float_type: type) -> None:
        self.weights = weights
        self._types = array_types(float_type)
        self._count = weights.layers("decoder.angular")
        self._layers = CooperativeLayers(split_matrices(weights), float_type)

    def view_activations(
        self, table: LatentTable, taps: AnisotropicTaps, view: Vec3, back: Mask
    ) -> ViewActivations:
        """Activations of footprints and views, for any number of lights.

        Args:
            view: unit vector [3] in the frame of the face that is seen, z > 0.
            back: whether that face is the back.
        """
        inputs = *taps.numbers(), view, back
        if self.uses_kernel(inputs):
            angular = self.weights.table.hidden
            *outputs, hole, correction_weight = self._call_kernel("view", table, inputs, angular + 2)
            return ViewActivations(outputs, hole, correction_weight, view, back, table)
        spatial, cosines = self._spatial(table, taps, back), self._view_cosines(table, view, back)
        angular = self._layers.product("spatial", spatial, "0 bias")
        angular = self._layers.added(angular, self._layers.product("view", [view.x, view.y, *cosines]))
        correction_weight = fine_tuning_weight(self._coordinates(table, taps)[2], dr)
        return ViewActivations([*angular], self._hole(spatial, view), correction_weight, view, back, table)

    def hole(self, table: LatentTable, taps: AnisotropicTaps, view: Vec3, back: Mask) -> Float:
        """The hole of `view_activations` alone."""
        inputs = *taps.numbers(), view, back
        if self.uses_kernel(inputs):
            (hole,) = self._call_kernel("hole", table, inputs, 1)
            return hole
        return self._hole(self._spatial(table, taps, back), view)

    def components(self, activations: ViewActivations, light: Vec3) -> list[Float]:
        """The four components, 1/sr, ≥ 0, for a light in the frame of the face that is seen."""
        inputs = activations.angular, activations.correction_weight, activations.view, activations.back, light
        if self.uses_kernel(inputs):
            return self._call_kernel("components", activations.table, inputs, DIFFUSE + 2)
        return self._components(activations, light)

    def components_and_hole(
        self, table: LatentTable, light: Vec3, taps: AnisotropicTaps, view: Vec3, back: Mask
    ) -> list[Float]:
        """The four components for one light, and the hole, in one pass."""
        inputs = *taps.numbers(), view, back, light
        if self.uses_kernel(inputs):
            return self._call_kernel("components_and_hole", table, inputs, DIFFUSE + 3)
        activations = self.view_activations(table, taps, view, back)
        return [*self._components(activations, light), activations.hole]

    def uses_kernel(self, inputs: Sequence[Array]) -> bool:
        """Whether a SIMD kernel evaluates these queries."""
        return can_use_kernel(self._types.Float, inputs)

    def _call_kernel(
        self, entry_point: EntryPoint, table: LatentTable, inputs: Sequence[Array], count: int
    ) -> list[Float]:
        """The `count` outputs of an entry point of the kernel."""
        decoder = compiled_decoder(self.weights)
        return call_kernel(
            self._types.Float,
            inputs,
            count,
            lambda kernel_inputs, outputs: decoder.run(entry_point, table, kernel_inputs, outputs),
        )

    def _coordinates(self, table: LatentTable, taps: AnisotropicTaps) -> tuple[Float, Float, Float]:
        size = taps.size(dr)
        return footprint_coordinates(self.weights.table, table.picks, table.ends, taps.x, taps.y, size, dr)

    def _view_cosines(self, table: LatentTable, view: Vec3, back: Mask) -> list[Float]:
        fibres = table.fibres(back) if self.weights.table.fibres else ()
        return [fibre.cosine(view.x, view.y) for fibre in fibres]

    def _spatial(self, table: LatentTable, taps: AnisotropicTaps, back: Mask) -> Vector:
        """Latent and footprint, fused."""
        coordinates = self._coordinates(table, taps)
        coded = one_blob(coordinates, dr) if self.weights.table.position == "one_blob" else list(coordinates)
        fetched, layers = table.at(taps, back), self._layers
        if not self.weights.table.fusion:
            return [*fetched, *coded]
        hidden = layers.leaky(layers.added(layers.product("coordinates", coded), fetched))
        return layers.leaky(layers.product("fusion", hidden, "fusion bias"))

    def _hole(self, spatial: Vector, view: Vec3) -> Float:
        layers = self._layers
        hidden = layers.added(
            layers.product("hole spatial", spatial, "hole bias"),
            layers.product("hole view", [view.x, view.y]),
        )
        (hole,) = layers.product("hole last", layers.leaky(hidden), "hole last bias")
        return clip(hole, 0, 1)

    def _components(self, activations: ViewActivations, light: Vec3) -> list[Float]:
        layers, table, weights = self._layers, activations.table, self.weights
        directions = [light.x, light.y, light.z]
        if weights.table.fibres:
            directions += fibre_features(light, activations.view, table.fibres(activations.back), dr)
        skip = layers.added(activations.angular, layers.product("light", directions))
        hidden = last_inputs = layers.leaky(skip)
        for number in range(1, self._count):
            last_inputs = hidden
            hidden = layers.product(f"{number}", hidden, f"{number} bias")
            if number == 2:
                hidden = layers.added(hidden, skip)
            if number + 1 < self._count:
                hidden = layers.leaky(hidden)
        outputs, specular = [*hidden], None
        if weights.table.bundles:
            correction_weight = dr.select(light.z > 0, activations.correction_weight, self._types.Float(0))
            lobe_weights = table.corrected(outputs[DIFFUSE:], [*last_inputs], correction_weight)
            outputs = outputs[:DIFFUSE]
            specular = mixed_bundles(
                lobe_weights, light, activations.view, table.bundles, activations.back, dr
            )
        return unmapped(outputs, specular, light.z, weights.linear_diffuse, dr)


def split_matrices(weights: Weights) -> dict[str, NDArray[np.float32]]:
    """Weights and biases, split by the layers' inputs."""
    table = weights.table
    parts: dict[str, NDArray[np.float32]] = {}
    if table.fusion:
        parts["coordinates"] = weights.tensor("decoder.fusion.0.weight")[:, table.latent_size :]
        parts["fusion"] = weights.tensor("decoder.fusion.1.weight")
        parts["fusion bias"] = weights.tensor("decoder.fusion.1.bias")
    first, hole = weights.tensor("decoder.angular.0.weight"), weights.tensor("decoder.hole.0.weight")
    spatial = hole.shape[1] - 2
    parts["spatial"], light, view, fibres = np.split(first, [spatial, spatial + 3, spatial + 5], axis=1)
    of_views, of_lights = np.split(fibres, [VIEW_FEATURES], axis=1)
    parts["view"] = np.concatenate([view, of_views], axis=1)
    parts["light"] = np.concatenate([light, of_lights], axis=1)
    parts["0 bias"] = weights.tensor("decoder.angular.0.bias")
    for number in range(1, weights.layers("decoder.angular")):
        parts[f"{number}"] = weights.tensor(f"decoder.angular.{number}.weight")
        parts[f"{number} bias"] = weights.tensor(f"decoder.angular.{number}.bias")
    parts["hole spatial"], parts["hole view"] = hole[:, :spatial], hole[:, spatial:]
    parts["hole bias"] = weights.tensor("decoder.hole.0.bias")
    parts["hole last"] = weights.tensor("decoder.hole.1.weight")
    parts["hole last bias"] = weights.tensor("decoder.hole.1.bias")
    return parts


@dataclass(frozen=True)
class DecoderCost:
    """Cost of a query in multiply-adds of layers and bytes fetched, without encodings and activations.

    Attributes:
        per_view: multiply-adds of a footprint and view, once for all lights.
        per_light: multiply-adds of each light.
        bytes_fetched: of latents.
    """

    per_view: int
    per_light: int
    bytes_fetched: int


def decoder_cost(weights: Weights, corrected: bool) -> DecoderCost:
    """The cost of a query of the network.

    Args:
        corrected: whether the fabric has a correction of the last layer.
    """
    sizes = {name: values.size for name, values in weights.tensors.items() if name.endswith("weight")}

    def layers(prefix: str) -> int:
        return sum(size for name, size in sizes.items() if name.startswith(f"decoder.{prefix}."))

    latent = weights.table.latent_size
    fetched, multiplied = latent, 0
    if weights.table.fusion:
        # The latent's part of the first layer is multiplied beforehand; its results are fetched.
        fetched = weights.tensor("decoder.fusion.0.bias").size
        multiplied = fetched * latent
    # Two levels, four texels each.
    taps = 8 if weights.table.latent == "field" else 1
    hidden, directions = weights.tensor("decoder.angular.0.weight").shape
    spatial = weights.tensor("decoder.hole.0.weight").shape[1] - 2
    angular = hidden * directions
    light = angular - hidden * (spatial + 2)
    per_light = light + layers("angular") - angular
    if corrected:
        per_light += 2 * BUNDLES * weights.table.hidden
    per_view = layers("fusion") - multiplied + angular - light + layers("hole") + taps * fetched
    return DecoderCost(per_view, per_light, 4 * taps * fetched)


@cache
def decoder_of(weights: Weights, float_type: type) -> Decoder:
    """The decoder of some weights on one backend; all fabrics share it."""
    return Decoder(weights, float_type)


# Layers in the order of memory, as shaders have them; see `neural_layers`.
LAYERS = ("FUSION_0", "FUSION_1", "HOLE_0", "HOLE_1", "VIEW", "LIGHT")
ANGULAR = ("ANGULAR", "ANGULAR_2", "ANGULAR_3")
LAST = "LAST"


def neural_layers(weights: Weights) -> dict[str, Layer]:
    """Weights and biases of the decoder's layers, split by their inputs as `neural.slang` evaluates them.

    The hole reads the inputs of the view's layer, whose last ones it does not use.
    """
    parts = split_matrices(weights)
    hole = np.concatenate([parts["hole spatial"], parts["hole view"]], axis=1)
    view = np.concatenate([parts["spatial"], parts["view"]], axis=1)
    hole = np.pad(hole, ((0, 0), (0, view.shape[1] - hole.shape[1])))
    layers: list[Layer] = [
        (weights.tensor("decoder.fusion.0.weight"), weights.tensor("decoder.fusion.0.bias")),
        (parts["fusion"], parts["fusion bias"]),
        (hole, parts["hole bias"]),
        (parts["hole last"], parts["hole last bias"]),
        (view, parts["0 bias"]),
        (parts["light"], None),
        *((parts[f"{number}"], parts[f"{number} bias"]) for number in range(1, len(ANGULAR) + 2)),
    ]
    return dict(zip((*LAYERS, *ANGULAR, LAST), layers, strict=True))


def shader_network(weights: Weights) -> Shared:
    """The decoder as shaders read it: halves, once for all fabrics.

    Raises:
        InputError: a network of another shape than that of the shaders.
    """
    shipped = shipped_weights()
    if weights.table.model_copy(update={"width": shipped.table.width}) != shipped.table or (
        weights.linear_diffuse != shipped.linear_diffuse
    ):
        raise InputError(
            f"{weights.source}: real-time shaders are compiled for networks of the shape of the shipped one, "
            f"of width {shipped.table.hidden}: train such a network, or leave weights away."
        )

    def halves() -> list[Layer]:
        return [
            (weight.astype(np.float16), None if bias is None else bias.astype(np.float16))
            for weight, bias in neural_layers(weights).values()
        ]

    return Shared(weights.sha256, halves)
