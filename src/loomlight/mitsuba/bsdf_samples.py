"""Flags, samples and vectors of models' BSDFs in Mitsuba's terms, and how many samples share a pixel."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Float
from loomlight.core.backend import ArrayTypes, array_types
from loomlight.scattering.point import DirectionSample

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
