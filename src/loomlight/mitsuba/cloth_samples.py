"""What every BSDF of cloth tells Mitsuba of its lobes, and its samples in Mitsuba's terms."""

from __future__ import annotations

from typing import Any
from weakref import WeakSet

import drjit as dr
import mitsuba as mi

from loomlight.core.backend import ArrayTypes, array_types
from loomlight.scattering.point import DirectionSample

# Places of lobes in `m_components`.
_REFLECTION, _TRANSMISSION, _NULL = 0, 2, 4
# Every BSDF of cloth that there is: Dr.Jit traces them all, whichever scene they belong to.
CLOTHS: WeakSet[Any] = WeakSet()


def declare_lobes(bsdf: Any) -> None:
    """Sets components and flags: reflection and transmission, diffuse and glossy, and holes; both faces.

    The BSDF is one of `CLOTHS` from then on.
    """
    CLOTHS.add(bsdf)
    flags: Any = mi.BSDFFlags
    both = flags.FrontSide | flags.BackSide | flags.SpatiallyVarying | flags.Anisotropic
    bsdf.m_components = [
        flags.DiffuseReflection | both,
        flags.GlossyReflection | both,
        flags.DiffuseTransmission | both,
        flags.GlossyTransmission | both,
        flags.Null | flags.FrontSide | flags.BackSide | flags.SpatiallyVarying,
    ]
    bsdf.m_flags = bsdf.m_components[0]
    for component in bsdf.m_components[1:]:
        bsdf.m_flags = bsdf.m_flags | component


def tell_pixel_samples(samples: int) -> None:
    """Tells every cloth that averages over footprints how many samples share a pixel."""
    for cloth in CLOTHS:
        # The number is kept beside the array: while a frozen function records, arrays cannot be read.
        if getattr(cloth, "pixel_samples_told", samples) != samples:
            cloth.pixel_samples_told = samples
            cloth.pixel_samples = dr.opaque(type(cloth.pixel_samples), samples)


def bsdf_sample(drawn: DirectionSample, si: Any, active: Any) -> tuple[Any, Any]:
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
    bs.sampled_type = dr.select(drawn.passes, mi.UInt32(+flags.Null), scattered)
    lobe = dr.select(same_side, mi.UInt32(_REFLECTION), mi.UInt32(_TRANSMISSION))
    bs.sampled_component = dr.select(drawn.passes, mi.UInt32(_NULL), lobe)
    return bs, mi.Spectrum(dr.select(active, drawn.weight, 0))


def variant_types() -> ArrayTypes:
    """The array types of the current variant."""
    return array_types(mi.Float)


def plain(value: Any) -> Any:
    """A Mitsuba vector or colour as the three-component array that the physics uses."""
    return variant_types().Vector3(value.x, value.y, value.z)
