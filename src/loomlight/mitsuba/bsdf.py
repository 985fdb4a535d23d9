"""BSDFs: what the integrator asks of any, and every model as one of Mitsuba's.

`SurfaceBsdf` is all that the integrator asks. A BSDF of a model answers it by itself, any other by way of
`ForeignBsdf`; `SceneTraits` adapts those of a scene once, before it is traced. `ModelBsdf` is the one class
of all models' plugins, which knows them by their interface alone. Below it are its parts: the way from a
mesh's uv to the draft, lobes and samples in Mitsuba's terms, the modes in which Dr.Jit traces its calls.
"""

from __future__ import annotations

import functools
import itertools
import os
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, ClassVar, Protocol, TypeVar
from weakref import WeakSet

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Color3, Float, Mask
from loomlight.core.backend import ArrayTypes, array_types, clip
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.footprint import Footprint
from loomlight.core.frozen import leaves
from loomlight.mesh.picture_places import PicturePlace
from loomlight.mitsuba.filtered_texture import FilteredTexture
from loomlight.mitsuba.painting import Painted, painted_of
from loomlight.mitsuba.pixels import cone_partials
from loomlight.mitsuba.props import (
    LiveEdits,
    model_of_props,
    number_of_props,
    require_valid_edits,
    uv_size_of,
)
from loomlight.mitsuba.variants import TURN
from loomlight.models.interface import FootprintBsdf, Model, Parameter
from loomlight.models.registry import MODELS
from loomlight.scattering.point import DirectionSample, Tint
from loomlight.sources.kinds import Source


class SurfaceBsdf(Protocol):
    """A BSDF as the integrator asks it.

    Mitsuba's own calls ask for one thing after another, and BSDFs written in Python would work out anew for
    each what the view sees. Each call here asks for all that a vertex of a path needs.

    Attributes:
        filters: it averages over footprints.
        has_holes: it may let light pass straight through.
        lets_light_through: as much that it would be seen in a shadow.
        symbolic_calls: Dr.Jit may trace it in symbolic calls; see `Model.symbolic`.
        picture_places: where its maps lie, in the order of `painting.attribute_name`.
        source: of which its model is made; None where it has none.
    """

    @property
    def filters(self) -> bool: ...
    @property
    def has_holes(self) -> bool: ...
    @property
    def lets_light_through(self) -> bool: ...
    @property
    def symbolic_calls(self) -> bool: ...
    @property
    def picture_places(self) -> tuple[PicturePlace, ...]: ...
    @property
    def source(self) -> Source | None: ...

    def eval_and_null_transmission(
        self,
        ctx: mi.BSDFContext,
        si: mi.SurfaceInteraction3f,
        wo: Any,
        active: Mask,
        entering: Mask,
    ) -> tuple[Color3, Color3]:
        """f·cos [3] of active lanes, and the share [3] that passes straight through, of entering ones."""

    def roughness(self, si: mi.SurfaceInteraction3f, active: Mask) -> Float:
        """α of what is seen, 0 to 1."""

    def eval_pdf_sample_and_null_transmission(
        self,
        ctx: mi.BSDFContext,
        si: mi.SurfaceInteraction3f,
        wo: Any,
        sample1: Float,
        sample2: Any,
        active: Mask,
    ) -> tuple[Color3, Float, Any, Color3, Color3]:
        """f·cos [3] and density towards `wo`, a sample and its weight [3], and what passes on [3]."""


