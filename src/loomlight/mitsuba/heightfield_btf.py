"""The BTF of a height field: paths traced over a mesh of its tile, which repeats (kuznetsov2021 section 4).

The reference plane lies at the mean height. A path begins where its view ray meets the top of the relief, and
takes light at each of its vertices from a distant source that is smoothed over a small cone. The source has
unit irradiance across its direction, so a path's value is f·cos: that of eq. 1 times the cosine of the light.
"""

from __future__ import annotations

import math
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.assets.heightfield import Heightfield
from loomlight.core.arrays import Float, Mask, Vec3
from loomlight.mitsuba.mesh_arrays import MeshArrays, make_shape
from loomlight.mitsuba.variants import choose_variant

# Half the angle of the light's cone, radians: 2.9°.
LIGHT_CONE = 0.05
# Vertices of a path.
MOST_BOUNCES = 4
# Copies of the tile on each side of the one in the middle: rays that leave them go on from the middle.
_COPIES = 1
# How often a ray goes on, at most: at the lowest elevation it crosses a relief as deep as the tile is wide.
_MOST_WRAPS = 64
# Rays in one launch.
_BATCH = 1 << 19
# Distance of starts of rays from the surface, in texels of the height map.
_EPSILON = 1e-2


class HeightfieldBtf:
    """f·cos of paths through a height field."""

    faces = 1

    def __init__(self, source: Heightfield) -> None:
        choose_variant(None)
        self._extent = source.size_mm
        relief = source.height_mm * (source.height - source.height.mean(dtype=np.float64))
        self._top = float(relief.max())
        self._bottom = float(relief.min())
        self._epsilon = _EPSILON * min(source.size_mm) / max(source.height.shape)
        self._scene: Any = mi.load_dict({"type": "scene", "relief": _tiles(source, relief)})

    def values(
        self,
        positions: NDArray[np.float32],
        lights: NDArray[np.float32],
        views: NDArray[np.float32],
        seed: tuple[int, ...],
    ) -> NDArray[np.float32]:
        """Estimates of f·cos by a path each [n, 3]; see `Btf.values`."""
        found = np.empty((len(positions), 3), np.float32)
        for number, first in enumerate(range(0, len(positions), _BATCH)):
            part = slice(first, first + _BATCH)
            x, y = (mi.Float(np.ascontiguousarray(row)) for row in positions[part].T)
            light, view = (mi.Vector3f(np.ascontiguousarray(rows[part].T)) for rows in (lights, views))
            key = np.random.SeedSequence([*seed, number]).generate_state(1)[0]
            sampler: Any = mi.load_dict({"type": "independent"})
            sampler.seed(int(key), dr.width(x))
            found[part] = np.array(self._traced(x, y, light, view, sampler)).T
        return found

    def _traced(self, x: Float, y: Float, light: Vec3, view: Vec3, sampler: Any) -> Any:
        """Radiance of paths towards `view`, under unit irradiance across `light`."""
        start = (self._top + self._epsilon) / view.z
        origin = mi.Point3f(x + view.x * start, y + view.y * start, self._top + self._epsilon)
        ray = self._ray(origin, -view, mi.Bool(True))
        total, weight = mi.Color3f(0), mi.Color3f(1)
        active = mi.Bool(True)
        frame = mi.Frame3f(mi.Vector3f(light))
        context: Any = mi.BSDFContext()
        warp: Any = mi.warp
        # Bounces are launches of their own: virtual calls of a single kind of BSDF are cheap, loops are not.
        for bounce in range(MOST_BOUNCES):
            si = self._scene.ray_intersect(ray, active)
            active &= si.is_valid()
            bsdf = si.bsdf(ray)
            towards = frame.to_world(
                warp.square_to_uniform_cone(sampler.next_2d(), mi.Float(math.cos(LIGHT_CONE)))
            )
            lit = active & (towards.z > 0) & ~self._shadowed(si, towards, active)
            value = bsdf.eval(context, si, si.to_local(towards), lit)
            total += dr.select(lit, weight * value, 0)
            if bounce + 1 < MOST_BOUNCES:
                sample, factor = bsdf.sample(context, si, sampler.next_1d(), sampler.next_2d(), active)
                active &= dr.max(factor) > 0
                weight *= dr.select(active, factor, 0)
                direction = si.to_world(sample.wo)
                ray = self._ray(self._lifted(si, direction), direction, active)
                # Paths of a source that is all there is end where they leave it.
                dr.eval(total, weight, ray, active, sampler)
        return total

    def _shadowed(self, si: Any, direction: Vec3, active: Mask) -> Mask:
        return self._scene.ray_test(self._ray(self._lifted(si, direction), direction, active), active)

    def _ray(self, origin: Any, direction: Vec3, active: Mask) -> Any:
        """The ray from where it is in the copies of the tile in which it meets the relief or leaves it."""
        start = self._wrapped(origin)
        searching = mi.Bool(active)

        def search(start: Any, searching: Mask, count: Any) -> tuple[Any, Mask, Any]:
            edge = self._distance_to_edge(start, direction)
            rises = direction.z > 0
            vertical = dr.select(rises, self._top - start.z, start.z - self._bottom)
            # Within the copies it leaves at the top, or meets the relief before it is at the bottom.
            searching &= vertical > dr.abs(direction.z) * edge
            searching &= ~self._scene.ray_test(mi.Ray3f(mi.Ray3f(start, direction), edge), searching)
            moved = self._wrapped(start + direction * edge)
            return dr.select(searching, moved, start), searching, count + 1

        start, searching, _ = dr.while_loop(
            (start, searching, mi.UInt32(0)),
            lambda start, searching, count: searching & (count < _MOST_WRAPS),
            search,
            label="tiles of a height field",
        )
        return mi.Ray3f(start, direction)

    def _distance_to_edge(self, start: Any, direction: Vec3) -> Float:
        """Distance along a ray to the sides of all copies of the tile."""
        found = mi.Float(dr.inf)
        for place, step, side in zip(
            (start.x, start.y), (direction.x, direction.y), self._extent, strict=True
        ):
            edge = dr.select(step > 0, (1 + _COPIES) * side, -_COPIES * side)
            found = dr.minimum(found, dr.select(dr.abs(step) > 1e-9, (edge - place) / step, dr.inf))
        return found

    def _lifted(self, si: Any, direction: Vec3) -> Any:
        """The start of a ray from a surface, on the side that it leaves to."""
        side = dr.sign(dr.dot(si.n, direction))
        return si.p + mi.Vector3f(si.n) * (side * self._epsilon)

    def _wrapped(self, point: Any) -> Any:
        """The same point of the tile in the middle."""
        width, height = self._extent
        return mi.Point3f(
            point.x - width * dr.floor(point.x / width),
            point.y - height * dr.floor(point.y / height),
            point.z,
        )


