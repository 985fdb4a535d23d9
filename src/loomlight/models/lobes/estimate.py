"""The analytic estimate: what groups of a footprint do to light, and what directions their lobes suggest.

A group's weight is what views see of it: how much of it the footprint holds times the share of the view rays
that meet it. The weight of holes is their share; groups have the rest by their weights. Diffuse terms are the
group's irradiance, specular ones its lobe times the share of it that light reaches.

Light and view hide from the same yarns. Where both come from one azimuth, what the lower one reaches the
higher one reaches too, so of what is seen a share g = min(1, V(light)/V(view)) is lit; where their azimuths
differ by 90° or more they are as good as independent. In between a share κ = max(cos Δφ, 0) of g is taken and
1 − κ of V(light).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr

from loomlight.core.backend import ArrayTypes, uploaded
from loomlight.core.footprint import Footprint
from loomlight.models.lobes.coverage import CoverageTable, CoverageTaps
from loomlight.models.lobes.density import GroupLobe, layer_value
from loomlight.models.lobes.hemisphere import NODES, NodeTaps, node_taps
from loomlight.models.lobes.tables import MOMENTS, LobeTables

_PER_BYTE = 1 / 255


@dataclass
class Place:
    """Where a footprint and a view lie in the tables: what no light changes.

    Attributes:
        coverage: nodes of the pyramid.
        view_nodes: nodes of the hemisphere around the view.
        view: unit vector [3] in the frame of the face seen.
        back: Bool, the back is seen.
    """

    coverage: CoverageTaps
    view_nodes: NodeTaps
    view: Any
    back: Any


@dataclass
class Seen:
    """A word of four groups as a view sees them.

    Attributes:
        weights: of the groups, not divided by their sum yet: four Floats.
        lobes: of the groups.
        reached: share of each that light from the view's side and direction would reach: four Floats.
    """

    weights: list[Any]
    lobes: list[GroupLobe]
    reached: list[Any]


class Estimator:
    """The tables of one fabric on one backend.

    Attributes:
        words: words of four groups, the warp's half first: UInt32.
    """

    def __init__(
        self,
        tables: LobeTables,
        repeat: tuple[float, float],
        roughness: tuple[float, float],
        optical_depth: float,
        types: ArrayTypes,
    ) -> None:
        self._types = types
        self._coverage = CoverageTable(tables.size, tables.levels, tables.coverage, repeat, types)
        self.words = dr.opaque(types.UInt32, tables.words)
        self.warp_words = dr.opaque(types.UInt32, tables.words // 2)
        self._seen_row = dr.opaque(types.UInt32, 2 * tables.words + 1)
        self._lit_row = dr.opaque(types.UInt32, 2 * tables.words)
        self._face_rows = dr.opaque(types.UInt32, tables.words * 4)
        self._seen = uploaded(types.UInt32, tables.seen.view("<u4"))
        self._lit = uploaded(types.UInt32, tables.lit.view("<u4"))
        self._moments = uploaded(types.Float, tables.moments)
        self._hole_weight = [dr.opaque(types.Float, float(weight)) for weight in tables.hole_weight]
        self._roughness = [dr.opaque(types.Float, float(value)) for value in roughness]
        self._optical_depth = dr.opaque(types.Float, float(optical_depth))

    def place(self, footprint: Footprint, view: Any, back: Any) -> Place:
        """Where a footprint, millimetres, and a view [3] of the face seen lie in the tables."""
        return Place(self._coverage.taps(footprint, back), node_taps(view), view, back)

    def hole(self, place: Place) -> Any:
        """Share of the view rays that pass through holes: Float, 0 to 1."""
        holes = self._coverage.bytes(place.coverage, self.words)[0]
        seen = self._view_bytes(place, self.words)[0]
        weight = holes * dr.square(seen) * dr.select(place.back, self._hole_weight[1], self._hole_weight[0])
        return dr.minimum(weight, 1)

    def seen(self, place: Place, word: Any, is_warp: Any) -> Seen:
        """The four groups of a word."""
        types = self._types
        coverage = self._coverage.bytes(place.coverage, word)
        seen = self._view_bytes(place, word)
        reached = self._view_bytes(place, self.words + 1 + word)
        start = dr.select(place.back, self._face_rows, 0) + 4 * word
        roughness = dr.select(is_warp, *self._roughness)
        weights, lobes = [], []
        for byte in range(4):
            row = (start + byte) * (MOMENTS // 4)
            a, b, c = (dr.gather(types.Vector4, self._moments, row + part) for part in range(3))
            weights.append(coverage[byte] * dr.square(seen[byte]) * a.w)
            tangent = types.Vector3(b.x, b.y, b.z)
            zz = 1 - dr.squared_norm(tangent) - b.w - c.x
            lobes.append(
                GroupLobe(types.Vector3(a.x, a.y, a.z), tangent, b.w, c.x, zz, c.y, c.z, c.w, roughness)
            )
        return Seen(weights, lobes, [part * _PER_BYTE for part in reached])

    def light_nodes(self, place: Place, light: Any) -> NodeTaps:
        """Nodes around a light [3] in the frame of the face seen, in the tables of its side."""
        types = self._types
        side = dr.select(place.back, types.UInt32(2), types.UInt32(0)) + dr.select(
            light.z < 0, types.UInt32(1), types.UInt32(0)
        )
        taps = node_taps(light)
        start = side * NODES
        return NodeTaps(tuple((start + node) * self._lit_row for node in taps.nodes), taps.weights)

    def components(
        self, seen: Seen, place: Place, nodes: NodeTaps, word: Any, light: Any, half: Any
    ) -> tuple[Any, Any]:
        """Sums over four groups of weight times diffuse and specular component: Float each.

        Args:
            nodes: from `light_nodes`.
            light: unit vector [3] in the frame of the face seen.
            half: half vector [3] of light and view.
        """
        beyond = light.z < 0
        irradiance = self._bytes(self._lit, nodes, word)
        lit = self._bytes(self._lit, nodes, self.words + word)
        correlation = dr.select(beyond, 0, azimuth_correlation(light, place.view))
        diffuse: Any = 0
        specular: Any = 0
        for byte in range(4):
            # V + κ(min(1, V/V_view) − V), divided by V.
            reached = lit[byte] * _PER_BYTE
            most = dr.maximum(dr.maximum(reached, seen.reached[byte]), _PER_BYTE)
            raised = dr.fma(correlation, dr.rcp(most) - 1, 1)
            weight = seen.weights[byte]
            diffuse += weight * irradiance[byte] * raised
            value = layer_value(half, light, place.view, beyond, seen.lobes[byte], self._optical_depth)
            specular += weight * value * (reached * raised)
        return diffuse * (_PER_BYTE * dr.inv_pi), specular

    def _view_bytes(self, place: Place, word: Any) -> list[Any]:
        face = dr.select(place.back, self._types.UInt32(NODES), self._types.UInt32(0))
        nodes = tuple((face + node) * self._seen_row for node in place.view_nodes.nodes)
        return self._bytes(self._seen, NodeTaps(nodes, place.view_nodes.weights), word)

    def _bytes(self, table: Any, nodes: NodeTaps, word: Any) -> list[Any]:
        words = [dr.gather(self._types.UInt32, table, node + word) for node in nodes.nodes]
        return nodes.weights.interpolated(words)


def azimuth_correlation(light: Any, view: Any) -> Any:
    """κ = max(cos Δφ, 0) of two directions [3]; 0 where one has no azimuth."""
    together = light.x * view.x + light.y * view.y
    lengths = dr.sqrt((dr.square(light.x) + dr.square(light.y)) * (dr.square(view.x) + dr.square(view.y)))
    return dr.maximum(together, 0) * dr.rcp(dr.maximum(lengths, 1e-6))


def half_vector(light: Any, view: Any) -> Any:
    """Unit half vector [3]; where light = −view any vector of at most that length."""
    total = light + view
    return total * dr.rsqrt(dr.maximum(dr.squared_norm(total), 1e-12))
