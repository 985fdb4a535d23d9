"""The Monte Carlo reference of a footprint: the exact point model at uniform points, with its variance.

It draws points in the pixel's parallelogram, traces the view ray and the shadow ray of each, and averages:
unbiased, at any roughness and any size of draft. `brute_force` averages over the points of a slice's grid,
through the point model as a renderer calls it: the independent check of slices.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.aggregate.components import (
    CHANNELS,
    COLOURS,
    LIGHT_VISIBILITY,
    colours,
    components,
    light_visibility,
    trace_views,
    without_sheen_and_variation,
)
from loomlight.aggregate.tables import Grid
from loomlight.core.arrays import Float, FloatType, Vec3
from loomlight.core.backend import ArrayTypes, array_types, upload, upload_vector
from loomlight.core.footprint import Footprint
from loomlight.scattering.appearance import Appearance, FamilyAppearance
from loomlight.scattering.point import YarnScattering

# Points evaluated in one launch.
_BATCH = 1 << 21
_ALBEDOS = ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit")


@dataclass(frozen=True, eq=False)
class Estimate:
    """Means over footprints.

    Attributes:
        channels: names of the channels; components and colours in 1/sr, `hole` as a fraction.
        mean: [n, channels].
        variance: of each mean, not of one sample [n, channels].
        samples: points in each footprint.
    """

    channels: tuple[str, ...]
    mean: NDArray[np.float64]
    variance: NDArray[np.float64]
    samples: int

    @property
    def hole(self) -> NDArray[np.float64]:
        """Fraction of rays that pass through the cloth [n]."""
        return self.mean[:, self.channels.index("hole")]

    @property
    def colour(self) -> NDArray[np.float64]:
        """f·cos with the albedos of the threads, linear RGB [n, 3], 1/sr."""
        first = self.channels.index("red")
        return self.mean[:, first : first + 3]

    @property
    def light_visibility(self) -> NDArray[np.float64]:
        """Fraction of rays that meet yarn which the light reaches [n]; with the hole it scales the sheen."""
        return self.mean[:, self.channels.index(LIGHT_VISIBILITY)]


def reference(
    model: YarnScattering,
    footprint: Footprint,
    lights: ArrayLike,
    views: ArrayLike,
    samples: int,
    seed: int,
) -> Estimate:
    """Monte Carlo means over footprints: the five channels, red, green and blue, and the light visibility.

    Args:
        footprint: n parallelograms, in draft millimetres.
        lights, views: unit vectors, one pair a footprint [n, 3], or one for all [3]; z < 0 is the back, and a
            light on the other side than the view gives transmission.
        samples: uniform points in each parallelogram, at least 2.
        seed: of the points; the same for any batching.
    """
    plain = without_sheen_and_variation(model)
    types = array_types(footprint.area)
    rng = np.random.default_rng(seed)
    count = max(dr.width(footprint.centre), dr.width(footprint.duv_dx), dr.width(footprint.duv_dy))
    light, view = (_directions(types, directions, count) for directions in (lights, views))
    whole = Footprint(
        *(_spread(types, part, count) for part in (footprint.centre, footprint.duv_dx, footprint.duv_dy))
    )
    names = (*CHANNELS, *COLOURS, LIGHT_VISIBILITY)
    sums = _Sums(count, len(names))
    at_once = max(1, _BATCH // samples)
    for first in range(0, count, at_once):
        number = min(at_once, count - first)
        lane = dr.arange(types.UInt32, number * samples)
        index = lane // samples + first
        # One sequence over all batches, so results do not depend on their size.
        s, t = rng.random((number * samples, 2), np.float32).T
        chosen = Footprint(
            *(dr.gather(types.Vector2, part, index) for part in (whole.centre, whole.duv_dx, whole.duv_dy))
        )
        position = chosen.at(_uniform(types, s), _uniform(types, t))
        towards, eye = dr.gather(types.Vector3, light, index), dr.gather(types.Vector3, view, index)
        point = trace_views(plain, position.x, position.y, eye).point
        visible = plain.visibility(point, towards)
        appearance = plain.appearance
        channels = [
            *components(appearance, point, towards, eye, visible),
            dr.select(point.hole, types.Float(1), 0),
            *colours(appearance, point, towards, eye, visible),
            light_visibility(point, visible),
        ]
        sums.add(first, number, channels)
    mean, variance = sums.moments(samples)
    return Estimate(names, mean, variance, samples)


def brute_force(
    model: YarnScattering,
    grid: Grid,
    lights: ArrayLike,
    views: ArrayLike,
    centres: ArrayLike,
    sizes: ArrayLike,
    samples: int,
    seed: int,
    float_type: FloatType,
) -> Estimate:
    """Means of the five channels over boxes, by Monte Carlo over the rays of a grid's texels only.

    Points uniform in the box are moved to the ray of their texel, so the expectation is the exact mean of
    the slice on that grid. The channels are values of the point model for albedos of 0 and 1.

    Args:
        lights, views: unit vectors [n, 3].
        centres, sizes: boxes [n, 2], millimetres.
        samples: points in each box.
        seed: of the points.
        float_type: the Dr.Jit Float type to compute with.
    """
    types = array_types(float_type)
    rng = np.random.default_rng(seed)
    centres, sizes = np.asarray(centres, np.float64), np.asarray(sizes, np.float64)
    count = len(centres)
    light_vectors, view_vectors = (
        np.broadcast_to(np.asarray(v, np.float64), (count, 3)) for v in (lights, views)
    )
    probes = [_probe(model, *names) for names in (((0, 1, 2)), ((3,)))]
    sums = _Sums(count, len(CHANNELS))
    corner, step = np.array([grid.left, grid.bottom]), np.array(grid.step)
    at_once = max(1, _BATCH // samples)
    for first in range(0, count, at_once):
        part = slice(first, min(first + at_once, count))
        offsets = rng.random((part.stop - part.start, samples, 2)) - 0.5
        positions = centres[part, None] + offsets * sizes[part, None]
        column, row = np.moveaxis(np.floor((positions - corner) / step) % [grid.columns, grid.rows], -1, 0)
        texel = (row * grid.columns + column).astype(np.uint32).ravel()
        x, y = grid.points(types, upload(types.UInt32, texel))
        light, view = (
            upload_vector(types.Vector3, np.repeat(vectors[part], samples, axis=0).T)
            for vectors in (light_vectors, view_vectors)
        )
        point = probes[0].locate(x, y, view)
        three = probes[0].evaluate(point, light, view)
        fourth = probes[1].evaluate(probes[1].locate(x, y, view), light, view)
        hole = probes[0].straight_through(point, view)
        sums.add(first, part.stop - part.start, [three.x, three.y, three.z, fourth.x, hole])
    mean, variance = sums.moments(samples)
    return Estimate(CHANNELS, mean, variance, samples)


def _probe(model: YarnScattering, *numbers: int) -> YarnScattering:
    """The model whose red, green, blue are the components of these numbers: albedo 1 there, 0 elsewhere."""

    def family(number: int, old: FamilyAppearance) -> FamilyAppearance:
        threads = len(old.diffuse_reflect)
        tables = {name: np.zeros((threads, 3)) for name in _ALBEDOS}
        for channel, component in enumerate(numbers):
            if component % 2 == number:
                term = "diffuse" if component < 2 else "specular"
                tables[f"{term}_reflect"][:, channel] = 1
                tables[f"{term}_transmit"][:, channel] = 1
        reflect, transmit, specular, specular_transmit = tables.values()
        return FamilyAppearance(reflect, transmit, specular, specular_transmit, old.roughness)

    old = model.appearance
    appearance = Appearance(
        family(0, old.warp),
        family(1, old.weft),
        diffuse_blend=old.diffuse_blend,
        optical_depth=old.optical_depth,
    )
    return YarnScattering(model.surface, appearance, model.quality)


class _Sums:
    """Sums and sums of squares of samples, a row a footprint."""

    def __init__(self, count: int, channels: int) -> None:
        self._mean = np.zeros((count, channels))
        self._squares = np.zeros((count, channels))

    def add(self, first: int, number: int, channels: list[Float]) -> None:
        """Adds the samples of `number` footprints from `first` on."""
        dr.eval(channels)
        for index, channel in enumerate(channels):
            samples = np.asarray(channel.numpy(), np.float64).reshape(number, -1)
            mean = samples.mean(axis=1)
            self._mean[first : first + number, index] = mean
            self._squares[first : first + number, index] = ((samples - mean[:, None]) ** 2).sum(axis=1)

    def moments(self, samples: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Means and their variances."""
        return self._mean, self._squares / (samples * max(samples - 1, 1))


def _directions(types: ArrayTypes, directions: ArrayLike, count: int) -> Vec3:
    vectors = np.broadcast_to(np.asarray(directions, np.float64), (count, 3))
    return upload_vector(types.Vector3, vectors.T)


def _uniform(types: ArrayTypes, numbers: NDArray[np.float32]) -> Any:
    """Numbers of [0, 1) moved to [−1/2, 1/2)."""
    return upload(types.Float, numbers) - 0.5


def _spread(types: ArrayTypes, vector: Vec3, count: int) -> Vec3:
    """A vector of width 1 or `count`, broadcast to `count`."""
    return types.Vector2(*(part + dr.zeros(types.Float, count) for part in (vector.x, vector.y)))
