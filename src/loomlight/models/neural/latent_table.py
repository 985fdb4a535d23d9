"""A fabric as the decoder reads it: uniform buffers of kernels, and arrays on a Dr.Jit backend.

Lengths are in threads. With fusion, the decoder's first layer is linear in the latents, so they are
multiplied by its weights here, before interpolation.
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import drjit.nn as nn
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask, UInt
from loomlight.core.backend import array_types, clip, maximum, minimum, opaque, upload
from loomlight.core.footprint import ANISOTROPIC_TAPS
from loomlight.core.simd import aligned, host_target, is_host_type
from loomlight.models.neural.codings import Fibre
from loomlight.models.neural.decoder_kernel import correction_layers
from loomlight.models.neural.encoded_fabric import FINEST_LEVEL, PACKET, AnisotropicTaps, EncodedFabric
from loomlight.models.neural.weights import Weights


class LatentTable:
    """Latents of both faces, fibres and correction of a fabric, for kernels and for one Dr.Jit backend.

    Attributes:
        picks, ends: of the repeat.
        channels: numbers a texel.
        has_correction: whether the fabric has a correction of the last layer.
        repeat: picks and ends where code depends on them (latents of kind "vector"); else 0 and 0.
        uniforms: uniform buffers of `decoder_kernel` after the packed layers; empty on devices without
            kernels.
        bundles: of the front, b and a of each, for both families; see `Fibres.bundles`.
        lobe_roughness: of both families; see `Fibres.lobe_roughness`.
    """

    def __init__(self, weights: Weights, encoded: EncodedFabric, float_type: FloatType | None = None) -> None:
        """The tables of a fabric.

        Args:
            float_type: of queries; None is for kernels alone, which take numpy arrays.
        """
        self.picks, self.ends = encoded.picks, encoded.ends
        self.texels = len(encoded.faces[0])
        self.channels = weights.table.fetched_channels
        self.has_correction = encoded.correction is not None
        field = weights.table.latent == "field"
        self.repeat = (0, 0) if field else (encoded.picks, encoded.ends)
        values = _fetched_values(weights, encoded)
        levels = encoded.levels
        if float_type is not None:
            values = self._upload(weights, encoded, float_type, values, levels)
        self.uniforms: list[NDArray[np.float32]] = []
        if float_type is None or is_host_type(float_type):
            self.uniforms = [values, levels, *_fabric_uniforms(weights, encoded, len(levels))]

    def _upload(
        self,
        weights: Weights,
        encoded: EncodedFabric,
        float_type: FloatType,
        values: NDArray[np.float32],
        levels: NDArray[np.float32],
    ) -> NDArray[np.float32]:
        """Uploads the tables of the methods below; returns the values, in Dr.Jit's memory on the host."""
        self._types = types = array_types(float_type)
        self._padded = values.shape[1]
        self._values = upload(types.Float, values)
        self._levels = upload(types.Float, levels)
        self._width = dr.opaque(types.UInt32, self.texels)
        self._extent = dr.opaque(types.Float, float(self.ends)), dr.opaque(types.Float, float(self.picks))
        self._top = dr.opaque(types.UInt32, len(levels) - 1)
        # Of the front, for each family.
        self._fibres = opaque(types.Float, encoded.fibres.face(False))
        self.lobe_roughness = tuple(opaque(types.Float, encoded.fibres.lobe_roughness()))
        self.bundles = opaque(types.Float, encoded.fibres.bundles(False)) if weights.table.bundles else []
        # Of the last layer: weights, then biases.
        self._correction: tuple[Float, Float] | None = None
        if encoded.correction is not None:
            weight, bias = encoded.correction[:, :-1], encoded.correction[:, -1]
            self._correction = (
                upload(types.Float, np.ascontiguousarray(weight)),
                upload(types.Float, np.ascontiguousarray(bias)),
            )
        if not is_host_type(float_type):
            return values
        dr.sync_thread()
        return self._values.numpy().reshape(values.shape)

    def fibres(self, back: Mask) -> tuple[Fibre, Fibre]:
        """The fibres of both families in the frame of the face that is seen; see `Fibres.face`."""
        (warp_x, warp_y, warp_roughness), (weft_x, weft_y, weft_roughness) = self._fibres
        return (
            Fibre(dr.select(back, -warp_x, warp_x), warp_y, warp_roughness),
            Fibre(weft_x, dr.select(back, -weft_y, weft_y), weft_roughness),
        )

    def corrected(
        self, lobe_weights: list[Float], hidden: list[Float], correction_weight: Float
    ) -> list[Float]:
        """The network's outputs for the lobe basis plus the fabric's fine-tuning of the last layer.

        Args:
            hidden: inputs of the last layer.
            correction_weight: weight of the correction, 0 to 1.
        """
        if self._correction is None:
            return lobe_weights
        tensor: Any = dr.tensor_t(self._types.Float)
        weight, bias = self._correction
        outputs = len(lobe_weights)
        matrix: Any = nn.view(tensor(weight, (outputs, dr.width(weight) // outputs)))
        added = nn.matvec(matrix, nn.CoopVec(*hidden), nn.view(tensor(bias, (outputs,))))
        return [
            dr.fma(correction_weight, change, value)
            for value, change in zip(lobe_weights, added, strict=True)
        ]

    def at(self, footprint: AnisotropicTaps, back: Mask) -> list[Float]:
        """Means of interpolated values over the anisotropic taps of footprints: `channels` Floats."""
        types = self._types
        face = dr.select(back, self._width, 0)
        if self.texels == 1:
            packets = [self._packet(face, number) for number in range(self._padded // PACKET)]
            return [value for packet in packets for value in packet][: self.channels]
        position = clip(dr.log2(maximum(footprint.side, 1e-6)) + FINEST_LEVEL, 0, types.Float(self._top))
        lower = minimum(types.UInt32(position), self._top - 1)
        blend = position - types.Float(lower)
        has_steps = (footprint.first_x != 0) | (footprint.first_y != 0)
        steps = dr.select(has_steps, types.UInt32(ANISOTROPIC_TAPS), 1)

        def added(number: UInt, total: list[Float]) -> tuple[UInt, list[Float]]:
            x, y = footprint.place(types.Float(number), dr)
            taps = [
                (face + texel, level_weight * weight / types.Float(steps))
                for level, level_weight in ((lower, 1 - blend), (lower + 1, blend))
                for texel, weight in self._taps(level, *self._near_origin(x, y))
            ]
            for packet in range(self._padded // PACKET):
                part = slice(packet * PACKET, (packet + 1) * PACKET)
                for texel, weight in taps:
                    row = self._packet(texel, packet)
                    total[part] = [
                        dr.fma(weight, value, sum_) for value, sum_ in zip(row, total[part], strict=True)
                    ]
            return number + 1, total

        nothing = [dr.zeros(types.Float, dr.width(footprint.numbers())) for _ in range(self._padded)]
        _, total = dr.while_loop(
            (dr.zeros(types.UInt32, dr.width(steps)), nothing),
            lambda number, _: number < steps,
            added,
            label="anisotropic taps",
            mode="symbolic",
            max_iterations=ANISOTROPIC_TAPS,
        )
        return list(total[: self.channels])

    def _near_origin(self, x: Float, y: Float) -> tuple[Float, Float]:
        """Positions wrapped to the repeat, where float32 is finest."""
        ends, picks = self._extent
        return x - ends * dr.floor(x / ends), y - picks * dr.floor(y / picks)

    def _taps(self, level: UInt, x: Float, y: Float) -> list[tuple[UInt, Float]]:
        """Texels and bilinear weights of one level; see `encoded_fabric.taps`."""
        types = self._types
        numbers = dr.gather(types.Vector4, self._levels, level)
        first, columns, rows, per_thread = (numbers[k] for k in range(4))
        corner = dr.select((level > FINEST_LEVEL) & (level < self._top), types.Float(1), 0.5)
        u, v = dr.fma(x, per_thread, -corner), dr.fma(y, per_thread, -corner)
        column, row = dr.floor(u), dr.floor(v)
        right, up = u - column, v - row
        left_column, right_column = _wrapped(column, columns), _wrapped(column + 1, columns)
        lower_row, upper_row = _wrapped(row, rows), _wrapped(row + 1, rows)
        return [
            (types.UInt32(dr.fma(r, columns, first + c)), across * along)
            for r, along in ((lower_row, 1 - up), (upper_row, up))
            for c, across in ((left_column, 1 - right), (right_column, right))
        ]

    def _packet(self, texel: UInt, number: int) -> list[Float]:
        """Some of the numbers of texels."""
        index = texel * (self._padded // PACKET) + number
        return dr.gather(self._types.Vectors, self._values, index, shape=(PACKET, dr.width(texel)))


def _fetched_values(weights: Weights, encoded: EncodedFabric) -> NDArray[np.float32]:
    """Values of texels, front above back [2 texels, channels up to whole packets], cache-line aligned."""
    latents = encoded.stacked
    if weights.table.fusion:
        first = weights.tensor("decoder.fusion.0.weight")[:, : weights.table.latent_size]
        latents = latents @ first.T + weights.tensor("decoder.fusion.0.bias")
    return aligned(np.pad(latents, ((0, 0), (0, -latents.shape[1] % PACKET))))


def _fabric_uniforms(weights: Weights, encoded: EncodedFabric, levels: int) -> list[NDArray[np.float32]]:
    """Parameters of the fabric, and its packed correction."""
    bundles = encoded.fibres.bundles(False) if weights.table.bundles else np.zeros(0)
    counts = [encoded.ends, encoded.picks, len(encoded.faces[0]), levels]
    parameters = np.concatenate([counts, encoded.fibres.face(False).ravel(), bundles.ravel()])
    correction = np.zeros(1, np.float32)
    if encoded.correction is not None:
        correction = correction_layers(encoded.correction, host_target()).weights()
    return [parameters.astype(np.float32), correction]


def _wrapped(index: Float, count: Float) -> Float:
    """An index from −1 to count, wrapped to 0 to count − 1."""
    return dr.select(index < 0, index + count, dr.select(index >= count, index - count, index))
