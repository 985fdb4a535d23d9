"""The prefiltered regime: components of a footprint as a sum over groups.

The weight of a group is its visible fraction: the footprint's coverage times the fraction of the view rays
that hit the group. Holes weigh likewise; groups divide the rest in proportion to their weights. A diffuse
term is the group's irradiance, a specular term its lobe times its visibility from the light.

V(light) is the fraction of a group's points that light reaches, as the mean of all views sees them. What one
view sees of a family, light reaches more or less: sums over groups are multiplied by the ratios of
`JointLookup`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, maximum, minimum, opaque, upload
from loomlight.core.footprint import Footprint
from loomlight.models.lobes.coverage import CoverageLookup, CoverageTaps
from loomlight.models.lobes.hemisphere import NODES, NodeTaps, node_taps
from loomlight.models.lobes.tables import MOMENTS, LobeTables
from loomlight.models.lobes.visibility import JointLookup

# -------------------------------------------------------------------------------------------- lobe of a group
# The fibre layer over a group of points: closed forms of the layer of `scattering/fibre.py`.
#
# D(h) depends on the fibre direction by x = h·t alone, and over a group x is close to uniform: yarns bend
# evenly, and groups partition a family without gaps. With mean m and standard deviation s that is the
# interval [m − w, m + w], w = √3 s, and the mean of D(x) = 1/(πα (1 + k x²)²), k = 1/α² − 1, over it is
# elementary:
#
#     D̄ = 1/(2πα)·((1 − k x₀ x₁)/(q₀ q₁) + atan2(2w√k, 1 + k x₀ x₁)/(2w√k)),    q = 1 + k x²
#
# Neighbouring groups join without a seam, which sums of wider SGGX lobes do not. σ² is linear in t tᵀ, so its
# mean is exact. Attenuation uses the group's mean normal, and in reflection a factor for the spread of
# normals.


# Smallest half-width w in units of α: narrower groups act as one fibre, and the quotient below would cancel.
GROUP_NARROWEST = 0.02
# √k of α = 1, where D is constant; keeps quotients finite.
GROUP_MIN_STEEPNESS = 1e-3
# Lower bound of mean cosines: a group that is visible has normals that face the view.
GROUP_MIN_COSINE = 0.02
# Attenuation in reflection, averaged over a group, is that of its mean normal n̄ times
# 1 − GROUP_SPREAD_LOSS·(1 − |n̄|²) (points of silk, denim, wool and linen in random directions: 0.2 to 0.35).
# In transmission the factor is 1.
GROUP_SPREAD_LOSS = 0.35
# Shortest path x: below it, 1 − e^{−x} would cancel.
GROUP_MIN_PATH = 1e-3
# Coefficients of atan(x)/x in powers of x².
GROUP_ARC_TANGENT = (
    0.999999715,
    -0.33327976,
    0.198950258,
    -0.135376751,
    0.0847596977,
    -0.0377517076,
    0.00809729493,
)


@dataclass
class GroupLobe:
    """Moments of one group.

    Attributes:
        normal, tangent: means over the group [3], shorter than 1.
        xx, yy, zz, xy, xz, yz: covariance of the fibre direction.
        roughness: α of its family.
    """

    normal: Vec3
    tangent: Vec3
    xx: Float
    yy: Float
    zz: Float
    xy: Float
    xz: Float
    yz: Float
    roughness: Float

    def variance(self, direction: Vec3) -> Float:
        """Variance of direction·t, ≥ 0."""
        x, y, z = direction.x, direction.y, direction.z
        # Products of the direction are the same for all groups.
        square = dr.fma(self.xx, x * x, dr.fma(self.yy, y * y, self.zz * (z * z)))
        mixed = dr.fma(self.xy, x * y, dr.fma(self.xz, x * z, self.yz * (y * z)))
        return maximum(dr.fma(2, mixed, square), 0)


@dataclass
class _Interval:
    """[m − w, m + w] in units of 1/√k: the terms of D̄ that need no division.

    Attributes:
        product: k x₀ x₁.
        quotient: q₀ q₁.
        span: 2 w √k.
        larger: of span and |1 + product|.
        scale: 1/(2πα).
    """

    product: Float
    quotient: Float
    span: Float
    larger: Float
    scale: Float

    @property
    def denominator(self) -> Float:
        """The common denominator of D̄."""
        return self.quotient * self.span * self.larger


def _interval(half: Vec3, lobe: GroupLobe) -> _Interval:
    roughness = lobe.roughness
    per_roughness = dr.rcp(roughness)
    steepness = dr.sqrt(maximum(1 - dr.square(roughness), 0)) * per_roughness
    steepness = maximum(steepness, GROUP_MIN_STEEPNESS)
    narrowest = dr.fma(roughness, GROUP_NARROWEST, 1e-4)
    width = maximum(dr.sqrt(3 * lobe.variance(half)), narrowest)
    mean = dr.dot(half, lobe.tangent)
    first, last = steepness * (mean - width), steepness * (mean + width)
    product = first * last
    span = 2 * width * steepness
    return _Interval(
        product,
        dr.fma(first, first, 1) * dr.fma(last, last, 1),
        span,
        maximum(span, dr.abs(1 + product)),
        (0.5 / math.pi) * per_roughness,
    )


def _mean_density(interval: _Interval, reciprocal: Float) -> Float:
    """D̄ from the reciprocal of `denominator`: one division for three."""
    base = 1 + interval.product
    span, larger = interval.span, interval.larger
    per_span = reciprocal * interval.quotient * larger
    ratio = minimum(span, dr.abs(base)) * (reciprocal * interval.quotient * span)
    angle = _arc_tangent(ratio)
    angle = dr.select(span > dr.abs(base), 0.5 * math.pi - angle, angle)
    angle = dr.select(base < 0, math.pi - angle, angle)
    return interval.scale * dr.fma(1 - interval.product, reciprocal * span * larger, angle * per_span)


def _arc_tangent(ratio: Float) -> Float:
    """atan of 0 to 1: a least-squares polynomial at Chebyshev nodes, off by 6e-7 at most."""
    square = dr.square(ratio)
    value: Float = GROUP_ARC_TANGENT[-1]
    for coefficient in reversed(GROUP_ARC_TANGENT[:-1]):
        value = dr.fma(value, square, coefficient)
    return ratio * value


def mean_density(half: Vec3, lobe: GroupLobe) -> Float:
    """D̄(h) over the group, 1/sr; `half` is a unit vector [3]."""
    interval = _interval(half, lobe)
    return _mean_density(interval, dr.rcp(interval.denominator))


def mean_area(direction: Vec3, lobe: GroupLobe) -> Float:
    """Root of the mean σ² over the group: the fibres' projected area, α to 1."""
    mean = dr.dot(direction, lobe.tangent)
    along = dr.fma(mean, mean, lobe.variance(direction))
    squared = dr.square(lobe.roughness)
    return dr.sqrt(maximum(dr.fma(squared - 1, along, 1), squared))


