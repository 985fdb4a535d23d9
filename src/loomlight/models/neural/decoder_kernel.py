"""The decoder as a SIMD kernel: from the inputs of a query to its outputs, block by block.

Latents are fetched, positions and directions encoded, layers multiplied and lobes mixed while a block's
activations stay in the L1 cache. Code depends on the network's shape alone; weights and fabrics are uniform
buffers.

A kernel has one of five entry points. Inputs and outputs are arrays [n]. A footprint is the numbers of
`AnisotropicTaps`; a view is x, y, z of a unit vector in the frame of the face that is seen, z > 0, and 1
where that face is the back, else 0; a light is x, y, z in the same frame.

- "components_and_hole": footprint, view, light → four components, 1/sr, and the hole fraction.
- "hole": footprint, view → the hole fraction alone.
- "view": footprint, view → the first angular layer without the light's part, `hidden` numbers; the hole
  fraction; and the weight of the fabric's correction.
- "components": outputs of "view" without the hole fraction, view, light → four components.
- "hidden": footprint, view, light → the inputs of the last layer, `hidden` numbers.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

from loomlight.core.footprint import ANISOTROPIC_TAPS
from loomlight.core.simd import (
    BlockBuffer,
    KernelBuilder,
    PackedLayers,
    SimdTarget,
    SimdValue,
    Uniform,
    emit_activation,
    emit_dense,
)
from loomlight.models.neural.architecture import BINS, BUNDLES, LEAKY_SLOPE, VIEW_FEATURES
from loomlight.models.neural.codings import (
    DIFFUSE,
    Direction,
    Fibre,
    fibre_features,
    mixed_bundles,
    one_blob,
    unmapped,
)
from loomlight.models.neural.encoded_fabric import (
    FINEST_LEVEL,
    PACKET,
    AnisotropicTaps,
    fine_tuning_weight,
    footprint_coordinates,
)
from loomlight.models.neural.weights import Weights

EntryPoint = Literal["components_and_hole", "hole", "view", "components", "hidden"]
# Uniform buffers: packed layers, values and levels of `LatentTable`, parameters of the fabric, and its packed
# correction of the last layer.
_LAYERS, _TEXELS, _LEVELS, _FABRIC, _CORRECTION = range(5)
# Where parameters of the fabric begin.
_ENDS, _PICKS, _TEXEL_COUNT, _LEVEL_COUNT, _FIBRES, _BUNDLES = 0, 1, 2, 3, 4, 10
_FOOTPRINT, _VIEW, _LIGHT = 7, 4, 3  # numbers of an input
_COMPONENTS = DIFFUSE + 2
# Bilinear taps on two levels.
_TAPS = 8
# Vectors of a texel that are summed at a time, so that sums stay in registers.
_TEXEL_VECTORS = 6


def packed_layers(weights: Weights, target: SimdTarget) -> PackedLayers:
    """The layers of the decoder, split by their inputs, in the order of evaluation."""
    table, packed = weights.table, PackedLayers(target)

    def tensors(name: str) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        return weights.tensor(f"decoder.{name}.weight"), weights.tensor(f"decoder.{name}.bias")

    if table.fusion:
        # `LatentTable` stores the product of this layer with the latent, plus its bias.
        packed.add("coordinates", weights.tensor("decoder.fusion.0.weight")[:, table.latent_size :])
        packed.add("fusion", *tensors("fusion.1"))
    packed.add("hole", *tensors("hole.0"))
    packed.add("hole output", *tensors("hole.1"))
    weight, bias = tensors("angular.0")
    spatial = weights.tensor("decoder.hole.0.weight").shape[1] - 2
    of_spatial, of_light, of_view, of_fibres = np.split(weight, [spatial, spatial + 3, spatial + 5], axis=1)
    of_views, of_lights = np.split(of_fibres, [VIEW_FEATURES], axis=1)
    packed.add("view", np.concatenate([of_spatial, of_view, of_views], axis=1), bias)
    packed.add("light", np.concatenate([of_light, of_lights], axis=1))
    for number in range(1, weights.layers("decoder.angular")):
        packed.add(f"{number}", *tensors(f"angular.{number}"))
    return packed


def decoder_kernel(
    entry_point: EntryPoint,
    weights: Weights,
    has_correction: bool,
    repeat: tuple[int, int],
    target: SimdTarget,
) -> KernelBuilder:
    """The kernel of one entry point.

    Args:
        has_correction: whether the fabric has a correction of its own.
        repeat: picks and ends, for latents of kind "vector".
    """
    emitter = _DecoderEmitter(entry_point, weights, has_correction, repeat, target)
    with emitter.kernel.each_block():
        emitter.emit()
    return emitter.kernel


class _DecoderEmitter:
    """Emits the body of one entry point."""

    def __init__(
        self,
        entry_point: EntryPoint,
        weights: Weights,
        has_correction: bool,
        repeat: tuple[int, int],
        target: SimdTarget,
    ) -> None:
        table = weights.table
        self._entry_point, self._table, self._repeat = entry_point, table, repeat
        self._linear_diffuse = weights.linear_diffuse
        self._layers = packed_layers(weights, target).layers
        self._layer_count = weights.layers("decoder.angular")
        self._channels = table.fetched_channels
        self._padded_channels = -(-self._channels // PACKET) * PACKET
        self._hidden, self._has_correction = table.hidden, has_correction
        self._spatial = weights.tensor("decoder.hole.0.weight").shape[1] - 2
        inputs, outputs = {
            "components_and_hole": (_FOOTPRINT + _VIEW + _LIGHT, _COMPONENTS + 1),
            "hole": (_FOOTPRINT + _VIEW, 1),
            "view": (_FOOTPRINT + _VIEW, self._hidden + 2),
            "components": (self._hidden + 1 + _VIEW + _LIGHT, _COMPONENTS),
            "hidden": (_FOOTPRINT + _VIEW + _LIGHT, self._hidden),
        }[entry_point]
        self._first_view_input = self._hidden + 1 if entry_point == "components" else _FOOTPRINT
        self.kernel = KernelBuilder(f"neural_{entry_point}", target, inputs, outputs)
        self._fabric = self.kernel.uniform_buffer(_FABRIC)

    def emit(self) -> None:
        """Emits the body for a block."""
        kernel = self.kernel
        if self._entry_point == "components":
            view_sums, correction_weight = self._load_view_sums()
        else:
            correction_weight = kernel.block_buffer(1)
            view_sums = self._emit_view_layers(correction_weight)
        if self._entry_point == "view":
            self._store_channels(view_sums)
            with kernel.each_vector():
                kernel.store_output(self._hidden + 1, correction_weight[0])
        elif self._entry_point != "hole":
            hidden = self._emit_light_layers(view_sums)
            if self._entry_point == "hidden":
                self._store_channels(hidden)
            else:
                self._emit_components(hidden, correction_weight)

    # Inputs and uniforms.

    def _uniform_pointer(self, buffer: int) -> ir.Value:
        return self.kernel.uniform_buffer(buffer).pointer

    def _load_view(self) -> tuple[Direction, SimdValue]:
        """The view, and whether the back is seen."""
        x, y, z, back = (self.kernel.load_input(self._first_view_input + k) for k in range(_VIEW))
        return Direction(x, y, z), back > 0.5

    def _load_light(self) -> Direction:
        first = self._first_view_input + _VIEW
        return Direction(*(self.kernel.load_input(first + k) for k in range(_LIGHT)))

    def _load_footprint(self) -> AnisotropicTaps:
        return AnisotropicTaps(*(self.kernel.load_input(k) for k in range(_FOOTPRINT)))

    def _fibres(self, back: SimdValue) -> tuple[Fibre, Fibre]:
        """See `LatentTable.fibres`."""
        numbers, math = [self._fabric.load(_FIBRES + k) for k in range(6)], self.kernel.math
        (warp_x, warp_y, warp_roughness), (weft_x, weft_y, weft_roughness) = numbers[:3], numbers[3:]
        return (
            Fibre(math.select(back, -warp_x, warp_x), warp_y, warp_roughness),
            Fibre(weft_x, math.select(back, -weft_y, weft_y), weft_roughness),
        )

    def _emit_layer(
        self,
        name: str,
        inputs: BlockBuffer,
        outputs: BlockBuffer,
        initial: BlockBuffer | None = None,
        residual: BlockBuffer | None = None,
        leaky: bool = False,
    ) -> None:
        emit_dense(
            self.kernel,
            self._uniform_pointer(_LAYERS),
            self._layers[name],
            inputs,
            outputs,
            initial=initial,
            residual=residual,
            activation="leaky_relu" if leaky else "none",
            slope=LEAKY_SLOPE,
        )

    def _buffer_for(self, name: str) -> BlockBuffer:
        """A buffer for the outputs of a layer."""
        return self.kernel.block_buffer(self._layers[name].channels)

    # Layers that depend on footprint and view alone.

    def _emit_view_layers(self, correction_weight: BlockBuffer) -> BlockBuffer:
        """The first angular layer without the light's part; stores the hole fraction if it is an output."""
        kernel, table, math = self.kernel, self._table, self.kernel.math
        encoded, is_long = kernel.block_buffer(3 * BINS), kernel.block_buffer(1)
        with kernel.each_vector():
            footprint = self._load_footprint()
            size = footprint.size(math)
            coordinates = footprint_coordinates(table, *self._repeat, footprint.x, footprint.y, size, math)
            numbers = one_blob(coordinates, math) if table.position == "one_blob" else coordinates
            for number, value in enumerate(numbers):
                encoded[number] = value
            correction_weight[0] = fine_tuning_weight(coordinates[2], math)
            is_long[0] = math.abs(footprint.first_x) + math.abs(footprint.first_y)
        # The view's features follow the spatial ones, and overwrite the padding of layers.
        spatial = self._layers["fusion"].channels if table.fusion else self._padded_channels
        fused = kernel.block_buffer(max(spatial, self._spatial + 2 + VIEW_FEATURES))
        if table.fusion:
            padded = max(self._padded_channels, self._layers["coordinates"].channels)
            fetched, hidden = kernel.block_buffer(padded), self._buffer_for("coordinates")
            self._emit_fetch(is_long, fetched)
            self._emit_layer("coordinates", encoded, hidden, initial=fetched, leaky=True)
            self._emit_layer("fusion", hidden, fused, leaky=True)
        else:
            self._emit_fetch(is_long, fused)
            with kernel.each_vector():
                for number in range(self._spatial - self._channels):
                    fused[self._channels + number] = encoded[number]
        with kernel.each_vector():
            view, back = self._load_view()
            features: list[SimdValue] = [view.x, view.y]
            if table.fibres:
                features += [fibre.cosine(view.x, view.y) for fibre in self._fibres(back)]
            for number, value in enumerate(features):
                fused[self._spatial + number] = value
        view_sums = self._buffer_for("view")
        if self._entry_point != "hole":
            self._emit_layer("view", fused, view_sums)
        if self._entry_point != "hidden":
            self._emit_hole(fused)
        return view_sums

    def _emit_hole(self, fused: BlockBuffer) -> None:
        kernel = self.kernel
        hidden, hole = self._buffer_for("hole"), self._buffer_for("hole output")
        self._emit_layer("hole", fused, hidden, leaky=True)
        self._emit_layer("hole output", hidden, hole)
        output = {"components_and_hole": _COMPONENTS, "hole": 0, "view": self._hidden}[self._entry_point]
        with kernel.each_vector():
            kernel.store_output(output, kernel.math.clip(hole[0], 0, 1))

    def _emit_taps(self, taps: BlockBuffer, number: SimdValue, count: SimdValue) -> None:
        """Texels, then weights, of one of `count` anisotropic taps for the current vector; see `taps`."""
        math = self.kernel.math
        _, back = self._load_view()
        face = math.select(back, self._fabric[_TEXEL_COUNT], 0)
        if self._table.latent != "field":
            taps[0], taps[_TAPS] = face, 1
            return
        footprint = self._load_footprint()
        x, y = footprint.place(number, math)
        ends, picks, levels = (self._fabric[number] for number in (_ENDS, _PICKS, _LEVEL_COUNT))
        # Positions near the origin keep most digits. Clipping keeps texels in bounds, even those of NaN.
        x, y = (
            math.clip(value - period * math.floor(value / period), 0, period)
            for value, period in ((x, ends), (y, picks))
        )
        position = math.clip(math.log2(math.maximum(footprint.side, 1e-6)) + FINEST_LEVEL, 0, levels - 1)
        lower = math.minimum(math.floor(position), levels - 2)
        blend, weight = position - lower, 1 / count
        for side, level_weight in enumerate(((1 - blend) * weight, blend * weight)):
            level = lower + side
            first, columns, rows, texels_per_thread = self._load_level(level)
            is_running_mean = (level > FINEST_LEVEL) & (level < levels - 1)
            corner = math.select(is_running_mean, 1, 0.5)
            u, v = math.fma(x, texels_per_thread, -corner), math.fma(y, texels_per_thread, -corner)
            column, row = math.floor(u), math.floor(v)
            right, up = u - column, v - row
            for tall, along in enumerate((1 - up, up)):
                start = first + self._wrap(row + tall, rows) * columns
                for wide, across in enumerate((1 - right, right)):
                    tap = 4 * side + 2 * tall + wide
                    taps[tap] = face + start + self._wrap(column + wide, columns)
                    taps[_TAPS + tap] = level_weight * along * across

    def _wrap(self, index: SimdValue, count: SimdValue) -> SimdValue:
        """An index from −1 to count, wrapped to 0 … count − 1."""
        math = self.kernel.math
        return math.select(index < 0, index + count, math.select(index >= count, index - count, index))

    def _load_level(self, level: SimdValue) -> list[SimdValue]:
        """First texel, columns, rows and texels per thread of each lane's level."""
        count = self.kernel.load_index(self._uniform_pointer(_FABRIC), _LEVEL_COUNT)
        return self.kernel.table_rows(self._uniform_pointer(_LEVELS), 4, count, level)

    def _emit_fetch(self, is_long: BlockBuffer, outputs: BlockBuffer) -> None:
        """Means of interpolated latents over the anisotropic taps of footprints.

        Sums are accumulated query by query, with channels contiguous, and transposed afterwards.

        Args:
            is_long: 0 where a footprint has one tap.
        """
        kernel = self.kernel
        width, block, padded = kernel.target.width, kernel.target.block_size, self._padded_channels
        sums, taps = kernel.stack_floats(block * padded), kernel.block_buffer(2 * _TAPS)
        with kernel.loop(block * padded // width) as number:
            kernel.store(0, kernel.element_pointer(sums, kernel.multiply(number, width)))
        any_long = kernel.any_positive(is_long)
        count = kernel.ir.select(any_long, kernel.index(ANISOTROPIC_TAPS), kernel.index(1))
        with kernel.loop(count) as number:
            with kernel.each_vector():
                self._emit_taps(taps, kernel.broadcast_index(number), kernel.broadcast_index(count))
            self._emit_add_texels(taps, sums)
        with kernel.each_vector():
            first_query = kernel.element_pointer(sums, kernel.multiply(kernel.lane_index, padded))
            with kernel.loop(-(-self._channels // width)) as number:
                channel = kernel.ir.mul(number, kernel.index(width))
                rows = [
                    kernel.load(
                        kernel.element_pointer(
                            first_query, kernel.ir.add(channel, kernel.index(lane * padded))
                        )
                    )
                    for lane in range(width)
                ]
                for offset, value in enumerate(kernel.transpose(rows)):
                    outputs[kernel.ir.add(channel, kernel.index(offset))] = value

    def _emit_add_texels(self, taps: BlockBuffer, sums: ir.Value) -> None:
        """Adds weighted texels to the sums [block_size, padded channels]."""
        kernel, width, padded = self.kernel, self.kernel.target.width, self._padded_channels
        count = _TAPS if self._table.latent == "field" else 1
        texels = self._uniform_pointer(_TEXELS)
        with kernel.loop(kernel.target.block_size) as query:
            rows = [
                kernel.element_pointer(
                    texels, kernel.multiply(kernel.load_index(taps.channel_pointer(tap), query), padded)
                )
                for tap in range(count)
            ]
            query_sums = kernel.element_pointer(sums, kernel.multiply(query, padded))
            for first in range(0, padded, _TEXEL_VECTORS * width):
                channels = range(first, min(first + _TEXEL_VECTORS * width, padded), width)
                totals = [kernel.load(kernel.element_pointer(query_sums, channel)) for channel in channels]
                for tap, row in enumerate(rows):
                    weight = kernel.load_broadcast(taps.channel_pointer(_TAPS + tap), query)
                    totals = [
                        kernel.math.fma(weight, kernel.load(kernel.element_pointer(row, channel)), total)
                        for channel, total in zip(channels, totals, strict=True)
                    ]
                for channel, total in zip(channels, totals, strict=True):
                    kernel.store(total, kernel.element_pointer(query_sums, channel))

    def _store_channels(self, channels: BlockBuffer) -> None:
        """Writes `hidden` channels to the first outputs."""
        with self.kernel.loop(self._hidden) as channel, self.kernel.each_vector():
            self.kernel.store_output(channel, channels[channel])

    def _load_view_sums(self) -> tuple[BlockBuffer, BlockBuffer]:
        """The outputs of "view", from the first inputs."""
        kernel = self.kernel
        view_sums, correction_weight = self._buffer_for("view"), kernel.block_buffer(1)
        with kernel.loop(self._hidden) as channel, kernel.each_vector():
            view_sums[channel] = kernel.load_input(channel)
        with kernel.each_vector():
            correction_weight[0] = kernel.load_input(self._hidden)
        return view_sums, correction_weight

    # Layers that depend on the light.

    def _emit_light_layers(self, view_sums: BlockBuffer) -> BlockBuffer:
        """The inputs of the last layer."""
        kernel = self.kernel
        directions = kernel.block_buffer(self._layers["light"].inputs)
        with kernel.each_vector():
            light = self._load_light()
            view, back = self._load_view()
            features: list[SimdValue] = [light.x, light.y, light.z]
            if self._table.fibres:
                features += fibre_features(light, view, self._fibres(back), kernel.math)
            for number, value in enumerate(features):
                directions[number] = value
        skip, hidden = self._buffer_for("light"), self._buffer_for("light")
        self._emit_layer("light", directions, skip, initial=view_sums)
        emit_activation(kernel, skip, hidden, self._hidden, "leaky_relu", LEAKY_SLOPE)
        for number in range(1, self._layer_count - 1):
            outputs = self._buffer_for(f"{number}")
            # The second layer adds the first one's sums to its own.
            residual = skip if number == 2 else None
            self._emit_layer(f"{number}", hidden, outputs, residual=residual, leaky=True)
            hidden = outputs
        return hidden

    def _emit_correction(self, hidden: BlockBuffer) -> BlockBuffer | None:
        """The fabric's correction of the weights of lobes; None without one."""
        if not self._has_correction:
            return None
        kernel = self.kernel
        layer = correction_layers(np.zeros((2 * BUNDLES, self._hidden + 1)), kernel.target).layers[
            "correction"
        ]
        outputs = kernel.block_buffer(layer.channels)
        emit_dense(kernel, self._uniform_pointer(_CORRECTION), layer, hidden, outputs)
        return outputs

    def _emit_components(self, hidden: BlockBuffer, correction_weight: BlockBuffer) -> None:
        """The last layer, and the four components."""
        kernel, math, name = self.kernel, self.kernel.math, f"{self._layer_count - 1}"
        last = self._buffer_for(name)
        self._emit_layer(name, hidden, last)
        correction = self._emit_correction(hidden)
        with kernel.each_vector():
            light, specular = self._load_light(), None
            if self._table.bundles:
                lobe_weights = [last[DIFFUSE + number] for number in range(2 * BUNDLES)]
                if correction is not None:
                    weight = math.select(light.z > 0, correction_weight[0], 0)
                    lobe_weights = [
                        math.fma(weight, correction[number], value)
                        for number, value in enumerate(lobe_weights)
                    ]
                view, back = self._load_view()
                specular = mixed_bundles(lobe_weights, light, view, self._bundles(), back, math)
            output = [last[number] for number in range(DIFFUSE if specular else _COMPONENTS)]
            components = unmapped(output, specular, light.z, self._linear_diffuse, math)
            for number, value in enumerate(components):
                kernel.store_output(number, value)

    def _bundles(self) -> list[list[list[Uniform]]]:
        """Lobes of both families [2][`BUNDLES`][4]; see `Fibres.bundles`."""
        return [
            [
                [self._fabric[_BUNDLES + 4 * (family * BUNDLES + bundle) + k] for k in range(4)]
                for bundle in range(BUNDLES)
            ]
            for family in range(2)
        ]


def correction_layers(correction: NDArray[np.floating], target: SimdTarget) -> PackedLayers:
    """The layer of a fabric's correction: weights, then biases in the last column [outputs, hidden + 1]."""
    packed = PackedLayers(target)
    packed.add("correction", correction[:, :-1], correction[:, -1])
    return packed
