"""Samples of pixels: where they lie, what numbers they draw, how they make a picture, their footprints.

The film's reconstruction filter is divided between samples, rays and footprints. Samples that are spread
evenly over the film and splatted with its filter h reconstruct texture by h. A footprint g would add its own
variance: the picture would be filtered by h * g. Where models filter, h is therefore divided, h = s * g:

- samples are spread and splatted by s, or spread within their own pixel by s (filter importance sampling,
  Ernst et al. 2006);
- the ray of a sample goes past its place by an offset drawn from g: silhouettes, shadows and whatever does
  not filter are seen through s * g = h, as the film promises;
- models that filter are asked at the sample's own place with a footprint of the variance of g: again s * g.

The number of samples does not enter. Texture leaves the less noise the wider g is; everything else the less
noise the more samples pixels share, which is 4π·var(s) for a Gaussian s.

Filters with negative lobes cannot be divided like that; their samples are splatted, each with its part of the
pixel as its footprint.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Float, Mask, UInt, Vec2
from loomlight.core.backend import InvariantDivider, array_types, maximum, minimum
from loomlight.scattering.variation import hash_bits

# Mitsuba's Gaussians reach so many standard deviations far.
_REACH = 4.0
# Of their Gaussian by default, pixels.
_DEVIATION = 0.5
# Of a Gaussian's standard deviation, what samples are splatted with: footprints have 36 % of the variance.
_SPLATTED = 0.8


@dataclass
class SamplePlaces:
    """Where the samples of pixels are, pixels from the middle of each.

    Attributes:
        sample: places [2] that samples stand for.
        offset: of their rays from there [2].
    """

    sample: Vec2
    offset: Vec2


@dataclass(frozen=True)
class PixelFilter:
    """The division of a film's filter.

    Attributes:
        name: class of the film's filter, such as "GaussianFilter".
        radius: where the filter ends, pixels.
        centred: all rays go through the pixel's centre, and footprints have all of the variance.
        apart: every sample counts in its own pixel alone, so that no two pixels share noise: samples are
            drawn from the filter in place of being splatted. Footprints of all of its variance at the pixel's
            centre would do for texture, but fabrics judge a pattern by few moments: where yarns are about as
            wide as pixels, rings of moiré stay in the mean of many samples.
    """

    name: str
    radius: float
    centred: bool = False
    apart: bool = False

    @classmethod
    def of(cls, film: mi.Film, centred: bool, apart: bool = False) -> PixelFilter | None:
        """The filter of a film, or None if it cannot be divided; `apart` a Gaussian in its place."""
        rfilter = film.rfilter()
        found = cls(rfilter.class_name(), float(rfilter.radius()), centred, apart)
        if found.name in _VARIANCES:
            return found
        return replace(found, name="GaussianFilter", radius=_REACH * _DEVIATION) if apart else None

    @property
    def variance(self) -> float:
        """Variance of the filter along one axis, square pixels."""
        return _VARIANCES[self.name] * self.radius**2

    @property
    def footprint_side(self) -> float:
        """Side of the box that has the variance of footprints, pixels."""
        return math.sqrt(12 * self._footprint_share * self.variance)

    @property
    def _footprint_share(self) -> float:
        return 1.0 if self.centred else _FOOTPRINT_SHARES[self.name]

    @property
    def splat_deviation(self) -> float | None:
        """Deviation of the Gaussian to splat samples with, pixels; None adds them to their own pixel."""
        if self.centred or self.apart or self.name != "GaussianFilter":
            return None
        return _SPLATTED * math.sqrt(self.variance)

    def places(self, u: Any, v: Any) -> SamplePlaces:
        """Places of samples and of their rays.

        Args:
            u, v: uniform numbers in [0, 1) [2]; strata stay strata.
        """
        if self.centred:
            return SamplePlaces(mi.Vector2f(0), mi.Vector2f(0))
        first, second = mi.Vector2f(u) - 0.5, mi.Vector2f(v) - 0.5
        if self.name == "BoxFilter":
            return SamplePlaces(mi.Vector2f(0), first * (2 * self.radius))
        if self.name == "TentFilter":
            # A box upon a box of half its width.
            return SamplePlaces(first * self.radius, second * self.radius)
        deviation = math.sqrt(self.variance)
        offset = _normal(second, deviation * math.sqrt(self._footprint_share))
        return SamplePlaces(_normal(first, deviation * _SPLATTED) if self.apart else first, offset)


def _normal(uniform: Any, deviation: float) -> Any:
    """Normal numbers [2] of uniform ones in [-0.5, 0.5) [2].

    Mitsuba lowers the Gaussian by its value at the end, a thousandth of its mass in all; not here.
    """
    inside = math.erf(_REACH / math.sqrt(2))
    return (math.sqrt(2) * deviation) * dr.erfinv(2 * inside * uniform)


# Variances over squared radii, and the shares of them that footprints take.
_VARIANCES = {"BoxFilter": 1 / 3, "TentFilter": 1 / 6, "GaussianFilter": 1 / _REACH**2}
_FOOTPRINT_SHARES = {"BoxFilter": 1.0, "TentFilter": 0.5, "GaussianFilter": 1 - _SPLATTED**2}


class SplattingSensor:
    """A sensor whose film splats samples as `PixelFilter` says, as far as integrators ask for it."""

    def __init__(self, sensor: mi.Sensor, pixel_filter: PixelFilter) -> None:
        self._sensor = sensor
        self.apart = pixel_filter.apart
        self._film = _SplattingFilm(sensor.film(), pixel_filter.splat_deviation)

    def film(self) -> Any:
        return self._film

    def __getattr__(self, name: str) -> Any:
        return getattr(self._sensor, name)


class _SplattingFilm:
    """A film with a Gaussian filter in place of its own, or with the box filter of one pixel."""

    def __init__(self, film: mi.Film, deviation: float | None) -> None:
        self._film = film
        gaussian = {"type": "gaussian", "stddev": deviation}
        self._rfilter = mi.load_dict({"type": "box"} if deviation is None else gaussian)

    def __str__(self) -> str:
        return str(self._film)

    def rfilter(self) -> Any:
        return self._rfilter

    def create_block(self) -> Any:
        own = self._film.create_block()
        return mi.ImageBlock(
            size=own.size(),
            offset=own.offset(),
            channel_count=own.channel_count(),
            rfilter=self._rfilter,
            border=own.has_border(),
            coalesce=own.coalesce(),
        )

    def __getattr__(self, name: str) -> Any:
        return getattr(self._film, name)


# ------------------------------------------------------------------------------------------ samples and films
# Pixels of samples that lie one after another, and pictures of them that need no film.


def has_pixel_sampler(sensor: Any) -> bool:
    """Whether `PixelSampler` takes the place of a sensor's sampler, which it is at least as good as."""
    return bool(sensor.sampler().class_name() == "MultijitterSampler")


