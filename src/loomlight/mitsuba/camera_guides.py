"""What guides a denoiser: pictures of what the camera sees that have no noise of light.

Every pixel takes the same few lights, drawn from the scene's emitters by the same numbers, and no shadow.
Cloth that is averaged over footprints has its weave, its colours and its highlights in these pictures, as
sharp as in the picture itself, and free of noise.
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Color3, Mask
from loomlight.core.backend import channel_mean
from loomlight.mitsuba.bsdf_samples import FILTERS
from loomlight.mitsuba.path_vertices import MAX_PASSES, FirstFootprint
from loomlight.mitsuba.scene_traits import SceneTraits

# Rays of smaller shares end.
_LEAST_SHARE = 1e-3
# Lights by which surfaces are seen, as the two numbers that draw each: as many as samples a pixel.
_COUNT = 8


@dr.syntax
def camera_guides(
    scene: Any, traits: SceneTraits, first: FirstFootprint, ray: Any, number: Any, emitters: bool
) -> list[Any]:
    """Normal and unshadowed light of what camera rays see, through holes too.

    Args:
        first: footprints of these rays.
        number: of the sample within its pixel.
        emitters: they show.

    Returns:
        six arrays: normal of the world [3], light [3].
    """
    ray = mi.Ray3f(dr.detach(ray))
    active = mi.Bool(True)
    share, passes = mi.Spectrum(1), mi.UInt32(0)
    normal, light = mi.Vector3f(0), mi.Spectrum(0)
    while dr.hint(active, exclude=[first, traits], label="camera_guides"):
        si = scene.ray_intersect(ray, mi.RayFlags.All, coherent=True, active=active)
        bsdf = si.bsdf()
        filters = mi.Bool(traits.filters) & ((bsdf.flags() & FILTERS) != 0)
        first.set_on(si, filters)
        valid = active & si.is_valid()
        if dr.hint(emitters, mode="scalar"):
            light += share * dr.select(active, si.emitter(scene).eval(si, active), 0)
        lit, through = _seen(scene, traits, si, number, valid)
        light += share * lit
        normal += dr.select(valid, mi.Vector3f(si.sh_frame.n) * channel_mean(share * (1 - through)), 0)
        share *= dr.select(valid, through, 0)
        passes += 1
        ray = si.spawn_ray(ray.d)
        active = valid & (dr.max(share) > _LEAST_SHARE) & (passes < MAX_PASSES)
    return [*normal, *light]


def _seen(scene: Any, traits: SceneTraits, si: Any, number: Any, active: Mask) -> tuple[Color3, Color3]:
    """Reflected light and what passes straight through of a surface [3 each]."""
    # Of a plane's lattice of so many points: every pixel takes the same lights.
    numbers = mi.Point2f((mi.Float(number) + 0.5) * (1 / _COUNT), _radical_inverse(number))
    ds, weight = scene.sample_emitter_direction(si, numbers, False, active)

    def call(bsdf: Any, si: Any, light: Any, active: Any) -> Any:
        return traits.surface(bsdf).eval_and_null_transmission(mi.BSDFContext(), si, light, active, active)

    lit, through = dr.dispatch(si.bsdf(), call, si, si.to_local(ds.d), active)
    return lit * weight, through


def _radical_inverse(number: Any) -> Any:
    """Of the last three bits."""
    reversed_bits = ((number & 1) << 2) | (number & 2) | ((number >> 2) & 1)
    return (mi.Float(reversed_bits) + 0.5) * (1 / _COUNT)
