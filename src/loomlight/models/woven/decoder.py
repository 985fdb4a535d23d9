"""The decoder in Dr.Jit, on any backend: layers, and gathers for the latents.

What the light does not change (latents, fusion, the view's part of the first angular layer, holes) is
computed once a footprint and view (`Decoder.seen`), the rest for every light (`Decoder.components`). The
first layer is linear, so latents are multiplied by its weights beforehand and interpolated afterwards.

Symbolic calls hand cooperative vectors their weights lane by lane, which makes them ten times slower, and
other layers are not for these: call it outside.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import drjit as dr
import drjit.nn as nn
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types, clipped, keep_order, larger, smaller, uploaded
from loomlight.core.recorded import Held, Recorded
from loomlight.models.woven.architecture import (
    BINS,
    BLOB_REACH,
    BUNDLE_PLACES,
    BUNDLE_UNIT,
    BUNDLES,
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
from loomlight.models.woven.layers import CooperativeLayers, Layers, UnrolledLayers
from loomlight.models.woven.places import own_share, place_of
from loomlight.models.woven.pyramid import FINEST
from loomlight.models.woven.weights import Weights

# Of components, the first are diffuse.
_DIFFUSE = 2
# Numbers of a texel that are fetched at once: a line of the cache.
_PACKET = 16


@dataclass
class Seen:
    """What a view sees of footprints, before any light.

    Attributes:
        angular: the first angular layer without the light's part, numbers one by one.
        hole: share of rays that pass through, 0 to 1.
        own: how much of the fabric's own correction of the last layer counts, 0 to 1.
        view: unit vector [3] in the frame of the face that is seen.
        back: whether that is the back.
        table: latents that were seen.
    """

    angular: list[Any]
    hole: Any
    own: Any
    view: Any
    back: Any
    table: LatentTable


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
        bundles: of the front, b and a of each, for both families; see `Fibres.bundles`.
    """

    def __init__(self, weights: Weights, encoded: EncodedFabric, float_type: type) -> None:
        self.picks, self.ends = encoded.picks, encoded.ends
        latents = fetched_latents(weights, encoded)
        self.channels = latents.shape[1]
        self.texels = len(encoded.faces[0])
        self._types = types = array_types(float_type)
        self._padded = -(-self.channels // _PACKET) * _PACKET
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
        # Of the front, for each family.
        self.bundles = [
            [tuple(dr.opaque(types.Float, number) for number in bundle) for bundle in family]
            for family in (encoded.fibres.bundles(False).tolist() if weights.table.bundles else [])
        ]
        # Of the last layer: weights, then biases.
        self._correction: tuple[Any, Any] | None = None
        if encoded.correction is not None:
            weight, bias = encoded.correction[:, :-1], encoded.correction[:, -1]
            self._correction = tuple(
                uploaded(types.Float, np.ascontiguousarray(part)) for part in (weight, bias)
            )

    def fibres(self, back: Any) -> tuple[Fibre, Fibre]:
        """The fibres of both families in the frame of the face that is seen; see `Fibres.face`."""
        (warp_x, warp_y, warp_roughness), (weft_x, weft_y, weft_roughness) = self._fibres
        return (
            Fibre(dr.select(back, -warp_x, warp_x), warp_y, warp_roughness),
            Fibre(weft_x, dr.select(back, -weft_y, weft_y), weft_roughness),
        )

    @property
    def is_corrected(self) -> bool:
        """Whether the fabric has a correction of its own."""
        return self._correction is not None

    def corrected(self, shares: list[Any], hidden: list[Any], own: Any) -> list[Any]:
        """What is put out for bundles, with the fabric's own correction.

        Args:
            hidden: what the last layer takes.
            own: how much of the correction counts, 0 to 1.
        """
        if self._correction is None:
            return shares
        tensor: Any = dr.tensor_t(self._types.Float)
        weight, bias = self._correction
        outputs = len(shares)
        matrix: Any = nn.view(tensor(weight, (outputs, dr.width(weight) // outputs)))
        added = nn.matvec(matrix, nn.CoopVec(*hidden), nn.view(tensor(bias, (outputs,))))
        return [dr.fma(own, more, share) for share, more in zip(shares, added, strict=True)]

    def at(self, x: Any, y: Any, size: Any, back: Any) -> list[Any]:
        """Interpolated values of footprints: centres and sides in threads, `channels` Floats."""
        types = self._types
        face = dr.select(back, self._width, 0)
        if self.texels == 1:
            packets = [self._packet(face, number) for number in range(self._padded // _PACKET)]
            return [value for packet in packets for value in packet][: self.channels]
        ends, picks = self._extent
        # Near the origin, where float32 is finest.
        x, y = x - ends * dr.floor(x / ends), y - picks * dr.floor(y / picks)
        place = clipped(dr.log2(larger(size, 1e-6)) + FINEST, 0, types.Float(self._top))
        lower = smaller(types.UInt32(place), self._top - 1)
        blend = place - types.Float(lower)
        taps = []
        for side in range(2):
            share = blend if side else 1 - blend
            taps += [(face + texel, share * weight) for texel, weight in self._taps(lower + side, x, y)]
        total: list[Any] = []
        for number in range(self._padded // _PACKET):
            sums: list[Any] = [types.Float(0)] * _PACKET
            for texel, weight in taps:
                # Of one tap after another: all at once are more than there are registers.
                keep_order(types.Float)
                row = self._packet(texel, number)
                sums = [dr.fma(weight, value, sum_) for value, sum_ in zip(row, sums, strict=True)]
            total += sums
        return total[: self.channels]

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

    def _packet(self, texel: Any, number: int) -> Any:
        """Some of the numbers of texels."""
        index = texel * (self._padded // _PACKET) + number
        return dr.gather(self._types.Vectors, self._values, index, shape=(_PACKET, dr.width(texel)))


class Decoder:
    """The network of some weights on one backend.

    On CPUs queries are answered by kernels of their own, whose code the weights are part of
    (`UnrolledLayers`): they take seconds to compile, but once for all fabrics and scenes, and Dr.Jit keeps
    them on disk. Derivatives, and queries within symbolic calls and loops, go by cooperative vectors.
    """

    def __init__(self, weights: Weights, float_type: type) -> None:
        self.weights = weights
        self._types = array_types(float_type)
        self._count = weights.layers("decoder.angular")
        matrices = _matrices(weights)
        self._cooperative = CooperativeLayers(matrices, float_type)
        self._unrolled = UnrolledLayers(matrices, float_type)
        functions = self._seen, self._hole, self._components, self._answers
        self._launched = {
            function.__name__: Recorded(partial(self._unrolled_found, function)) for function in functions
        }

    @property
    def recordings(self) -> int:
        """How often kernels of its own were traced."""
        return sum(recorded.recordings for recorded in self._launched.values())

    def seen(self, table: LatentTable, x: Any, y: Any, size: Any, view: Any, back: Any) -> Seen:
        """What a view sees of footprints.

        Args:
            x, y, size: centres and sides of footprints, in threads.
            view: unit vector [3] in the frame of the face that is seen, z > 0.
            back: whether that face is the back.
        """
        asked = x, y, size, view, back
        angular, hole, own = self._found(self._seen, table, asked)
        return Seen(angular, hole, own, view, back, table)

    def hole(self, table: LatentTable, x: Any, y: Any, size: Any, view: Any, back: Any) -> Any:
        """The hole alone of `seen`."""
        return self._found(self._hole, table, (x, y, size, view, back))

    def components(self, seen: Seen, light: Any) -> list[Any]:
        """The four components, 1/sr, ≥ 0, for a light in the frame of the face that is seen."""
        asked = seen.angular, seen.view, seen.back, seen.own, light
        found: list[Any] = self._found(self._components, seen.table, asked)
        return found

    def answers(
        self, table: LatentTable, light: Any, x: Any, y: Any, size: Any, view: Any, back: Any
    ) -> list[Any]:
        """The four components for one light, and the hole: `components` of `seen` in one kernel."""
        found: list[Any] = self._found(self._answers, table, (x, y, size, view, back, light))
        return found

    def unrolls(self, asked: Sequence[Any]) -> bool:
        """Whether queries are answered by kernels of their own."""
        return (
            dr.backend_v(self._types.Float) == dr.JitBackend.LLVM
            and dr.width(asked) > 0
            and not dr.flag(dr.JitFlag.SymbolicScope)
            and not dr.flag(dr.JitFlag.FreezingScope)
            and not dr.grad_enabled(asked)
        )

    def _found(self, function: Callable[..., Any], table: LatentTable, asked: Sequence[Any]) -> Any:
        """What a function of layers, latents, the repeat and queries returns."""
        if not self.unrolls(asked):
            return function(self._cooperative, table, self._repeat(table), asked)
        # Kernels for single queries would be others, with numbers in place of arrays.
        width = max(dr.width(asked), 2)
        launched = self._launched[function.__name__]
        found = launched([self._unrolled.only], Held(table), self._repeat(table), _wide(asked, width))
        return found if width == dr.width(asked) else _first(found)

    def _unrolled_found(self, function: Callable[..., Any], _only: list[Any], *arguments: Any) -> Any:
        """The same of unrolled layers, within a recording that is told of their array."""
        return function(self._unrolled, *arguments)

    def _repeat(self, table: LatentTable) -> tuple[int, int]:
        """Picks and ends, if the code depends on them."""
        return (0, 0) if self.weights.table.latent == "field" else (table.picks, table.ends)

    def _seen(
        self, layers: Layers, table: LatentTable, repeat: tuple[int, int], asked: Sequence[Any]
    ) -> tuple[Any, Any, Any]:
        """The first angular layer without the light's part, the hole, and how much of a correction counts."""
        *_, view, back = asked

        def of_place(fetched: list[Any], coded: list[Any], eye: list[Any], cosines: list[Any]) -> list[Any]:
            spatial = self._spatial(layers, fetched, coded)
            angular = layers.added(
                layers.product("spatial", spatial, "0 bias"), layers.product("view", [*eye, *cosines])
            )
            return [self._share(layers, spatial, eye), *angular]

        cosines = [fibre.cosine(view) for fibre in table.fibres(back)] if self.weights.table.fibres else []
        fetched, coded = self._fetched(table, repeat, asked)
        hole, *angular = layers.outlined(of_place, fetched, coded, [view.x, view.y], cosines)
        x, y, side = asked[:3]
        size = place_of(self.weights.table, *repeat, x, y, side, dr)[2]
        return angular, clipped(hole, 0, 1), own_share(size, dr)

    def _hole(self, layers: Layers, table: LatentTable, repeat: tuple[int, int], asked: Sequence[Any]) -> Any:
        view = asked[3]

        def of_place(fetched: list[Any], coded: list[Any], eye: list[Any]) -> list[Any]:
            return [self._share(layers, self._spatial(layers, fetched, coded), eye)]

        (hole,) = layers.outlined(of_place, *self._fetched(table, repeat, asked), [view.x, view.y])
        return clipped(hole, 0, 1)

    def _fetched(
        self, table: LatentTable, repeat: tuple[int, int], asked: Sequence[Any]
    ) -> tuple[list[Any], list[Any]]:
        """Latents of footprints, and where these lie, coded."""
        x, y, size, _, back = asked
        network = self.weights.table
        place = place_of(network, *repeat, x, y, size, dr)
        coded = one_blob(place) if network.position == "one_blob" else list(place)
        return table.at(x, y, size, back), coded

    def _spatial(self, layers: Layers, fetched: list[Any], coded: list[Any]) -> Any:
        """Latent and footprint, fused."""
        if not self.weights.table.fusion:
            return [*fetched, *coded]
        hidden = layers.leaky(layers.added(layers.product("place", coded), fetched))
        return layers.leaky(layers.product("fusion", hidden, "fusion bias"))

    def _share(self, layers: Layers, spatial: Any, eye: list[Any]) -> Any:
        """The hole, not yet clipped."""
        hidden = layers.added(
            layers.product("hole spatial", spatial, "hole bias"), layers.product("hole view", eye)
        )
        (share,) = layers.product("hole last", layers.leaky(hidden), "hole last bias")
        return share

    def _components(
        self, layers: Layers, table: LatentTable, _repeat: tuple[int, int], asked: Sequence[Any]
    ) -> list[Any]:
        angular, view, back, own, light = asked
        directions = [light.x, light.y, light.z]
        if self.weights.table.fibres:
            directions += fibre_features(light, view, table.fibres(back))

        def of_light(angular: Any, directions: list[Any]) -> list[Any]:
            skip = layers.added(angular, layers.product("light", directions))
            hidden = layers.leaky(skip)
            for number in range(1, self._count):
                taken = hidden
                hidden = layers.product(f"{number}", hidden, f"{number} bias")
                if number == 2:
                    hidden = layers.added(hidden, skip)
                if number + 1 < self._count:
                    hidden = layers.leaky(hidden)
            return [*hidden, *(taken if table.is_corrected else [])]

        found = layers.outlined(of_light, angular, directions)
        if not self.weights.table.bundles:
            return self._unmapped(found, light)
        outputs = self.weights.table.outputs
        own = dr.select(light.z > 0, own, self._types.Float(0))
        shares = table.corrected(found[_DIFFUSE:outputs], found[outputs:], own)
        specular = mixed_bundles(shares, light + view, table.bundles, back)
        # As bright as a logarithm of `LARGEST_OUTPUT` is.
        most = math.expm1(LARGEST_OUTPUT) * self._scale(light)
        return [
            *self._unmapped(found[:_DIFFUSE], light),
            *(clipped(component, 0, most) for component in specular),
        ]

    def _answers(
        self, layers: Layers, table: LatentTable, repeat: tuple[int, int], asked: Sequence[Any]
    ) -> list[Any]:
        *of_view, light = asked
        angular, hole, own = self._seen(layers, table, repeat, of_view)
        return [*self._components(layers, table, repeat, [angular, *of_view[-2:], own, light]), hole]

    def _unmapped(self, output: list[Any], light: Any) -> list[Any]:
        """`losses.unmapped`."""
        scale = self._scale(light)
        linear = [(dr.exp(clipped(value, 0, LARGEST_OUTPUT)) - 1) * scale for value in output]
        if self.weights.linear_diffuse:
            return [*(larger(value, 0) for value in output[:2]), *linear[2:]]
        return linear

    def _scale(self, light: Any) -> Any:
        """1/k of `losses.gain`."""
        return dr.select(light.z > 0, self._types.Float(1 / REFLECTION_GAIN), 1 / TRANSMISSION_GAIN)


def _matrices(weights: Weights) -> dict[str, NDArray[np.float32]]:
    """Weights and biases, split by what they are multiplied with."""
    table = weights.table
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
    for number in range(1, weights.layers("decoder.angular")):
        parts[f"{number}"] = weights.tensor(f"decoder.angular.{number}.weight")
        parts[f"{number} bias"] = weights.tensor(f"decoder.angular.{number}.bias")
    parts["hole spatial"], parts["hole view"] = hole[:, :spatial], hole[:, spatial:]
    parts["hole bias"] = weights.tensor("decoder.hole.0.bias")
    parts["hole last"] = weights.tensor("decoder.hole.1.weight")
    parts["hole last bias"] = weights.tensor("decoder.hole.1.bias")
    return parts


def _wide(asked: Any, width: int) -> list[Any]:
    """Queries as evaluated arrays of a width: what all lanes share would make other kernels."""

    def spread(value: Any) -> Any:
        if isinstance(value, list | tuple):
            return [spread(part) for part in value]
        if dr.depth_v(value) > 1:
            return type(value)(*(spread(part) for part in value))
        if dr.width(value) == width:
            return type(value)(value)
        return dr.gather(type(value), value, dr.zeros(dr.uint32_array_t(value), width))

    found: list[Any] = spread(asked)
    dr.make_opaque(found)
    return found


def _first(found: Any) -> Any:
    """The first lane of arrays, in the containers that they are in."""
    if isinstance(found, list | tuple):
        return [_first(part) for part in found]
    return dr.gather(type(found), found, dr.uint32_array_t(found)(0))


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


def decoder_cost(weights: Weights, corrected: bool) -> DecoderCost:
    """What a query of the network costs, as it is computed here.

    Args:
        corrected: whether the fabric has a correction of its own.
    """
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
    if corrected:
        lit += 2 * BUNDLES * weights.table.hidden
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
            coded.append(dr.square(larger(dr.fma(-distance, distance, 1), 0)))
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
            bins.append(dr.square(larger(dr.fma(-distance, distance, 1), 0)))
        squared = dr.square(fibre.roughness)
        q = dr.fma(square * inverse_square, 1 - squared, squared)
        density = (DENSITY_GAIN * dr.inv_pi) * squared * fibre.roughness * dr.rcp(dr.square(q))
        densities.append(DENSITY_SCALE * dr.log(1 + density))
    return [*cosines, *bins, *densities]


def mixed_bundles(shares: Sequence[Any], total: Any, bundles: Sequence[Any], back: Any) -> list[Any]:
    """`network.mixed_bundles`: the specular components of both families.

    Args:
        shares: what is put out for the bundles of the face that is seen [2 · `BUNDLES`].
        total: light plus view [3], in the frame of that face.
        bundles: of the front.
        back: whether the back is seen.
    """
    inverse = dr.rcp(dr.squared_norm(total) + OPPOSITE)
    mixed = []
    for family, of_front in enumerate(bundles):
        # Those of the back are mirrored across the yarn, and so is their order of places.
        x = total.x if family else dr.select(back, -total.x, total.x)
        y = dr.select(back, -total.y, total.y) if family else total.y
        kept = shares[family * BUNDLES : (family + 1) * BUNDLES]
        component: Any = 0
        for number, (along_x, along_y, along_z, width) in enumerate(of_front):
            cosine = dr.fma(along_x, x, dr.fma(along_y, y, along_z * total.z))
            root = dr.fma(dr.square(cosine), inverse, width)
            behind = _mirrored(number)
            share = kept[number] if behind == number else dr.select(back, kept[behind], kept[number])
            share = larger(share, share * SLOPE)
            component = dr.fma(share, dr.rcp(dr.square(root)), component)
        mixed.append(BUNDLE_UNIT * component)
    return mixed


def _mirrored(bundle: int) -> int:
    """The number on the back of a bundle of the front."""
    slope, place = divmod(bundle, BUNDLE_PLACES)
    return bundle if bundle == BUNDLES - 1 else slope * BUNDLE_PLACES + BUNDLE_PLACES - 1 - place


def _wrapped(index: Any, count: Any) -> Any:
    """An index from −1 to count, brought to 0 to count − 1."""
    return dr.select(index < 0, index + count, dr.select(index >= count, index - count, index))