class ForeignBsdf:
    """A BSDF that knows nothing of footprints: Mitsuba's, or what users have written."""

    symbolic_calls = True
    picture_places = ()
    source = None

    def __init__(self, bsdf: mi.BSDF) -> None:
        self._bsdf = bsdf
        # Of the BSDFs within it, which it passes on.
        self.filters = bool(bsdf.flags() & FILTERS)
        self.has_holes = self.lets_light_through = bool(mi.has_flag(bsdf.flags(), mi.BSDFFlags.Null))

    def eval_and_null_transmission(
        self,
        ctx: mi.BSDFContext,
        si: mi.SurfaceInteraction3f,
        wo: Any,
        active: Mask,
        entering: Mask,
    ) -> tuple[Color3, Color3]:
        """Both, by a call each."""
        value: Any = self._bsdf.eval(ctx, si, wo, active)
        return value, self._bsdf.eval_null_transmission(si, entering)

    def roughness(self, si: mi.SurfaceInteraction3f, active: Mask) -> Float:
        """α where the BSDF shows it as an attribute; else 0 of smooth mirrors, 1 of all others."""
        if self._has("alpha"):
            return self._bsdf.eval_attribute_1("alpha", si, active)
        if self._has("alpha_u"):
            u, v = (self._bsdf.eval_attribute_1(name, si, active) for name in ("alpha_u", "alpha_v"))
            return dr.sqrt(u * v)
        if self._has("roughness"):
            # Of the principled BSDF, whose α is its square.
            return dr.square(self._bsdf.eval_attribute_1("roughness", si, active))
        return mi.Float(0 if mi.has_flag(self._bsdf.flags(), mi.BSDFFlags.DeltaReflection) else 1)

    def _has(self, name: str) -> bool:
        return bool(dr.all(self._bsdf.has_attribute(name)))

    def eval_pdf_sample_and_null_transmission(
        self,
        ctx: mi.BSDFContext,
        si: mi.SurfaceInteraction3f,
        wo: Any,
        sample1: Float,
        sample2: Any,
        active: Mask,
    ) -> tuple[Color3, Float, Any, Color3, Color3]:
        """All, by a call each."""
        asked: Any = self._bsdf.eval_pdf_sample(ctx, si, wo, sample1, sample2, active)
        # Only where the pixel's share of what lies behind is computed.
        through = self._bsdf.eval_null_transmission(si, active) if self.filters else mi.Spectrum(0)
        return *asked, through


class NoBsdf:
    """Where there is none: it takes all light."""

    filters = has_holes = lets_light_through = False
    symbolic_calls = True
    picture_places = ()
    source = None

    def eval_and_null_transmission(self, *_: Any) -> tuple[Color3, Color3]:
        """Nothing."""
        return mi.Spectrum(0), mi.Spectrum(0)

    def roughness(self, *_: Any) -> Float:
        """That of a diffuse surface."""
        return mi.Float(1)

    def eval_pdf_sample_and_null_transmission(self, *_: Any) -> tuple[Color3, Float, Any, Color3, Color3]:
        """Nothing, and no direction."""
        return mi.Spectrum(0), mi.Float(0), dr.zeros(mi.BSDFSample3f), mi.Spectrum(0), mi.Spectrum(0)


def surface_bsdf(bsdf: Any) -> SurfaceBsdf:
    """A BSDF of Mitsuba, of a model or None as the integrator asks it."""
    if bsdf is None:
        return NoBsdf()
    if isinstance(bsdf, model_bsdf_class()):
        ours: SurfaceBsdf = bsdf
        return ours
    return ForeignBsdf(bsdf)


