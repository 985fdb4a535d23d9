"""The prefiltered regime: components of a footprint as a sum over groups.

The weight of a group is its visible fraction: the footprint's coverage times the fraction of the view rays
that hit the group. Holes weigh likewise; groups divide the rest in proportion to their weights. A diffuse
term is the group's irradiance, a specular term its lobe times its visibility from the light.

V(light) is the fraction of a group's points that light reaches, as the mean of all views sees them. What one
view sees of a family, light reaches more or less: sums over groups are multiplied by the ratios of
`joint_visibility`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, maximum, minimum, opaque, upload
from loomlight.core.footprint import Footprint
from loomlight.models.lobes.coverage_lookup import CoverageLookup, CoverageTaps
from loomlight.models.lobes.density import GroupLobe, layer_value
from loomlight.models.lobes.hemisphere import NODES, NodeTaps, node_taps
from loomlight.models.lobes.joint_lookup import JointLookup
from loomlight.models.lobes.tables import MOMENTS, LobeTables

PER_BYTE = 1 / 255
# Numbers loaded at once; the moments of a pack are three times as many.
_PACKET = 16


@dataclass
class TableLookup:
    """Positions of a footprint and a view in the tables, which do not depend on the light.

    Attributes:
        coverage: taps of the pyramid.
        view_nodes: nodes of the hemisphere around the view, of the face seen.
        joint_nodes: nodes of the ratios around the view.
        view: unit vector [3] in the frame of the face seen.
        back: the back is seen.
    """

    coverage: CoverageTaps
    view_nodes: NodeTaps
    joint_nodes: NodeTaps
    view: Vec3
    back: Mask


@dataclass
class SeenPack:
    """The four groups of one pack of the tables, for one view.

    Attributes:
        is_warp: all four are the warp's, else the weft's.
        weights: visible fraction of each group, not normalized: four Floats.
        lobes: moments of each group.
    """

    is_warp: Mask
    weights: list[Float]
    lobes: list[GroupLobe]


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
        self._warp_packs = opaque(types.UInt32, tables.warp_packs)
        area, visibility, irradiance = (
            part.view("<u4") for part in (tables.projected_area, tables.light_visibility, tables.irradiance)
        )
        self._view_table = upload(types.UInt32, area[..., :packs])
        self._holes = upload(types.UInt32, np.pad(area[..., packs, None], ((0, 0), (0, 0), (0, 1))))
        self._light_table = upload(types.UInt32, _in_pairs(irradiance, visibility))
        self._joint = JointLookup(tables.joint, types)
        self._moments = upload(types.Float, tables.moments)
        self._hole_weight = opaque(types.Float, tables.hole_weight)
        self._roughness = opaque(types.Float, roughness)
        self._optical_depth = dr.opaque(types.Float, float(optical_depth))

    def lookup(self, footprint: Footprint, view: Vec3, back: Mask) -> TableLookup:
        """Positions in the tables of a footprint, millimetres, and a view [3] of the face seen."""
        taps = node_taps(view)
        face = dr.select(back, self._types.UInt32(NODES), self._types.UInt32(0))
        around = NodeTaps(tuple(face + node for node in taps.nodes), taps.weights)
        return TableLookup(self._coverage.taps(footprint, back), around, self._joint.taps(view), view, back)

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
        projected = self._read(self._view_table, at.view_nodes, pair, self._types.Index2)
        return [self._seen_pack(at, 2 * pair + half, coverage[half], projected[half]) for half in range(2)]

    def _seen_pack(
        self, at: TableLookup, pack: UInt, coverage: list[Float], projected: list[Float]
    ) -> SeenPack:
        types = self._types
        is_warp = pack < dr.select(at.back, self._warp_packs[1], self._warp_packs[0])
        roughness = self.roughness(is_warp)
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
        return SeenPack(is_warp, weights, lobes)

    def roughness(self, is_warp: Mask) -> Float:
        """α of the warp where `is_warp`, else of the weft."""
        return dr.select(is_warp, *self._roughness)

    def light_nodes(self, at: TableLookup, light: Vec3) -> NodeTaps:
        """Nodes around a light [3] in the frame of the face seen, in the tables of its side."""
        types = self._types
        side = dr.select(at.back, types.UInt32(2), types.UInt32(0)) + dr.select(
            light.z < 0, types.UInt32(1), types.UInt32(0)
        )
        taps = node_taps(light)
        start = side * NODES
        return NodeTaps(tuple(start + node for node in taps.nodes), taps.weights)

    def ratios(self, at: TableLookup, light: Vec3) -> tuple[Float, Float]:
        """Joint over independent visibility of a light [3] in the frame of the face seen."""
        return self._joint.ratios(at.joint_nodes, self._joint.taps(light), at.back, light.z < 0)

    def components(
        self, packs: list[SeenPack], at: TableLookup, nodes: NodeTaps, pair: UInt, light: Vec3, half: Vec3
    ) -> list[tuple[Float, Float, Float]]:
        """Sums over each pack's four groups of weight times diffuse, specular component and light visibility.

        They are those of independent visibility, to be multiplied by `ratios`.

        Args:
            packs: the pair's packs.
            nodes: from `light_nodes`.
            light: unit vector [3] in the frame of the face seen.
            half: half vector [3] of light and view.
        """
        is_transmission = light.z < 0
        read = self._read(self._light_table, nodes, pair, self._types.Index4)
        irradiance, visibility = read[:2], read[2:]
        sums = []
        for number, pack in enumerate(packs):
            diffuse: Float = 0
            specular: Float = 0
            lit: Float = 0
            for group in range(4):
                weight = pack.weights[group]
                diffuse += weight * irradiance[number][group]
                value = layer_value(
                    half, light, at.view, is_transmission, pack.lobes[group], self._optical_depth
                )
                lit_weight = weight * visibility[number][group]
                specular += lit_weight * value
                lit += lit_weight
            sums.append((diffuse * (PER_BYTE * dr.inv_pi), specular * PER_BYTE, lit * PER_BYTE))
        return sums

    def _read(self, table: UInt, nodes: NodeTaps, pair: UInt, row_type: Any) -> list[list[Float]]:
        """The interpolated bytes of a pair's packs, four Floats each; `row_type` holds a row of the table."""
        rows = [dr.gather(row_type, table, dr.fma(node, self.pairs, pair)) for node in nodes.nodes]
        return [nodes.weights.interpolate([row[pack] for row in rows]) for pack in range(len(rows[0]))]


def _in_pairs(first: NDArray[np.uint32], second: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Interleaves two tables of packs [..., n]: two packs of the first, two of the second, and so on."""
    parts = [part.reshape(*part.shape[:-1], -1, 2) for part in (first, second)]
    return np.concatenate(parts, axis=-1)


def half_vector(light: Vec3, view: Vec3) -> Vec3:
    """Unit half vector [3]; where light = −view any vector of at most that length."""
    x, y, z = light.x + view.x, light.y + view.y, light.z + view.z
    squared = dr.fma(x, x, dr.fma(y, y, z * z))
    scale = dr.rsqrt(maximum(squared, 1e-12))
    return type(light)(x * scale, y * scale, z * scale)
