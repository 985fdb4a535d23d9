"""Flags, samples and vectors of models' BSDFs in Mitsuba's terms."""

from __future__ import annotations

from typing import Any
from weakref import WeakSet

import drjit as dr
import mitsuba as mi

from loomlight.core.backend import ArrayTypes, array_types
from loomlight.mitsuba.variants import TURN
from loomlight.scattering.point import DirectionSample

# Places of lobes in `m_components`.
_REFLECTION, _TRANSMISSION, _NULL = 0, 2, 4
# A flag of BSDFs beside those of `mi.BSDFFlags`: they average over footprints. BSDFs around them pass it on.
FILTERS = 1 << 30
# Every BSDF of a model that there is: Dr.Jit traces them all, whichever scene they belong to.
_MODEL_BSDFS: WeakSet[Any] = WeakSet()


def model_bsdfs() -> list[Any]:
    """Every BSDF of a model that there is now; other threads may make more of them meanwhile."""
    with TURN:
        return list(_MODEL_BSDFS)


def declare_lobes(bsdf: mi.BSDF, has_holes: bool, filters: bool) -> None:
    """Sets components and flags: reflection and transmission, diffuse and glossy, and holes; both faces.

    Args:
        filters: it averages over footprints.

    The BSDF is one of `model_bsdfs` from then on.
    """
    with TURN:
        _MODEL_BSDFS.add(bsdf)
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


def set_samples_per_pixel(samples: int) -> None:
    """Sets how many samples share a pixel, for all BSDFs of models."""
    for bsdf in model_bsdfs():
        # The number is kept beside the array: while a frozen function records, arrays cannot be read.
        if bsdf.samples_per_pixel != samples:
            bsdf.samples_per_pixel = samples
            bsdf.pixel_samples = dr.opaque(type(bsdf.pixel_samples), samples)


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
