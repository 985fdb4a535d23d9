"""Denoising with Open Image Denoise, guided by pictures without noise."""

from __future__ import annotations

import math
import warnings
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Color3, Mask
from loomlight.core.backend import channel_mean
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.picture_settings import DENOISING
from loomlight.mitsuba.bsdf import FILTERS, SceneTraits
from loomlight.mitsuba.pixels import FirstFootprint

_MODULE, _PACKAGE = "mitsuba_oidn", "mitsuba-oidn"

# Deviations, pixels: of the blur that competes with the denoiser, about a film's own filter, and of the
# neighbourhoods over which errors are averaged. Wider ones follow what is smeared less well, smaller ones are
# noise themselves (studies/accuracy/denoise.py).
_BLUR, _NEIGHBOURHOOD = 0.5, 16.0
_LEAST_ERROR = 1e-9

Array = NDArray[np.float64]


def require_denoising(denoise: str) -> None:
    """Raises InputError unless `denoise` is "auto" or "off"."""
    if denoise not in DENOISING:
        raise InputError(f'denoise = "{denoise}" is unknown: use {" or ".join(DENOISING)}.')


def wants_denoising(denoise: str) -> bool:
    """Whether a picture is denoised: with "auto", where Open Image Denoise is installed.

    Raises:
        InputError: neither "auto" nor "off".
    """
    require_denoising(denoise)
    return denoise == "auto" and _library() is not None


@cache
def _library() -> ModuleType | None:
    try:
        return import_module(_MODULE)
    except ImportError:
        warnings.warn(
            f"Pictures are not denoised, as {_PACKAGE} is not installed: pip install {_PACKAGE}, or say "
            'denoise = "off".',
            LoomlightWarning,
            stacklevel=4,
        )
        return None


def denoised(halves: list[Array], guides: NDArray[np.float32]) -> Array:
    """A picture with less noise: linear [height, width, channels].

    Where two halves are given, each is a measure of the other's error: with B free of A's noise, the mean of
    |f(A) − B|² over a neighbourhood is the error of f(A) and the variance of B. Where what Open Image Denoise
    makes of the halves errs as much as a slight blur of them, as it does where it smears yarns, the picture
    is both in proportion to their errors.

    Args:
        halves: one or two pictures of samples that are independent of one another and from pixel to pixel.
        guides: normal and light without noise [height, width, 6]; see `camera_guides`.
    """
    parts = [np.nan_to_num(half) for half in halves]
    picture = np.mean(parts, axis=0)
    # The light shows the weave of whatever colour, highlights too; denoisers take guides of 0 to 1.
    light, normal = np.maximum(guides[..., 3:], 0), guides[..., :3]
    light = light / (1 + light)
    colours = [part[..., :3] for part in parts]
    filtered = [_filtered(colour, light, normal) for colour in colours]
    picture[..., :3] = np.mean(filtered, axis=0)
    if len(halves) == 2:
        blurred = [gaussian_blur(colour, _BLUR) for colour in colours]
        filtering, blurring = _error(colours, filtered), _error(colours, blurred)
        share = (blurring / (filtering + blurring))[..., None]
        picture[..., :3] = share * picture[..., :3] + (1 - share) * np.mean(blurred, axis=0)
    if picture.shape[2] == 4:
        picture[..., 3] = _filtered(np.repeat(picture[..., 3:], 3, axis=2), light, normal)[..., 0]
    return picture


def _error(halves: list[Array], made: list[Array]) -> Array:
    """Mean squared error of the mean of what was made of two halves, around each pixel [height, width]."""
    first, second = halves
    crossed = (np.square(made[0] - second) + np.square(made[1] - first)) / 2
    # Less the variance of a half, and of half of what the mean of both has less than each.
    squared = crossed - np.square(first - second) / 2 - np.square(made[0] - made[1]) / 4
    return np.maximum(
        gaussian_blur(squared.mean(axis=2, keepdims=True), _NEIGHBOURHOOD)[..., 0], _LEAST_ERROR
    )


def gaussian_blur(picture: Array, deviation: float) -> Array:
    """A picture [height, width, channels] blurred by a Gaussian of that many pixels; edges are continued."""
    reach = math.ceil(2 * deviation)
    offsets = np.arange(-reach, reach + 1)
    weights = np.exp(-0.5 * np.square(offsets / deviation))
    for axis in (0, 1):
        ends = [(reach, reach) if each == axis else (0, 0) for each in range(3)]
        padded, count = np.pad(picture, ends, mode="edge"), picture.shape[axis]
        parts = (
            weight * np.take(padded, range(start, start + count), axis=axis)
            for start, weight in enumerate(weights / weights.sum())
        )
        picture = sum(parts, np.zeros_like(picture))
    return picture


