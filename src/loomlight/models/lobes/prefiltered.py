"""The prefiltered regime: what groups of a footprint do to light, and what a view sees of them.

A group's weight is what views see of it: how much of it the footprint holds times the share of the view rays
that meet it. The weight of holes is their share; groups have the rest by their weights. Diffuse terms are the
group's irradiance, specular ones its lobe times the share of it that light reaches.

Within a group, visibility from light and view are correlated: P(lit given seen) lies between V(light)
(independent) and min(1, V(light)/V(view)) (fully correlated). κ interpolates. For diffuse terms κ grows as
the azimuths come together; for specular ones, which are bright where light and view mirror each other, it is
one number. In transmission κ < 0: light from the other side reaches what the view does not see. The numbers
are fits to rays (`tools/fits/lobes_shadows.py`).
"""

from __future__ import annotations

from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, maximum, minimum, upload
from loomlight.core.footprint import Footprint
from loomlight.models.lobes.coverage_lookup import CoverageLookup, CoverageTaps
from loomlight.models.lobes.density import GroupLobe, layer_value
from loomlight.models.lobes.hemisphere import NODES, NodeTaps, node_taps
from loomlight.models.lobes.tables import MOMENTS, LobeTables

PER_BYTE = 1 / 255
# κ: of terms that depend on the angle Δφ between azimuths, what there is at 90° and what cos Δφ adds.
DIFFUSE_CORRELATION = 0.5, 0.7
SPECULAR_CORRELATION = 0.9
TRANSMISSION_CORRELATION = -0.35, -0.2
# Numbers fetched at once; what a word's four groups have is three times as many.
_PACKET = 16


@dataclass
class TableLookup:
    """Where a footprint and a view lie in the tables: what no light changes.

    Attributes:
        coverage: nodes of the pyramid.
        view_nodes: nodes of the hemisphere around the view, of the face seen.
        view: unit vector [3] in the frame of the face seen.
        back: the back is seen.
    """

    coverage: CoverageTaps
    view_nodes: NodeTaps
    view: Vec3
    back: Mask


@dataclass
class SeenWord:
    """Four groups, a word of the tables, as a view sees them.

    Attributes:
        is_warp: they are of the warp, all four.
        weights: of the groups, not divided by their sum yet: four Floats.
        lobes: of the groups.
        visibility: share of each group's plan that light from the view's direction reaches: four Floats.
    """

    is_warp: Mask
    weights: list[Float]
    lobes: list[GroupLobe]
    visibility: list[Float]


