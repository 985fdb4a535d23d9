"""The point model: what one yarn point, found along the exact view ray, does to light (zhu2024 eq. 3–4).

It composes the geometry (which yarn point a ray meets, what hides the light from it) with the lobes:
fibre-SGGX reflection and transmission, blended diffuse reflection and transmission, sheen on top, and delta
transmission through holes. It is the reference that every multi-scale model is judged by.

Everything is computed in the frame of the face that is seen: from behind, z of both directions is
negated and the geometry mirrored (`core/footprint.py`).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np

from loomlight.core.arrays import Color3, Float, Int, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types, channel_mean, masked_branch, maximum, opaque
from loomlight.scattering.appearance import ALBEDO_NAMES, Appearance, FamilyAppearance
from loomlight.scattering.detail import DetailNumbers, detail_gain, diffuse_gain, fibre_cell, turned_frame
from loomlight.scattering.diffuse import diffuse_pdf, diffuse_reflection, diffuse_transmission, sample_diffuse
from loomlight.scattering.fibre import (
    layer_albedo_estimate,
    mean_layer_shares,
    pdf_specular,
    reflection,
    sample_specular,
    transmission,
)
from loomlight.scattering.grazing import Grazing
from loomlight.scattering.hairs import Hair, Hairs, under_hair
from loomlight.scattering.interreflection import Interreflection, Scattered, beneath, bounced, scattered
from loomlight.scattering.irregularity import IrregularYarns
from loomlight.scattering.sheen import sample_sheen, sheen_pdf, sheen_transmittance, sheen_with_transmittance
from loomlight.scattering.variation import FIBRES_ACROSS, vary_albedos
from loomlight.yarn.flanks import Sheet, SurfacePoint
from loomlight.yarn.rays import DEFAULT_QUALITY, SearchQuality, Surface, extent_of
from loomlight.yarn.visibility import first_hit, unoccluded


@dataclass
class Albedos:
    """The four albedos of a point, Color3 each."""

    diffuse_reflect: Color3
    diffuse_transmit: Color3
    specular_reflect: Color3
    specular_transmit: Color3


@dataclass
class YarnPoint:
    """A yarn point as a view ray meets it, in the frame of the face that is seen.

    Attributes:
        back: the face behind is seen.
        hole: the ray passes through; only sheen and delta transmission are left.
        x, y, height: where, millimetres.
        plane: height of the plane that its yarn lies in, millimetres.
        normal, tangent: of the yarn and its fibres [3], turned by detail.
        is_warp: the family.
        roughness: α.
        albedos: of its thread; None where they are not asked for.
        surface_normal: of the yarn's surface [3], which hides light; None is `normal`.
        diffuse_gain: what turned normals gain (`detail.diffuse_gain`); None is 1.
        hairs: those over it, and the share of the footprint that one covers; None without.
        bounced: albedos of light between yarns and layers, reflected and transmitted, Color3 each; None
            without.
    """

    back: Mask
    hole: Mask
    x: Float
    y: Float
    height: Float
    plane: Float
    normal: Vec3
    tangent: Vec3
    is_warp: Mask
    roughness: Float
    albedos: Any
    surface_normal: Any = None
    diffuse_gain: Any = None
    hairs: Any = None
    bounced: Any = None

    def diffuse(self, value: Float) -> Float:
        """The diffuse term at this point, of its value for smooth yarn."""
        return value if self.diffuse_gain is None else value * self.diffuse_gain

    def under_hairs(self, light: Vec3) -> Float:
        """Share of light from a direction [3], in the frame of the face, that hairs let by."""
        if self.hairs is None:
            return array_types(self.x).Float(1)
        hairs, cover = self.hairs
        return dr.lerp(hairs.lit(light), 1, cover)


@dataclass
class DirectionSample:
    """A sampled light direction.

    Attributes:
        light: unit direction [3].
        pdf: density per solid angle, or the probability of passing straight through.
        weight: evaluate / pdf, Color3.
        is_null: the direction goes straight through a hole (delta).
    """

    light: Vec3
    pdf: Float
    weight: Color3
    is_null: Mask


@dataclass
class ShadowQuery:
    """The visibility query of a yarn point and a light, in the frame of the face that the light falls on.

    Attributes:
        height: of the point, millimetres.
        direction: unit vector [3] to the light.
        back: which face that is.
        searched: whether a search is needed; False where the yarn shadows itself, and in holes.
    """

    height: Float
    direction: Vec3
    back: Mask
    searched: Mask


def shadow_query(surface: Surface, point: YarnPoint, light: Vec3) -> ShadowQuery:
    """The visibility query of a yarn point and a light, unit vector [3].

    Light from the other side falls on the yarn's other surface, so the geometry of that face occludes it.
    """
    types = array_types(point.x)
    facing = to_face_frame(light, point.back)
    beyond = facing.z < 0
    # Visibility is a Mask, so no derivatives are needed.
    surface_normal = point.normal if point.surface_normal is None else point.surface_normal
    own: tuple[Vec3, Float] = dr.detach((surface_normal, types.Float(point.height)))

    def turned(_: tuple[Vec3, Float]) -> tuple[Vec3, Float]:
        far = surface.surface(point.x, point.y, ~point.back)
        return dr.detach((far.normal, far.height))

    normal, height = masked_branch(beyond, own, turned, "cloth: other side")
    direction = types.Vector3(facing.x, facing.y, abs(facing.z))
    # The yarn itself occludes lights below its tangent plane.
    searched = ~point.hole & (dr.dot(normal, direction) > 0)
    return ShadowQuery(height, direction, point.back ^ beyond, searched)


@dataclass
class Tint:
    """What diffuse albedos of both families are multiplied with, 0 to 1, as prints do."""

    warp: Color3
    weft: Color3

    @classmethod
    def of(cls, colour: Color3) -> Tint:
        """The same for both."""
        return cls(colour, colour)


def towards_grazing(albedos: Albedos, grazing: Grazing, light: Vec3, view: Vec3) -> Albedos:
    """Albedos as they count for unit vectors [3] of light and view, in the frame of the cloth."""
    if grazing.gain <= 0:
        return albedos
    kept = grazing.kept(light, view)
    return Albedos(
        albedos.diffuse_reflect * kept,
        albedos.diffuse_transmit * kept,
        albedos.specular_reflect + grazing.rise(light, view),
        albedos.specular_transmit,
    )


def tinted(albedos: Albedos, colour: Color3 | None) -> Albedos:
    """Albedos whose diffuse terms are multiplied with a colour; None leaves them."""
    if colour is None:
        return albedos
    return Albedos(
        albedos.diffuse_reflect * colour,
        albedos.diffuse_transmit * colour,
        albedos.specular_reflect,
        albedos.specular_transmit,
    )


def colours_of(tint: Tint | None) -> tuple[Color3 | None, Color3 | None]:
    """The colour of warp and of weft; None for each without a tint."""
    return (None, None) if tint is None else (tint.warp, tint.weft)


def to_face_frame(direction: Vec3, back: Mask) -> Vec3:
    """A direction in the frame of a face: z is negated for the back. It is its own inverse."""
    z = dr.select(back, -direction.z, direction.z)
    return type(direction)(direction.x, direction.y, z)


# ---------------------------------------------------------------------------------- one family on one backend
# One family's scattering parameters on one backend.


class FamilyParameters:
    """One family's scattering parameters on one backend: scalars where threads are alike, else a table."""

    def __init__(self, family: FamilyAppearance, types: ArrayTypes) -> None:
        rows = np.stack([np.asarray(getattr(family, name), np.float64) for name in ALBEDO_NAMES], axis=1)
        self.roughness = dr.opaque(types.Float, float(family.roughness))
        self.threads = rows.shape[0]
        self._mean = [types.Color3(*row) for row in opaque(types.Float, rows.mean(axis=0))]
        self.alike = bool(np.allclose(rows, rows[:1], rtol=0, atol=1e-12))
        self.shared = [types.Color3(*row) for row in opaque(types.Float, rows[0])]
        padded = np.zeros((self.threads, 4, 4))
        padded[:, :, :3] = rows
        self.table = None if self.alike else types.Float(padded.ravel())
        self._types = types

    def albedo(self, number: int, thread: UInt) -> Color3:
        """Albedo `number` (in the order of `ALBEDO_NAMES`) of a thread, Color3."""
        if self.table is None:
            return self.shared[number]
        row = dr.gather(self._types.Vector4, self.table, thread * 4 + number)
        return self._types.Color3(row.x, row.y, row.z)

    def follow_table(self) -> None:
        """Takes the means of the table anew, after an edit of it."""
        if self.table is not None:
            rows = self.table.numpy().reshape(self.threads, 4, 4)[:, :, :3].astype(np.float64).mean(axis=0)
            self._mean = [self._types.Color3(*row) for row in opaque(self._types.Float, rows)]

    def mean(self) -> list[Color3]:
        """Mean albedos over the threads, in the order of `ALBEDO_NAMES`."""
        return self.shared if self.table is None else self._mean