@dataclass(frozen=True)
class SceneTraits:
    """A scene prepared for the integrator: its BSDFs adapted, and facts that decide what is traced at all.

    Attributes:
        holes: some surface lets light pass straight through; instances count, as their BSDFs are hidden.
        porous_shadows: some surface lets through enough light to be seen in its shadow.
        hittable_emitters: some emitter can be hit by a ray: it has an extent, or lies all around.
        filters: some surface averages over footprints.
        filtered_holes: some surface does, and lets light pass straight through.
        symbolic: Dr.Jit may trace every surface in symbolic calls; see `Model.symbolic`.
    """

    holes: bool
    porous_shadows: bool
    hittable_emitters: bool
    filters: bool
    filtered_holes: bool
    symbolic: bool
    _adapted: dict[Any, SurfaceBsdf]

    @classmethod
    def of(cls, scene: mi.Scene) -> SceneTraits:
        """The traits of a scene as it is now."""
        adapted = {bsdf: surface_bsdf(bsdf) for bsdf in (shape.bsdf() for shape in scene.shapes())}
        surfaces = list(adapted.values())
        instances = any(shape.class_name() == "Instance" for shape in scene.shapes())
        return cls(
            holes=instances or any(each.has_holes for each in surfaces),
            porous_shadows=instances or any(each.has_holes and each.lets_light_through for each in surfaces),
            hittable_emitters=any(
                not mi.has_flag(emitter.flags(), mi.EmitterFlags.Delta) for emitter in scene.emitters()
            ),
            filters=any(each.filters for each in surfaces),
            filtered_holes=any(each.filters and each.has_holes for each in surfaces),
            symbolic=all(each.symbolic_calls for each in surfaces),
            _adapted=adapted,
        )

    def eval_and_null_transmission(
        self, ctx: mi.BSDFContext, si: mi.SurfaceInteraction3f, wo: Any, active: Mask, entering: Mask
    ) -> tuple[Color3, Color3]:
        """Each lane's answer, of the BSDF that it has met; see `SurfaceBsdf`."""

        def call(bsdf: Any, *asked: Any) -> Any:
            return self._surface(bsdf).eval_and_null_transmission(ctx, *asked)

        found: tuple[Color3, Color3] = dr.dispatch(si.bsdf(), call, si, wo, active, entering)
        return found

    def roughness(self, si: mi.SurfaceInteraction3f, active: Mask) -> Float:
        """Each lane's answer, of the BSDF that it has met; see `SurfaceBsdf`."""

        def call(bsdf: Any, *asked: Any) -> Any:
            return self._surface(bsdf).roughness(*asked)

        return dr.dispatch(si.bsdf(), call, si, active)

    def eval_pdf_sample_and_null_transmission(
        self,
        ctx: mi.BSDFContext,
        si: mi.SurfaceInteraction3f,
        wo: Any,
        sample1: Float,
        sample2: Any,
        active: Mask,
        needs_null_transmission: bool,
    ) -> tuple[Color3, Float, Any, Color3, Color3]:
        """Each lane's answer, of the BSDF that it has met; the last is 0 unless needed."""

        def call(bsdf: Any, *asked: Any) -> Any:
            answer = self._surface(bsdf).eval_pdf_sample_and_null_transmission(ctx, *asked)
            return answer if needs_null_transmission else (*answer[:-1], mi.Spectrum(0))

        found: tuple[Color3, Float, Any, Color3, Color3] = dr.dispatch(
            si.bsdf(), call, si, wo, sample1, sample2, active
        )
        return found

    def _surface(self, bsdf: Any) -> SurfaceBsdf:
        """A BSDF as it was adapted: Dr.Jit traces those within instances and of other scenes too."""
        if bsdf not in self._adapted:
            self._adapted[bsdf] = surface_bsdf(bsdf)
        return self._adapted[bsdf]


