"""The point model as a multi-scale model: the yarn at the footprint's centre, whatever the size."""

from __future__ import annotations

from copy import copy
from functools import cached_property
from typing import Any, Self, final

import drjit as dr

from loomlight.aggregate.components import components, light_visibility
from loomlight.core.arrays import Color3, Float, Mask, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types
from loomlight.core.footprint import Footprint
from loomlight.fabric.fabric import Fabric
from loomlight.models.between_yarns import Bounced
from loomlight.models.fabric_model import (
    ALBEDOS,
    FAMILIES,
    FabricModel,
    colour_parameters,
    fabric_in_loom,
    fabric_source,
    parameter_of,
    recolour,
)
from loomlight.models.interface import Report, Values
from loomlight.models.options import Options
from loomlight.models.separable import Components, Evaluation, FamilyAlbedos, SeparableBsdf
from loomlight.scattering.point import Albedos, DirectionSample, YarnPoint, YarnScattering, to_face_frame
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile
from loomlight.yarn.geometry import DetachedSurface, YarnGeometry
from loomlight.yarn.rays import upload_extent
from loomlight.yarn.visibility import first_hit

_BENDS = ("height_scale", "twist")
_SHEEN = ("sheen.strength", "sheen.roughness")


@final
class PointBsdf(SeparableBsdf):
    """The yarn points that view rays through the centres of footprints meet."""

    def __init__(
        self, model: YarnScattering, view: Vec3, footprint: Footprint, tint: Color3 | None, active: Mask
    ) -> None:
        super().__init__(view, footprint, model.appearance.sheen)
        self._model = model
        centre, back = footprint.centre, array_types(view.x).Bool(view.z < 0)
        # Derivatives of where a ray meets yarn would be wrong as well as dear.
        with dr.suspend_grad():
            seen = to_face_frame(view, back)
            hit = first_hit(model.surface, centre.x, centre.y, seen, back, active, model.quality)
        size = footprint.spread_side if model.has_detail else None
        self.point = model.at(hit.x, hit.y, back, hit.hole, size, tint, (seen, hit.height))

    @cached_property
    def hole(self) -> Float:
        """1 where the ray passes through, else 0."""
        return dr.select(self.point.hole, array_types(self.view.x).Float(1), 0)

    @property
    def null_transmission(self) -> Float:
        """1 in a hole, less under sheen, else 0."""
        return self._model.straight_through(self.point, self.view)

    @property
    def diffuse_reflectance(self) -> Color3:
        """The diffuse albedo of the yarn that shows."""
        return dr.select(self.point.hole, 0, self.point.albedos.diffuse_reflect)

    @property
    def albedos(self) -> FamilyAlbedos:
        """Albedos of the thread that shows; 0 for the other family."""
        return families_of(self.point)

    def evaluate(self, light: Vec3, active: Mask = True) -> Evaluation:
        """Components of the yarn point, of one family."""
        visible = self._model.visibility(self.point, light, active)
        found = Components.of(
            components(self._model.appearance, self.point, light, self.view, visible),
            light_visibility(self.point, visible),
        )
        return Evaluation(found, self.hole)

    def bounced(self, evaluation: Evaluation) -> Bounced | None:
        """Albedos of light between yarns at the point."""
        del evaluation
        bounced: Bounced | None = self.point.bounced
        return bounced

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """f·cos with derivatives, 1/sr; 0 in lanes that are not active."""
        return self._model.evaluate(self.point, light, self.view, active)

    def value_and_null_transmission(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both."""
        return self.value(light, active), self.null_transmission

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""
        return self._model.pdf(self.point, light, self.view)

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A light direction by one of the yarn's lobes, straight through in holes."""
        return self._model.sample(self.point, self.view, choice, u)


def families_of(point: YarnPoint) -> FamilyAlbedos:
    """Albedos of the thread that a point shows for its family, 0 for the other; 0 in holes."""
    types = array_types(point.x)

    def family(shows: Mask) -> Albedos:
        share = dr.select(shows & ~point.hole, types.Float(1), 0)
        return Albedos(*(getattr(point.albedos, name) * share for name in ALBEDOS))

    return FamilyAlbedos(family(point.is_warp), family(~point.is_warp))


@final
class PointModel(FabricModel):
    """One sample of the footprint, at its centre: exact there, aliased where threads are small.

    Scene parameters: ``warp.roughness``, ``warp.height_scale``, ``warp.twist`` (radians), the albedos
    ``warp.diffuse_reflect`` … and ``warp.color``, the same of ``weft``; ``sheen.strength`` and
    ``sheen.roughness`` where there is sheen. Where threads of a family differ, they are arrays
    ``warp.colors`` and ``warp.albedos``: a row a thread, four albedos a row, four numbers an albedo of which
    the last is unused. All but colours are differentiable; shadows and holes are held fixed.
    """

    name = "point"
    filters = False
    conserves_energy = True

    def __init__(self, fabric: Fabric) -> None:
        super().__init__(fabric)
        self._geometry = YarnGeometry(fabric.layout())
        self.point_model = YarnScattering(DetachedSurface(self._geometry), fabric.appearance())

    @classmethod
    def for_source(cls, source: Source, options: Options | None = None, report: Report | None = None) -> Self:
        """The model of a fabric; nothing is baked.

        Raises:
            InputError: no fabric.
        """
        del options, report
        return cls(fabric_source(source, cls.name))

    def to_loom(self) -> LoomFile:
        """The fabric."""
        return LoomFile(model=self.name, source=self.fabric)

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of the fabric.

        Raises:
            InputError: another model's file.
        """
        return cls(fabric_in_loom(loom, cls.name))

    def at(
        self, view: Vec3, footprint: Footprint, tint: Color3 | None = None, active: Mask = True
    ) -> PointBsdf:
        """The yarn points at the centres of footprints as views see them."""
        return PointBsdf(self.point_model, view, footprint, tint, active)

    def upload(self, types: ArrayTypes) -> None:
        """Puts the yarns and their parameters on a backend."""
        super().upload(types)
        self._geometry.upload(types)
        upload_extent(self.point_model.surface, types)
        self.point_model.parameters(types)
        self.point_model.detail(types)

    def parameters(self, types: ArrayTypes) -> Values:
        """Arrays of the model: with one that is `bound_to` them, edits show at once, with derivatives."""
        found: dict[str, Any] = {}
        families = self.point_model.parameters(types)
        for number, (name, family) in enumerate(zip(FAMILIES, families, strict=True)):
            found[f"{name}.roughness"] = family.roughness
            for bend in _BENDS:
                value = getattr(self._geometry, bend)[number]
                found[f"{name}.{bend}"] = dr.opaque(types.Float, float(value))
            if family.table is not None:
                found[f"{name}.albedos"] = family.table
            else:
                found |= {f"{name}.{part}": value for part, value in zip(ALBEDOS, family.shared, strict=True)}
        if self.point_model.sheen is not None:
            # Literals until they are edited: the sheen's closed form is cheaper with a literal roughness.
            for name, value in zip(_SHEEN, self.point_model.sheen, strict=True):
                found[name] = types.Float(float(value))
        shown = {name: parameter_of(name, value, differentiable=True) for name, value in found.items()}
        return {**shown, **colour_parameters(self.fabric, types)}

    def bound_to(self, values: Values) -> Self:
        """The model that reads parameters from arrays; derivatives of these may be switched on later."""
        bound, geometry, point_model = copy(self), copy(self._geometry), copy(self.point_model)
        arrays = {name: parameter.value for name, parameter in values.items()}
        geometry.height_scale, geometry.twist = (
            (arrays[f"warp.{bend}"], arrays[f"weft.{bend}"]) for bend in _BENDS
        )
        point_model.surface = DetachedSurface(geometry)
        if point_model.sheen is not None:
            strength, roughness = (arrays[name] for name in _SHEEN)
            point_model.sheen = strength, roughness
        bound._geometry, bound.point_model = geometry, point_model
        return bound

    def updated(self, values: Values, changed: frozenset[str]) -> Self:
        """The same model, whose albedos follow edited colours."""
        changed |= recolour(self.fabric, values, changed)
        types = array_types(values["warp.roughness"].value)
        for name, family in zip(FAMILIES, self.point_model.parameters(types), strict=True):
            if f"{name}.albedos" in changed:
                family.follow_table()
        return self
