"""Where a path is, and how scattering takes it on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Float, Mask
from loomlight.mitsuba.ray_cone import opening


@dataclass
class PathState:
    """Where a path is, and how it got there.

    Attributes:
        ray: from the last surface.
        active: lanes that go on.
        β: throughput.
        η: product of the relative indices of refraction.
        depth: segments, without passing through holes.
        scattered: it has scattered.
        width, spread: of the ray cone at the ray's origin.
        vertex, vertex_pdf, vertex_delta: where the path scattered last, the density of its direction, and
            whether that was a delta: both strategies that reach an emitter start there.
    """

    ray: mi.Ray3f
    active: Any
    β: Any
    η: Any
    depth: Any
    scattered: Any
    width: Any
    spread: Any
    vertex: Any
    vertex_pdf: Any
    vertex_delta: Any

    @classmethod
    def begin(cls, ray: mi.Ray3f, active: Mask, width: Float, spread: Float) -> PathState:
        """The camera's rays."""
        return cls(
            ray=mi.Ray3f(dr.detach(ray)),
            active=mi.Bool(active),
            β=mi.Spectrum(1),
            η=mi.Float(1),
            depth=mi.UInt32(0),
            scattered=mi.Bool(False),
            width=mi.Float(width),
            spread=mi.Float(spread),
            vertex=mi.Point3f(ray.o),
            vertex_pdf=mi.Float(1),
            vertex_delta=mi.Bool(True),
        )

    def scattered_by(
        self, si: mi.SurfaceInteraction3f, scattering: Any, bounced: Mask, passed: Mask, samples: Float
    ) -> PathState:
        """The path beyond a surface.

        Args:
            scattering: what its BSDF drew.
            bounced: lanes that scatter there.
            passed: lanes that pass straight through a hole.
            samples: of a pixel.
        """
        bs = scattering.sample
        delta = mi.has_flag(bs.sampled_type, mi.BSDFFlags.Delta)
        return PathState(
            ray=si.spawn_ray(si.to_world(bs.wo)),
            active=bounced | passed,
            β=self.β * scattering.weight,
            η=self.η * bs.eta,
            depth=self.depth + dr.select(bounced, mi.UInt32(1), 0),
            scattered=self.scattered | bounced,
            width=self.width,
            spread=self.spread + dr.select(bounced & ~delta, opening(bs.pdf, samples), 0),
            vertex=dr.select(bounced, si.p, self.vertex),
            vertex_pdf=dr.select(bounced, bs.pdf, self.vertex_pdf),
            vertex_delta=dr.select(bounced, delta, self.vertex_delta),
        )
