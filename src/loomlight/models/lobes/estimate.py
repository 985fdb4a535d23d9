"""The analytic estimate: what groups of a footprint do to light, and what directions their lobes suggest.

A group's weight is what views see of it: how much of it the footprint holds times the share of the view rays
that meet it. The weight of holes is their share; groups have the rest by their weights. Diffuse terms are the
group's irradiance, specular ones its lobe times the share of it that light reaches.

What light and view reach of a group is much the same: what stands high both reach. Were it as much the
same as can be, of what is seen a share min(1, V(light)/V(view)) would be lit; were it independent, V(light).
A share κ of the first is taken and 1 − κ of the second. Of diffuse terms κ is the larger the nearer the
azimuths; of specular ones, which are bright where light and view mirror each other, it is the same all
around. Light from the other side reaches what the view does not, and κ < 0. The numbers are fits to rays
(`tools/fits/lobes_shadows.py`).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import DRJIT, ArrayTypes, minimum, upload
from loomlight.core.footprint import Footprint
from loomlight.models.lobes.coverage_lookup import CoverageLookup, CoverageTaps
from loomlight.models.lobes.density import GroupLobe, layer_value
from loomlight.models.lobes.hemisphere import NODES, NodeTaps, node_taps
from loomlight.models.lobes.tables import MOMENTS, LobeTables

PER_BYTE = 1 / 255
# κ: of terms that depend on the angle Δφ between azimuths, what there is at 90° and what cos Δφ adds.
DIFFUSE_CORRELATION = 0.5, 0.7
SPECULAR_CORRELATION = 0.9
THROUGH_CORRELATION = -0.35, -0.2
# Numbers fetched at once; what a word's four groups have is three times as many.
_PACKET = 16


@dataclass
class Place:
    """Where a footprint and a view lie in the tables: what no light changes.

    Attributes:
        coverage: nodes of the pyramid.
        view_nodes: nodes of the hemisphere around the view, of the face seen.
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
        is_warp: they are of the warp, all four.
        weights: of the groups, not divided by their sum yet: four Floats.
        lobes: of the groups.
        reached: share of each that light from the view's side and direction would reach: four Floats.
    """

    is_warp: Any
    weights: list[Any]
    lobes: list[GroupLobe]
    reached: list[Any]


class Estimator:
    """The tables of one fabric on one backend.

    Groups come in pairs of words, eight at a time, the warp's first: what is fetched for them lies in a row.

    Attributes:
        pairs: how many: UInt32.
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
        self._coverage = CoverageLookup(tables.base_size, tables.levels, tables.coverage, repeat, types)
        packs = tables.packs
        self.pairs = dr.opaque(types.UInt32, packs // 2)
        self._packs = dr.opaque(types.UInt32, packs)
        self._warp_packs = [dr.opaque(types.UInt32, int(number)) for number in tables.warp_packs]
        area, visibility, irradiance = (
            part.view("<u4") for part in (tables.projected_area, tables.light_visibility, tables.irradiance)
        )
        # Light from the view's direction comes from the side that is seen.
        self._seen = upload(types.UInt32, _in_pairs(area[..., :packs], visibility[:, 0]))
        self._holes = upload(types.UInt32, np.pad(area[..., packs, None], ((0, 0), (0, 0), (0, 1))))
        self._lit = upload(types.UInt32, _in_pairs(irradiance, visibility))
        self._moments = upload(types.Float, tables.moments)
        self._hole_weight = [dr.opaque(types.Float, float(weight)) for weight in tables.hole_weight]
        self._roughness = [dr.opaque(types.Float, float(value)) for value in roughness]
        self._optical_depth = dr.opaque(types.Float, float(optical_depth))

    def place(self, footprint: Footprint, view: Any, back: Any) -> Place:
        """Where a footprint, millimetres, and a view [3] of the face seen lie in the tables."""
        taps = node_taps(view)
        face = dr.select(back, self._types.UInt32(NODES), self._types.UInt32(0))
        around = NodeTaps(tuple(face + node for node in taps.nodes), taps.weights)
        return Place(self._coverage.taps(footprint, back), around, view, back)

    def hole(self, place: Place) -> Any:
        """Share of the view rays that pass through holes: Float, 0 to 1."""
        holes = self._coverage.holes(place.coverage)
        words = [dr.gather(self._types.Index2, self._holes, node).x for node in place.view_nodes.nodes]
        seen = place.view_nodes.weights.interpolate(words)[0]
        weight = holes * dr.square(seen) * dr.select(place.back, self._hole_weight[1], self._hole_weight[0])
        return minimum(weight, 1)

    def seen(self, place: Place, pair: Any) -> list[Seen]:
        """The groups of two words."""
        coverage = self._coverage.groups(place.coverage, pair)
        visible, reached = self._read(self._seen, place.view_nodes, pair)
        return [
            self._seen_word(place, 2 * pair + half, coverage[half], visible[half], reached[half])
            for half in range(2)
        ]

    def _seen_word(
        self, place: Place, word: Any, coverage: list[Any], visible: list[Any], reached: list[Any]
    ) -> Seen:
        types = self._types
        is_warp = word < dr.select(place.back, self._warp_packs[1], self._warp_packs[0])
        roughness = dr.select(is_warp, *self._roughness)
        row = (dr.select(place.back, self._packs, 0) + word) * (4 * MOMENTS // _PACKET)
        numbers: list[Any] = []
        for part in range(4 * MOMENTS // _PACKET):
            shape = _PACKET, dr.width(row)
            numbers.extend(dr.gather(types.Vectors, self._moments, row + part, shape=shape))
        weights, lobes = [], []
        for group in range(4):
            x, y, z, unit, *moments = numbers[MOMENTS * group : MOMENTS * (group + 1)]
            weights.append(coverage[group] * dr.square(visible[group]) * unit)
            tangent = types.Vector3(moments[0], moments[1], moments[2])
            xx, yy, xy, xz, yz = moments[3:]
            zz = 1 - dr.squared_norm(tangent) - xx - yy
            lobes.append(GroupLobe(types.Vector3(x, y, z), tangent, xx, yy, zz, xy, xz, yz, roughness))
        return Seen(is_warp, weights, lobes, [part * PER_BYTE for part in reached])

    def light_nodes(self, place: Place, light: Any) -> NodeTaps:
        """Nodes around a light [3] in the frame of the face seen, in the tables of its side."""
        types = self._types
        side = dr.select(place.back, types.UInt32(2), types.UInt32(0)) + dr.select(
            light.z < 0, types.UInt32(1), types.UInt32(0)
        )
        taps = node_taps(light)
        start = side * NODES
        return NodeTaps(tuple(start + node for node in taps.nodes), taps.weights)

    def components(
        self, seen: list[Seen], place: Place, nodes: NodeTaps, pair: Any, light: Any, half: Any
    ) -> list[tuple[Any, Any]]:
        """Sums over each word's four groups of weight times diffuse and specular component: Float each.

        Args:
            seen: the pair's words.
            nodes: from `light_nodes`.
            light: unit vector [3] in the frame of the face seen.
            half: half vector [3] of light and view.
        """
        beyond = light.z < 0
        irradiance, lit = self._read(self._lit, nodes, pair)
        correlations = shadow_correlation(light, place.view, beyond)
        found = []
        for number, word in enumerate(seen):
            diffuse: Any = 0
            specular: Any = 0
            for group in range(4):
                reached = lit[number][group] * PER_BYTE
                more_diffuse, more = raised_by(correlations, reached, word.reached[group], DRJIT)
                weight = word.weights[group]
                diffuse += weight * irradiance[number][group] * more_diffuse
                value = layer_value(half, light, place.view, beyond, word.lobes[group], self._optical_depth)
                specular += weight * value * (reached * more)
            found.append((diffuse * (PER_BYTE * dr.inv_pi), specular))
        return found

    def _read(self, table: Any, nodes: NodeTaps, pair: Any) -> tuple[list[Any], list[Any]]:
        """The bytes of two words in both halves of a table of `_in_pairs`: twice four Floats each."""
        rows = [dr.gather(self._types.Index4, table, dr.fma(node, self.pairs, pair)) for node in nodes.nodes]
        read = [nodes.weights.interpolate([row[word] for row in rows]) for word in range(4)]
        return read[:2], read[2:]


def _in_pairs(first: NDArray[np.uint32], second: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Two tables of words [..., n] as one, two words of the first and two of the second in turn."""
    parts = [part.reshape(*part.shape[:-1], -1, 2) for part in (first, second)]
    return np.concatenate(parts, axis=-1)


# Formulas for Dr.Jit's arrays and for machine code: `arrays` is `backend.DRJIT`, or a `Code` being written.


def shadow_correlation(light: Any, view: Any, beyond: Any, arrays: Any = DRJIT) -> tuple[Any, Any]:
    """κ of diffuse and of specular terms: how far what light and view reach is the same; −0.55 to 1.

    Args:
        light, view: unit vectors [3].
        beyond: Bool, they lie on different sides of the cloth.
    """
    together = arrays.fma(light.x, view.x, light.y * view.y)
    squares = [arrays.fma(side.x, side.x, side.y * side.y) for side in (light, view)]
    # 0 where one has no azimuth; from there nearly all is reached, and κ hardly counts.
    cosine = together * arrays.rcp(arrays.maximum(arrays.sqrt(squares[0] * squares[1]), 1e-6))
    through = arrays.fma(THROUGH_CORRELATION[1], cosine, THROUGH_CORRELATION[0])
    diffuse = arrays.fma(DIFFUSE_CORRELATION[1], cosine, DIFFUSE_CORRELATION[0])
    return (
        arrays.select(beyond, through, arrays.minimum(diffuse, 1)),
        arrays.select(beyond, through, SPECULAR_CORRELATION),
    )


def raised_by(
    correlations: tuple[Any, Any], reached: Any, reached_from_view: Any, arrays: Any
) -> tuple[Any, Any]:
    """(V + κ(min(1, V/V_view) − V))/V, ≥ 0, of shares that light, and light from the view, would reach."""
    most = arrays.maximum(arrays.maximum(reached, reached_from_view), PER_BYTE)
    less_one = arrays.rcp(most) - 1
    diffuse, specular = (arrays.maximum(arrays.fma(part, less_one, 1), 0) for part in correlations)
    return diffuse, specular


def half_vector(light: Any, view: Any, arrays: Any = DRJIT) -> Any:
    """Unit half vector [3]; where light = −view any vector of at most that length."""
    x, y, z = light.x + view.x, light.y + view.y, light.z + view.z
    squared = arrays.fma(x, x, arrays.fma(y, y, z * z))
    scale = arrays.rsqrt(arrays.maximum(squared, 1e-12))
    return type(light)(x * scale, y * scale, z * scale)
