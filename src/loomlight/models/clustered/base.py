"""The surface of texels, and its base, whose sum over footprints is known (zhu2024 eq. 8 to 11).

On the texel p of cluster c, with light i, view o and half vector h, at albedo 1, cosine included, the surface
has

    specular   V(p, i) A_c(i, o) D(p, h)
    diffuse    V(p, i) ((1 − w) |i_z| + w ⟨n_p·i⟩) / π
    lit        V(p, i)

V is the texel's lobe of visibility, D its fibre density, A_c the attenuation of the fibre layer at the mean
normal and fibre direction of the cluster (eq. 9 and 10). The base has v̄_c(i), the mean of V over the
cluster, in the place of V, and n_p·i of either sign; its sums over footprints are those of summed-area
tables. In holes both are 0.
Light from the other side has the same form, with the visibility of the other face.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr

from loomlight.core.arrays import Array, Float, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, maximum, minimum
from loomlight.core.footprint import Footprint
from loomlight.models.clustered.footprint_sums import FootprintBox, FootprintSums
from loomlight.models.clustered.gaussians import LOBE_NUMBERS, lobe_value
from loomlight.models.clustered.parallax import PARALLAX_BINS, parallax_offset
from loomlight.models.clustered.square_map import BINS, BinTaps, bin_taps
from loomlight.models.clustered.tables import NORMAL_UNIT, NUMBERS, TEXEL_NUMBERS, THREAD_BASE, ClusterTables
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


@dataclass
class TexelTerms:
    """A texel for one light.

    Attributes:
        own: of the surface.
        known: of the base.
        thread: index of the thread that shows.
    """

    own: Components
    known: Components
    thread: UInt


class ViewedBase:
    """Surface and base as one view sees them.

    Attributes:
        view: in the frame of the face that is seen [3].
        back: which face that is.
    """

    def __init__(self, tables: DeviceTables, view: Vec3, back: Mask) -> None:
        types = tables.types
        self._tables = tables
        self.view, self.back = view, back
        self._face = dr.select(back, types.UInt32(1), types.UInt32(0))

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
        first = dr.gather(types.Vector4, tables.arrays.moments, entry)
        second = dr.gather(types.Vector4, tables.arrays.moments, entry + 1)
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
            lit = taps.around.read(
                types.Vector4, tables.arrays.light, taps.first, packets, types.UInt32(packet)
            )
            density: Any = types.Vector4(0)
            for number in range(1 + tables.rank):
                entry = types.UInt32(number * packets + packet)
                density += means[number * packets + packet] * taps.half.read(
                    types.Vector4, tables.arrays.basis, half_first, packets * (1 + tables.rank), entry
                )
            normal = [means[(1 + tables.rank + axis) * packets + packet] for axis in range(3)]
            for lane in range(4):
                cluster = 4 * packet + lane
                family = 0 if cluster < tables.clusters // 2 else 1
                attenuation = self._attenuation(self.lobe(types.UInt32(cluster)), taps)
                share = means[packet][lane]
                cosine = self._cosine(taps, types.Vector3(*(part[lane] for part in normal)))
                total[family] += lit[lane] * self._diffuse(taps, share, cosine)
                total[2 + family] += lit[lane] * attenuation * density[lane]
                total[4] += share * lit[lane]
        return Components(*total)

    def shown_over(self, means: list[Array]) -> tuple[Float, Float]:
        """Shares of the texels of footprints that show warp and weft.

        Args:
            means: from `FootprintSums.means`.
        """
        packets = self._tables.clusters // 4
        shown = [self._tables.types.Float(0), self._tables.types.Float(0)]
        for cluster in range(self._tables.clusters):
            packet, lane = divmod(cluster, 4)
            shown[cluster // (2 * packets)] += means[packet][lane]
        return shown[0], shown[1]

    def at_texel(self, texel: UInt, taps: LightTaps) -> TexelTerms:
        """Surface and base of one texel of the repeat, row by row."""
        types, tables = self._tables.types, self._tables
        place = self._face * tables.face_texels + texel
        label = dr.gather(types.UInt32, tables.arrays.labels, place)
        met = label < tables.clusters
        label = minimum(label, types.UInt32(tables.clusters - 1))
        clusters = tables.clusters
        lit = taps.around.read(types.Float, tables.arrays.light, taps.first, clusters, label)
        numbers = range(tables.rank + 3)
        coefficients = [
            dr.gather(types.Float, tables.arrays.coefficients, place * len(numbers) + number)
            for number in numbers
        ]
        density: Any = types.Float(0)
        for number in range(1 + tables.rank):
            part = taps.half.read(
                types.Float,
                tables.arrays.basis,
                self._face * BINS**2,
                clusters * (1 + tables.rank),
                number * clusters + label,
            )
            if number:
                part *= coefficients[number - 1]
            density += part
        # Light from the other side meets the texel's other face.
        there = dr.select(self.back ^ taps.transmits, tables.face_texels, 0) + texel
        raised = types.Vector3(taps.facing.x, taps.facing.y, abs(taps.facing.z))
        visible = dr.select(met, lobe_value(self._visibility(there), raised), 0)
        cosine = self._cosine(taps, types.Vector3(*coefficients[-3:]))
        attenuated = self._attenuation(self.lobe(label), taps) * density
        is_warp = label < clusters // 2
        lit = dr.select(met, lit, 0)

        def components(diffuse: Float, specular: Float, light_visibility: Float) -> Components:
            return Components(
                dr.select(is_warp, diffuse, 0),
                dr.select(is_warp, 0, diffuse),
                dr.select(is_warp, specular, 0),
                dr.select(is_warp, 0, specular),
                light_visibility,
            )

        return TexelTerms(
            own=components(
                visible * self._diffuse(taps, types.Float(1), maximum(cosine, 0)),
                visible * attenuated,
                visible,
            ),
            known=components(lit * self._diffuse(taps, types.Float(1), cosine), lit * attenuated, lit),
            thread=self._thread(place),
        )

    def _thread(self, place: UInt) -> UInt:
        """The thread that a texel shows, both faces counted."""
        types, first = self._tables.types, place * TEXEL_NUMBERS + LOBE_NUMBERS
        below, above = (dr.gather(types.Float, self._tables.arrays.texels, first + part) for part in (0, 1))
        return types.UInt32(below) + THREAD_BASE * types.UInt32(above)

    def _visibility(self, place: UInt) -> tuple[Vec3, Vec3, Vec3]:
        """The lobe of a texel, both faces counted."""
        types = self._tables.types
        entry = place * (TEXEL_NUMBERS // 4)
        a, b, c = (
            dr.gather(types.Vector4, self._tables.arrays.texels, entry + number) for number in range(3)
        )
        return types.Vector3(a.x, a.y, a.z), types.Vector3(a.w, b.x, b.y), types.Vector3(b.z, b.w, c.x)

    def _cosine(self, taps: LightTaps, normal: Vec3) -> Float:
        """Cosine of a light with a normal of coefficients, or with its other side."""
        cosine = dr.dot(normal, taps.facing) * NORMAL_UNIT
        return dr.select(taps.transmits, -cosine, cosine)

    def _diffuse(self, taps: LightTaps, share: Float, cosine: Float) -> Float:
        """The diffuse term of a share of the texels that light reaches all; the cosine is summed over it."""
        blend = self._tables.diffuse_blend
        return dr.inv_pi * ((1 - blend) * abs(taps.facing.z) * share + blend * cosine)

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
        arrays: the tables that `ClusterTables` declares for devices, by name.
        sums: summed-area tables.
        size: of the repeat, millimetres, Float each.
        clusters, rank, face_texels: counts.
        diffuse_blend, optical_depth: of the fabric.
    """

    def __init__(
        self,
        tables: ClusterTables,
        size: tuple[float, float],
        diffuse_blend: float,
        optical_depth: float,
        types: ArrayTypes,
    ) -> None:
        self.types = types
        self.clusters, self.rank = tables.clusters, tables.rank
        self.face_texels = dr.opaque(types.UInt32, tables.columns * tables.rows)
        self.arrays = tables.upload(types)
        self.sums = FootprintSums(self.arrays.sums, tables.columns, tables.rows, tables.channels, size, types)
        self.size = tuple(dr.opaque(types.Float, extent) for extent in size)
        self.diffuse_blend = diffuse_blend
        self.optical_depth = optical_depth

    def box(self, footprint: Footprint, view: Vec3, back: Mask, place: Float) -> FootprintBox:
        """The box of a footprint, whose texels are shifted by the mean parallax offset over it.

        Args:
            view: in the frame of the face that is seen [3].
            place: on the segment that the box is swept along, −1/2 to 1/2.
        """
        types = self.types
        below = self.sums.box(footprint, types.Vector2(0), place)
        first = dr.select(back, types.UInt32(PARALLAX_BINS**2), types.UInt32(0))
        offset = parallax_offset(view, self.arrays.heights, first, self.sums.parallax(below, back))
        return self.sums.box(footprint, offset, place)

    def seen_from(self, view: Vec3, back: Mask) -> ViewedBase:
        """Surface and base as a view in the frame of a face sees them."""
        return ViewedBase(self, view, back)
