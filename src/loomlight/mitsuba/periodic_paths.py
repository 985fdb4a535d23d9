"""Paths through geometry that repeats: nine copies of a tile, from whose sides rays go on in the middle.

The reference plane is z = 0. A path begins where its view ray meets the top of the geometry (or its bottom,
seen from behind), and takes light at each vertex from a distant source, smoothed over a small cone. The
source has unit irradiance across its direction, so a path's value is f·cos: that of kuznetsov2021 eq. 1 times
the cosine of the light.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, Vec3

# Half the angle of the light's cone, radians: 2.9°.
LIGHT_CONE = 0.05
# Copies of the tile on each side of the one in the middle.
COPIES = 1
# How often a ray goes on, at most: at the lowest elevation it crosses a relief as deep as the tile is wide.
_MAX_WRAPS = 64
# Rays in one launch.
_BATCH = 1 << 19


@dataclass(frozen=True)
class Tile:
    """Geometry that repeats.

    Attributes:
        scene: `COPIES` copies on each side of the tile, which begins at x = y = 0.
        size_mm: width and height of the tile, millimetres.
        top, bottom: bounds of z, millimetres.
        overhang: how far geometry sticks out of its tile along x and y, millimetres.
        epsilon: distance of starts of rays from the surface, millimetres.
        bounces: vertices of a path, at most.
    """

    scene: Any
    size_mm: tuple[float, float]
    top: float
    bottom: float
    overhang: tuple[float, float]
    epsilon: float
    bounces: int


class PeriodicPaths:
    """Estimates of f·cos by paths through a tile that repeats without end."""

    def __init__(self, tile: Tile) -> None:
        self._tile = tile

    def values(
        self,
        positions: NDArray[np.float32],
        lights: NDArray[np.float32],
        views: NDArray[np.float32],
        seed: tuple[int, ...],
    ) -> NDArray[np.float32]:
        """Estimates of f·cos by a path each [n, 3]; see `Btf.values`."""
        found = np.empty((len(positions), 3), np.float32)
        for number, part in enumerate(_batches(len(positions))):
            x, y = (mi.Float(np.ascontiguousarray(row)) for row in positions[part].T)
            light, view = (mi.Vector3f(np.ascontiguousarray(rows[part].T)) for rows in (lights, views))
            key = np.random.SeedSequence([*seed, number]).generate_state(1)[0]
            sampler: Any = mi.load_dict({"type": "independent"})
            sampler.seed(int(key), dr.width(x))
            found[part] = np.array(self._traced(x, y, light, view, sampler)).T
        return found

    def holes(self, positions: NDArray[np.float32], views: NDArray[np.float32]) -> NDArray[np.float32]:
        """1 where the view ray passes straight through, else 0 [n]; see `Btf.holes`."""
        found = np.empty(len(positions), np.float32)
        for part in _batches(len(positions)):
            x, y = (mi.Float(np.ascontiguousarray(row)) for row in positions[part].T)
            view = mi.Vector3f(np.ascontiguousarray(views[part].T))
            ray = self._view_ray(x, y, view)
            found[part] = ~np.array(self._tile.scene.ray_test(ray))
        return found

    def _view_ray(self, x: Float, y: Float, view: Vec3) -> Any:
        """The ray from the eye through a point of the reference plane, from where it enters the geometry."""
        tile = self._tile
        start = dr.select(view.z > 0, tile.top + tile.epsilon, tile.bottom - tile.epsilon)
        distance = start / view.z
        origin = mi.Point3f(x + view.x * distance, y + view.y * distance, start)
        return self._ray(origin, -view, mi.Bool(True))

    def _traced(self, x: Float, y: Float, light: Vec3, view: Vec3, sampler: Any) -> Any:
        """Radiance of paths towards `view`, under unit irradiance across `light`."""
        ray = self._view_ray(x, y, view)
        total, weight = mi.Color3f(0), mi.Color3f(1)
        active = mi.Bool(True)
        frame = mi.Frame3f(mi.Vector3f(light))
        context: Any = mi.BSDFContext()
        warp: Any = mi.warp
        # Bounces are launches of their own: virtual calls of a single kind of BSDF are cheap, loops are not.
        for bounce in range(self._tile.bounces):
            si = self._tile.scene.ray_intersect(ray, active)
            active &= si.is_valid()
            bsdf = si.bsdf(ray)
            towards = frame.to_world(
                warp.square_to_uniform_cone(sampler.next_2d(), mi.Float(math.cos(LIGHT_CONE)))
            )
            lit = active & (towards.z * light.z > 0) & ~self._shadowed(si, towards, active)
            value = bsdf.eval(context, si, si.to_local(towards), lit)
            total += dr.select(lit, weight * value, 0)
            if bounce + 1 < self._tile.bounces:
                sample, factor = bsdf.sample(context, si, sampler.next_1d(), sampler.next_2d(), active)
                active &= dr.max(factor) > 0
                weight *= dr.select(active, factor, 0)
                direction = si.to_world(sample.wo)
                ray = self._ray(self._lifted(si, direction), direction, active)
                # Paths of a source that is all there is end where they leave it.
                dr.eval(total, weight, ray, active, sampler)
        return total

    def _shadowed(self, si: mi.SurfaceInteraction3f, direction: Vec3, active: Mask) -> Mask:
        return self._tile.scene.ray_test(self._ray(self._lifted(si, direction), direction, active), active)

    def _ray(self, origin: Any, direction: Vec3, active: Mask) -> Any:
        """The ray from where it is in the copies of the tile in which it meets the geometry or leaves it."""
        tile, start = self._tile, self._wrapped(origin)
        searching = mi.Bool(active)

        def search(start: Any, searching: Mask, count: Any) -> tuple[Any, Mask, Any]:
            edge = self._distance_to_edge(start, direction)
            rises = direction.z > 0
            vertical = dr.select(rises, tile.top - start.z, start.z - tile.bottom)
            # Within the copies it leaves at top or bottom, or meets the geometry before.
            searching &= vertical > dr.abs(direction.z) * edge
            searching &= ~tile.scene.ray_test(mi.Ray3f(mi.Ray3f(start, direction), edge), searching)
            moved = self._wrapped(start + direction * edge)
            return dr.select(searching, moved, start), searching, count + 1

        start, searching, _ = dr.while_loop(
            (start, searching, mi.UInt32(0)),
            lambda start, searching, count: searching & (count < _MAX_WRAPS),
            search,
            label="tiles of a source that repeats",
        )
        return mi.Ray3f(start, direction)

    def _distance_to_edge(self, start: Any, direction: Vec3) -> Float:
        """Distance along a ray to where copies that are not there would stick into the others."""
        found = mi.Float(dr.inf)
        for place, step, side, outside in zip(
            (start.x, start.y),
            (direction.x, direction.y),
            self._tile.size_mm,
            self._tile.overhang,
            strict=True,
        ):
            edge = dr.select(step > 0, (1 + COPIES) * side - outside, outside - COPIES * side)
            found = dr.minimum(found, dr.select(dr.abs(step) > 1e-9, (edge - place) / step, dr.inf))
        return found

    def _lifted(self, si: mi.SurfaceInteraction3f, direction: Vec3) -> Any:
        """The start of a ray from a surface, on the side that it leaves to."""
        side = dr.sign(dr.dot(si.n, direction))
        return si.p + mi.Vector3f(si.n) * (side * self._tile.epsilon)

    def _wrapped(self, point: Any) -> Any:
        """The same point of the tile in the middle."""
        width, height = self._tile.size_mm
        return mi.Point3f(
            point.x - width * dr.floor(point.x / width),
            point.y - height * dr.floor(point.y / height),
            point.z,
        )


def _batches(count: int) -> list[slice]:
    return [slice(first, first + _BATCH) for first in range(0, count, _BATCH)]
