"""The prefiltered regime: components of a footprint as a sum over groups.

The weight of a group is its visible fraction: the footprint's coverage times the fraction of the view rays
that hit the group. Holes weigh likewise; groups divide the rest in proportion to their weights. A diffuse
term is the group's irradiance, a specular term its lobe times its visibility from the light.

V(light) is the fraction of a group's points that light reaches, as the mean of all views sees them. For one
view, visibility from light and view are correlated: P(lit given seen) lies between V(light) (independent) and
V(light)/max(V(light), V(view)) (fully correlated). κ interpolates. For diffuse terms κ grows as the azimuths
come together, and what the mean of all views has of it already is taken off again, in proportion to 1 −
V(light). In transmission κ < 0: light from the other side reaches the points that the view does not see. The
constants are fitted to rays (`tools/fits/lobes_shadows.py`).
"""

from __future__ import annotations

from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum, upload
from loomlight.core.footprint import Footprint
from loomlight.models.lobes.coverage_lookup import CoverageLookup, CoverageTaps
from loomlight.models.lobes.density import GroupLobe, layer_value
from loomlight.models.lobes.hemisphere import NODES, NodeTaps, node_taps
from loomlight.models.lobes.tables import MOMENTS, LobeTables

PER_BYTE = 1 / 255
# κ. Pairs are (a, b) of a + b·cos Δφ, Δφ the angle between the azimuths of light and view.
DIFFUSE_CORRELATION = 0.62, 0.63
MAX_CORRELATION = 1.2
SPECULAR_CORRELATION = 0.62
TRANSMISSION_CORRELATION = -0.09, -0.08
# Factor of 1 − V(light) that is taken off the diffuse term in reflection.
DIFFUSE_LOSS = 0.37
# Numbers loaded at once; the moments of a pack are three times as many.
_PACKET = 16


@dataclass
class TableLookup:
    """Positions of a footprint and a view in the tables, which do not depend on the light.

    Attributes:
        coverage: taps of the pyramid.
        view_nodes: nodes of the hemisphere around the view, of the face seen.
        view: unit vector [3] in the frame of the face seen.
        back: the back is seen.
    """

    coverage: CoverageTaps
    view_nodes: NodeTaps
    view: Vec3
    back: Mask


@dataclass
class SeenPack:
    """The four groups of one pack of the tables, for one view.

    Attributes:
        is_warp: all four are the warp's, else the weft's.
        weights: visible fraction of each group, not normalized: four Floats.
        lobes: moments of each group.
        visibility: V of light from the view's direction, of each group: four Floats.
    """

    is_warp: Mask
    weights: list[Float]
    lobes: list[GroupLobe]
    visibility: list[Float]


class PrefilteredLobes:
    """The tables of one fabric on one backend.

    Groups are read in pairs of packs, eight at a time, the warp's first, from contiguous memory.

    Attributes:
        pairs: number of pairs of packs: UInt32.
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
        self._view_table = upload(types.UInt32, _in_pairs(area[..., :packs], visibility[:, 0]))
        self._holes = upload(types.UInt32, np.pad(area[..., packs, None], ((0, 0), (0, 0), (0, 1))))
        self._light_table = upload(types.UInt32, _in_pairs(irradiance, visibility))
        self._moments = upload(types.Float, tables.moments)
        self._hole_weight = [dr.opaque(types.Float, float(weight)) for weight in tables.hole_weight]
        self._roughness = [dr.opaque(types.Float, float(value)) for value in roughness]
        self._optical_depth = dr.opaque(types.Float, float(optical_depth))

    def lookup(self, footprint: Footprint, view: Vec3, back: Mask) -> TableLookup:
        """Positions in the tables of a footprint, millimetres, and a view [3] of the face seen."""
        taps = node_taps(view)
        face = dr.select(back, self._types.UInt32(NODES), self._types.UInt32(0))
        around = NodeTaps(tuple(face + node for node in taps.nodes), taps.weights)
        return TableLookup(self._coverage.taps(footprint, back), around, view, back)

    def hole(self, at: TableLookup) -> Float:
        """Fraction of the view rays that pass through holes, 0 to 1."""
        holes = self._coverage.holes(at.coverage)
        packs = [dr.gather(self._types.Index2, self._holes, node).x for node in at.view_nodes.nodes]
        root_area = at.view_nodes.weights.interpolate(packs)[0]
        weight = holes * dr.square(root_area) * dr.select(at.back, self._hole_weight[1], self._hole_weight[0])
        return minimum(weight, 1)

    def seen_packs(self, at: TableLookup, pair: UInt) -> list[SeenPack]:
        """The groups of two packs."""
        coverage = self._coverage.groups(at.coverage, pair)
        projected, visibility = self._read(self._view_table, at.view_nodes, pair)
        return [
            self._seen_pack(at, 2 * pair + half, coverage[half], projected[half], visibility[half])
            for half in range(2)
        ]

    def _seen_pack(
        self,
        at: TableLookup,
        pack: UInt,
        coverage: list[Float],
        projected: list[Float],
        visibility: list[Float],
    ) -> SeenPack:
        types = self._types
        is_warp = pack < dr.select(at.back, self._warp_packs[1], self._warp_packs[0])
        roughness = dr.select(is_warp, *self._roughness)
        row = (dr.select(at.back, self._packs, 0) + pack) * (4 * MOMENTS // _PACKET)
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
        return SeenPack(is_warp, weights, lobes, [part * PER_BYTE for part in visibility])

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
        self, packs: list[SeenPack], at: TableLookup, nodes: NodeTaps, pair: UInt, light: Vec3, half: Vec3
    ) -> list[tuple[Float, Float, Float]]:
        """Sums over each pack's four groups of weight times diffuse, specular component and light visibility.

        Args:
            packs: the pair's packs.
            nodes: from `light_nodes`.
            light: unit vector [3] in the frame of the face seen.
            half: half vector [3] of light and view.
        """
        is_transmission = light.z < 0
        irradiance, visibility = self._read(self._light_table, nodes, pair)
        correlation = shadow_correlation(light, at.view, is_transmission)
        sums = []
        for number, pack in enumerate(packs):
            diffuse: Float = 0
            specular: Float = 0
            lit: Float = 0
            for group in range(4):
                from_light = visibility[number][group] * PER_BYTE
                diffuse_gain, gain = visibility_gain(correlation, from_light, pack.visibility[group])
                weight = pack.weights[group]
                diffuse += weight * irradiance[number][group] * diffuse_gain
                value = layer_value(
                    half, light, at.view, is_transmission, pack.lobes[group], self._optical_depth
                )
                specular += weight * value * (from_light * gain)
                lit += weight * (from_light * diffuse_gain)
            sums.append((diffuse * (PER_BYTE * dr.inv_pi), specular, lit))
        return sums

    def _read(self, table: UInt, nodes: NodeTaps, pair: UInt) -> tuple[list[list[Float]], list[list[Float]]]:
        """The interpolated bytes of two packs of both tables of `_in_pairs`: twice four Floats each."""
        rows = [dr.gather(self._types.Index4, table, dr.fma(node, self.pairs, pair)) for node in nodes.nodes]
        read = [nodes.weights.interpolate([row[pack] for row in rows]) for pack in range(4)]
        return read[:2], read[2:]


def _in_pairs(first: NDArray[np.uint32], second: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Interleaves two tables of packs [..., n]: two packs of the first, two of the second, and so on."""
    parts = [part.reshape(*part.shape[:-1], -1, 2) for part in (first, second)]
    return np.concatenate(parts, axis=-1)


