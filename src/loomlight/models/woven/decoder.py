"""The decoder for Dr.Jit's arrays, on any backend.

What the light does not change (latents, fusion, the view's part of the first angular layer, holes) is
computed once a footprint and view (`Decoder.seen`), the rest for every light (`Decoder.components`). The
first layer is linear, so latents are multiplied by its weights beforehand and interpolated afterwards.

On CPUs queries are answered by machine code (`compiled`); on GPUs, for derivatives, and within symbolic calls
and loops by cooperative vectors. On CPUs these are four times slower, in symbolic calls seventy times, as
Dr.Jit then hands them their weights lane by lane: call it outside.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types, clip
from loomlight.core.simd import call_kernel, can_use_kernel
from loomlight.models.woven.architecture import BUNDLES, VIEW_FEATURES
from loomlight.models.woven.codings import (
    DIFFUSE,
    fibre_features,
    mixed_bundles,
    one_blob,
    unmapped,
)
from loomlight.models.woven.compiled import compiled_decoder
from loomlight.models.woven.decoder_kernel import EntryPoint
from loomlight.models.woven.footprint_coding import AnisotropicTaps, own_share, place_of
from loomlight.models.woven.latent_table import LatentTable
from loomlight.models.woven.layers import CooperativeLayers
from loomlight.models.woven.weights import Weights


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


class Decoder:
    """The network of some weights on one backend."""

    def __init__(self, weights: Weights, float_type: type) -> None:
        self.weights = weights
        self._types = array_types(float_type)
        self._count = weights.layers("decoder.angular")
        self._layers = CooperativeLayers(_matrices(weights), float_type)

    def seen(self, table: LatentTable, squares: AnisotropicTaps, view: Any, back: Any) -> Seen:
        """What a view sees of footprints.

        Args:
            view: unit vector [3] in the frame of the face that is seen, z > 0.
            back: whether that face is the back.
        """
        asked = *squares.numbers(), view, back
        if self.compiles(asked):
            angular = self.weights.table.hidden
            *found, hole, own = self._compiled("seen", table, asked, angular + 2)
            return Seen(found, hole, own, view, back, table)
        spatial, cosines = self._spatial(table, squares, back), self._view_cosines(table, view, back)
        angular = self._layers.product("spatial", spatial, "0 bias")
        angular = self._layers.added(angular, self._layers.product("view", [view.x, view.y, *cosines]))
        coded_size = self._place(table, squares)[2]
        return Seen([*angular], self._hole(spatial, view), own_share(coded_size, dr), view, back, table)

    def hole(self, table: LatentTable, squares: AnisotropicTaps, view: Any, back: Any) -> Any:
        """The hole alone of `seen`."""
        asked = *squares.numbers(), view, back
        if self.compiles(asked):
            (found,) = self._compiled("hole", table, asked, 1)
            return found
        return self._hole(self._spatial(table, squares, back), view)

    def components(self, seen: Seen, light: Any) -> list[Any]:
        """The four components, 1/sr, ≥ 0, for a light in the frame of the face that is seen."""
        asked = seen.angular, seen.own, seen.view, seen.back, light
        if self.compiles(asked):
            return self._compiled("components", seen.table, asked, DIFFUSE + 2)
        return self._components(seen, light)

    def answers(
        self, table: LatentTable, light: Any, squares: AnisotropicTaps, view: Any, back: Any
    ) -> list[Any]:
        """The four components for one light, and the hole: `components` of `seen` at once."""
        asked = *squares.numbers(), view, back, light
        if self.compiles(asked):
            return self._compiled("answers", table, asked, DIFFUSE + 3)
        seen = self.seen(table, squares, view, back)
        return [*self._components(seen, light), seen.hole]

    def compiles(self, asked: Sequence[Any]) -> bool:
        """Whether queries are answered by machine code."""
        return can_use_kernel(self._types.Float, asked)

    def _compiled(self, question: EntryPoint, table: LatentTable, asked: Any, answers: int) -> list[Any]:
        """What machine code answers."""
        decoder = compiled_decoder(self.weights)
        return call_kernel(
            self._types.Float,
            asked,
            answers,
            lambda queries, found: decoder.run(question, table, queries, found),
        )

    def _place(self, table: LatentTable, squares: AnisotropicTaps) -> tuple[Any, Any, Any]:
        size = squares.size(dr)
        return place_of(self.weights.table, table.picks, table.ends, squares.x, squares.y, size, dr)

    def _view_cosines(self, table: LatentTable, view: Any, back: Any) -> list[Any]:
        fibres = table.fibres(back) if self.weights.table.fibres else ()
        return [fibre.cosine(view.x, view.y) for fibre in fibres]

    def _spatial(self, table: LatentTable, squares: AnisotropicTaps, back: Any) -> Any:
        """Latent and footprint, fused."""
        place = self._place(table, squares)
        coded = one_blob(place, dr) if self.weights.table.position == "one_blob" else list(place)
        fetched, layers = table.at(squares, back), self._layers
        if not self.weights.table.fusion:
            return [*fetched, *coded]
        hidden = layers.leaky(layers.added(layers.product("place", coded), fetched))
        return layers.leaky(layers.product("fusion", hidden, "fusion bias"))

    def _hole(self, spatial: Any, view: Any) -> Any:
        layers = self._layers
        hidden = layers.added(
            layers.product("hole spatial", spatial, "hole bias"),
            layers.product("hole view", [view.x, view.y]),
        )
        (share,) = layers.product("hole last", layers.leaky(hidden), "hole last bias")
        return clip(share, 0, 1)

    def _components(self, seen: Seen, light: Any) -> list[Any]:
        layers, table, weights = self._layers, seen.table, self.weights
        directions = [light.x, light.y, light.z]
        if weights.table.fibres:
            directions += fibre_features(light, seen.view, table.fibres(seen.back), dr)
        skip = layers.added(seen.angular, layers.product("light", directions))
        hidden = taken = layers.leaky(skip)
        for number in range(1, self._count):
            taken = hidden
            hidden = layers.product(f"{number}", hidden, f"{number} bias")
            if number == 2:
                hidden = layers.added(hidden, skip)
            if number + 1 < self._count:
                hidden = layers.leaky(hidden)
        found, specular = [*hidden], None
        if weights.table.bundles:
            own = dr.select(light.z > 0, seen.own, self._types.Float(0))
            shares = table.corrected(found[DIFFUSE:], [*taken], own)
            found = found[:DIFFUSE]
            specular = mixed_bundles(shares, light, seen.view, table.bundles, seen.back, dr)
        return unmapped(found, specular, light.z, weights.linear_diffuse, dr)


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
