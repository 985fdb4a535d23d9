"""The decoder in Dr.Jit, on any backend: cooperative vectors for the layers, gathers for the latents.

What the light does not change (latents, fusion, the view's part of the first angular layer, holes) is
computed once a footprint and view (`Decoder.seen`), the rest for every light (`Decoder.components`). The
first layer is linear, so latents are multiplied by its weights beforehand and interpolated afterwards.

Symbolic calls hand a network its weights lane by lane, which makes it ten times slower: call it outside.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import drjit as dr
import drjit.nn as nn
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types, uploaded
from loomlight.models.woven.architecture import (
    BINS,
    BLOB_REACH,
    HALF_BINS,
    HALF_REACH,
    LARGEST_OUTPUT,
    OPPOSITE,
    REFLECTION_GAIN,
    SLOPE,
    TRANSMISSION_GAIN,
)
from loomlight.models.woven.encoding import EncodedFabric
from loomlight.models.woven.latents import fetched_latents
from loomlight.models.woven.places import place_of
from loomlight.models.woven.pyramid import FINEST
from loomlight.models.woven.weights import Weights


@dataclass
class Seen:
    """What a view sees of footprints, before any light.

    Attributes:
        angular: the first angular layer without the light's part, a cooperative vector.
        hole: share of rays that pass through, 0 to 1.
        view: unit vector [3] in the frame of the face that is seen.
    """

    angular: Any
    hole: Any
    view: Any


class LatentTable:
    """Latents of both faces on one backend, multiplied by the first layer where there is fusion.

    Attributes:
        picks, ends: of the repeat.
        channels: numbers a texel.
    """

    def __init__(self, weights: Weights, encoded: EncodedFabric, float_type: type) -> None:
        self.picks, self.ends = encoded.picks, encoded.ends
        latents = fetched_latents(weights, encoded)
        self.channels = latents.shape[1]
        self.texels = len(encoded.faces[0])
        self._types = types = array_types(float_type)
        # Fetched by fours.
        self._padded = -(-self.channels // 4) * 4
        padding = ((0, 0), (0, self._padded - self.channels))
        self._values = uploaded(types.Float, np.pad(latents, padding))
        levels = encoded.levels
        self._last = len(levels) - 1
        # Whole numbers below 2^24 are exact in float32.
        numbers = [(level.first, level.columns, level.rows, level.per_thread) for level in levels]
        self._levels = uploaded(types.Float, np.array(numbers, np.float32))
        self._width = dr.opaque(types.UInt32, self.texels)
        self._extent = dr.opaque(types.Float, float(self.ends)), dr.opaque(types.Float, float(self.picks))
        self._top = dr.opaque(types.UInt32, self._last)

    def at(self, x: Any, y: Any, size: Any, back: Any) -> list[Any]:
        """Interpolated values of footprints: centres and sides in threads, `channels` Floats."""
        types = self._types
        face = dr.select(back, self._width, 0)
        if self.texels == 1:
            return self._row(face)
        ends, picks = self._extent
        # Near the origin, where float32 is finest.
        x, y = x - ends * dr.floor(x / ends), y - picks * dr.floor(y / picks)
        place = dr.clip(dr.log2(dr.maximum(size, 1e-6)) + FINEST, 0, types.Float(self._top))
        lower = dr.minimum(types.UInt32(place), self._top - 1)
        blend = place - types.Float(lower)
        total: list[Any] = [types.Float(0)] * self.channels
        for side in range(2):
            share = blend if side else 1 - blend
            for texel, weight in self._taps(lower + side, x, y):
                row = self._row(face + texel)
                total = [dr.fma(share * weight, value, sum_) for value, sum_ in zip(row, total, strict=True)]
        return total

    def _taps(self, level: Any, x: Any, y: Any) -> list[tuple[Any, Any]]:
        """Texels and bilinear weights of one level; see `pyramid.taps`."""
        types = self._types
        numbers = dr.gather(types.Vector4, self._levels, level)
        first, columns, rows, per_thread = (numbers[k] for k in range(4))
        corner = dr.select((level > FINEST) & (level < self._top), types.Float(1), 0.5)
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

    def _row(self, texel: Any) -> list[Any]:
        fours = self._padded // 4
        packets = [
            dr.gather(self._types.Vector4, self._values, texel * fours + number) for number in range(fours)
        ]
        return [value for packet in packets for value in packet][: self.channels]


class Decoder:
    """The network of some weights on one backend."""

    def __init__(self, weights: Weights, float_type: type) -> None:
        self.weights = weights
        self._types = array_types(float_type)
        table = weights.table
        self._layers = weights.layers("decoder.angular")
        parts: dict[str, NDArray[np.float32]] = {}
        if table.fusion:
            parts["place"] = weights.tensor("decoder.fusion.0.weight")[:, table.latent_size :]
            parts["fusion"] = weights.tensor("decoder.fusion.1.weight")
            parts["fusion bias"] = weights.tensor("decoder.fusion.1.bias")
        first, hole = weights.tensor("decoder.angular.0.weight"), weights.tensor("decoder.hole.0.weight")
        spatial = hole.shape[1] - 2
        parts["spatial"], light, parts["view"], half = np.split(
            first, [spatial, spatial + 3, spatial + 5], axis=1
        )
        # All that a light brings.
        parts["light"] = np.concatenate([light, half], 1)
        parts["0 bias"] = weights.tensor("decoder.angular.0.bias")
        for number in range(1, self._layers):
            parts[f"{number}"] = weights.tensor(f"decoder.angular.{number}.weight")
            parts[f"{number} bias"] = weights.tensor(f"decoder.angular.{number}.bias")
        parts["hole spatial"], parts["hole view"] = hole[:, :spatial], hole[:, spatial:]
        parts["hole bias"] = weights.tensor("decoder.hole.0.bias")
        parts["hole last"] = weights.tensor("decoder.hole.1.weight")
        parts["hole last bias"] = weights.tensor("decoder.hole.1.bias")
        tensor_type: Any = dr.tensor_t(float_type)
        tensors = [tensor_type(np.ascontiguousarray(values)) for values in parts.values()]
        views: Any = nn.pack(tensors, layout="inference")
        self._parts: dict[str, Any] = dict(zip(parts, views, strict=True))

    def seen(self, table: LatentTable, x: Any, y: Any, size: Any, view: Any, back: Any) -> Seen:
        """What a view sees of footprints.

        Args:
            x, y, size: centres and sides of footprints, in threads.
            view: unit vector [3] in the frame of the face that is seen, z > 0.
            back: whether that face is the back.
        """
        network = self.weights.table
        place = place_of(network, table.picks, table.ends, x, y, size, dr)
        coded = one_blob(place) if network.position == "one_blob" else list(place)
        fetched = table.at(x, y, size, back)
        if network.fusion:
            hidden = _leaky(self._product("place", coded) + nn.CoopVec(*fetched))
            spatial = _leaky(self._product("fusion", hidden, "fusion bias"))
        else:
            spatial = nn.CoopVec(*fetched, *coded)
        eye = nn.CoopVec(view.x, view.y)
        angular = self._product("spatial", spatial, "0 bias") + self._product("view", eye)
        hole = _leaky(self._product("hole spatial", spatial, "hole bias") + self._product("hole view", eye))
        (share,) = self._product("hole last", hole, "hole last bias")
        return Seen(angular, dr.clip(share, 0, 1), view)

    def components(self, seen: Seen, light: Any) -> list[Any]:
        """The four components, 1/sr, ≥ 0, for a light in the frame of the face that is seen."""
        directions = [light.x, light.y, light.z]
        if self.weights.table.half_vector:
            directions += coded_half_vector(light, seen.view)
        skip = seen.angular + self._product("light", directions)
        hidden = _leaky(skip)
        for number in range(1, self._layers):
            hidden = self._product(f"{number}", hidden, f"{number} bias")
            if number == 2:
                hidden = hidden + skip
            if number + 1 < self._layers:
                hidden = _leaky(hidden)
        return self._unmapped([*hidden], light)

    def _product(self, matrix: str, vector: Any, bias: str | None = None) -> Any:
        values = vector if isinstance(vector, nn.CoopVec) else nn.CoopVec(*vector)
        return nn.matvec(self._parts[matrix], values, None if bias is None else self._parts[bias])

    def _unmapped(self, output: list[Any], light: Any) -> list[Any]:
        """`losses.unmapped`."""
        types = self._types
        scale = dr.select(light.z > 0, types.Float(1 / REFLECTION_GAIN), 1 / TRANSMISSION_GAIN)
        linear = [(dr.exp(dr.clip(value, 0, LARGEST_OUTPUT)) - 1) * scale for value in output]
        if self.weights.linear_diffuse:
            return [*(dr.maximum(value, 0) for value in output[:2]), *linear[2:]]
        return linear


@dataclass(frozen=True)
class DecoderCost:
    """What one query costs, in multiply-adds of layers and fetches; codings and activations are not counted.

    Attributes:
        seen: of what the view sees of a footprint, once for all lights.
        lit: of each light.
        bytes_fetched: of latents.
    """

    seen: int
    lit: int
    bytes_fetched: int


def decoder_cost(weights: Weights) -> DecoderCost:
    """What a query of the network costs, as it is computed here."""
    sizes = {name: values.size for name, values in weights.tensors.items() if name.endswith("weight")}

    def layers(prefix: str) -> int:
        return sum(size for name, size in sizes.items() if name.startswith(f"decoder.{prefix}."))

    latent = weights.table.latent_size
    fetched, multiplied = latent, 0
    if weights.table.fusion:
        # The latent's part of the first layer is multiplied beforehand, and its result fetched.
        fetched = weights.tensor("decoder.fusion.0.bias").size
        multiplied = fetched * latent
    # Two levels, four texels each.
    taps = 8 if weights.table.latent == "field" else 1
    hidden, directions = weights.tensor("decoder.angular.0.weight").shape
    spatial = weights.tensor("decoder.hole.0.weight").shape[1] - 2
    angular = hidden * directions
    light = angular - hidden * (spatial + 2)
    lit = light + layers("angular") - angular
    seen = layers("fusion") - multiplied + angular - light + layers("hole") + taps * fetched
    return DecoderCost(seen, lit, 4 * taps * fetched)


@cache
def decoder_of(weights: Weights, float_type: type) -> Decoder:
    """The decoder of some weights on one backend; all fabrics share it."""
    return Decoder(weights, float_type)


def one_blob(place: tuple[Any, Any, Any]) -> list[Any]:
    """One-blob coding of x, y and size, 8 Floats each; see `network.one_blob`."""
    coded = []
    for number, value in enumerate(place):
        for bin_ in range(BINS):
            offset = value - (bin_ + 0.5) / BINS
            if number < 2:
                offset -= dr.round(offset)
            distance = offset * (BINS / BLOB_REACH)
            coded.append(dr.square(dr.maximum(dr.fma(-distance, distance, 1), 0)))
    return coded


def coded_half_vector(light: Any, view: Any) -> list[Any]:
    """One-blob coding of x and y of the half vector, 16 Floats each; see `network.coded_half_vector`."""
    total = light + view
    scale = 0.5 * dr.rsqrt(dr.squared_norm(total) + OPPOSITE)
    coded = []
    for value in (total.x, total.y):
        place = dr.fma(value, scale, 0.5) * (HALF_BINS / HALF_REACH)
        for bin_ in range(HALF_BINS):
            distance = place - (bin_ + 0.5) / HALF_REACH
            coded.append(dr.square(dr.maximum(dr.fma(-distance, distance, 1), 0)))
    return coded


def _leaky(vector: Any) -> Any:
    return dr.maximum(vector, vector * SLOPE)


def _wrapped(index: Any, count: Any) -> Any:
    """An index from −1 to count, brought to 0 to count − 1."""
    return dr.select(index < 0, index + count, dr.select(index >= count, index - count, index))