def _tiles(source: Heightfield, relief: NDArray[np.floating[Any]]) -> Any:
    """A mesh of all copies of the tile."""
    one = _mesh(source, relief)
    width, height = source.size_mm
    shifts = range(-_COPIES, _COPIES + 1)
    offsets = [np.array([column * width, row * height, 0]) for row in shifts for column in shifts]
    count = len(offsets)
    copies = MeshArrays(
        np.concatenate([one.positions + offset for offset in offsets]),
        np.tile(one.normals, (count, 1)),
        np.tile(one.uv, (count, 1)),
        np.concatenate([one.triangles + number * len(one.positions) for number in range(count)]),
    )
    return make_shape("relief", copies, mi.load_dict(_bsdf(source)))


def _mesh(source: Heightfield, relief: NDArray[np.floating[Any]]) -> MeshArrays:
    """The relief over one tile, a vertex a texel of the height map, and one more at the far sides."""
    rows, columns = relief.shape
    width, height = source.size_mm
    across, along = width / columns, height / rows
    slope_x = (np.roll(relief, -1, 1) - np.roll(relief, 1, 1)) / (2 * across)
    slope_y = (np.roll(relief, -1, 0) - np.roll(relief, 1, 0)) / (2 * along)
    normals = np.stack([-slope_x, -slope_y, np.ones_like(relief)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    z, normal = (
        np.pad(part, ((0, 1), (0, 1), (0, 0))[: part.ndim], mode="wrap") for part in (relief, normals)
    )
    v, u = np.meshgrid(
        (np.arange(rows + 1) + 0.5) / rows, (np.arange(columns + 1) + 0.5) / columns, indexing="ij"
    )
    positions = np.stack([u * width, v * height, z], axis=-1)
    corner = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    right, up, far = corner + 1, corner + columns + 1, corner + columns + 2
    triangles = np.concatenate([np.stack([corner, right, far], 1), np.stack([corner, far, up], 1)])
    return MeshArrays(
        positions.reshape(-1, 3).astype(np.float32),
        normal.reshape(-1, 3).astype(np.float32),
        np.stack([u, v], axis=-1).reshape(-1, 2).astype(np.float32),
        triangles.astype(np.uint32),
    )


def _bsdf(source: Heightfield) -> dict[str, Any]:
    """Mitsuba's principled BSDF of the maps."""
    principled = {
        "type": "principled",
        "base_color": _texture(source.albedo),
        "roughness": _texture(source.roughness[..., None]),
        "metallic": _texture(source.metallic[..., None]),
        "specular": source.specular,
    }
    if source.normal is None:
        return principled
    return {"type": "normalmap", "normalmap": _texture(source.normal), "bsdf": principled}


def _texture(values: NDArray[np.float32]) -> dict[str, Any]:
    """A map [rows, columns, channels], numbers as they are."""
    return {
        "type": "bitmap",
        "data": mi.TensorXf(np.ascontiguousarray(values, np.float32)),
        "raw": True,
        "wrap_mode": "repeat",
    }