def layer_value(
    half: Vec3, light: Vec3, view: Vec3, is_transmission: Mask, lobe: GroupLobe, optical_depth: Float
) -> Float:
    """f·cos of the group's fibre layer at albedo 1, without shadows, 1/sr.

    Args:
        half: unit half vector [3] of light and view.
        light, view: unit vectors [3] in the frame of the face seen; light.z < 0 in transmission.
        is_transmission: light comes from the other side.
    """
    cos_light = dr.dot(light, lobe.normal)
    cos_light = maximum(dr.select(is_transmission, -cos_light, cos_light), GROUP_MIN_COSINE)
    cos_view = maximum(dr.dot(view, lobe.normal), GROUP_MIN_COSINE)
    area_light, area_view = mean_area(light, lobe), mean_area(view, lobe)
    # Divisions cost most here: reciprocals are taken of products, and multiplied back.
    per_cosines = dr.rcp(cos_view * cos_light)
    per_view = per_cosines * cos_light
    slope_light, slope_view = area_light * per_cosines * cos_view, area_view * per_view
    # Reflection is (1 − e^{−x})/x·Tρ/cos_v with x = Tρ(Λ_l + Λ_v), transmission e^{−Tρ min(Λ_l, Λ_v)} times
    # the same with x = Tρ|Λ_l − Λ_v|: one form, so that both together take two exponentials.
    path = dr.select(is_transmission, dr.abs(slope_light - slope_view), slope_light + slope_view)
    depth = optical_depth * maximum(path, GROUP_MIN_PATH)
    unscattered = dr.exp(-optical_depth * dr.select(is_transmission, minimum(slope_light, slope_view), 0))
    interval = _interval(half, lobe)
    denominator = interval.denominator
    # At most 1e18, where α = 0.01 and both directions graze.
    reciprocal = dr.rcp(denominator * depth)
    attenuation = optical_depth * unscattered * (1 - dr.exp(-depth)) * (reciprocal * denominator) * per_view
    spread = 1 - dr.squared_norm(lobe.normal)
    spread_factor = dr.select(is_transmission, 1, dr.fma(-GROUP_SPREAD_LOSS, spread, 1))
    return 0.25 * _mean_density(interval, reciprocal * depth) * (spread_factor * attenuation)


# ------------------------------------------------------------------------------------------------ prefiltered


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
