"""Base plus residual over footprints (zhu2024 eq. 8): unbiased for the surface of texels, from a few of them.

With f the surface, b the base, and the texel y uniform in the footprint's box,

    mean of f over the box = mean of b over the box + E[f(y) − b(y)]

where the first mean is exact. Colours of threads are the texels' own: value = shade(base, ᾱ) + mean of
(value(y) − shade(b(y), ᾱ)) for any albedos ᾱ.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any, final

import drjit as dr

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.arrays import Array, Color3, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types, channel_mean, clip, maximum, minimum
from loomlight.core.footprint import Footprint
from loomlight.models.between_yarns import Bounced
from loomlight.models.clustered.footprint_sums import FootprintBox, FootprintSums
from loomlight.models.clustered.gaussians import LOBE_NUMBERS, lobe_value
from loomlight.models.clustered.parallax import PARALLAX_BINS, parallax_offset
from loomlight.models.clustered.square_map import BINS, BinTaps, bin_taps
from loomlight.models.clustered.tables import NORMAL_UNIT, NUMBERS, TEXEL_NUMBERS, THREAD_BASE, ClusterTables
from loomlight.models.random_numbers import uniform
from loomlight.models.separable import Components, Evaluation, FamilyAlbedos, FilteredBsdf, shade
from loomlight.scattering.appearance import ALBEDO_NAMES, Sheen
from loomlight.scattering.directions import cosine_about
from loomlight.scattering.fibre import layer_albedo_estimate, pdf_specular, projected_area, sample_specular
from loomlight.scattering.irregularity import IrregularYarns
from loomlight.scattering.point import (
    Albedos,
    DirectionSample,
    Tint,
    YarnScattering,
    colours_of,
    to_face_frame,
    towards_grazing,
)
from loomlight.scattering.sheen import sample_sheen, sheen_pdf, sheen_transmittance

# ------------------------------------------------------------------------------------------------------- base
# The surface of texels, and its base, whose sum over footprints is known (zhu2024 eq. 8 to 11).
#
# On the texel p of cluster c, with light i, view o and half vector h, at albedo 1, cosine included, the
# surface has
#
#     specular   V(p, i) A_c(i, o) D(p, h)
#     diffuse    V(p, i) ((1 − w) |i_z| + w ⟨n_p·i⟩) / π
#     lit        V(p, i)
#
# V is the texel's lobe of visibility, D its fibre density, A_c the attenuation of the fibre layer at the mean
# normal and fibre direction of the cluster (eq. 9 and 10). The base has v̄_c(i), the mean of V over the
# cluster, in the place of V, and n_p·i of either sign; its sums over footprints are those of summed-area
# tables. In holes both are 0. Light from the other side has the same form, with the visibility of the other
# face.


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


# --------------------------------------------------------------------------------------------------- sampling
# Importance sampling by lobes (zhu2024 5.1): clusters' fibre lobes, diffuse lobes, sheen, and straight on.
#
# Densities come from the tables alone, never from the residual's random points, so they are those of the
# sampled directions exactly. A cluster's lobe has its mean fibre direction, and a roughness that its spread
# of fibre directions widens. Diffuse lobes are cosines about the macro normal.


# Weight of diffuse reflection beside the albedos, so that black cloth has a lobe as well.
_MIN = 1e-3
# What passes straight on is drawn at most so often: a hole may be estimated to be 1 where light is scattered.
_MAX_NULL = 0.95


@dataclass
class LobeProbabilities:
    """Probabilities of lobes; all add up to 1.

    Attributes:
        clusters: of each cluster's fibre lobe.
        reflect, transmit: of the diffuse lobes.
        sheen: of the sheen.
        null: of passing straight on.
    """

    clusters: list[Float]
    reflect: Float
    transmit: Float
    sheen: Float
    null: Float


class LobeSampler:
    """Draws directions for one view of footprints, in the frame of the face that is seen."""

    def __init__(
        self,
        tables: DeviceTables,
        base: ViewedBase,
        means: list[Array],
        albedos: FamilyAlbedos,
        sheen: Sheen,
        hole: Float,
    ) -> None:
        types = array_types(base.view.x)
        self._base, self._sheen = base, sheen
        self._lobes = [base.lobe(types.UInt32(cluster)) for cluster in range(tables.clusters)]
        families = (albedos.warp, albedos.weft)
        specular: list[Float] = []
        reflect, transmit = types.Float(_MIN), types.Float(0)
        for cluster, lobe in enumerate(self._lobes):
            family = families[0 if cluster < tables.clusters // 2 else 1]
            share = maximum(means[cluster // 4][cluster % 4], 0)
            turned, through = layer_albedo_estimate(
                base.view, lobe.normal, lobe.tangent, lobe.roughness, types.Float(tables.optical_depth)
            )
            specular.append(
                share
                * (
                    channel_mean(family.specular_reflect) * turned
                    + channel_mean(family.specular_transmit) * through
                )
            )
            reflect += share * channel_mean(family.diffuse_reflect)
            transmit += share * channel_mean(family.diffuse_transmit)
        scattered = reflect + transmit
        for part in specular:
            scattered += part
        from_sheen = types.Float(0)
        if sheen.strength > 0:
            transmittance = sheen_transmittance(base.view, sheen.strength, sheen.roughness)
            from_sheen = (1 - transmittance) * dr.rcp(maximum(transmittance, 1e-3)) * maximum(scattered, 0.1)
        null = minimum(hole, _MAX_NULL)
        scale = (1 - null) * dr.rcp(scattered + from_sheen)
        self.probabilities = LobeProbabilities(
            [part * scale for part in specular], reflect * scale, transmit * scale, from_sheen * scale, null
        )

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` but for passing straight on, 1/sr."""
        of = self.probabilities
        density = dr.inv_pi * dr.select(light.z > 0, of.reflect, of.transmit) * abs(light.z)
        for probability, lobe in zip(of.clusters, self._lobes, strict=True):
            density += probability * pdf_specular(light, self._base.view, lobe.tangent, lobe.wide)
        if self._sheen.strength > 0:
            density += of.sheen * sheen_pdf(light, self._base.view, self._sheen.roughness)
        return density

    def sample(self, choice: Float, u: Vec2) -> tuple[Vec3, Mask]:
        """A direction, and whether it goes straight on."""
        types = array_types(choice)
        of, view = self.probabilities, self._base.view
        bound = types.Float(of.null)
        is_null = choice < bound
        tangent, wide = types.Vector3(1, 0, 0), types.Float(1)
        is_specular = types.Bool(False)
        for probability, lobe in zip(of.clusters, self._lobes, strict=True):
            chosen = (choice >= bound) & (choice < bound + probability)
            bound = bound + probability
            tangent = dr.select(chosen, lobe.tangent, tangent)
            wide = dr.select(chosen, lobe.wide, wide)
            is_specular |= chosen
        light = cosine_about(types.Vector3(0, 0, 1), u)
        light = dr.select((choice >= bound) & (choice < bound + of.transmit), -light, light)
        light = dr.select(is_specular, sample_specular(view, tangent, wide, u), light)
        if self._sheen.strength > 0:
            from_sheen = (choice >= bound + of.transmit) & (choice < bound + of.transmit + of.sheen)
            light = dr.select(from_sheen, sample_sheen(view, self._sheen.roughness, u), light)
        return dr.select(is_null, -view, light), is_null


