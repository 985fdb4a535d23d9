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
    DENSITY_GAIN,
    DENSITY_SCALE,
    INCLINATION_BINS,
    INCLINATION_CROWDING,
    INCLINATION_REACH,
    LARGEST_OUTPUT,
    OPPOSITE,
    REFLECTION_GAIN,
    SLOPE,
    TRANSMISSION_GAIN,
    VIEW_FEATURES,
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
        fibres: of both families in that frame.
    """

    angular: Any
    hole: Any
    view: Any
    fibres: tuple[Fibre, Fibre]


@dataclass
class Fibre:
    """Fibres of one family on a yarn's crown.

    Attributes:
        x, y: their direction, a unit vector.
        roughness: α.
    """

    x: Any
    y: Any
    roughness: Any

    def cosine(self, direction: Any) -> Any:
        """Cosine with a unit vector [3]."""
        return dr.fma(self.x, direction.x, self.y * direction.y)


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
        numbers_of_fibres = encoded.fibres.face(False).tolist()
        self._fibres = [[dr.opaque(types.Float, number) for number in row] for row in numbers_of_fibres]

    def fibres(self, back: Any) -> tuple[Fibre, Fibre]:
        """The fibres of both families in the frame of the face that is seen; see `Fibres.face`."""
        (warp_x, warp_y, warp_roughness), (weft_x, weft_y, weft_roughness) = self._fibres
        return (
            Fibre(dr.select(back, -warp_x, warp_x), warp_y, warp_roughness),
            Fibre(weft_x, dr.select(back, -weft_y, weft_y), weft_roughness),
        )

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
        parts["spatial"], light, view, fibres = np.split(first, [spatial, spatial + 3, spatial + 5], axis=1)
        of_views, of_lights = np.split(fibres, [VIEW_FEATURES], axis=1)
        parts["view"] = np.concatenate([view, of_views], axis=1)
        parts["light"] = np.concatenate([light, of_lights], axis=1)
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
        fibres = table.fibres(back)
        cosines = [fibre.cosine(view) for fibre in fibres] if network.fibres else []
        angular = self._product("spatial", spatial, "0 bias") + self._product(
            "view", [view.x, view.y, *cosines]
        )
        hole = _leaky(self._product("hole spatial", spatial, "hole bias") + self._product("hole view", eye))
        (share,) = self._product("hole last", hole, "hole last bias")
        return Seen(angular, dr.clip(share, 0, 1), view, fibres)

    def components(self, seen: Seen, light: Any) -> list[Any]:
        """The four components, 1/sr, ≥ 0, for a light in the frame of the face that is seen."""
        directions = [light.x, light.y, light.z]
        if self.weights.table.fibres:
            directions += fibre_features(light, seen.view, seen.fibres)
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


def fibre_features(light: Any, view: Any, fibres: tuple[Fibre, Fibre]) -> list[Any]:
    """What lights bring of `network.fibre_features`: 36 Floats."""
    total = light + view
    height = dr.fma(total.z, total.z, OPPOSITE)
    inverse_square = dr.rcp(dr.fma(total.x, total.x, dr.fma(total.y, total.y, height)))
    cosines, bins, densities = [], [], []
    for fibre in fibres:
        cosines.append(fibre.cosine(light))
        cosine = fibre.cosine(total)
        square = dr.square(cosine)
        reach = dr.fma(INCLINATION_CROWDING, dr.sqrt(square + height), dr.abs(cosine))
        place = (0.5 * (1 + INCLINATION_CROWDING)) * cosine * dr.rcp(reach)
        place = (place + 0.5) * (INCLINATION_BINS / INCLINATION_REACH)
        for bin_ in range(INCLINATION_BINS):
            distance = place - (bin_ + 0.5) / INCLINATION_REACH
            bins.append(dr.square(dr.maximum(dr.fma(-distance, distance, 1), 0)))
        squared = dr.square(fibre.roughness)
        q = dr.fma(square * inverse_square, 1 - squared, squared)
        density = (DENSITY_GAIN * dr.inv_pi) * squared * fibre.roughness * dr.rcp(dr.square(q))
        densities.append(DENSITY_SCALE * dr.log(1 + density))
    return [*cosines, *bins, *densities]


def _leaky(vector: Any) -> Any:
    return dr.maximum(vector, vector * SLOPE)


def _wrapped(index: Any, count: Any) -> Any:
    """An index from −1 to count, brought to 0 to count − 1."""
    return dr.select(index < 0, index + count, dr.select(index >= count, index - count, index))