def _filtered(picture: Array, light: NDArray[np.float32], normal: NDArray[np.float32]) -> Array:
    library = _library()
    assert library is not None
    color, first, second = (np.ascontiguousarray(each, np.float32) for each in (picture, light, normal))
    found = library.denoise(color, first, second, hdr=True, clean_aux=True, device=_device())
    return np.array(found, dtype=np.float64)


@cache
def _device() -> object:
    """The CPU: pictures are the same on machines with and without a GPU."""
    library = _library()
    assert library is not None
    return library.Device(library.DeviceType.CPU)


# ---------------------------------------------------------------------------------------------------- guides
# What guides a denoiser: pictures of what the camera sees that have no noise of light.
#
# Every pixel takes the same few lights, drawn from the scene's emitters by the same numbers, and no shadow.
# Cloth that is averaged over footprints has its weave, its colours and its highlights in these pictures, as
# sharp as in the picture itself, and free of noise.


# Rays of smaller shares end.
_LEAST_GUIDE_SHARE = 1e-3
# Lights by which surfaces are seen, as the two numbers that draw each: as many as samples a pixel.
_GUIDE_LIGHTS = 8


@dr.syntax
def camera_guides(
    scene: Any,
    traits: SceneTraits,
    first: FirstFootprint,
    ray: Any,
    number: Any,
    emitters: bool,
    max_passes: int,
    background: float | None = None,
) -> list[Any]:
    """Normal and unshadowed light of what camera rays see, through holes too.

    Args:
        first: footprints of these rays.
        number: of the sample within its pixel.
        emitters: they show.
        max_passes: rays that pass through so many holes end.
        background: radiance where they meet nothing; None for the emitters' own.

    Returns:
        six arrays: normal of the world [3], light [3].
    """
    ray = mi.Ray3f(dr.detach(ray))
    active = mi.Bool(True)
    share, passes = mi.Spectrum(1), mi.UInt32(0)
    normal, light = mi.Vector3f(0), mi.Spectrum(0)
    behind: Any = None if background is None else dr.opaque(mi.Float, background)
    while dr.hint(active, exclude=[first, traits], label="camera_guides"):
        si = scene.ray_intersect(ray, mi.RayFlags.All, coherent=True, active=active)
        bsdf = si.bsdf()
        filters = mi.Bool(traits.filters) & ((bsdf.flags() & FILTERS) != 0)
        first.set_on(si, filters)
        valid = active & si.is_valid()
        if dr.hint(behind is not None, mode="scalar"):
            light += share * dr.select(active & ~valid, behind, 0)
        elif dr.hint(emitters, mode="scalar"):
            light += share * dr.select(active, si.emitter(scene).eval(si, active), 0)
        lit, through = _lit_without_shadow(scene, traits, si, number, valid)
        light += share * lit
        normal += dr.select(valid, mi.Vector3f(si.sh_frame.n) * channel_mean(share * (1 - through)), 0)
        share *= dr.select(valid, through, 0)
        passes += 1
        ray = si.spawn_ray(ray.d)
        active = valid & (dr.max(share) > _LEAST_GUIDE_SHARE) & (passes < max_passes)
    return [*normal, *light]


def _lit_without_shadow(
    scene: Any, traits: SceneTraits, si: Any, number: Any, active: Mask
) -> tuple[Color3, Color3]:
    """Reflected light and what passes straight through of a surface [3 each]."""
    numbers = lattice_point(number)
    ds, weight = scene.sample_emitter_direction(si, numbers, False, active)
    lit, through = traits.eval_and_null_transmission(mi.BSDFContext(), si, si.to_local(ds.d), active, active)
    return lit * weight, through


def lattice_point(number: Any) -> Any:
    """One of eight points spread over a square [2]: every pixel takes the same ones."""
    return mi.Point2f((mi.Float(number) + 0.5) * (1 / _GUIDE_LIGHTS), _radical_inverse(number))


def _radical_inverse(number: Any) -> Any:
    """Of the last three bits."""
    reversed_bits = ((number & 1) << 2) | (number & 2) | ((number >> 2) & 1)
    return (mi.Float(reversed_bits) + 0.5) * (1 / _GUIDE_LIGHTS)
