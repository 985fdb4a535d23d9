"""`woven_point`: the point model as a Mitsuba BSDF, the reference that multi-scale models are judged by."""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.backend import clip
from loomlight.mitsuba.cloth_samples import bsdf_sample, declare_lobes, plain, variant_types
from loomlight.mitsuba.cloth_uv import draft_position
from loomlight.mitsuba.fabric_props import fabric_of, uv_size_of
from loomlight.mitsuba.held_surface import HeldSurface
from loomlight.scattering.point import PointModel
from loomlight.yarn.geometry import YarnGeometry

_FAMILIES = ("warp", "weft")
_ALBEDOS = ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit")


def woven_point_class() -> type:
    """The BSDF's class in the current variant, for `mi.register_bsdf`."""
    base: Any = mi.BSDF

    class WovenPoint(base):
        """Woven cloth, yarn by yarn.

        Parameters (see `fabric_props` for the fabric's):
            uv_size: millimetres per unit of u and of v, "x,y" or a 2-vector; 100 mm.
            uv_scale: the same in repeats of the draft.
            albedo: a texture over the mesh's uv; the diffuse albedos are multiplied by it, clipped to [0, 1].

        Scene parameters: ``warp.roughness``, ``warp.height_scale``, ``warp.twist`` (radians) and the albedos
        ``warp.diffuse_reflect`` …, the same of ``weft``, ``sheen.strength`` and ``sheen.roughness`` where
        there is sheen, and ``uv_size``. Albedos of families whose threads differ are one array
        ``warp.albedos``: a row a thread, four albedos a row, four numbers an albedo of which the last is
        unused. All but ``uv_size`` are differentiable; shadows and holes are held fixed.
        """

        def __init__(self, props: Any) -> None:
            super().__init__(props)
            self.fabric = fabric_of(props)
            self.uv_size = mi.Vector2f(uv_size_of(props, self.fabric))
            self.albedo = props.get_texture("albedo", 1.0) if "albedo" in props else None
            for name in ("toml", "folder"):
                props.mark_queried(name)
            self.geometry = YarnGeometry(self.fabric.layout())
            self.model = PointModel(HeldSurface(self.geometry), self.fabric.appearance())
            dr.make_opaque(self.uv_size)
            self._bends = {
                name: [dr.opaque(mi.Float, float(getattr(self.geometry, name)[family])) for family in (0, 1)]
                for name in ("height_scale", "twist")
            }
            # Literals until they are edited: the sheen's closed form is cheaper with a literal roughness.
            sheen = self.model.sheen
            self._sheen = None if sheen is None else [mi.Float(float(value)) for value in sheen]
            self.parameters_changed([])
            declare_lobes(self)

        def traverse(self, callback: Any) -> None:
            free = mi.ParamFlags.Differentiable
            callback.put("uv_size", self.uv_size, mi.ParamFlags.NonDifferentiable)
            for number, (name, family) in enumerate(zip(_FAMILIES, self._families(), strict=True)):
                callback.put(f"{name}.roughness", family.roughness, free)
                for bend, values in self._bends.items():
                    callback.put(f"{name}.{bend}", values[number], free)
                if family.table is not None:
                    callback.put(f"{name}.albedos", family.table, free)
                    continue
                for albedo, value in zip(_ALBEDOS, family.shared, strict=True):
                    callback.put(f"{name}.{albedo}", value, free)
            if self._sheen is not None:
                callback.put("sheen.strength", self._sheen[0], free)
                callback.put("sheen.roughness", self._sheen[1], free)
            if self.albedo is not None:
                callback.put("albedo", self.albedo, free)

        def parameters_changed(self, keys: Any) -> None:
            warp, weft = self._bends["height_scale"]
            self.geometry.height_scale = (warp, weft)
            warp, weft = self._bends["twist"]
            self.geometry.twist = (warp, weft)
            if self._sheen is not None:
                strength, roughness = self._sheen
                self.model.sheen = (strength, roughness)

        def _families(self) -> Any:
            return self.model.parameters(variant_types())

        def _point(self, si: Any, active: Any) -> Any:
            x, y = draft_position(si, self.uv_size)
            with dr.suspend_grad():
                hit = self.model.locate(x, y, plain(si.wi), active)
            point = self.model.at(hit.x, hit.y, hit.back, hit.hole)
            if self.albedo is not None:
                tint = plain(clip(self.albedo.eval(si, active), 0, 1))
                point.albedos.diffuse_reflect = point.albedos.diffuse_reflect * tint
                point.albedos.diffuse_transmit = point.albedos.diffuse_transmit * tint
            return point

        def eval(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            point = self._point(si, active)
            return mi.Spectrum(self.model.evaluate(point, plain(wo), plain(si.wi), active))

        def pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            point = self._point(si, active)
            return dr.select(active, self.model.pdf(point, plain(wo), plain(si.wi)), 0)

        def eval_pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self._value_and_pdf(self._point(si, active), si, wo, active)

        def sample(self, ctx: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> Any:
            return self._drawn(self._point(si, active), si, sample1, sample2, active)

        def eval_pdf_sample(
            self, ctx: Any, si: Any, wo: Any, sample1: Any, sample2: Any, active: Any = True
        ) -> Any:
            # The yarn point is searched once for both.
            point = self._point(si, active)
            value, pdf = self._value_and_pdf(point, si, wo, active)
            drawn, weight = self._drawn(point, si, sample1, sample2, active)
            return value, pdf, drawn, weight

        def eval_and_null_transmission(
            self, ctx: Any, si: Any, wo: Any, active: Any = True, entering: Any = True
        ) -> tuple[Any, Any]:
            """`eval` of active lanes and `eval_null_transmission` of entering ones: one search for both."""
            point = self._point(si, active | entering)
            value = self.model.evaluate(point, plain(wo), plain(si.wi), active)
            through = self.model.straight_through(point, plain(si.wi))
            return mi.Spectrum(value), mi.Spectrum(dr.select(entering, through, 0))

        def eval_null_transmission(self, si: Any, active: Any = True) -> Any:
            point = self._point(si, active)
            return mi.Spectrum(dr.select(active, self.model.straight_through(point, plain(si.wi)), 0))

        def eval_diffuse_reflectance(self, si: Any, active: Any = True) -> Any:
            point = self._point(si, active)
            return mi.Spectrum(dr.select(active & ~point.hole, point.albedos.diffuse_reflect, 0))

        def _value_and_pdf(self, point: Any, si: Any, wo: Any, active: Any) -> Any:
            light, view = plain(wo), plain(si.wi)
            value = self.model.evaluate(point, light, view, active)
            return mi.Spectrum(value), dr.select(active, self.model.pdf(point, light, view), 0)

        def _drawn(self, point: Any, si: Any, choice: Any, square: Any, active: Any) -> Any:
            types = variant_types()
            drawn = self.model.sample(point, plain(si.wi), choice, types.Vector2(square), active)
            return bsdf_sample(drawn, si, active)

        def to_string(self) -> str:
            width, height = self.fabric.repeat_mm
            picks, ends = self.fabric.layout().warp_on_top.shape
            return (
                f'WovenPoint[\n  fabric = "{self.fabric.name}",\n  draft = {ends} ends × {picks} picks,\n'
                f"  repeat = {width:.4g} × {height:.4g} mm,\n"
                f"  uv_size = {self.uv_size.x[0]:.6g} × {self.uv_size.y[0]:.6g} mm,\n"
                f"  albedo = {'none' if self.albedo is None else self.albedo.class_name()}\n]"
            )

    return WovenPoint