# ------------------------------------------------------------------------------------------------- ModelBsdf
# Every model as a Mitsuba BSDF: one plugin class, which knows models by their interface alone.


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
        painted: where maps show which of several models, whose source has them; None without any.
    """

    model: Model
    uv_size_mm: tuple[float, float]
    painted: Painted | None = None


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

        Parameters (see `props.py` for the model's own):
            uv_size: millimetres per unit of u and of v, "x,y" or a 2-vector; of fabrics 100 mm.
            uv_scale: the same in repeats of the source.
            albedo: a texture over the mesh's uv, averaged over footprints; the diffuse albedos are multiplied
                by it, clipped to [0, 1].
            pixel_angle: angle of a pixel seen from the camera, radians, for integrators that hand over no
                footprint; 0 (default).

        Scene parameters are the model's (`Model.parameters`), ``uv_size`` and those of ``albedo``; of a
        fabric with maps ``uv_size`` alone.

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
                painted = painted_of(model.source, name, model.options)
                given = GivenModel(model, uv_size_of(props, model.source), painted)
            self.uv_size = mi.Vector2f(given.uv_size_mm)
            self.albedo = props.get_texture("albedo", 1.0) if "albedo" in props else None
            radians = "an angle in radians, such as 0.001"
            self.pixel_angle = number_of_props(props, "pixel_angle", 0.0, radians, least=0.0)
            dr.make_opaque(self.uv_size)
            self.arrays: list[Any] = []
            self._texture: FilteredTexture | None = None
            self._was_traced = False
            self._painted = given.painted
            self._set_model(given.model if given.painted is None else given.painted.variants[0])
            self._filter_albedo()
            super().__init__(props)
            declare_lobes(self, self.has_holes, self.filters)
            with TURN:
                self.alive.add(self)

        @property
        def source(self) -> Source:
            """What the model is made of."""
            return self.model.source if self._painted is None else self._painted.source

        @property
        def picture_places(self) -> tuple[PicturePlace, ...]:
            """Where its maps lie."""
            return () if self._painted is None else self._painted.shown.places

        @property
        def _models(self) -> tuple[Model, ...]:
            return (self.model,) if self._painted is None else self._painted.variants

        @property
        def filters(self) -> bool:
            """Whether it averages over footprints."""
            return self.model.filters

        @property
        def has_holes(self) -> bool:
            """Whether light may pass straight through."""
            return any(model.has_holes for model in self._models)

        def set_source(self, source: Source) -> None:
            """Becomes the BSDF of another source; `mi.traverse` has to be called again.

            A BSDF put in its place would be another instance, for which kernels are compiled anew.

            Raises:
                InputError: a name in place of a source, or a source that the model cannot handle.
            """
            if isinstance(source, str | os.PathLike):
                raise InputError(f"{source!r} is a name: hand over the fabric, loomlight.load({source!r}).")
            if self._painted is not None or getattr(getattr(source, "fields", None), "maps", None):
                raise InputError(f"{source.name} or what it takes the place of has maps: make a new BSDF.")
            self._set_model(self.model.with_source(source))

        def _set_model(self, model: Model) -> None:
            self.symbolic_calls = model.symbolic
            # Edits of one variant would leave the others as they are.
            self._parameters = {} if self._painted else dict(model.parameters(variant_types()))
            self.model = model if self._painted else model.bound_to(self._parameters)
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
                for model in self._models:
                    model.upload(variant_types())
            # Dr.Jit looks for arrays in the attributes of BSDFs, and no deeper.
            self.arrays = []
            self.arrays = leaves(self)
            open_area = max(model.open_area for model in self._models)
            self.lets_light_through = not self.model.filters or open_area > _MIN_OPEN_AREA
            literals = itertools.chain.from_iterable(model.literals() for model in self._models)
            self.literals = (*literals, float(self.lets_light_through))

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

        def _asked(
            self, ask: Callable[..., Any], si: mi.SurfaceInteraction3f, active: Mask, *args: Any
        ) -> Any:
            """What `ask(at, si, active, *args)` answers, where `at` is all of the BSDF but the light."""
            if not self._was_traced:
                self._was_traced = True
                warn_of_missing_uv(self, si)
            if not self.symbolic_calls:
                warn_of_slow_calls(MODELS[self.model.name].plugin)
            edges = uv_footprint(si, self.pixel_angle)
            tint, active = self._tint(si, edges, active), mi.Bool(active)
            if self._painted is None:
                return ask(self._at(self.model, si, edges, tint, active), si, active, *args)
            cloth = draft_footprint(si, self.uv_size, edges)
            number, warp, weft = self._painted.shown.shown(si, edges, cloth, active)
            tint = (
                Tint(plain(warp), plain(weft)) if tint is None else Tint(tint.warp * warp, tint.weft * weft)
            )

            def of(model: Model) -> Callable[..., Any]:
                return lambda si, edges, tint, active, *args: ask(
                    self._at(model, si, edges, tint, active), si, active, *args
                )

            if len(self._models) == 1:
                return of(self._models[0])(si, edges, tint, active, *args)
            return dr.switch(number, [of(model) for model in self._models], si, edges, tint, active, *args)

        def _at(
            self,
            model: Model,
            si: mi.SurfaceInteraction3f,
            edges: tuple[Any, Any],
            tint: Tint | None,
            active: Mask,
        ) -> FootprintBsdf:
            """The query of the view: everything but the light."""
            footprint = replace(draft_footprint(si, self.uv_size, edges), samples=pixel_samples())
            view = dr.select(_is_seen(si), si.wi, mi.Vector3f(0, 0, 1))
            return model.at(plain(view), model.on_cloth(footprint), tint, active)

        def _tint(self, si: mi.SurfaceInteraction3f, edges: tuple[Any, Any], active: Mask) -> Tint | None:
            if self.albedo is None:
                return None
            if self._texture is not None:
                return Tint.of(plain(clip(self._texture.over(si, *edges, active), 0, 1)))
            return Tint.of(plain(clip(self.albedo.eval(si, active), 0, 1)))

        @nested
        def eval(self, ctx: mi.BSDFContext, si: mi.SurfaceInteraction3f, wo: Any, active: Mask = True) -> Any:
            warn_of_light_paths(ctx, self.label)

            def ask(at: FootprintBsdf, si: Any, active: Mask, wo: Any) -> Any:
                active &= _is_seen(si)
                return mi.Spectrum(dr.select(active, at.value(plain(wo), active), 0))

            return self._asked(ask, si, active, wo)

        @nested
        def pdf(self, ctx: mi.BSDFContext, si: mi.SurfaceInteraction3f, wo: Any, active: Mask = True) -> Any:
            def ask(at: FootprintBsdf, si: Any, active: Mask, wo: Any) -> Any:
                return dr.select(active & _is_seen(si), at.pdf(plain(wo)), 0)

            return self._asked(ask, si, active, wo)

        @nested
        def eval_pdf(
            self, ctx: mi.BSDFContext, si: mi.SurfaceInteraction3f, wo: Any, active: Mask = True
        ) -> Any:
            def ask(at: FootprintBsdf, si: Any, active: Mask, wo: Any) -> Any:
                active &= _is_seen(si)
                value, pdf = at.value_and_pdf(plain(wo), active)
                return mi.Spectrum(dr.select(active, value, 0)), dr.select(active, pdf, 0)

            return self._asked(ask, si, active, wo)

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

            def ask(at: FootprintBsdf, si: Any, active: Mask, choice: Any, u: Any) -> Any:
                drawn = at.sample(choice, variant_types().Vector2(u))
                return bsdf_sample(drawn, si, active & _is_seen(si))

            return self._asked(ask, si, active, sample1, sample2)

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

            def ask(at: FootprintBsdf, si: Any, active: Mask, wo: Any, choice: Any, u: Any) -> Any:
                active &= _is_seen(si)
                value, pdf, drawn, null_transmission = at.value_pdf_sample_and_null_transmission(
                    plain(wo), choice, variant_types().Vector2(u)
                )
                value = mi.Spectrum(dr.select(active, value, 0))
                null = mi.Spectrum(dr.select(active, null_transmission, 0))
                return value, dr.select(active, pdf, 0), *bsdf_sample(drawn, si, active), null

            found: tuple[Any, ...] = self._asked(ask, si, active, wo, sample1, sample2)
            return found

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

            def ask(at: FootprintBsdf, si: Any, _: Mask, wo: Any, active: Mask, entering: Mask) -> Any:
                value, null_transmission = at.value_and_null_transmission(plain(wo), active)
                value = mi.Spectrum(dr.select(active, value, 0))
                return value, mi.Spectrum(dr.select(entering, null_transmission, 0))

            active, entering = active & _is_seen(si), entering & _is_seen(si)
            found: tuple[Any, Any] = self._asked(ask, si, active | entering, wo, active, entering)
            return found

        def roughness(self, si: mi.SurfaceInteraction3f, active: Mask = True) -> Any:
            """α of what is seen, 0 to 1."""

            def ask(at: FootprintBsdf, si: Any, active: Mask) -> Any:
                return dr.select(active, mi.Float(at.roughness), 0)

            return self._asked(ask, si, active & _is_seen(si))

        @nested
        def eval_null_transmission(self, si: mi.SurfaceInteraction3f, active: Mask = True) -> Any:
            def ask(at: FootprintBsdf, si: Any, active: Mask) -> Any:
                return mi.Spectrum(dr.select(active & _is_seen(si), at.null_transmission, 0))

            return self._asked(ask, si, active)

        @nested
        def eval_diffuse_reflectance(self, si: mi.SurfaceInteraction3f, active: Mask = True) -> Any:
            def ask(at: FootprintBsdf, si: Any, active: Mask) -> Any:
                return mi.Spectrum(dr.select(active & _is_seen(si), at.diffuse_reflectance, 0))

            return self._asked(ask, si, active)

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


# ------------------------------------------------------------------------------------------ from uv to draft
# From a surface's uv to draft coordinates, the same weave on every uv convention.


def draft_position(si: mi.SurfaceInteraction3f, uv_size: Any) -> tuple[Any, Any]:
    """Draft coordinates x, y in millimetres of `si`, where `uv_size` is mm per unit of u and of v.

    The frame's y is n × x. Where dp/dv points against it (OBJ as Mitsuba loads it, glTF, mirrored islands)
    the draft counts from the other end of v, so that a Z twill stays a Z twill.
    """
    v = dr.select(_mirrored(si), 1 - si.uv.y, si.uv.y)
    return si.uv.x * mi.Float(uv_size[0]), v * mi.Float(uv_size[1])


def draft_footprint(si: mi.SurfaceInteraction3f, uv_size: Any, uv_footprint: tuple[Any, Any]) -> Footprint:
    """A footprint in draft coordinates, millimetres; see `draft_position`.

    Args:
        uv_footprint: its edges in uv.
    """
    types = array_types(mi.Float)
    turn = dr.select(_mirrored(si), mi.Float(-1), 1)

    def step(edge: Any) -> Any:
        return types.Vector2(edge.x * mi.Float(uv_size[0]), turn * edge.y * mi.Float(uv_size[1]))

    return Footprint(types.Vector2(*draft_position(si, uv_size)), *(step(edge) for edge in uv_footprint))


def uv_footprint(si: mi.SurfaceInteraction3f, pixel_angle: float) -> tuple[Any, Any]:
    """Edges of the footprint in uv, as the integrator sets them.

    Args:
        pixel_angle: of a cone from the camera, radians, where the integrator sets no footprint; 0 for none.
    """
    if pixel_angle <= 0:
        return si.duv_dx, si.duv_dy
    is_set = (dr.squared_norm(si.duv_dx) > 0) | (dr.squared_norm(si.duv_dy) > 0)
    cone = cone_partials(si, -si.to_world(si.wi), si.t * pixel_angle)
    return dr.select(is_set, si.duv_dx, cone[0]), dr.select(is_set, si.duv_dy, cone[1])


def _mirrored(si: Any) -> Any:
    return dr.dot(dr.cross(si.dp_du, si.dp_dv), si.sh_frame.n) < 0


# ------------------------------------------------------------------------------------------ lobes and samples
# Flags, samples and vectors of models' BSDFs in Mitsuba's terms, and how many samples share a pixel.


# Places of lobes in `m_components`.
_REFLECTION, _TRANSMISSION, _NULL = 0, 2, 4
# A flag beside those of `mi.BSDFFlags`: the BSDF averages over footprints. BSDFs around it pass the flag on.
FILTERS = 1 << 30
# Of the render that is going on. BSDFs within Mitsuba's own, such as a mask or a normal map, are called by
# these, whose calls have no place for it.
_PIXEL_SAMPLES: ContextVar[Float] = ContextVar("pixel_samples", default=1)


def declare_lobes(bsdf: mi.BSDF, has_holes: bool, filters: bool) -> None:
    """Sets components and flags: reflection and transmission, diffuse and glossy, and holes; both faces.

    Args:
        filters: it averages over footprints.
    """
    flags: Any = mi.BSDFFlags
    both = flags.FrontSide | flags.BackSide | flags.SpatiallyVarying | flags.Anisotropic
    components = [
        flags.DiffuseReflection | both,
        flags.GlossyReflection | both,
        flags.DiffuseTransmission | both,
        flags.GlossyTransmission | both,
    ]
    if has_holes:
        components.append(flags.Null | flags.FrontSide | flags.BackSide | flags.SpatiallyVarying)
    # Assigned whole: what Mitsuba hands out is a copy.
    bsdf.m_components = components
    bsdf.m_flags = components[0] | (FILTERS if filters else 0)
    for component in components[1:]:
        bsdf.m_flags = bsdf.m_flags | component


@contextmanager
def sharing_pixels(samples: Float) -> Iterator[None]:
    """While BSDFs are asked by a render of which so many samples share a pixel; 1 in any other."""
    before = _PIXEL_SAMPLES.set(samples)
    try:
        yield
    finally:
        _PIXEL_SAMPLES.reset(before)


def pixel_samples() -> Float:
    """How many samples share a pixel in the render that asks."""
    return _PIXEL_SAMPLES.get()


def bsdf_sample(drawn: DirectionSample, si: mi.SurfaceInteraction3f, active: Any) -> tuple[Any, Any]:
    """A sampled direction as (BSDFSample3f, weight)."""
    bs: Any = dr.zeros(mi.BSDFSample3f)
    bs.wo = mi.Vector3f(drawn.light)
    bs.pdf = drawn.pdf
    bs.eta = 1.0
    flags: Any = mi.BSDFFlags
    same_side = drawn.light.z * mi.Frame3f.cos_theta(si.wi) > 0
    scattered = dr.select(
        same_side, mi.UInt32(+flags.DiffuseReflection), mi.UInt32(+flags.DiffuseTransmission)
    )
    bs.sampled_type = dr.select(drawn.is_null, mi.UInt32(+flags.Null), scattered)
    lobe = dr.select(same_side, mi.UInt32(_REFLECTION), mi.UInt32(_TRANSMISSION))
    bs.sampled_component = dr.select(drawn.is_null, mi.UInt32(_NULL), lobe)
    return bs, mi.Spectrum(dr.select(active, drawn.weight, 0))


def variant_types() -> ArrayTypes:
    """The array types of the current variant."""
    return array_types(mi.Float)


def plain(value: Any) -> Any:
    """A Mitsuba vector or colour as the three-component array that the physics uses."""
    return variant_types().Vector3(value.x, value.y, value.z)


# -------------------------------------------------------------------------------------------- modes of calls
# Modes in which Dr.Jit traces the calls of a BSDF, and what is looked at while it does.


_Method = TypeVar("_Method", bound=Callable[..., Any])
_LOOPS = dr.JitFlag.SymbolicLoops
_BRANCHES = dr.JitFlag.SymbolicConditionals
# BSDFs already warned about, and other warnings already given.
_WARNED: set[str] = set()


@contextmanager
def symbolic_mode(traits: SceneTraits) -> Iterator[None]:
    """Symbolic calls and loops, unless a surface must not be traced in them; see `Model.symbolic`."""
    symbolic = traits.symbolic
    with (
        dr.scoped_set_flag(dr.JitFlag.SymbolicCalls, symbolic and dr.flag(dr.JitFlag.SymbolicCalls)),
        dr.scoped_set_flag(dr.JitFlag.SymbolicLoops, symbolic and dr.flag(dr.JitFlag.SymbolicLoops)),
    ):
        yield


def nested(method: _Method) -> _Method:
    """A method of a BSDF whose loops are symbolic within a symbolic call.

    Integrators that differentiate by automatic differentiation evaluate loops, but calls of BSDFs stay
    symbolic. Dr.Jit then makes every loop within them symbolic too, and prints a warning for each.
    """

    @functools.wraps(method)
    def call(*arguments: Any, **named: Any) -> Any:
        if not dr.flag(dr.JitFlag.SymbolicScope):
            return method(*arguments, **named)
        with dr.scoped_set_flag(_LOOPS, True), dr.scoped_set_flag(_BRANCHES, True):
            return method(*arguments, **named)

    # A type checker cannot see that `wraps` keeps the signature.
    return call  # type: ignore[return-value]


def warn_of_slow_calls(plugin: str) -> None:
    """Warns once that a BSDF with a network is traced in symbolic calls.

    Args:
        plugin: the name of the BSDF.
    """
    # Evaluated calls are traced symbolically too, once, for the types of what they return.
    if plugin in _WARNED or not (dr.flag(dr.JitFlag.SymbolicScope) and dr.flag(dr.JitFlag.SymbolicCalls)):
        return
    _WARNED.add(plugin)
    warnings.warn(
        f"{plugin} takes some 30 times as long in symbolic calls, which this integrator makes: render with "
        "footprint_path, or switch off dr.JitFlag.SymbolicCalls and dr.JitFlag.SymbolicLoops.",
        LoomlightWarning,
        stacklevel=2,
    )


def warn_of_light_paths(ctx: mi.BSDFContext, plugin: str) -> None:
    """Warns once of an integrator that traces paths from lights.

    Mean reflection is reciprocal within some per cent, transmission is not: a model's footprint, and the path
    that light takes through yarns, are those of the view.
    """
    if ctx.mode != mi.TransportMode.Importance or "light paths" in _WARNED:
        return
    _WARNED.add("light paths")
    warnings.warn(
        f"{plugin} is made for paths that begin at the camera: from lights, cloth that lets light through is "
        "up to 1.8 times too bright or dark. Render with footprint_path or path.",
        LoomlightWarning,
        stacklevel=2,
    )


def warn_of_missing_uv(bsdf: mi.BSDF, si: mi.SurfaceInteraction3f) -> None:
    """Warns of every mesh with this BSDF that has no uv coordinates.

    Mitsuba hands out the barycentric coordinates of each triangle for uv then. A BSDF does not know its
    shapes, but a call of all shapes, which Dr.Jit traces once for each, does; it computes nothing.
    """
    told: set[str] = set()

    def look(shape: Any, _: Any) -> None:
        if shape is None or not shape.is_mesh() or shape.bsdf() is not bsdf:
            return
        name = str(shape.id())
        # Shapes that Mitsuba computes, such as rectangles, count as meshes too and have uv.
        uv = [value for key, value in mi.traverse(shape) if key.endswith("texcoords")]
        if name in told or not uv or dr.width(uv) > 0:
            return
        told.add(name)
        # Mitsuba merges meshes that share a BSDF, and the merged one has no name.
        what = f'The mesh "{name}"' if name else "A mesh"
        warnings.warn(
            f"{what} has no uv coordinates: every triangle shows the same corner of the cloth. Unwrap it.",
            LoomlightWarning,
            stacklevel=2,
        )

    dr.dispatch(si.shape, look, mi.UInt32(0))
