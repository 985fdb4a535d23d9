"""The principled material of U3M over footprints: Burley 2012 with holes, and diffuse light that passes.

    f = (1 − metalness) · (base · (1 − transmission) · diffuse + sheen) + glossy    on the side of the view
    f = (1 − metalness) · base · transmission / π                                  on the other side

times the opacity; the rest is hole. NumPy's twin, without metal and tints, is
`exporters/standards.py:evaluate_principled`. Normals that a footprint averages widen highlights: their mean
has the length L ≈ 1 − σ² where σ² is the variance of their slopes along each axis, which adds 2σ² to α².
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, Self, final

import drjit as dr

from loomlight.core.arrays import Color3, Float, FloatType, Mask, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum, minimum
from loomlight.core.errors import InputError
from loomlight.core.fleet import Report
from loomlight.core.footprint import Footprint
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.standard.maps import DeviceMaps, FaceMaps
from loomlight.scattering.point import DirectionSample, Tint
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile
from loomlight.sources.u3m import U3mMaterial

_MIN_ALPHA = 1e-3
# Views below the shading normal's horizon are taken for this cosine.
_MIN_COSINE = 0.02
# Share of samples that follow the gloss even where it is faint from above: at grazing angles it is not.
_GRAZING = 0.05


class StandardBsdf(FootprintBsdf):
    """The material over footprints, in the frame of the face that is seen: the back is turned about y."""

    def __init__(self, maps: DeviceMaps, tint: Tint | None, view: Vec3, footprint: Footprint) -> None:
        super().__init__(view, footprint)
        types = self._types = array_types(view.x)
        self._back = view.z < 0
        (
            red, green, blue, alpha, *normal, roughness, twice_x, twice_y, metalness, transmission, specular,
            specular_tint, sheen, sheen_tint,
        ) = maps.at(footprint, self._back)  # fmt: skip
        base = types.Color3(red, green, blue)
        if tint is not None:
            base *= tint.warp
        # Find the shading frame, x along which highlights are wide.
        n = types.Vector3(*normal)
        length = clip(dr.norm(n), 1e-3, 1)
        n = dr.normalize(types.Vector3(n.x, n.y, maximum(n.z, 1e-3)))
        x = dr.normalize(types.Vector3(1 - n.x * n.x, -n.x * n.y, -n.x * n.z))
        y = dr.cross(n, x)
        strength = clip(dr.sqrt(twice_x * twice_x + twice_y * twice_y), 0, 1)
        angle = 0.5 * dr.atan2(twice_y, twice_x)
        sine, cosine = dr.sincos(angle)
        self._axes = (cosine * x + sine * y, cosine * y - sine * x, n)
        # Find α along both axes, widened by what the footprint averages.
        aspect = dr.sqrt(1 - 0.9 * strength)
        wider = 2 * (1 - length) / length
        square = roughness * roughness
        self._alpha_x, self._alpha_y = (
            dr.sqrt(minimum(alpha_of * alpha_of + wider, 1))
            for alpha_of in (maximum(square / aspect, _MIN_ALPHA), maximum(square * aspect, _MIN_ALPHA))
        )
        self._roughness = roughness
        # Find colours.
        luminance = dr.dot(base, types.Color3(0.2126, 0.7152, 0.0722))
        hue = dr.select(luminance > 0, base / maximum(luminance, 1e-6), 1)
        self._f0 = dr.lerp(0.08 * specular * dr.lerp(types.Color3(1), hue, specular_tint), base, metalness)
        diffuse = base * (1 - metalness)
        self._reflect, self._transmit = diffuse * (1 - transmission), diffuse * transmission
        self._sheen = sheen * (1 - metalness) * dr.lerp(types.Color3(1), hue, sheen_tint)
        self._cover = clip(alpha, 0, 1)
        # Look from where the shading normal sees.
        seen = self._to_face(view)
        local = types.Vector3(*(dr.dot(axis, seen) for axis in self._axes))
        self._view = dr.normalize(types.Vector3(local.x, local.y, maximum(local.z, _MIN_COSINE)))
        # Share samples among lobes.
        weights = [_mean(self._reflect) + 0.1 * sheen, _mean(self._f0) + _GRAZING, _mean(self._transmit)]
        total = maximum(weights[0] + weights[1] + weights[2], 1e-6)
        self._shares = tuple(weight / total for weight in weights)

    def _to_face(self, direction: Vec3) -> Vec3:
        """A direction in the frame of the face that is seen; its own inverse."""
        sign = dr.select(self._back, self._types.Float(-1), 1)
        return self._types.Vector3(sign * direction.x, direction.y, sign * direction.z)

    @property
    def hole(self) -> Float:
        """Share of the view rays that pass straight through, 0 to 1."""
        return 1 - self._cover

    @property
    def diffuse_reflectance(self) -> Color3:
        """Mean diffuse albedo over the footprint, holes counted as 0."""
        return self._cover * self._reflect

    @property
    def roughness(self) -> Float:
        """Geometric mean of α along both axes, widened by what the footprint averages."""
        return dr.sqrt(self._alpha_x * self._alpha_y)

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """f·cos, 1/sr."""
        del active
        facing, local = self._local(light)
        half = dr.normalize(local + self._view)
        front, n_v = maximum(local.z, 0), self._view.z
        cosine = clip(dr.dot(self._view, half), 0, 1)
        of_half, at_light, at_view = (_power_5(1 - part) for part in (cosine, front, n_v))
        bent = 2 * self._roughness * cosine * cosine
        diffuse = (1 - 0.5 * at_light) * (1 - 0.5 * at_view)
        diffuse += bent * (at_light + at_view + at_light * at_view * (bent - 1))
        below = self._reflect * (diffuse * dr.inv_pi)
        gloss = self._distribution(half) * self._visibility(local)
        glossy = dr.lerp(self._f0, self._types.Color3(1), of_half) * gloss
        reflected = (below + glossy + self._sheen * of_half) * front
        passed = self._transmit * (dr.inv_pi * maximum(-local.z, 0))
        return self._cover * dr.select(facing.z > 0, reflected, passed)

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""
        _, local = self._local(light)
        half = dr.normalize(local + self._view)
        above, gloss, below = self._shares
        visible = self._distribution(half) * self._masking(self._view) / (4 * self._view.z)
        cosine = above * maximum(local.z, 0) + below * maximum(-local.z, 0)
        return self._cover * (cosine * dr.inv_pi + gloss * visible)

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A direction of one of the lobes, or straight on in proportion to the hole."""
        types, through = self._types, self.hole
        is_null = choice < through
        choice = (choice - through) / maximum(self._cover, 1e-6)
        above, gloss, _ = self._shares
        # Draw by the cosine, for both sides.
        radius = dr.sqrt(u.x)
        sine, cosine = dr.sincos(dr.two_pi * u.y)
        height = dr.sqrt(maximum(1 - u.x, 0))
        up = dr.select(choice < above + gloss, height, -height)
        diffuse = types.Vector3(radius * cosine, radius * sine, up)
        # Draw a visible normal (Heitz 2018, listing 1).
        stretched = dr.normalize(
            types.Vector3(self._alpha_x * self._view.x, self._alpha_y * self._view.y, self._view.z)
        )
        across = stretched.x * stretched.x + stretched.y * stretched.y
        inverse = dr.rsqrt(maximum(across, 1e-12))
        first = types.Vector3(-stretched.y * inverse, stretched.x * inverse, 0)
        first = dr.select(across > 1e-10, first, types.Vector3(1, 0, 0))
        second = dr.cross(stretched, first)
        t1, t2, s = radius * cosine, radius * sine, 0.5 * (1 + stretched.z)
        t2 = dr.lerp(dr.sqrt(maximum(1 - t1 * t1, 0)), t2, s)
        up = dr.sqrt(maximum(1 - t1 * t1 - t2 * t2, 0))
        drawn = t1 * first + t2 * second + up * stretched
        half = dr.normalize(
            types.Vector3(self._alpha_x * drawn.x, self._alpha_y * drawn.y, maximum(drawn.z, 1e-6))
        )
        mirrored = 2 * dr.dot(self._view, half) * half - self._view
        # Choose.
        local = dr.select((choice >= above) & (choice < above + gloss), mirrored, diffuse)
        facing = sum(axis * part for axis, part in zip(self._axes, local, strict=True))
        light = dr.select(is_null, -self.view, dr.normalize(self._to_face(types.Vector3(facing))))
        pdf = dr.select(is_null, through, self.pdf(light))
        value = dr.select(is_null, types.Color3(through), self.value(light))
        weight = dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0)
        return DirectionSample(light, pdf, weight, is_null)

    def _local(self, light: Vec3) -> tuple[Vec3, Vec3]:
        """A light in the frame of the face, and in that of the shading normal."""
        facing = self._to_face(light)
        return facing, self._types.Vector3(*(dr.dot(axis, facing) for axis in self._axes))

    def _distribution(self, half: Vec3) -> Float:
        """GGX; 0 below the horizon."""
        x, y = half.x / self._alpha_x, half.y / self._alpha_y
        square = x * x + y * y + half.z * half.z
        found = 1 / (dr.pi * self._alpha_x * self._alpha_y * maximum(square * square, 1e-12))
        return dr.select(half.z > 0, found, 0)

    def _masking(self, direction: Vec3) -> Float:
        """Smith's G₁."""
        x, y = self._alpha_x * direction.x, self._alpha_y * direction.y
        z = maximum(dr.abs(direction.z), 1e-6)
        return 2 * z / (z + dr.sqrt(x * x + y * y + z * z))

    def _visibility(self, light: Vec3) -> Float:
        """Smith's height-correlated masking and shadowing over 4 cos cos."""

        def reach(direction: Vec3) -> Float:
            x, y = self._alpha_x * direction.x, self._alpha_y * direction.y
            return dr.sqrt(x * x + y * y + direction.z * direction.z)

        z = maximum(light.z, 0)
        return 0.5 / maximum(z * reach(self._view) + self._view.z * reach(light), 1e-6)


