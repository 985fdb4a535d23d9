"""Models with a part left out, to show what that part does: importance sampling, or parallax.

They answer as the model that they are made of, and are called by its name.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Self

import drjit as dr

from loomlight.aggregate.components import colours
from loomlight.core.arrays import Color3, Float, Mask, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum
from loomlight.core.errors import InputError
from loomlight.core.fleet import Report
from loomlight.core.footprint import Footprint
from loomlight.models.interface import FootprintBsdf, Model, Values
from loomlight.models.point import PointModel
from loomlight.scattering.diffuse import diffuse_pdf, sample_diffuse
from loomlight.scattering.point import DirectionSample, Tint, YarnScattering, to_face_frame
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile

# From a model and what `Model.at` takes to what it returns.
At = Callable[[Model, Vec3, Footprint, Any, Mask], FootprintBsdf]


class AlteredModel(Model):
    """A model whose answers to footprints another function gives; everything else is the model's."""

    # Of the model that is altered: set on the object.
    name = ""
    filters = False
    conserves_energy = False

    def __init__(self, model: Model, at: At) -> None:
        self._model, self._at = model, at
        own = ("name", "source_kind", "filters", "symbolic", "has_holes", "options_class", "options")
        for attribute in own:
            setattr(self, attribute, getattr(model, attribute))
        self.source = model.source

    @classmethod
    def for_source(cls, source: Source, options: Any = None, report: Report | None = None) -> Self:
        """Not made of sources.

        Raises:
            InputError: always.
        """
        raise InputError(f"{source.name}: an altered model is made of a model, not of a source.")

    def to_loom(self) -> LoomFile:
        """The model's."""
        return self._model.to_loom()

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """Not made of files.

        Raises:
            InputError: always.
        """
        raise InputError(f"{loom.file}: an altered model is made of a model, not of a file.")

    def at(
        self, view: Vec3, footprint: Footprint, tint: Tint | None = None, active: Mask = True
    ) -> FootprintBsdf:
        """What the function says."""
        return self._at(self._model, view, footprint, tint, active)

    def upload(self, types: ArrayTypes) -> None:
        """The model's."""
        self._model.upload(types)

    def parameters(self, types: ArrayTypes) -> Values:
        """The model's."""
        return self._model.parameters(types)

    def bound_to(self, values: Values) -> Self:
        """The same alteration of the model that reads its parameters from arrays."""
        return type(self)(self._model.bound_to(values), self._at)

    @property
    def open_area(self) -> float:
        """The model's."""
        return self._model.open_area

    def literals(self) -> tuple[float, ...]:
        """The model's."""
        return self._model.literals()


def uniformly_sampled(model: Model) -> AlteredModel:
    """The model without importance sampling: uniform directions over the sphere, or through holes."""

    def at(of: Model, view: Vec3, footprint: Footprint, tint: Any, active: Mask) -> FootprintBsdf:
        return UniformDirections(of.at(view, footprint, tint, active))

    return AlteredModel(model, at)


class UniformDirections(FootprintBsdf):
    """Another BSDF's values, at directions that know nothing of them."""

    def __init__(self, inner: FootprintBsdf) -> None:
        super().__init__(inner.view, inner.footprint)
        self._inner = inner

    @property
    def hole(self) -> Float:
        return self._inner.hole

    @property
    def null_transmission(self) -> Float:
        return self._inner.null_transmission

    @property
    def diffuse_reflectance(self) -> Color3:
        return self._inner.diffuse_reflectance

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        return self._inner.value(light, active)

    def pdf(self, light: Vec3) -> Float:
        return (1 - self.null_transmission) * (1 / (4 * math.pi)) + 0 * light.z

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        types = array_types(self.view.x)
        passing = self.null_transmission
        is_null = types.Bool(choice < passing)
        z = 1 - 2 * u.x
        radius = dr.sqrt(maximum(1 - z * z, 0))
        sin, cos = dr.sincos(2 * math.pi * u.y)
        light = types.Vector3(radius * cos, radius * sin, z)
        light = dr.select(is_null, -self.view, light)
        pdf = dr.select(is_null, passing, self.pdf(light))
        scattered = self.value(light, ~is_null) / maximum(pdf, 1e-30)
        weight = dr.select(is_null, types.Color3(1), dr.select(pdf > 0, scattered, 0))
        return DirectionSample(light=light, pdf=pdf, weight=weight, is_null=is_null)


def without_parallax(model: PointModel) -> AlteredModel:
    """The point model as before parallax (zhu2023): the point below the pixel, dark where the view is hidden.

    V(light)·V(view) multiplies its value, sheen aside, and no view ray is followed.
    """

    def at(of: Model, view: Vec3, footprint: Footprint, tint: Any, active: Mask) -> FootprintBsdf:
        del tint, active
        assert isinstance(of, PointModel)
        return _FlatPoint(of.point_model, view, footprint)

    return AlteredModel(model, at)


class _FlatPoint(FootprintBsdf):
    """Points of a flat cloth."""

    def __init__(self, model: YarnScattering, view: Vec3, footprint: Footprint) -> None:
        super().__init__(view, footprint)
        self._model = model
        types = array_types(view.x)
        self._back = types.Bool(view.z < 0)
        centre = footprint.centre
        _, hole = model.surface.height(centre.x, centre.y, self._back)
        self.point = model.at(centre.x, centre.y, self._back, hole)
        self._seen = model.visibility(self.point, view) | hole

    @property
    def hole(self) -> Float:
        return dr.select(self.point.hole, array_types(self.view.x).Float(1), 0)

    @property
    def diffuse_reflectance(self) -> Color3:
        return dr.select(self.point.hole, 0, self.point.albedos.diffuse_reflect)

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        visible = self._model.visibility(self.point, light, active) & self._seen
        return colours(self._model.appearance, self.point, light, self.view, visible)

    def pdf(self, light: Vec3) -> Float:
        facing = to_face_frame(light, self._back)
        blend = array_types(light.x).Float(self._model.appearance.diffuse_blend)
        return dr.select(self.point.hole, 0, diffuse_pdf(facing, self.point.normal, blend))

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        types = array_types(self.view.x)
        blend = types.Float(self._model.appearance.diffuse_blend)
        facing = sample_diffuse(self.point.normal, blend, u)
        is_null = self.point.hole
        light = dr.select(is_null, -self.view, to_face_frame(facing, self._back))
        pdf = dr.select(is_null, 1, self.pdf(light))
        scattered = self.value(light) / maximum(pdf, 1e-30)
        weight = dr.select(is_null, types.Color3(1), dr.select(pdf > 0, scattered, 0))
        return DirectionSample(light=light, pdf=pdf, weight=weight, is_null=is_null)
