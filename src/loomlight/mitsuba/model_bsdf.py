"""Every model as a Mitsuba BSDF: one plugin class, which knows models by their interface alone."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, ClassVar
from weakref import WeakSet

import drjit as dr
import mitsuba as mi

from loomlight.assets.sources import Source
from loomlight.core.arrays import Color3, Mask
from loomlight.core.backend import clip
from loomlight.core.errors import InputError
from loomlight.core.frozen import leaves
from loomlight.mitsuba.bsdf_samples import bsdf_sample, declare_lobes, pixel_samples, plain, variant_types
from loomlight.mitsuba.call_modes import nested, warn_of_light_paths, warn_of_missing_uv, warn_of_slow_calls
from loomlight.mitsuba.cloth_uv import draft_footprint, uv_footprint
from loomlight.mitsuba.filtered_texture import FilteredTexture
from loomlight.mitsuba.live_edits import LiveEdits, require_valid_edits
from loomlight.mitsuba.model_props import model_of_props, number_of_props, uv_size_of
from loomlight.mitsuba.variants import TURN
from loomlight.models.interface import FootprintBsdf, Model, Parameter
from loomlight.models.registry import MODELS

# Surfaces with less open area than this cast the shadow of one without: a thousandth of the light, which is
# three steps of 8-bit sRGB on white cloth where nothing else brightens the shadow.
_MIN_OPEN_AREA = 1e-3
# Millimetres; far below a fibre.
_MIN_UV_SIZE = 1e-6


@dataclass(frozen=True)
class GivenModel:
    """The parts of a BSDF.

    Attributes:
        model: what answers.
        uv_size_mm: millimetres per unit of u and of v.
    """

    model: Model
    uv_size_mm: tuple[float, float]


def model_bsdf_class() -> Any:
    """The plugin's class in the current variant: Mitsuba's base classes differ from one to another."""
    return _class_of(mi.variant())


def model_bsdfs() -> list[Any]:
    """Every BSDF of a model that there is now; other threads may make more of them meanwhile."""
    with TURN:
        return list(model_bsdf_class().alive)


@cache
def _class_of(_variant: str) -> Any:
    return made_class()


def made_class() -> Any:
    """The class anew, derived from what `mi.BSDF` is now."""
    base: Any = mi.BSDF

    class ModelBsdf(base):
        """A surface whose scattering a multi-scale model describes; `footprint_path` hands it footprints.

        Parameters (see `model_props` for the model's own):
            uv_size: millimetres per unit of u and of v, "x,y" or a 2-vector; of fabrics 100 mm.
            uv_scale: the same in repeats of the source.
            albedo: a texture over the mesh's uv, averaged over footprints; the diffuse albedos are multiplied
                by it, clipped to [0, 1].
            pixel_angle: angle of a pixel seen from the camera, radians, for integrators that hand over no
                footprint; 0 (default).

        Scene parameters are the model's (`Model.parameters`), ``uv_size`` and those of ``albedo``.

        Attributes:
            model: what answers.
            uv_size: millimetres per unit of u and of v.
            symbolic_calls: whether Dr.Jit may trace it symbolically; all tables are on the device already.
            lets_light_through: whether as much goes straight through holes that it would be seen in a shadow.
            arrays: all arrays that it holds, for frozen functions.
            literals: numbers of the model that kernels hold: where they change, they are compiled anew.
            alive: all there are, of whichever scene: Dr.Jit traces them all.
        """

        alive: ClassVar[WeakSet[Any]] = WeakSet()

        def __init__(self, props: Any, name: str, given: GivenModel | None = None) -> None:
            """
            Args:
                name: of the model.
                given: what properties would describe, where it is at hand.
            """
            # Mitsuba's part comes last: from then on renders on other threads trace this BSDF too, and they
            # must find all of it.
            if given is None:
                model = model_of_props(props, name)
                given = GivenModel(model, uv_size_of(props, model.source))
            self.uv_size = mi.Vector2f(given.uv_size_mm)
            self.albedo = props.get_texture("albedo", 1.0) if "albedo" in props else None
            radians = "an angle in radians, such as 0.001"
            self.pixel_angle = number_of_props(props, "pixel_angle", 0.0, radians, least=0.0)
            dr.make_opaque(self.uv_size)
            self.arrays: list[Any] = []
            self._texture: FilteredTexture | None = None
            self._was_traced = False
            self._set_model(given.model)
            self._filter_albedo()
            super().__init__(props)
            declare_lobes(self, self.has_holes, self.filters)
            with TURN:
                self.alive.add(self)

        @property
        def source(self) -> Source:
            """What the model is made of."""
            return self.model.source

        @property
        def filters(self) -> bool:
            """Whether it averages over footprints."""
            return self.model.filters

        @property
        def has_holes(self) -> bool:
            """Whether light may pass straight through."""
            return self.model.has_holes

        def set_source(self, source: Source) -> None:
            """Becomes the BSDF of another source; `mi.traverse` has to be called again.

            A BSDF put in its place would be another instance, for which kernels are compiled anew.

            Raises:
                InputError: a name in place of a source, or a source that the model cannot handle.
            """
            if isinstance(source, str | os.PathLike):
                raise InputError(f"{source!r} is a name: hand over the fabric, loomlight.load({source!r}).")
            self._set_model(self.model.with_source(source))

        def _set_model(self, model: Model) -> None:
            self.symbolic_calls = model.symbolic
            self._parameters = dict(model.parameters(variant_types()))
            self.model = model.bound_to(self._parameters)
            self._shown = {"uv_size": Parameter(self.uv_size, low=_MIN_UV_SIZE, unit="mm")}
            self._shown |= self._parameters
            self._upload_parameters(model_changed=True)
            self.edits = LiveEdits(self._shown)

        def traverse(self, callback: Any) -> None:
            fixed, free = mi.ParamFlags.NonDifferentiable, mi.ParamFlags.Differentiable
            for name, parameter in self._shown.items():
                callback.put(name, parameter.value, free if parameter.differentiable else fixed)
            if self.albedo is not None:
                callback.put("albedo", self.albedo, fixed if self.model.filters else free)

        def parameters_changed(self, keys: Any) -> None:
            # Mitsuba updates one BSDF after another: a wrong edit of any must find all as they were.
            with TURN:
                cloths = list(self.alive)
            require_valid_edits((cloth.label, cloth.edits) for cloth in cloths)
            self._require_no_albedo_derivatives()
            try:
                self._follow(keys)
            except InputError as error:
                self.edits.take_back()
                raise InputError(f"{self.label}: {error}") from error
            self.edits.keep()

        def _follow(self, keys: Any) -> None:
            changed = self.edits.changed() & self._parameters.keys()
            before = self.model
            if changed:
                self.model = self.model.updated(self._parameters, changed)
            # Mitsuba names what lies deeper by the last part of its name.
            if any(key.startswith("albedo") and key not in changed for key in keys):
                self._filter_albedo()
            self._upload_parameters(model_changed=self.model is not before)

        def _upload_parameters(self, model_changed: bool) -> None:
            """Puts what calls use on the device: symbolic calls may not upload anything."""
            # Equal literals are one variable until one is edited, which frozen functions would notice.
            fixed = [value for value in self._parameters.values() if not value.differentiable]
            dr.make_opaque([parameter.value for parameter in fixed])
            if model_changed:
                self.model.upload(variant_types())
            # Dr.Jit looks for arrays in the attributes of BSDFs, and no deeper.
            self.arrays = []
            self.arrays = leaves(self)
            self.lets_light_through = not self.model.filters or self.model.open_area > _MIN_OPEN_AREA
            self.literals = (*self.model.literals(), float(self.lets_light_through))

        @property
        def label(self) -> str:
            """Its name in messages."""
            return str(self.id()) or MODELS[self.model.name].plugin

        def _require_no_albedo_derivatives(self) -> None:
            if self._texture is None or not dr.grad_enabled([value for _, value in mi.traverse(self.albedo)]):
                return
            raise InputError(
                f"{self.label}.albedo has no derivatives, as its means over footprints are computed "
                "beforehand: woven_point has them."
            )

        def _filter_albedo(self) -> None:
            filters = self.albedo is not None and self.model.filters
            self._texture = FilteredTexture(self.albedo) if filters else None

        def _at(self, si: mi.SurfaceInteraction3f, active: Mask) -> FootprintBsdf:
            """The query of the view: everything but the light."""
            if not self._was_traced:
                self._was_traced = True
                warn_of_missing_uv(self, si)
            if not self.symbolic_calls:
                warn_of_slow_calls(MODELS[self.model.name].plugin)
            edges = uv_footprint(si, self.pixel_angle)
            footprint = replace(draft_footprint(si, self.uv_size, edges), samples=pixel_samples())
            view = dr.select(_is_seen(si), si.wi, mi.Vector3f(0, 0, 1))
            footprint, tint = self.model.on_cloth(footprint), self._tint(si, edges, active)
            return self.model.at(plain(view), footprint, tint, active)

        def _tint(self, si: mi.SurfaceInteraction3f, edges: tuple[Any, Any], active: Mask) -> Color3 | None:
            if self.albedo is None:
                return None
            if self._texture is not None:
                return plain(clip(self._texture.over(si, *edges, active), 0, 1))
            return plain(clip(self.albedo.eval(si, active), 0, 1))

        @nested
        def eval(self, ctx: mi.BSDFContext, si: mi.SurfaceInteraction3f, wo: Any, active: Mask = True) -> Any:
            warn_of_light_paths(ctx, self.label)
            at, active = self._at(si, active), active & _is_seen(si)
            return mi.Spectrum(dr.select(active, at.value(plain(wo), active), 0))

        @nested
        def pdf(self, ctx: mi.BSDFContext, si: mi.SurfaceInteraction3f, wo: Any, active: Mask = True) -> Any:
            return dr.select(active & _is_seen(si), self._at(si, active).pdf(plain(wo)), 0)

        @nested
        def eval_pdf(
            self, ctx: mi.BSDFContext, si: mi.SurfaceInteraction3f, wo: Any, active: Mask = True
        ) -> Any:
            active &= _is_seen(si)
            value, pdf = self._at(si, active).value_and_pdf(plain(wo), active)
            return mi.Spectrum(dr.select(active, value, 0)), dr.select(active, pdf, 0)

        @nested
        def sample(
            self,
            ctx: mi.BSDFContext,
            si: mi.SurfaceInteraction3f,
            sample1: Any,
            sample2: Any,
            active: Mask = True,
        ) -> Any:
            warn_of_light_paths(ctx, self.label)
            drawn = self._at(si, active).sample(sample1, variant_types().Vector2(sample2))
            return bsdf_sample(drawn, si, active & _is_seen(si))

        @nested
        def eval_pdf_sample(self, *arguments: Any) -> Any:
            return self.eval_pdf_sample_and_null_transmission(*arguments)[:-1]

        def eval_pdf_sample_and_null_transmission(
            self,
            ctx: mi.BSDFContext,
            si: mi.SurfaceInteraction3f,
            wo: Any,
            sample1: Any,
            sample2: Any,
            active: Mask = True,
        ) -> tuple[Any, ...]:
            """`eval_pdf_sample` and `eval_null_transmission`, for less than both."""
            u, active = variant_types().Vector2(sample2), active & _is_seen(si)
            value, pdf, drawn, null_transmission = self._at(
                si, active
            ).value_pdf_sample_and_null_transmission(plain(wo), sample1, u)
            value = mi.Spectrum(dr.select(active, value, 0))
            null = mi.Spectrum(dr.select(active, null_transmission, 0))
            return value, dr.select(active, pdf, 0), *bsdf_sample(drawn, si, active), null

        @nested
        def eval_and_null_transmission(
            self,
            ctx: mi.BSDFContext,
            si: mi.SurfaceInteraction3f,
            wo: Any,
            active: Mask = True,
            entering: Mask = True,
        ) -> tuple[Any, Any]:
            """`eval` of active lanes and `eval_null_transmission` of entering ones, for less than both."""
            active, entering = active & _is_seen(si), entering & _is_seen(si)
            at = self._at(si, active | entering)
            value, null_transmission = at.value_and_null_transmission(plain(wo), active)
            value = mi.Spectrum(dr.select(active, value, 0))
            return value, mi.Spectrum(dr.select(entering, null_transmission, 0))

        @nested
        def eval_null_transmission(self, si: mi.SurfaceInteraction3f, active: Mask = True) -> Any:
            null = self._at(si, active).null_transmission
            return mi.Spectrum(dr.select(active & _is_seen(si), null, 0))

        @nested
        def eval_diffuse_reflectance(self, si: mi.SurfaceInteraction3f, active: Mask = True) -> Any:
            reflectance = self._at(si, active).diffuse_reflectance
            return mi.Spectrum(dr.select(active & _is_seen(si), reflectance, 0))

        def to_string(self) -> str:
            facts = {
                **self.model.facts(),
                "uv_size": f"{self.uv_size.x[0]:.6g} × {self.uv_size.y[0]:.6g} mm",
                "albedo": "none" if self.albedo is None else self.albedo.class_name(),
            }
            lines = ",\n".join(f"  {name} = {fact}" for name, fact in facts.items())
            return f"{MODELS[self.model.name].plugin}[\n{lines}\n]"

    return ModelBsdf


def _is_seen(si: mi.SurfaceInteraction3f) -> Any:
    """False of a view that is no direction: Mitsuba asks for interactions that are none, whose `wi` is 0."""
    return dr.squared_norm(si.wi) > 0