@dataclass
class ShadowCorrelation:
    """Correlation of visibility from light and view within groups, for one pair of directions.

    Attributes:
        diffuse, specular: κ of either term, −0.2 to 1.2.
        diffuse_loss: factor of 1 − V(light) that is taken off the diffuse term.
    """

    diffuse: Float
    specular: Float
    diffuse_loss: Float


def shadow_correlation(light: Vec3, view: Vec3, is_transmission: Mask) -> ShadowCorrelation:
    """The correlation of visibility from light and view.

    Args:
        light, view: unit vectors [3].
        is_transmission: they lie on different sides of the cloth.
    """
    together = dr.fma(light.x, view.x, light.y * view.y)
    squares = [dr.fma(side.x, side.x, side.y * side.y) for side in (light, view)]
    # 0 where a direction has no azimuth: along the normal nearly all is visible, and κ hardly matters.
    cosine = together * dr.rcp(maximum(dr.sqrt(squares[0] * squares[1]), 1e-6))
    transmission = dr.fma(TRANSMISSION_CORRELATION[1], cosine, TRANSMISSION_CORRELATION[0])
    diffuse = dr.fma(DIFFUSE_CORRELATION[1], cosine, DIFFUSE_CORRELATION[0])
    return ShadowCorrelation(
        dr.select(is_transmission, transmission, minimum(diffuse, MAX_CORRELATION)),
        dr.select(is_transmission, transmission, SPECULAR_CORRELATION),
        dr.select(is_transmission, 0, array_types(cosine).Float(DIFFUSE_LOSS)),
    )


def visibility_gain(
    correlation: ShadowCorrelation, from_light: Float, from_view: Float
) -> tuple[Float, Float]:
    """P(lit given seen) over V(light), ≥ 0, of diffuse and of specular terms.

    Args:
        from_light: V(light), the fraction of a group's points that light reaches.
        from_view: the same for light from the view's direction.
    """
    most = maximum(maximum(from_light, from_view), PER_BYTE)
    less_one = dr.rcp(most) - 1
    kept = dr.fma(correlation.diffuse_loss, from_light, 1 - correlation.diffuse_loss)
    diffuse = maximum(dr.fma(correlation.diffuse, less_one, kept), 0)
    return diffuse, maximum(dr.fma(correlation.specular, less_one, 1), 0)


def half_vector(light: Vec3, view: Vec3) -> Vec3:
    """Unit half vector [3]; where light = −view any vector of at most that length."""
    x, y, z = light.x + view.x, light.y + view.y, light.z + view.z
    squared = dr.fma(x, x, dr.fma(y, y, z * z))
    scale = dr.rsqrt(maximum(squared, 1e-12))
    return type(light)(x * scale, y * scale, z * scale)