def is_plain(film: Any) -> bool:
    """Whether a film develops RGB or RGBA; films tell their format to readers alone."""
    return bool(mi.is_rgb) and re.search(r"pixel_format = rgba?\b", str(film)) is not None


def samples_are_pixels(camera: Any, spp: int) -> bool:
    """Whether a picture of so many samples a pixel (0: the sampler's) is nothing but its samples.

    The film would add them up one by one in whatever order, which takes a tenth of a picture of lobes.
    """
    film = camera.film()
    apart = isinstance(camera, SplattingSensor) and camera.apart
    count = spp or camera.sampler().sample_count()
    return bool((count == 1 or apart) and is_plain(film) and film.rfilter().is_box_filter())


def samples_of(film: Any, spp: int) -> tuple[Any, Any]:
    """Pixels of all samples, row by row, and their numbers within each pixel."""
    pixels = film_width(film) * (int(film.crop_size()[1]) + 2 * film_border(film))
    return InvariantDivider(spp, array_types(mi.Float)).divide(dr.arange(mi.UInt32, pixels * spp))


def means_of_pixels(samples: list[Any], spp: int, film: Any) -> Any:
    """A tensor [height, width, channels] of samples, `spp` of each pixel after another."""
    width, height = (int(side) for side in film.crop_size())
    # At once: sums evaluate their argument, each by a kernel of its own otherwise.
    dr.eval(samples)
    means = samples if spp == 1 else [dr.block_sum(channel, spp) / spp for channel in samples]
    tensor: Any = mi.TensorXf
    array: Any = mi.Float
    interleaved = dr.zeros(array, width * height * len(means))
    pixel = dr.arange(mi.UInt32, width * height) * len(means)
    for number, channel in enumerate(means):
        dr.scatter(interleaved, channel, pixel + number)
    return tensor(interleaved, (height, width, len(means)))


