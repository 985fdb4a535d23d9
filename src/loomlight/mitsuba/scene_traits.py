"""Traits of a scene that an integrator needs before it traces it."""

from __future__ import annotations

from dataclasses import dataclass

import mitsuba as mi

from loomlight.mitsuba.bsdf_samples import FILTERS


@dataclass(frozen=True)
class SceneTraits:
    """Facts that decide what is traced at all.

    Attributes:
        holes: some surface lets light pass straight through.
        porous_shadows: some surface lets through enough light to be seen in its shadow.
        hittable_emitters: some emitter can be hit by a ray: it has an extent, or lies all around.
        filters: some surface averages over footprints.
        filtered_holes: some surface does, and lets light pass straight through.
    """

    holes: bool
    porous_shadows: bool
    hittable_emitters: bool
    filters: bool
    filtered_holes: bool

    @classmethod
    def of(cls, scene: mi.Scene) -> SceneTraits:
        """The traits of a scene; instances count as surfaces with holes."""
        surfaces = [(shape.class_name() == "Instance", shape.bsdf()) for shape in scene.shapes()]
        return cls(
            holes=any(instance or _has_holes(bsdf) for instance, bsdf in surfaces),
            porous_shadows=any(
                instance or (_has_holes(bsdf) and getattr(bsdf, "lets_light_through", True))
                for instance, bsdf in surfaces
            ),
            hittable_emitters=any(
                not mi.has_flag(emitter.flags(), mi.EmitterFlags.Delta) for emitter in scene.emitters()
            ),
            filters=any(_filters(shape.bsdf()) for shape in scene.shapes()),
            filtered_holes=any(
                _filters(shape.bsdf()) and _has_holes(shape.bsdf()) for shape in scene.shapes()
            ),
        )


def is_symbolic(scene: mi.Scene) -> bool:
    """Whether Dr.Jit may trace every surface of the scene in symbolic calls; see `Model.symbolic`."""
    return all(
        shape.bsdf() is None or getattr(shape.bsdf(), "symbolic_calls", True) for shape in scene.shapes()
    )


def _filters(bsdf: mi.BSDF) -> bool:
    return bsdf is not None and bool(bsdf.flags() & FILTERS)


def _has_holes(bsdf: mi.BSDF) -> bool:
    return bsdf is not None and bool(mi.has_flag(bsdf.flags(), mi.BSDFFlags.Null))
