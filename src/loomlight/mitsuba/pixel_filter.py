"""The film's reconstruction filter, shared between where rays go and what footprints average.

Samples that are spread evenly over the film and splatted with its filter h reconstruct texture by h. A
footprint g would add its own variance: the picture were filtered by h * g, and as blurred as both. Pictures of
models that filter therefore draw the places of a pixel's samples from h itself and add them up within that
pixel (filter importance sampling, Ernst et al. 2006): silhouettes, shadows and everything that does not filter
are seen through h, as the film promises. Where a model filters, it is asked nearer to the pixel's centre, at
`contraction` a times the sample's offset, with a footprint of variance (1 − a²)·var(h): together var(h) again,
whatever the number of samples. The smaller a is, the less noise texture leaves.

Filters with negative lobes cannot be drawn from, and have hardly a variance that could be shared; their
samples are splatted, each with its part of the pixel as its footprint.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Vec2

# Gaussian filters reach so many standard deviations far in Mitsuba.
_REACH = 4.0


@dataclass(frozen=True)
class PixelFilter:
    """How the samples of a pixel are placed.

    Attributes:
        name: class of the film's filter, such as "GaussianFilter".
        radius: where the filter ends, pixels.
        centred: all rays go through the pixel's centre, and footprints have all of the variance.
    """

    name: str
    radius: float
    centred: bool = False

    @classmethod
    def of(cls, film: Any, centred: bool) -> PixelFilter | None:
        """The filter of a film, or None if it cannot be drawn from."""
        rfilter = film.rfilter()
        found = cls(rfilter.class_name(), float(rfilter.radius()), centred)
        return found if found.name in _VARIANCES else None

    @property
    def variance(self) -> float:
        """Variance of the filter along one axis, square pixels."""
        return _VARIANCES[self.name] * self.radius**2

    @property
    def contraction(self) -> float:
        """Where filtered texture is read: this times the offset of a sample from the pixel's centre."""
        # A box filter is the box that footprints are. With a third of a wider filter's variance in the samples'
        # places edges have its shape: of a Gaussian's within 2 % of the step, of footprints alone within 6 %.
        return 0.0 if self.centred or self.name == "BoxFilter" else math.sqrt(1 / 3)

    @property
    def footprint_side(self) -> float:
        """Side of the box that has the variance left to footprints, pixels."""
        return math.sqrt(12 * (1 - self.contraction**2) * self.variance)

    def offset(self, u: Any) -> Vec2:
        """A place drawn from the filter, pixels from the centre [2].

        Args:
            u: uniform numbers in [0, 1) [2]; strata stay strata.
        """
        if self.centred:
            return mi.Vector2f(0)
        u = mi.Vector2f(u)
        if self.name == "BoxFilter":
            return (u - 0.5) * (2 * self.radius)
        # Uniform in (−1, 1), which the rest are odd functions of.
        v = 2 * u - 1
        if self.name == "TentFilter":
            return self.radius * dr.copysign(1 - dr.sqrt(1 - dr.abs(v)), v)
        # Mitsuba lowers the Gaussian by its value at the end; that thousandth of its mass is left where it was.
        inside = math.erf(_REACH / math.sqrt(2))
        return (self.radius * math.sqrt(2) / _REACH) * dr.erfinv(v * inside)


# Variances over squared radii.
_VARIANCES = {"BoxFilter": 1 / 3, "TentFilter": 1 / 6, "GaussianFilter": 1 / _REACH**2}


class OwnPixelSensor:
    """A sensor whose film adds up samples within their own pixels, as far as integrators ask for it."""

    def __init__(self, sensor: Any) -> None:
        self._sensor = sensor
        self._film = _OwnPixelFilm(sensor.film())

    def film(self) -> Any:
        return self._film

    def __getattr__(self, name: str) -> Any:
        return getattr(self._sensor, name)


class _OwnPixelFilm:
    """A film with a box filter of one pixel in place of its own."""

    def __init__(self, film: Any) -> None:
        self._film = film
        self._box = mi.load_dict({"type": "box"})

    def rfilter(self) -> Any:
        return self._box

    def sample_border(self) -> bool:
        return False

    def create_block(self) -> Any:
        own = self._film.create_block()
        return mi.ImageBlock(
            size=own.size(),
            offset=own.offset(),
            channel_count=own.channel_count(),
            rfilter=self._box,
            coalesce=own.coalesce(),
        )

    def __getattr__(self, name: str) -> Any:
        return getattr(self._film, name)