# ------------------------------------------------------------------------------------------------------- bsdf


# Between seeds of points: odd, so that no two are the same.
POINT_SEED_STEP = 0x632BE5AB


@dataclass
class Estimate:
    """An estimate for one light.

    Attributes:
        components: base and residual.
        colour: f·cos of sampled texels with their own albedos, 1/sr; of either sign.
        rest: components that mean albedos multiply, so that the value is `colour` plus their colour.
    """

    components: Components
    colour: Color3
    rest: Components


@final
class ClusteredBsdf(FilteredBsdf):
    """Base and residual of footprints for one view each."""

    def __init__(
        self,
        tables: DeviceTables,
        model: YarnScattering,
        means: FootprintAlbedos,
        irregular: IrregularYarns,
        samples: int,
        controlled: bool,
        seed: UInt,
        view: Vec3,
        footprint: Footprint,
        tint: Tint | None,
        active: Mask,
    ) -> None:
        """
        Args:
            samples: texels of the residual; 0 leaves it out.
            controlled: False leaves out the base and estimates everything from the texels.
            seed: a random number a lane.
        """
        super().__init__(means, irregular, model.appearance, view, footprint, tint)
        self._tables, self._model, self._samples, self._seed = tables, model, samples, seed
        self._controlled = controlled
        self._active = active
        seen = to_face_frame(view, self._back)
        self._base = tables.seen_from(seen, self._back)
        self._box = tables.box(footprint, seen, self._back, uniform(seed, 0) - 0.5)

    @cached_property
    def _cluster_means(self) -> list[Any]:
        return self._tables.sums.means(self._box, self._back)

    @cached_property
    def _texels(self) -> list[UInt]:
        """Texels of the residual: uniform in the box and independent.

        Points of a lattice would be more even, but fall on like places of satins, whose floats form lattices
        too.
        """
        found = []
        for number in range(self._samples):
            seed = self._seed + array_types(self.view.x).UInt32(number) * POINT_SEED_STEP
            found.append(self._tables.sums.texel(self._box, uniform(seed, 1), uniform(seed, 2)))
        return found

    @cached_property
    def hole(self) -> Float:
        """Share of the texels that are holes, 0 to 1: no estimate."""
        return self.irregular_hole(self._even_hole)

    @cached_property
    def _even_hole(self) -> Float:
        warp, weft = self._base.shown_over(self._cluster_means)
        return clip(1 - warp - weft, 0, 1)

    def bounced(self, evaluation: Evaluation) -> Bounced | None:
        """Albedos of light between yarns by the families' shares of the texels: no estimate."""
        del evaluation
        return None if self.between is None else self.between.of_shares(*self.shown)

    @property
    def shown(self) -> tuple[Float, Float]:
        """Shares of warp and of weft in what the view shows: no estimate."""
        warp, weft = self._base.shown_over(self._cluster_means)
        if self.yarns is not None:
            warp, weft = warp * self.yarns.shares[0], weft * self.yarns.shares[1]
        return warp, weft

    def evaluate(self, light: Vec3, active: Mask = True) -> Evaluation:
        """Base and residual of the components: unbiased estimates, of either sign."""
        del active
        return self._evaluation(self._estimate(light).components)

    def _evaluation(self, components: Components) -> Evaluation:
        """The components of even yarns as those of the footprint show them, and the hole."""
        return self.irregular_evaluation(Evaluation(components, self._even_hole))

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """f·cos with the texels' own albedos, 1/sr: an unbiased estimate, of either sign."""
        return self.value_and_null_transmission(light, active)[0]

    def value_and_null_transmission(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both."""
        del active
        found = self._estimate(light)
        through = light.z * self.view.z < 0
        # Of families whose threads are alike, mean albedos are the threads' own, and carry derivatives.
        warp, weft = self._alike
        own, rest = found.components, found.rest
        known = Components(
            own.diffuse_warp if warp else rest.diffuse_warp,
            own.diffuse_weft if weft else rest.diffuse_weft,
            own.specular_warp if warp else rest.specular_warp,
            own.specular_weft if weft else rest.specular_weft,
            own.light_visibility,
        )
        evaluation = self._evaluation(own)
        known = self._evaluation(known).components
        body = found.colour + shade(known, self.albedos_towards(light), through)
        body += self.bounced_value(evaluation, light)
        return self.under_sheen(body, evaluation, light), self.null_transmission

    def _estimate(self, light: Vec3) -> Estimate:
        """Base and residual for one light."""
        types = array_types(self.view.x)
        taps = self._base.light_taps(to_face_frame(light, self._back))
        nothing = Components(*(types.Float(0) for _ in fields(Components)))
        base = self._base.over(self._cluster_means, taps) if self._controlled else nothing
        total = Estimate(base, types.Color3(0), base)
        for texel in self._texels:
            terms = self._base.at_texel(texel, taps)
            known = terms.known if self._controlled else nothing
            share = 1 / self._samples
            total.rest = _combined(total.rest, known, -share)
            total.components = _combined(_combined(total.components, terms.own, share), known, -share)
            total.colour += self._colour(terms, taps.transmits, light) * share
        return total

    @cached_property
    def _alike(self) -> tuple[bool, bool]:
        """Whether all texels of warp and of weft have the albedos of their family."""
        warp, weft = self._model.parameters(array_types(self.view.x))
        return warp.alike, weft.alike

    def _colour(self, terms: TexelTerms, transmits: Mask, light: Vec3) -> Color3:
        """f·cos of a texel of a family whose threads differ, with the albedos of its thread."""
        types = array_types(self.view.x)
        total = types.Color3(0)
        found = terms.own
        parts = (
            (found.diffuse_warp, found.specular_warp),
            (found.diffuse_weft, found.specular_weft),
        )
        families = self._model.parameters(types)
        shares = (1, 1) if self.yarns is None else self.yarns.shares[:2]
        tints = colours_of(self._tint)
        for alike, family, share, tint, (diffuse, specular) in zip(
            self._alike, families, shares, tints, parts, strict=True
        ):
            if alike:
                continue
            # The number of a thread of the other family may be larger.
            thread = minimum(terms.thread, types.UInt32(family.threads - 1))
            own = Albedos(*(family.albedo(number, thread) for number in range(len(ALBEDO_NAMES))))
            shown = self.irregular_albedos(FamilyAlbedos(own, own))
            own = shown.warp if family is families[0] else shown.weft
            own = towards_grazing(own, self.grazing, light, self.view)
            of_diffuse = dr.select(transmits, own.diffuse_transmit, own.diffuse_reflect)
            of_specular = dr.select(transmits, own.specular_transmit, own.specular_reflect)
            of_diffuse = of_diffuse if tint is None else of_diffuse * tint
            total += (of_diffuse * diffuse + of_specular * specular) * share
        return total

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""
        return self._sampler.pdf(to_face_frame(light, self._back))

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A light direction by one of the lobes, or straight through holes."""
        facing, is_null = self._sampler.sample(choice, u)
        light = to_face_frame(facing, self._back)
        pdf = dr.select(is_null, self._sampler.probabilities.null, self._sampler.pdf(facing))
        value = dr.select(is_null, self.null_transmission, self.value(light, ~is_null & self._active))
        weight = dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0)
        return DirectionSample(light=light, pdf=pdf, weight=weight, is_null=is_null)

    @cached_property
    def _sampler(self) -> LobeSampler:
        return LobeSampler(
            self._tables, self._base, self._cluster_means, self.albedos_in_mirror, self.sheen, self.hole
        )


def _combined(first: Components, second: Components, scale: float) -> Components:
    """first + scale·second."""
    return Components(
        *(dr.fma(getattr(second, part.name), scale, getattr(first, part.name)) for part in fields(Components))
    )
