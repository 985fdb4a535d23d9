"""The film's reconstruction filter, divided between samples, rays and footprints.

Samples that are spread evenly over the film and splatted with its filter h reconstruct texture by h. A
footprint g would add its own variance: the picture would be filtered by h * g. Where models filter, h is
therefore divided, h = s * g:

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
from dataclasses import dataclass, replace
from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Vec2

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
