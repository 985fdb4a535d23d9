"""A model of a surface that is no cloth, and one of fabrics: a Lambertian over footprints, 40 lines."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Self

import drjit as dr

from loomlight.core.arrays import Color3, Float, Mask, Vec2, Vec3
from loomlight.core.backend import array_types
from loomlight.core.fleet import Report
from loomlight.core.footprint import Footprint
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.scattering.point import DirectionSample, Tint
from loomlight.sources.loom_file import LoomFile


@dataclass(frozen=True)
class Paint:
    """A source that is no fabric: one colour."""

    name: str
    albedo: float
    repeat_mm: tuple[float, float] = (50.0, 50.0)
    default_uv_size_mm: tuple[float, float] = (50.0, 50.0)


class Lambertian(FootprintBsdf):
    """Reflects a share of the light by the cosine."""

    def __init__(self, albedo: float, tint: Tint | None, view: Vec3, footprint: Footprint) -> None:
        super().__init__(view, footprint)
        types = array_types(view.x)
        self.albedo = types.Color3(albedo) * (1 if tint is None else tint.warp)

    @property
    def diffuse_reflectance(self) -> Color3:
        return self.albedo

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        return self.albedo * self.pdf(light)

    def pdf(self, light: Vec3) -> Float:
        return dr.select(light.z * self.view.z > 0, dr.abs(light.z) * dr.inv_pi, 0)

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        radius = dr.sqrt(u.x)
        sine, cosine = dr.sincos(2 * math.pi * u.y)
        height = dr.sqrt(1 - u.x)
        types = array_types(self.view.x)
        up = dr.select(self.view.z < 0, -height, height)
        light = types.Vector3(radius * cosine, radius * sine, up)
        return DirectionSample(light, self.pdf(light), self.albedo, types.Bool(False))


class ToyModel(Model):
    """The Lambertian of a paint."""

    name, source_kind = "toy", "paint"
    filters = conserves_energy = True

    def __init__(self, source: Any, albedo: float) -> None:
        self.source, self.albedo = source, albedo

    @classmethod
    def for_source(cls, source: Any, options: Any = None, report: Report | None = None) -> Self:
        return cls(source, source.albedo)

    def to_loom(self) -> LoomFile:
        return LoomFile(self.name, self.source, settings={"albedo": self.albedo})

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        return cls(loom.source, loom.setting("albedo", float))

    def at(
        self, view: Vec3, footprint: Footprint, tint: Tint | None = None, active: Mask = True
    ) -> Lambertian:
        return Lambertian(self.albedo, tint, view, footprint)


class ToyOfFabrics(ToyModel):
    """The Lambertian of a fabric: half of the light."""

    name, source_kind = "toy of fabrics", "fabric"

    @classmethod
    def for_source(cls, source: Any, options: Any = None, report: Report | None = None) -> Self:
        return cls(source, 0.5)
