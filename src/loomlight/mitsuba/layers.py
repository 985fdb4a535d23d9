"""Layers of a picture for other programs: what the camera sees, free of light."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import channel_mean
from loomlight.mitsuba.bsdf import FILTERS, SceneTraits
from loomlight.mitsuba.denoising import lattice_point
from loomlight.mitsuba.pixels import FirstFootprint

# Of the arrays of `camera_layers`, in their order.
_PLANES = {"albedo": slice(0, 3), "normal": slice(3, 6), "depth": slice(6, 7), "roughness": slice(7, 8)}
# Rays of smaller shares end.
_LEAST_SHARE = 1e-3


@dr.syntax
def camera_layers(
    scene: Any, traits: SceneTraits, first: FirstFootprint, ray: Any, number: Any, max_passes: int
) -> list[Any]:
    """Albedo, normal, distance and roughness of what camera rays see, through holes too.

    The albedo is the share of light from all over a surface's own side that comes to the eye: it shows the
    weave of every model, where a mean of yarns' albedos would not.

    Args:
        first: footprints of these rays.
        number: of the sample within its pixel.
        max_passes: rays that pass through so many holes end.

    Returns:
        nine arrays: albedo [3], normal of the world [3], distance from the camera's near plane and α, both
        times cover, and cover, the share of the ray that meets a surface.
    """
    ray = mi.Ray3f(dr.detach(ray))
    active = mi.Bool(True)
    share, passes, travelled = mi.Spectrum(1), mi.UInt32(0), mi.Float(0)
    albedo, normal = mi.Spectrum(0), mi.Vector3f(0)
    distance, roughness, cover = mi.Float(0), mi.Float(0), mi.Float(0)
    while dr.hint(active, exclude=[first, traits], label="camera_layers"):
        si = scene.ray_intersect(ray, mi.RayFlags.All, coherent=True, active=active)
        filters = mi.Bool(traits.filters) & ((si.bsdf().flags() & FILTERS) != 0)
        first.set_on(si, filters)
        valid = active & si.is_valid()
        light = _light_of(number) * mi.Vector3f(1, 1, dr.sign(si.wi.z))
        reflected, through = traits.eval_and_null_transmission(mi.BSDFContext(), si, light, valid, valid)
        albedo += dr.select(valid, share * reflected * (dr.pi / dr.abs(light.z)), 0)
        met = dr.select(valid, channel_mean(share * (1 - through)), 0)
        travelled += dr.select(valid, si.t, 0)
        normal += dr.select(valid, mi.Vector3f(si.sh_frame.n) * met, 0)
        distance += travelled * met
        roughness += dr.select(valid, traits.roughness(si, valid), 0) * met
        cover += met
        share *= dr.select(valid, through, 0)
        passes += 1
        ray = si.spawn_ray(ray.d)
        active = valid & (dr.max(share) > _LEAST_SHARE) & (passes < max_passes)
    return [*albedo, *normal, distance, roughness, cover]


def _light_of(number: Any) -> Any:
    """A direction above a surface for a sample of a pixel, in proportion to its cosine [3]."""
    return mi.warp.square_to_cosine_hemisphere(lattice_point(number))


def layers_of(planes: NDArray[np.float32], names: Sequence[str]) -> dict[str, NDArray[np.float32]]:
    """Layers by their names, [height, width, 3] or [height, width, 1], of means over pixels.

    Args:
        planes: of `camera_layers` [height, width, 9].
        names: of layers that are wanted.
    """
    cover = planes[..., 8:]
    found = {name: planes[..., _PLANES[name]] for name in names}
    if "albedo" in found:
        found["albedo"] = np.clip(found["albedo"], 0, 1)
    for name in found.keys() & {"depth", "roughness"}:
        found[name] = np.where(cover > 0, found[name] / np.maximum(cover, 1e-6), 0)
    return found
