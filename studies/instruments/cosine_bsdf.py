"""A Mitsuba BSDF of the front that draws directions by the cosine, for values that any function gives."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Mask


def cosine_bsdf(value: Callable[[Any, Any], Any], flags: int = 0) -> Any:
    """The BSDF.

    Args:
        value: of a surface interaction and directions towards the light: f·cos, 1/sr, 0 below the horizon.
        flags: of `mi.BSDFFlags`, beside those of a glossy front that varies over the surface.
    """
    base: Any = mi.BSDF
    lobe = int(mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide | mi.BSDFFlags.SpatiallyVarying) | flags

    class CosineBsdf(base):
        """Values of the function."""

        def __init__(self) -> None:
            super().__init__(mi.Properties())
            self.m_components = [lobe]
            self.m_flags = lobe

        def eval(self, ctx: Any, si: Any, wo: Any, active: Mask = True) -> Any:
            return dr.select(active, value(si, wo), 0)

        def pdf(self, ctx: Any, si: Any, wo: Any, active: Mask = True) -> Any:
            above = active & (wo.z > 0) & (si.wi.z > 0)
            return dr.select(above, mi.warp.square_to_cosine_hemisphere_pdf(wo), 0)

        def eval_pdf(self, ctx: Any, si: Any, wo: Any, active: Mask = True) -> Any:
            return self.eval(ctx, si, wo, active), self.pdf(ctx, si, wo, active)

        def sample(self, ctx: Any, si: Any, sample1: Any, sample2: Any, active: Mask = True) -> Any:
            bs: Any = dr.zeros(mi.BSDFSample3f)
            bs.wo = mi.warp.square_to_cosine_hemisphere(sample2)
            bs.pdf = self.pdf(ctx, si, bs.wo, active)
            bs.eta = 1.0
            bs.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
            drawn = self.eval(ctx, si, bs.wo, active)
            return bs, dr.select(bs.pdf > 0, drawn / bs.pdf, 0)

    return CosineBsdf()
