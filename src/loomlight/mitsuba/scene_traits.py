"""What the integrator asks of BSDFs, ours and those of Mitsuba alike, and what a scene's are together.

`SurfaceBsdf` is the whole of it. A model's BSDF answers it by itself, any other by way of `ForeignBsdf`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

import drjit as dr
import mitsuba as mi

from loomlight.assets.sources import Source
from loomlight.core.arrays import Color3, Float, Mask
from loomlight.mitsuba.bsdf_samples import FILTERS
from loomlight.mitsuba.model_bsdf import model_bsdf_class


class SurfaceBsdf(Protocol):
    """A BSDF as the integrator asks it.

    Mitsuba's own calls ask for one thing after another, and BSDFs written in Python would work out anew for
    each what the view sees. Each call here asks for all that a vertex of a path needs.

    Attributes:
        filters: it averages over footprints.
        has_holes: it may let light pass straight through.
        lets_light_through: as much that it would be seen in a shadow.
        symbolic_calls: Dr.Jit may trace it in symbolic calls; see `Model.symbolic`.
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
    source = None

    def eval_and_null_transmission(self, *_: Any) -> tuple[Color3, Color3]:
        """Nothing."""
        return mi.Spectrum(0), mi.Spectrum(0)

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

    def surface(self, bsdf: Any) -> SurfaceBsdf:
        """A BSDF of a call as it was adapted: Dr.Jit traces those within instances and other scenes too."""
        if bsdf not in self._adapted:
            self._adapted[bsdf] = surface_bsdf(bsdf)
        return self._adapted[bsdf]
