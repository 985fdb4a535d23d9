"""The base term: a known function of the texel whose sum over footprints is known (zhu2024 eq. 8 to 11).

On the texel p of cluster c, with light i, view o and half vector h, at albedo 1 and cosine included:

    specular   m_c(o) v̄_c(i) A_c(i, o) D(p, h)
    diffuse    m_c(o) ((1 − w) |i_z| v̄_c(i) + w n̄_c(i)) / π
    lit        m_c(o) v̄_c(i)

v̄_c is the share of the cluster that the light reaches, n̄_c the mean over it of that times the cosine with the
yarn's normal, and A_c the attenuation of the fibre layer at the mean normal and fibre direction of the
cluster. m_c is the cluster's share of view rays over its share of texels: the paper looks at all texels
alike. In holes the base is 0.
Light from the other side has the same form, with v̄_c and n̄_c of the other face.

Whatever these functions are, base plus residual is exact: they decide about noise alone.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr

from loomlight.core.arrays import Array, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, maximum, minimum, upload
from loomlight.models.clustered.footprint_sums import FootprintSums
from loomlight.models.clustered.square_map import BINS, BinTaps, bin_taps
from loomlight.models.clustered.tables import NUMBERS, ClusterTables
from loomlight.models.clustered.texels import TexelModel
from loomlight.models.clustered.visibility_tables import VIEW_BINS
from loomlight.models.separable import Components
from loomlight.scattering.fibre import projected_area

# Cosines with the mean normal of a cluster, whose texels have others, are kept above this.
MIN_COSINE = 0.1
# Optical depth between the layer's slopes for light and view, kept above this: it is divided by.
MIN_DEPTH = 1e-3


@dataclass
class ClusterLobe:
    """Mean normal and fibre direction of a cluster [3], its roughness, and its lobe's in sampling."""

    normal: Vec3
    tangent: Vec3
    roughness: Float
    wide: Float


@dataclass
class LightTaps:
    """Table entries that the base of all clusters reads for one light.

    Attributes:
        facing: the light in the frame of the face that is seen [3].
        transmits: it falls on the other face.
        around: bins of the light, raised to the upper hemisphere.
        first: index of the first bin of its table.
        half: bins of the half vector.
    """

    facing: Vec3
    transmits: Mask
    around: BinTaps
    first: UInt
    half: BinTaps