def film_width(film: Any) -> int:
    return int(film.crop_size()[0]) + 2 * film_border(film)


def film_border(film: Any) -> int:
    """Pixels around a film where samples are taken too."""
    return int(film.rfilter().border_size()) if film.sample_border() else 0


# --------------------------------------------------------------------------------------------- random numbers
# Samples of pixels whose counts are data: Mitsuba's samplers are compiled anew for each number of samples.
#
# Every number, and every pair of numbers, is a (0, 2)-sequence with Owen scrambling by hashes, shuffled
# anew for each pair and pixel (Burley 2020, *Practical Hash-based Owen Scrambling*). So samples are
# stratified in all dimensions, whether a picture takes them in one pass or in many.


# Of the matrix of Sobol's second dimension, Pascal's triangle modulo 2: shifts, and the bits that stay.
_PASCAL = ((16, 0x0000FFFF), (8, 0x00FF00FF), (4, 0x0F0F0F0F), (2, 0x33333333), (1, 0x55555555))


@dataclass
class PixelSampler:
    """Random numbers of samples, as far as integrators ask for them.

    Attributes:
        count: samples of each pixel in this pass.
        number: of the sample among all of its pixel: UInt32.
        key: of the pixel and the seed: UInt32.
        dimension: how many numbers or pairs were drawn: UInt32.
    """

    count: int
    number: Any
    key: Any
    dimension: Any

    @classmethod
    def of(cls, pixel: UInt, number: UInt, seed: Any, count: int) -> PixelSampler:
        """The sampler of samples by their pixels and their numbers in them; any 32-bit seed."""
        seed = dr.opaque(mi.UInt32, seed) if isinstance(seed, int) else mi.UInt32(seed)
        return cls(count, number, hash_bits(hash_bits(seed, mi.UInt32(0)), pixel), mi.UInt32(0))

    def sample_count(self) -> int:
        """Samples of each pixel in this pass."""
        return self.count

    def next_1d(self) -> Float:
        """A number in (0, 1)."""
        key, place = self._next()
        return _unit(_permuted(place, key))

    def next_2d(self) -> Any:
        """Two numbers in (0, 1)."""
        key, place = self._next()
        second = place
        for shift, kept in _PASCAL:
            second = second ^ ((second >> shift) & kept)
        return mi.Point2f(_unit(_permuted(place, key)), _unit(_permuted(second, hash_bits(key, key))))

    def _next(self) -> tuple[UInt, UInt]:
        """A key of the next dimension, and the place of the sample in its shuffled order."""
        self.dimension = self.dimension + 1
        key = hash_bits(self.key, self.dimension)
        return hash_bits(key, self.dimension), dr.brev(_permuted(dr.brev(self.number), key))


def _permuted(bits: UInt, key: UInt) -> UInt:
    """Owen scrambling of reversed bits: each depends on those below it alone (Laine and Karras 2011)."""
    bits = ((bits ^ (bits * 0x3D20ADEA)) + key) * ((key >> 16) | 1)
    bits = bits ^ (bits * 0x05526C56)
    return bits ^ (bits * 0x53A22864)


def _unit(reversed_bits: UInt) -> Float:
    """A number in (0, 1) of reversed bits: 23 of them and a half are exact."""
    return (mi.Float(dr.brev(reversed_bits) >> 9) + 0.5) * 2**-23


# ------------------------------------------------------------------------------------------------- footprints
# The pixel footprint along a path: a cone around the ray, and what it covers in a surface's uv.
#
# A cone has a width (the side of a square perpendicular to the ray, scene units) and a spread (its growth
# per unit of distance, radians). On the camera's own ray the true differentials are used instead.