class PrefilteredLobes:
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

    def lookup(self, footprint: Footprint, view: Vec3, back: Mask) -> TableLookup:
        """Where a footprint, millimetres, and a view [3] of the face seen lie in the tables."""
        taps = node_taps(view)
        face = dr.select(back, self._types.UInt32(NODES), self._types.UInt32(0))
        around = NodeTaps(tuple(face + node for node in taps.nodes), taps.weights)
        return TableLookup(self._coverage.taps(footprint, back), around, view, back)

    def hole(self, at: TableLookup) -> Float:
        """Share of the view rays that pass through holes: 0 to 1."""
        holes = self._coverage.holes(at.coverage)
        words = [dr.gather(self._types.Index2, self._holes, node).x for node in at.view_nodes.nodes]
        seen = at.view_nodes.weights.interpolate(words)[0]
        weight = holes * dr.square(seen) * dr.select(at.back, self._hole_weight[1], self._hole_weight[0])
        return minimum(weight, 1)

    def seen(self, at: TableLookup, pair: UInt) -> list[SeenWord]:
        """The groups of two words."""
        coverage = self._coverage.groups(at.coverage, pair)
        projected, visibility = self._read(self._seen, at.view_nodes, pair)
        return [
            self._seen_word(at, 2 * pair + half, coverage[half], projected[half], visibility[half])
            for half in range(2)
        ]

    def _seen_word(
        self,
        at: TableLookup,
        word: UInt,
        coverage: list[Float],
        projected: list[Float],
        visibility: list[Float],
    ) -> SeenWord:
        types = self._types
        is_warp = word < dr.select(at.back, self._warp_packs[1], self._warp_packs[0])
        roughness = dr.select(is_warp, *self._roughness)
        row = (dr.select(at.back, self._packs, 0) + word) * (4 * MOMENTS // _PACKET)
        numbers: list[Float] = []
        for part in range(4 * MOMENTS // _PACKET):
            shape = _PACKET, dr.width(row)
            numbers.extend(dr.gather(types.Vectors, self._moments, row + part, shape=shape))
        weights, lobes = [], []
        for group in range(4):
            x, y, z, unit, *moments = numbers[MOMENTS * group : MOMENTS * (group + 1)]
            weights.append(coverage[group] * dr.square(projected[group]) * unit)
            tangent = types.Vector3(moments[0], moments[1], moments[2])
            xx, yy, xy, xz, yz = moments[3:]
            zz = 1 - dr.squared_norm(tangent) - xx - yy
            lobes.append(GroupLobe(types.Vector3(x, y, z), tangent, xx, yy, zz, xy, xz, yz, roughness))
        return SeenWord(is_warp, weights, lobes, [part * PER_BYTE for part in visibility])

    def light_nodes(self, at: TableLookup, light: Vec3) -> NodeTaps:
        """Nodes around a light [3] in the frame of the face seen, in the tables of its side."""
        types = self._types
        side = dr.select(at.back, types.UInt32(2), types.UInt32(0)) + dr.select(
            light.z < 0, types.UInt32(1), types.UInt32(0)
        )
        taps = node_taps(light)
        start = side * NODES
        return NodeTaps(tuple(start + node for node in taps.nodes), taps.weights)

    def components(
        self, seen: list[SeenWord], at: TableLookup, nodes: NodeTaps, pair: UInt, light: Vec3, half: Vec3
    ) -> list[tuple[Float, Float]]:
        """Sums over each word's four groups of weight times diffuse and specular component.

        Args:
            seen: the pair's words.
            nodes: from `light_nodes`.
            light: unit vector [3] in the frame of the face seen.
            half: half vector [3] of light and view.
        """
        is_transmission = light.z < 0
        irradiance, visibility = self._read(self._lit, nodes, pair)
        correlations = shadow_correlation(light, at.view, is_transmission)
        found = []
        for number, word in enumerate(seen):
            diffuse: Float = 0
            specular: Float = 0
            for group in range(4):
                from_light = visibility[number][group] * PER_BYTE
                diffuse_gain, gain = visibility_gain(correlations, from_light, word.visibility[group])
                weight = word.weights[group]
                diffuse += weight * irradiance[number][group] * diffuse_gain
                value = layer_value(
                    half, light, at.view, is_transmission, word.lobes[group], self._optical_depth
                )
                specular += weight * value * (from_light * gain)
            found.append((diffuse * (PER_BYTE * dr.inv_pi), specular))
        return found

    def _read(self, table: UInt, nodes: NodeTaps, pair: UInt) -> tuple[list[list[Float]], list[list[Float]]]:
        """The bytes of two words in both halves of a table of `_in_pairs`: twice four Floats each."""
        rows = [dr.gather(self._types.Index4, table, dr.fma(node, self.pairs, pair)) for node in nodes.nodes]
        read = [nodes.weights.interpolate([row[word] for row in rows]) for word in range(4)]
        return read[:2], read[2:]


def _in_pairs(first: NDArray[np.uint32], second: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Two tables of words [..., n] as one, two words of the first and two of the second in turn."""
    parts = [part.reshape(*part.shape[:-1], -1, 2) for part in (first, second)]
    return np.concatenate(parts, axis=-1)


def shadow_correlation(light: Vec3, view: Vec3, is_transmission: Mask) -> tuple[Float, Float]:
    """κ of diffuse and of specular terms: how far visibility from light and view agree; −0.55 to 1.

    Args:
        light, view: unit vectors [3].
        is_transmission: they lie on different sides of the cloth.
    """
    together = dr.fma(light.x, view.x, light.y * view.y)
    squares = [dr.fma(side.x, side.x, side.y * side.y) for side in (light, view)]
    # 0 where one has no azimuth; from there nearly all is visible, and κ hardly counts.
    cosine = together * dr.rcp(maximum(dr.sqrt(squares[0] * squares[1]), 1e-6))
    transmission = dr.fma(TRANSMISSION_CORRELATION[1], cosine, TRANSMISSION_CORRELATION[0])
    diffuse = dr.fma(DIFFUSE_CORRELATION[1], cosine, DIFFUSE_CORRELATION[0])
    return (
        dr.select(is_transmission, transmission, minimum(diffuse, 1)),
        dr.select(is_transmission, transmission, SPECULAR_CORRELATION),
    )


def visibility_gain(
    correlations: tuple[Float, Float], from_light: Float, from_view: Float
) -> tuple[Float, Float]:
    """P(lit given seen) over V(light), ≥ 0, of diffuse and of specular terms, by their κ.

    Args:
        from_light: V(light), the share of a group's plan that light reaches.
        from_view: the same for light from the view's direction.
    """
    most = maximum(maximum(from_light, from_view), PER_BYTE)
    less_one = dr.rcp(most) - 1
    diffuse, specular = (maximum(dr.fma(part, less_one, 1), 0) for part in correlations)
    return diffuse, specular


def half_vector(light: Vec3, view: Vec3) -> Vec3:
    """Unit half vector [3]; where light = −view any vector of at most that length."""
    x, y, z = light.x + view.x, light.y + view.y, light.z + view.z
    squared = dr.fma(x, x, dr.fma(y, y, z * z))
    scale = dr.rsqrt(maximum(squared, 1e-12))
    return type(light)(x * scale, y * scale, z * scale)