class ViewedBase:
    """The base as one view sees it.

    Attributes:
        view: in the frame of the face that is seen [3].
        back: which face that is.
        offset: mean offset of parallax, millimetres [2].
        texel_trust: coefficients of the texel model's diffuse and specular term [2].
    """

    def __init__(self, tables: DeviceTables, view: Vec3, back: Mask, trusted: bool) -> None:
        types = tables.types
        self._tables = tables
        self.view, self.back = view, back
        self._face = dr.select(back, types.UInt32(1), types.UInt32(0))
        self._around = bin_taps(view, VIEW_BINS)
        self._first = self._face * VIEW_BINS**2
        self.offset: Vec2 = self._around.read(types.Vector2, tables.offset, self._first, 1, types.UInt32(0))
        self.texel_trust: Vec2 = self._around.read(
            types.Vector2, tables.texel_trust, self._first, 1, types.UInt32(0)
        )
        self._trust: Vec2 = types.Vector2(1)
        if trusted:
            self._trust = self._around.read(types.Vector2, tables.trust, self._first, 1, types.UInt32(0))
        packets = tables.clusters // 4
        self.masking = [
            self._around.read(types.Vector4, tables.view, self._first, packets, types.UInt32(packet))
            for packet in range(packets)
        ]

    def light_taps(self, light: Vec3) -> LightTaps:
        """Table entries that a light in the frame of the face reads."""
        types = self._tables.types
        transmits = light.z < 0
        side = dr.select(transmits, types.UInt32(1), types.UInt32(0))
        total = light + self.view
        half = total * dr.rsqrt(maximum(dr.squared_norm(total), 1e-12))
        half = dr.select(half.z < 0, -half, half)
        return LightTaps(
            facing=light,
            transmits=transmits,
            around=bin_taps(types.Vector3(light.x, light.y, abs(light.z))),
            first=(self._face * 2 + side) * BINS**2,
            half=bin_taps(half),
        )

    def lobe(self, cluster: UInt) -> ClusterLobe:
        """A cluster's lobe; clusters are numbered within the face."""
        types, tables = self._tables.types, self._tables
        entry = (self._face * tables.clusters + cluster) * (NUMBERS // 4)
        first = dr.gather(types.Vector4, tables.moments, entry)
        second = dr.gather(types.Vector4, tables.moments, entry + 1)
        return ClusterLobe(
            normal=types.Vector3(first.x, first.y, first.z),
            tangent=types.Vector3(first.w, second.x, second.y),
            wide=second.z,
            roughness=second.w,
        )

    def over(self, means: list[Array], taps: LightTaps) -> Components:
        """The base's mean over footprints.

        Args:
            means: from `FootprintSums.means`.
        """
        types, tables = self._tables.types, self._tables
        packets = tables.clusters // 4
        half_first = self._face * BINS**2
        total = [types.Float(0) for _ in range(5)]
        for packet in range(packets):
            lit = taps.around.read(types.Vector4, tables.light, taps.first, 2 * packets, types.UInt32(packet))
            about_yarn = taps.around.read(
                types.Vector4, tables.light, taps.first, 2 * packets, types.UInt32(packets + packet)
            )
            density: Any = types.Vector4(0)
            for number in range(1 + tables.rank):
                entry = types.UInt32(number * packets + packet)
                density += means[number * packets + packet] * taps.half.read(
                    types.Vector4, tables.basis, half_first, packets * (1 + tables.rank), entry
                )
            masking = self.masking[packet]
            weight = means[packet] * masking
            for lane in range(4):
                cluster = 4 * packet + lane
                family = 0 if cluster < tables.clusters // 2 else 1
                attenuation = self._attenuation(self.lobe(types.UInt32(cluster)), taps)
                total[family] += weight[lane] * self._diffuse(taps, lit[lane], about_yarn[lane])
                total[2 + family] += masking[lane] * lit[lane] * attenuation * density[lane]
                total[4] += weight[lane] * lit[lane]
        return self._trusted(Components(*total))

    def shown_over(self, means: list[Array], trusted: bool) -> tuple[Float, Float]:
        """Shares of the view rays through footprints that meet warp and weft, as the base has them.

        Args:
            means: from `FootprintSums.means`.
            trusted: scale them as the diffuse term.
        """
        types, packets = self._tables.types, self._tables.clusters // 4
        shown = [types.Float(0), types.Float(0)]
        for cluster in range(self._tables.clusters):
            packet, lane = divmod(cluster, 4)
            shown[cluster // (2 * packets)] += means[packet][lane] * self.masking[packet][lane]
        scale = self._trust[0] if trusted else 1
        return shown[0] * scale, shown[1] * scale

    def shown_at_texel(self, texel: UInt, trusted: bool) -> tuple[Float, Float]:
        """The same of one texel."""
        _, label, masking = self._cluster_at(texel)
        shown = masking * (self._trust[0] if trusted else 1)
        is_warp = label < self._tables.clusters // 2
        return dr.select(is_warp, shown, 0), dr.select(is_warp, 0, shown)

    def _cluster_at(self, texel: UInt) -> tuple[UInt, UInt, Float]:
        """Place of a texel in the tables, its cluster, and the masking of that; 0 in holes."""
        types, tables = self._tables.types, self._tables
        place = self._face * tables.face_texels + texel
        label = dr.gather(types.UInt32, tables.labels, place)
        met = label < tables.clusters
        label = minimum(label, types.UInt32(tables.clusters - 1))
        masking = self._around.read(types.Float, tables.view, self._first, tables.clusters, label)
        return place, label, dr.select(met, masking, 0)

    def _trusted(self, known: Components) -> Components:
        diffuse, specular = self._trust
        return Components(
            known.diffuse_warp * diffuse,
            known.diffuse_weft * diffuse,
            known.specular_warp * specular,
            known.specular_weft * specular,
            known.light_visibility * diffuse,
        )

    def at_texel(self, texel: UInt, taps: LightTaps) -> Components:
        """The base of one texel."""
        types, tables = self._tables.types, self._tables
        place, label, masking = self._cluster_at(texel)
        clusters = tables.clusters
        lit = taps.around.read(types.Float, tables.light, taps.first, 2 * clusters, label)
        about_yarn = taps.around.read(types.Float, tables.light, taps.first, 2 * clusters, clusters + label)
        density: Any = types.Float(0)
        for number in range(1 + tables.rank):
            part = taps.half.read(
                types.Float,
                tables.basis,
                self._face * BINS**2,
                clusters * (1 + tables.rank),
                number * clusters + label,
            )
            if number:
                part *= dr.gather(types.Float, tables.coefficients, place * tables.rank + (number - 1))
            density += part
        diffuse = masking * self._diffuse(taps, lit, about_yarn)
        specular = masking * lit * self._attenuation(self.lobe(label), taps) * density
        is_warp = label < clusters // 2
        return self._trusted(
            Components(
                dr.select(is_warp, diffuse, 0),
                dr.select(is_warp, 0, diffuse),
                dr.select(is_warp, specular, 0),
                dr.select(is_warp, 0, specular),
                masking * lit,
            )
        )

    def _diffuse(self, taps: LightTaps, lit: Float, about_yarn: Float) -> Float:
        blend = self._tables.diffuse_blend
        return dr.inv_pi * ((1 - blend) * abs(taps.facing.z) * lit + blend * about_yarn)

    def _attenuation(self, lobe: ClusterLobe, taps: LightTaps) -> Float:
        """f·cos of the fibre layer over D, at a cluster's mean frame; see `scattering.fibre`."""
        depth = self._tables.optical_depth
        towards = dr.dot(taps.facing, lobe.normal)
        cos_light = maximum(dr.select(taps.transmits, -towards, towards), MIN_COSINE)
        cos_view = maximum(dr.dot(self.view, lobe.normal), MIN_COSINE)
        slope_light = projected_area(taps.facing, lobe.tangent, lobe.roughness) * dr.rcp(cos_light)
        slope_view = projected_area(self.view, lobe.tangent, lobe.roughness) * dr.rcp(cos_view)
        both = slope_light + slope_view
        reflected = (1 - dr.exp(-depth * both)) * dr.rcp(both)
        apart = maximum(depth * abs(slope_light - slope_view), MIN_DEPTH)
        passed = dr.exp(-depth * minimum(slope_light, slope_view))
        transmitted = depth * passed * (1 - dr.exp(-apart)) * dr.rcp(apart)
        return 0.25 * dr.select(taps.transmits, transmitted, reflected) * dr.rcp(cos_view)


class DeviceTables:
    """The tables of a fabric on one backend.

    Attributes:
        sums: summed-area tables.
        size: of the repeat, millimetres, Float each.
        texels: the texel model.
        clusters, rank, face_texels: counts.
        diffuse_blend, optical_depth: of the fabric.
    """

    def __init__(
        self,
        tables: ClusterTables,
        size: tuple[float, float],
        top: float,
        finest: float,
        diffuse_blend: float,
        optical_depth: float,
        types: ArrayTypes,
    ) -> None:
        self.types = types
        self.clusters, self.rank = tables.clusters, tables.rank
        columns, rows = tables.counts
        self.face_texels = dr.opaque(types.UInt32, columns * rows)
        self.sums = FootprintSums(tables.labels, tables.coefficients, tables.clusters, size, types)
        self.labels = upload(types.UInt32, tables.labels)
        self.coefficients = upload(types.Float, tables.coefficients)
        self.basis = upload(types.Float, tables.basis)
        self.moments = upload(types.Float, tables.moments)
        self.light = upload(types.Float, tables.light)
        self.view = upload(types.Float, tables.view)
        self.offset = upload(types.Float, tables.offset)
        self.trust = upload(types.Float, tables.trust)
        self.texel_trust = upload(types.Float, tables.texel_trust)
        self.size = tuple(dr.opaque(types.Float, extent) for extent in size)
        self.texels = TexelModel(tables, size, top, finest, diffuse_blend, optical_depth, types)
        self.diffuse_blend = diffuse_blend
        self.optical_depth = optical_depth

    def seen_from(self, view: Vec3, back: Mask, trusted: bool = False) -> ViewedBase:
        """The base as a view in the frame of a face sees it; `trusted` scales it by `ClusterTables.trust`."""
        return ViewedBase(self, view, back, trusted)