# A footprint seen at a grazing angle is stretched at most this much; beyond, the plane leaves the object.
_MAX_STRETCH = 20.0
# One scattering event opens the cone by at most this angle (radians).
_MAX_OPENING = 1.0


def pixel_cone(ray: Any) -> tuple[Any, Any]:
    """Width at the origin and spread of the cone whose cross-section has the area of the ray's pixel."""
    if not ray.has_differentials:
        return mi.Float(0), mi.Float(0)
    width = dr.sqrt(dr.norm(dr.cross(ray.o_x - ray.o, ray.o_y - ray.o)))
    spread = dr.sqrt(dr.norm(dr.cross(ray.d_x - ray.d, ray.d_y - ray.d)))
    return width, spread


def opening(pdf: Any, samples: Any) -> Any:
    """Angle by which a scattered sample of density `pdf` (1/sr) opens the cone, radians.

    One of `samples` samples stands for the solid angle 1/(samples·pdf); delta events do not open it.
    """
    angle = dr.rsqrt(maximum(pdf * samples, 1e-6))
    return minimum(angle, _MAX_OPENING)


def cone_partials(si: Any, direction: Any, width: Any) -> tuple[Any, Any]:
    """duv_dx and duv_dy of a cone of `width` that travels along `direction` and meets `si`.

    The first is the footprint's long side, along the ray's projection; the second its short side.
    """
    cosine = dr.dot(direction, si.n)
    along = direction - cosine * si.n
    length = dr.norm(along)
    fallback, _ = mi.coordinate_system(si.n)
    along = dr.select(length > 1e-4, along / maximum(length, 1e-4), fallback)
    across = dr.cross(si.n, along)
    stretch = minimum(dr.rcp(maximum(dr.abs(cosine), 1e-3)), _MAX_STRETCH)
    return _to_uv(si, along * (width * stretch)), _to_uv(si, across * width)


def _to_uv(si: mi.SurfaceInteraction3f, step: Any) -> Any:
    # Least squares in the tangent plane; a surface without a usable uv gets no footprint.
    uu, uv, vv = dr.squared_norm(si.dp_du), dr.dot(si.dp_du, si.dp_dv), dr.squared_norm(si.dp_dv)
    u, v = dr.dot(step, si.dp_du), dr.dot(step, si.dp_dv)
    inverse = dr.rcp(uu * vv - uv * uv)
    inverse = dr.select(dr.isfinite(inverse), inverse, 0)
    return mi.Vector2f(vv * u - uv * v, uu * v - uv * u) * inverse


@dataclass
class FirstFootprint:
    """Footprints of the camera's own rays, before they scatter.

    Not a pytree: as a variable of a loop the camera's ray would be copied, and copies lose the differentials.

    Attributes:
        camera: rays with the differentials of a whole pixel.
        offset: of rays from where filtered texture is read, pixels [2]; None where that is the same.
        filtered_side: side of the footprints of BSDFs that average over them, pixels.
        side: of those of others.
    """

    camera: Any
    offset: Vec2 | None
    filtered_side: float
    side: Float

    @classmethod
    def of(
        cls, pixel_filter: PixelFilter | None, offset: Vec2 | None, camera: Any, samples: Float
    ) -> FirstFootprint:
        """Footprints of rays at `offset` from their samples' places, of `samples` samples a pixel."""
        side = dr.rsqrt(samples)
        if pixel_filter is None:
            return cls(camera, None, side, side)
        return cls(camera, offset, pixel_filter.footprint_side, side)

    def set_on(self, si: Any, filters: Mask) -> None:
        """Sets the footprint in uv at `si`, and moves its uv where BSDFs filter."""
        si.compute_uv_partials(self.camera)
        if self.offset is not None:
            step = self.offset.x * si.duv_dx + self.offset.y * si.duv_dy
            si.uv -= dr.select(filters, step, 0)
        side = dr.select(filters, mi.Float(self.filtered_side), self.side)
        si.duv_dx *= side
        si.duv_dy *= side
