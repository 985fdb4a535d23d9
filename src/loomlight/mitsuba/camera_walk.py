"""Holes on the camera's own ray: what lies behind is blended in by its share, not met by chance.

A path that enters a hole with probability h brings what lies behind at full strength: at few samples a
pixel these are specks. Here the camera's ray goes straight on through surfaces with holes, and what it
meets counts by the share of light that comes through. Beside it, the path that scatters is drawn as ever:
it rides along until it scatters at one of the surfaces, waits there, and goes on when the ray has ended.
Emission and light samples of surfaces on the camera's ray thus have no noise from holes; expectations are
the same, since the path gets to each surface with the probability that is its share.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Color3, Float, Mask
from loomlight.core.backend import channel_mean, maximum, minimum
from loomlight.mitsuba.path_vertices import (
    PathState,
)

# What lies behind shows in a pixel in steps of at most this share of its radiance: of n samples those with
# less than n times as much are left to Russian roulette, which costs less. Light of emitters with an extent
# is noisy by itself: steps five times as high leave the variance of pictures of linen as it was.
_MAX_STEP, _MAX_STEP_IN_NOISE = 0.01, 0.05


def least_share_of(samples: Float, noisy: bool) -> Float:
    """Of light through holes: less is left to Russian roulette.

    Args:
        samples: of a pixel.
        noisy: lights have an extent.
    """
    return minimum((_MAX_STEP_IN_NOISE if noisy else _MAX_STEP) * samples, 1)


@dataclass
class HoleCrossing:
    """Transmission of the camera's ray by a surface.

    Attributes:
        straight: the ray beyond it.
        through: share of light that passes straight through [3].
        passed: the path drawn there does.
        may_pass: lanes whose ray may.
        blends: surfaces whose `through` counts; others let the ray through where the path passes.
    """

    straight: Any
    through: Color3
    passed: Mask
    may_pass: Mask
    blends: Mask


@dataclass
class CameraWalk:
    """The camera's ray on its way through surfaces with holes, and the path that waits for its end.

    Attributes:
        on: lanes whose ray goes on.
        share: of the light that comes through all surfaces so far [3], over the chance of having got here.
        rides: lanes whose path has not scattered yet: it is where the ray is.
        path: the path; unless it rides it goes on when the ray has ended.
        least_share: rays of smaller shares are left to Russian roulette.
    """

    on: Any
    share: Any
    rides: Any
    path: PathState
    least_share: Any

    @classmethod
    def begin(cls, path: PathState, least_share: Float) -> CameraWalk:
        """With the camera's rays; see `least_share_of`."""
        return cls(mi.Bool(path.active), mi.Spectrum(1), mi.Bool(True), dr.copy(path), least_share)

    def throughput(self, path: PathState) -> Color3:
        """Of what is met next: by the camera's ray, or by the path."""
        return dr.select(self.on, self.share, path.β)

    def step(
        self, before: PathState, after: PathState, at: HoleCrossing, number: Float
    ) -> tuple[CameraWalk, PathState]:
        """The ray beyond a surface, or the path where the ray ends.

        Args:
            before: at the surface.
            after: of the path that is drawn there.
            number: uniform in [0, 1).

        Returns:
            the walk, and what goes on.
        """
        # Whether the ray goes on: by chance where its share is small.
        chance = minimum(dr.max(self.share * at.through) / self.least_share, 1)
        # Where a path rides and passes, the ray passes too: its own chance is that of the rest.
        # An unbiased estimate of a share may be above 1, the chance of passing is not.
        drawn = dr.select(self.rides, minimum(channel_mean(at.through), 1), 0)
        chance = maximum(chance, drawn)
        rest = (chance - drawn) / maximum(1 - drawn, 1e-6)
        survives = (self.rides & at.passed) | (number < rest)
        on = self.on & at.may_pass & dr.select(at.blends, survives, at.passed)
        weight = dr.select(at.blends, at.through * dr.rcp(maximum(chance, 1e-8)), 1)
        # The path rides along or, once it has scattered, waits for the ray's end.
        path = dr.select(self.on & self.rides, after, self.path)
        following = dr.select(self.on, path, after)
        beyond = replace(before, ray=at.straight, active=on, β=after.β)
        walk = replace(self, on=on, share=self.share * weight, rides=self.rides & at.passed, path=path)
        return walk, dr.select(on, beyond, following)