# -------------------------------------------------------------------------------------------- the point model


class YarnScattering:
    """Scattering at single points of the yarns of one fabric: geometry, appearance and the search of rays.

    Attributes:
        surface: the geometry, analytic or textures.
        appearance: what scatters.
        quality: how finely rays are searched.
        sheen: strength and roughness, numbers or Dr.Jit scalars; None without sheen.
        grazing: how highlights rise.
        irregular: how yarns vary along themselves; None shows even ones, as tables of models do.
    """

    def __init__(
        self,
        surface: Surface,
        appearance: Appearance,
        quality: SearchQuality = DEFAULT_QUALITY,
        irregular: IrregularYarns | None = None,
    ) -> None:
        self.surface = surface
        self.appearance = appearance
        self.quality = quality
        self.irregular = irregular if irregular is not None and irregular.is_on else None
        self.grazing = appearance.grazing
        sheen = appearance.sheen
        # None without sheen, so that it costs nothing then.
        self.sheen: tuple[Float, Float] | None = (
            (sheen.strength, sheen.roughness) if sheen.strength > 0 else None
        )
        self._uploaded: dict[type, tuple[FamilyParameters, FamilyParameters]] = {}
        self._detail: dict[type, DetailNumbers] = {}
        self._between: dict[type, Interreflection] = {}

    def parameters(self, types: ArrayTypes) -> tuple[FamilyParameters, FamilyParameters]:
        """Parameters of (warp, weft) on one backend."""
        if types.Float not in self._uploaded:
            self._uploaded[types.Float] = (
                FamilyParameters(self.appearance.warp, types),
                FamilyParameters(self.appearance.weft, types),
            )
            self.between_yarns(types)
            if self.varies or self.has_detail or self.irregular is not None:
                self.detail(types)
        return self._uploaded[types.Float]

    @property
    def has_detail(self) -> bool:
        """Whether yarns show plies, fibres, slubs or hairs close up."""
        return self.appearance.warp.detail.is_on or self.appearance.weft.detail.is_on

    def detail(self, types: ArrayTypes) -> DetailNumbers:
        """Numbers of the yarns' detail on one backend."""
        if types.Float not in self._detail:
            self._detail[types.Float] = DetailNumbers(
                self.appearance, self.fibre_size, self.surface.size, types
            )
        return self._detail[types.Float]

    @property
    def fibre_size(self) -> float:
        """Width of a fibre, millimetres."""
        return min(self.surface.finest) / FIBRES_ACROSS

    def between_yarns(self, types: ArrayTypes) -> Interreflection | None:
        """Light between yarns on one backend; None without."""
        if self.appearance.openness is None:
            return None
        if types.Float not in self._between:
            self._between[types.Float] = Interreflection(self.appearance, types)
        return self._between[types.Float]

    def locate(
        self,
        x: Float,
        y: Float,
        view: Vec3,
        active: Mask = True,
        size: Float | None = None,
        tint: Tint | None = None,
    ) -> YarnPoint:
        """The yarn point that the view ray through x, y on the plane z = 0 meets.

        Args:
            x, y: draft coordinates, millimetres.
            view: unit vector [3] towards the eye; z < 0 sees the back.
            size, tint: see `at`.
        """
        types = array_types(x)
        back = types.Bool(view.z < 0)
        seen = to_face_frame(view, back)
        hit = first_hit(self.surface, x, y, seen, back, active, self.quality)
        return self.at(hit.x, hit.y, back, hit.hole, size, tint, (seen, hit.height))

    def at(
        self,
        x: Float,
        y: Float,
        back: Mask,
        hole: Mask,
        size: Float | None = None,
        tint: Tint | None = None,
        ray: tuple[Vec3, Float] | None = None,
    ) -> YarnPoint:
        """The yarn point at draft coordinates x, y (millimetres) of one face, without parallax.

        Args:
            size: side of the footprint, millimetres, that the yarns' detail is filtered with; None shows
                smooth yarns.
            tint: what diffuse albedos of the cloth are multiplied with; None for 1.
        """
        # Find the yarn, or the hair that lies over it.
        types = array_types(x)
        point = self.surface.surface(x, y, back, ray)
        warp, weft = self.parameters(types)
        hairs = self.hairs(point, back, size)
        hair = None if hairs is None else hairs.seen(types.Vector3(0, 0, 1) if ray is None else ray[0])
        is_warp = point.is_warp if hair is None else hair.family(point.is_warp)
        # Gather its albedos, varied from fibre to fibre and thread to thread.
        of_warp, of_weft = (
            [family.albedo(number, thread) for number in range(len(ALBEDO_NAMES))]
            for family, thread in ((warp, point.warp_thread), (weft, point.weft_thread))
        )
        albedos = Albedos(*(dr.select(is_warp, *pair) for pair in zip(of_warp, of_weft, strict=True)))
        albedos = self.toned(point, albedos, is_warp)
        if self.varies_at(size):
            albedos = self.varied(point, albedos, back, size, hair)
        if tint is not None:
            albedos = tinted(albedos, dr.select(is_warp, tint.warp, tint.weft))
        roughness = dr.select(is_warp, warp.roughness, weft.roughness)
        # Turn its frame by what it shows close up.
        frame = None
        if size is not None and self.has_detail:
            frame = turned_frame(self.detail(types), point, back, self.thread_number(point), size)
            frame = frame if hair is None else under_hair(frame, hair)
        surface_normal = None if frame is None else point.normal
        height = point.height
        if hairs is not None and hair is not None:
            # It lies above all yarns, which hide no light from it.
            height = dr.fma(hair.cover, hairs.below, height)
            surface_normal = dr.normalize(dr.lerp(surface_normal, types.Vector3(0, 0, 1), hair.cover))
        found = YarnPoint(
            back=back,
            hole=hole,
            x=point.x,
            y=point.y,
            height=height,
            plane=point.plane,
            normal=point.normal if frame is None else frame.normal,
            tangent=point.tangent if frame is None else frame.tangent,
            is_warp=is_warp,
            roughness=roughness,
            albedos=albedos,
            surface_normal=surface_normal,
            hairs=None if hair is None else (hairs, hair.cover),
            diffuse_gain=None if frame is None else diffuse_gain(frame, self.appearance.diffuse_blend),
        )
        found.bounced = self._bounced(found, tint)
        sheets = self.surface.sheets(x, y, back)
        return self._upon(found, sheets, tint) if sheets else found

    def _upon(self, point: YarnPoint, sheets: list[Sheet], tint: Tint | None) -> YarnPoint:
        """A point with the layers of cloth behind it, next to it first: they meet light that it lets through.

        What they send back leaves the point again, and what they let through too, spread evenly by either:
        sheets of R and T under one another, light to and fro between two of them included.
        """
        types = array_types(point.x)
        depth = types.Float(self.appearance.optical_depth)
        behind = Scattered(types.Color3(0), types.Color3(1))
        covered = types.Bool(False)
        for sheet in sheets[::-1]:
            of_sheet = scattered_by(*self._sheet(sheet, tint, types), depth)
            both = beneath(of_sheet, behind)
            behind = Scattered(*(dr.select(sheet.covered, *pair) for pair in zip(both, behind, strict=True)))
            covered |= sheet.covered
        own = scattered_by(point.albedos, point.roughness, depth)
        reflected, transmitted = (types.Color3(0),) * 2 if point.bounced is None else point.bounced
        own = Scattered(own.back, own.through + transmitted)
        both = beneath(own, behind)
        covered &= ~point.hole
        point.bounced = (
            dr.select(covered, reflected + both.back - own.back, reflected),
            dr.select(covered, both.through, transmitted),
        )
        point.albedos.diffuse_transmit = dr.select(covered, 0, point.albedos.diffuse_transmit)
        point.albedos.specular_transmit = dr.select(covered, 0, point.albedos.specular_transmit)
        return point

    def _sheet(self, sheet: Sheet, tint: Tint | None, types: ArrayTypes) -> tuple[Albedos, Float]:
        """Albedos and roughness of yarn in a layer behind."""
        warp, weft = self.parameters(types)
        of_warp, of_weft = (
            tinted(Albedos(*(family.albedo(n, thread) for n in range(len(ALBEDO_NAMES)))), colour)
            for family, thread, colour in (
                (warp, sheet.warp_thread, colours_of(tint)[0]),
                (weft, sheet.weft_thread, colours_of(tint)[1]),
            )
        )
        albedos = Albedos(
            *(
                dr.select(sheet.is_warp, getattr(of_warp, name), getattr(of_weft, name))
                for name in ALBEDO_NAMES
            )
        )
        return albedos, dr.select(sheet.is_warp, warp.roughness, weft.roughness)

    def _bounced(self, point: YarnPoint, tint: Tint | None) -> tuple[Color3, Color3] | None:
        """Albedos of light between yarns at a point, reflected and transmitted; 0 in holes."""
        types = array_types(point.roughness)
        between = self.between_yarns(types)
        if between is None:
            return None
        depth = types.Float(self.appearance.optical_depth)
        warp, weft = (
            scattered_by(tinted(Albedos(*family.mean()), colour), family.roughness, depth)
            for family, colour in zip(self.parameters(types), colours_of(tint), strict=True)
        )
        normal = point.normal if point.surface_normal is None else point.surface_normal
        blocked = between.blocked_at(point.is_warp, point.back, normal.z, point.height - point.plane)
        own = scattered_by(point.albedos, point.roughness, depth)
        reflected, transmitted = bounced(blocked, own, between.interior(warp, weft, point.back))
        return dr.select(point.hole, 0, reflected), dr.select(point.hole, 0, transmitted)

    @property
    def varies(self) -> bool:
        """Whether fibres or threads vary by chance."""
        return self.appearance.variation.fibre_noise > 0 or self.appearance.thread_noise > 0

    def varies_at(self, size: Float | None) -> bool:
        """Whether albedos vary by chance or by what yarns show to footprints of a side; see `at`."""
        return self.varies or (size is not None and self.has_detail)

    def hairs(self, point: SurfacePoint, back: Mask, size: Float | None) -> Hairs | None:
        """The hairs over a point; None where there are none. See `at`."""
        types = array_types(point.height)
        if size is None or not self.has_detail or not self.detail(types).has_hairs:
            return None
        below = extent_of(self.surface, types).high - point.height
        return Hairs(self.detail(types), types.Vector2(point.x, point.y), below, back, size)

    def thread_number(self, point: SurfacePoint) -> UInt:
        """Number of the thread of a point over the whole cloth, UInt32.

        Were it counted within the repeat, what varies by chance would repeat with the draft.
        """
        types = array_types(point.x)
        number = self._thread_of_family(point)
        # Two families must not share numbers.
        return types.UInt32(number) * 2 + dr.select(point.is_warp, types.UInt32(1), types.UInt32(0))

    def _thread_of_family(self, point: SurfacePoint) -> Int:
        """Number of the thread of a point among those of its family over the whole cloth, Int32."""
        types = array_types(point.x)
        numbers = self.detail(types)
        position = dr.select(point.is_warp, point.x, point.y) - point.across
        period = dr.select(point.is_warp, *numbers.period)
        threads = dr.select(point.is_warp, *numbers.threads)
        index = dr.select(point.is_warp, types.Int32(point.warp_thread), types.Int32(point.weft_thread))
        repeat = self.repeat_number(dr.floor(position / period), point.is_warp)
        return types.Int32(repeat) * threads + index

    def toned(self, point: SurfacePoint, albedos: Albedos, is_warp: Mask) -> Albedos:
        """Albedos of even yarn as the irregular yarn of a point has them."""
        if self.irregular is None:
            return albedos
        types = array_types(point.x)
        parts = (
            albedos.diffuse_reflect,
            albedos.diffuse_transmit,
            albedos.specular_reflect,
            albedos.specular_transmit,
        )
        number = types.Float(self._thread_of_family(point))
        process = self.irregular.on(types)
        return Albedos(*process.toned_at(parts, is_warp, number, point.x, point.y))

    def repeat_number(self, repeat: Float, is_warp: Mask) -> Float:
        """Number of a repeat, by which its threads differ from those of others; cloth that tiles has few.

        Args:
            repeat: its number across the threads of the family.
        """
        del is_warp
        return repeat

    def varied(
        self,
        point: SurfacePoint,
        old: Albedos,
        back: Mask,
        size: Float | None = None,
        hair: Hair | None = None,
    ) -> Albedos:
        """Albedos of the thread of a point, varied as it is there.

        Args:
            size: see `at`.
            hair: on top, which hides grooves and slubs.
        """
        types = array_types(point.x)
        numbers, thread = self.detail(types), self.thread_number(point)
        column, row, _ = fibre_cell(point.fibre_across, point.fibre_along, numbers.fibre_size)
        cell = types.UInt32(types.Int32(column)) * 65536 + types.UInt32(types.Int32(dr.floor(row)))
        gain = None
        if size is not None and self.has_detail:
            gain = detail_gain(numbers, point, back, thread, size)
            if hair is not None:
                gain.excess *= 1 - hair.cover
        parts = old.diffuse_reflect, old.diffuse_transmit, old.specular_reflect, old.specular_transmit
        return Albedos(*vary_albedos(parts, thread, cell, numbers.noise, gain))

    def visibility(self, point: YarnPoint, light: Vec3, active: Mask = True) -> Mask:
        """Whether nothing of the cloth hides the light from the point: Bool."""
        ray = shadow_query(self.surface, point, light)
        searched = ray.searched & active
        free = unoccluded(
            self.surface, point.x, point.y, ray.height, ray.direction, ray.back, searched, self.quality
        )
        return free | point.hole

    def evaluate(self, point: YarnPoint, light: Vec3, view: Vec3, active: Mask = True) -> Color3:
        """f(light, view)·|cos θ_light| of a yarn point, shadows included, without delta: Color3, 1/sr."""
        facing, seen = to_face_frame(light, point.back), to_face_frame(view, point.back)
        value = self._scattered(point, facing, seen)
        active = array_types(point.x).Bool(active)
        worth = active & (dr.max(value) > 0)
        value = dr.select(self.visibility(point, light, worth) & worth, value, 0)
        if point.bounced is not None:
            value += dr.select(active, self._bounced_value(point, facing, seen), 0)
        return value

    def pdf(self, point: YarnPoint, light: Vec3, view: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta: Float, 1/sr."""
        seen, facing = to_face_frame(view, point.back), to_face_frame(light, point.back)
        lobes = self._lobe_shares(point, seen)
        return self._pdf(point, facing, seen, lobes)

    def sample(
        self, point: YarnPoint, view: Vec3, choice: Float, u: Vec2, active: Mask = True
    ) -> DirectionSample:
        """A light direction, by lobe in proportion to the lobes' attenuated energy (zhu2024 5.1).

        Args:
            choice: uniform number in [0, 1) that chooses the lobe.
            u: Vector2 of uniform numbers in [0, 1).
        """
        types = array_types(point.x)
        seen = to_face_frame(view, point.back)
        lobes = self._lobe_shares(point, seen)
        specular, reflect, transmit, sheen, passing = lobes
        facing = sample_specular(seen, point.tangent, point.roughness, u)
        blends = self._sampling_blends(point)
        diffuse = sample_diffuse(point.normal, dr.select(choice < specular + reflect, *blends), u)
        facing = dr.select(
            choice < specular, facing, dr.select(choice < specular + reflect, diffuse, -diffuse)
        )
        if self.sheen is not None:
            from_sheen = choice >= specular + reflect + transmit
            facing = dr.select(from_sheen, sample_sheen(seen, self.sheen[1], u), facing)
        # Compared from the end: a choice of almost 1 must not fall past lobes that add up to less.
        is_null = point.hole & (choice >= sheen)
        facing = dr.select(is_null, -seen, facing)
        pdf = dr.select(is_null, passing, self._pdf(point, facing, seen, lobes))
        through = types.Color3(self._straight_through(point, seen))
        value = dr.select(is_null, through, self._scattered(point, facing, seen))
        light = to_face_frame(facing, point.back)
        drawn = types.Bool(active) & (pdf > 0)
        worth = drawn & (dr.max(value) > 0)
        worth &= self.visibility(point, light, worth & ~is_null) | is_null
        value = dr.select(worth, value, 0)
        if point.bounced is not None:
            value += dr.select(drawn & ~is_null, self._bounced_value(point, facing, seen), 0)
        weight = value / maximum(pdf, 1e-30)
        return DirectionSample(light=light, pdf=dr.select(active, pdf, 0), weight=weight, is_null=is_null)

    def straight_through(self, point: YarnPoint, view: Vec3) -> Float:
        """Share of light that passes straight through: 1 in a hole, less under sheen, else 0. Float."""
        return self._straight_through(point, to_face_frame(view, point.back))

    def _straight_through(self, point: YarnPoint, view: Vec3) -> Float:
        types = array_types(point.x)
        through = types.Float(1)
        if self.sheen is not None:
            through = sheen_transmittance(view, *self.sheen)
        return dr.select(point.hole, through, 0)

    def _scattered(self, point: YarnPoint, light: Vec3, view: Vec3) -> Color3:
        types = array_types(point.x)
        blend = types.Float(self.appearance.diffuse_blend)
        depth = types.Float(self.appearance.optical_depth)
        frame = (point.normal, point.tangent, point.roughness, depth)
        above, below = light.z > 0, light.z < 0
        albedos = towards_grazing(point.albedos, self.grazing, light, view)
        near = albedos.diffuse_reflect * point.diffuse(diffuse_reflection(light, point.normal, blend))
        near += albedos.specular_reflect * reflection(light, view, *frame)
        near *= point.under_hairs(light)
        far = albedos.diffuse_transmit * point.diffuse(diffuse_transmission(light, point.normal, blend))
        far += albedos.specular_transmit * transmission(light, view, *frame)
        value = dr.select(above, near, dr.select(below, far, types.Color3(0)))
        value = dr.select(point.hole, 0, value)
        if self.sheen is not None:
            # Fly-away fibres stand over holes too (zhu2024 eq. 4).
            sheen, transmittance = sheen_with_transmittance(light, view, *self.sheen)
            value = transmittance * value + sheen
        return value

    def _bounced_value(self, point: YarnPoint, light: Vec3, view: Vec3) -> Color3:
        """f·cos of light between yarns, directions in the frame of the face, 1/sr; no shadow falls on it."""
        reflected, transmitted = point.bounced
        value = dr.select(light.z > 0, reflected, transmitted) * (abs(light.z) * dr.inv_pi)
        if self.grazing.gain > 0:
            value *= self.grazing.kept(light, view)
        if self.sheen is not None:
            value *= sheen_transmittance(view, *self.sheen)
        return value

    def _diffuse_albedos(self, point: YarnPoint) -> tuple[Float, Float, Float, Float]:
        """Means of the channels: diffuse reflection and transmission, and light between yarns of both."""
        albedos = point.albedos
        reflect, transmit = channel_mean(albedos.diffuse_reflect), channel_mean(albedos.diffuse_transmit)
        if point.bounced is None:
            return reflect, transmit, array_types(point.x).Float(0), array_types(point.x).Float(0)
        return reflect, transmit, *(channel_mean(part) for part in point.bounced)

    def _sampling_blends(self, point: YarnPoint) -> tuple[Float, Float]:
        """Share of the yarn's normal in what is drawn for reflection and for transmission.

        Light between yarns is diffuse about the cloth's normal, so with it the diffuse lobe is of another
        blend, exactly.
        """
        blend = array_types(point.x).Float(self.appearance.diffuse_blend)
        if point.bounced is None:
            return blend, blend
        reflect, transmit, more_reflect, more_transmit = self._diffuse_albedos(point)
        return (
            blend * reflect * dr.rcp(maximum(reflect + more_reflect, 1e-20)),
            blend * transmit * dr.rcp(maximum(transmit + more_transmit, 1e-20)),
        )

    def _lobe_shares(self, point: YarnPoint, view: Vec3) -> tuple[Float, Float, Float, Float, Float]:
        """Probabilities of specular, diffuse reflection, diffuse transmission, sheen and passing; sum 1."""
        types = array_types(point.x)
        depth = types.Float(self.appearance.optical_depth)
        turned, through = layer_albedo_estimate(view, point.normal, point.tangent, point.roughness, depth)
        albedos = point.albedos
        reflected = channel_mean(albedos.specular_reflect)
        if self.grazing.gain > 0:
            reflected += self.grazing.rise_towards(view)
        specular = reflected * turned + channel_mean(albedos.specular_transmit) * through
        reflect, transmit, more_reflect, more_transmit = self._diffuse_albedos(point)
        reflect, transmit = reflect + more_reflect, transmit + more_transmit
        if self.sheen is None:
            sheen = types.Float(0)
        else:
            transmittance = sheen_transmittance(view, *self.sheen)
            sheen = dr.select(
                point.hole, 1 - transmittance, (1 - transmittance) * dr.rcp(maximum(transmittance, 1e-3))
            )
        total = maximum(specular + reflect + transmit + sheen, 1e-20)
        scale = dr.select(point.hole, 0, dr.rcp(total))
        passing = dr.select(point.hole, 1 - sheen, 0)
        sheen = dr.select(point.hole, sheen, sheen * scale)
        return specular * scale, reflect * scale, transmit * scale, sheen, passing

    def _pdf(
        self, point: YarnPoint, light: Vec3, view: Vec3, lobes: tuple[Float, Float, Float, Float, Float]
    ) -> Float:
        specular, reflect, transmit, sheen, _ = lobes
        blend_reflect, blend_transmit = self._sampling_blends(point)
        density = (
            specular * pdf_specular(light, view, point.tangent, point.roughness)
            + reflect * diffuse_pdf(light, point.normal, blend_reflect)
            + transmit * diffuse_pdf(-light, point.normal, blend_transmit)
        )
        if self.sheen is not None:
            density += sheen * sheen_pdf(light, view, self.sheen[1])
        return density


def scattered_by(albedos: Albedos, roughness: Float, optical_depth: Float) -> Scattered:
    """Shares that yarn of these albedos reflects and transmits at one scattering."""
    return scattered(
        albedos.diffuse_reflect,
        albedos.diffuse_transmit,
        albedos.specular_reflect,
        albedos.specular_transmit,
        mean_layer_shares(roughness, optical_depth),
    )