def _mean(colour: Color3) -> Float:
    return (colour.x + colour.y + colour.z) * (1 / 3)


def _power_5(value: Float) -> Float:
    square = value * value
    return square * square * value


@final
class StandardModel(Model):
    """A U3M material as its own formulas have it; nothing is baked or trained."""

    name, source_kind = "standard", "u3m"
    filters, conserves_energy = True, False
    has_holes = True

    def __init__(self, source: U3mMaterial) -> None:
        self.source = source
        front, back = source.faces
        maps = FaceMaps.of(front)
        self.maps = (maps, maps if back is front else FaceMaps.of(back))
        self._on: Callable[[Any], DeviceMaps] = cache(self._uploaded)

    @classmethod
    def for_source(cls, source: Source, options: Any = None, report: Report | None = None) -> Self:
        """The model of a source.

        Raises:
            InputError: it is no U3M.
        """
        del options, report
        if not isinstance(source, U3mMaterial):
            raise InputError(f"The model standard shows U3M materials, and {source.name} is none.")
        return cls(source)

    def to_loom(self) -> LoomFile:
        """The source alone."""
        return LoomFile(self.name, self.source)

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of a file's source."""
        return cls.for_source(loom.source)

    @property
    def open_area(self) -> float:
        """Mean share of light that passes straight through the front, 0 to 1."""
        return float(1 - self.maps[0].levels[-1][0, 0, 3])

    def at(
        self, view: Vec3, footprint: Footprint, tint: Tint | None = None, active: Mask = True
    ) -> StandardBsdf:
        """The material over footprints."""
        del active
        return StandardBsdf(self._on(type(view.x)), tint, view, footprint)

    def upload(self, types: ArrayTypes) -> None:
        """Puts the maps on a backend."""
        self._on(types.Float)

    def _uploaded(self, float_type: FloatType) -> DeviceMaps:
        return DeviceMaps(self.maps, float_type)
