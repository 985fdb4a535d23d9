"""The texel model: what a point of the feature maps does to light, from a few reads and no ray search.

Parallax marches through the map of heights, shadows read the horizons of a texel, lobes are
those of the point model. It is close to the point model and many times cheaper, so the residual is
estimated in two steps: from many points between texel model and base, and from few between point model and
texel model.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np

from loomlight.core.arrays import Color3, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, clip, maximum, minimum, opaque, upload
from loomlight.models.clustered.tables import ClusterTables
from loomlight.scattering.diffuse import diffuse_reflection
from loomlight.scattering.fibre import reflection, transmission
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.horizon import AZIMUTHS

# Steps of a view ray through the relief of the cloth, and how often the hit is refined.
_MIN_STEPS, _MAX_STEPS = 8, 64
# Of the finest thread, one step across the cloth.
_STRIDE = 0.15
_REFINEMENTS = 3
# Height of holes, in units of the relief.
_DEEP = -10.0
# The bit of a hit that passes through a hole.
_HOLE = 1 << 31


@dataclass
class TexelPoint:
    """A texel that a view ray meets.

    Attributes:
        place: index of the texel, both faces counted.
        hole: it is a hole.
        is_warp: the family that shows.
        thread: index of the thread.
        normal, tangent: of the yarn and its fibres [3].
    """

    place: UInt
    hole: Mask
    is_warp: Mask
    thread: UInt
    normal: Vec3
    tangent: Vec3


class TexelModel:
    """The texel model of one fabric on one backend."""

    def __init__(
        self,
        tables: ClusterTables,
        size: tuple[float, float],
        top: float,
        finest: float,
        diffuse_blend: float,
        optical_depth: float,
        types: ArrayTypes,
    ) -> None:
        """
        Args:
            size: of the repeat, millimetres.
            top: bound of the cloth's heights, millimetres.
            finest: width of the finest thread, millimetres.
        """
        self._types = types
        low, high = float(tables.height.min()), top
        features = tables.features.astype(np.float32)
        holes = features[..., 3] < 0
        heights = np.where(holes, _DEEP * (high - low), tables.height.astype(np.float32))
        self._features = upload(types.Float, features)
        self._heights = upload(types.Float, heights)
        self._horizon = upload(types.UInt32, np.ascontiguousarray(tables.horizon).view("<u4"))
        columns, rows = tables.counts
        self._counts = [dr.opaque(types.Float, float(count)) for count in (columns, rows)]
        self._wholes = [dr.opaque(types.UInt32, count) for count in (columns, rows)]
        self._per_mm = [dr.opaque(types.Float, 1 / extent) for extent in size]
        self._face = dr.opaque(types.UInt32, columns * rows)
        self._high = dr.opaque(types.Float, float(high))
        self._low = dr.opaque(types.Float, low)
        self._relief = dr.opaque(types.Float, float(high - low))
        self._stride = dr.opaque(types.Float, _STRIDE * finest)
        self._roughness = opaque(types.Float, tables.moments[0, [0, tables.clusters // 2], 7])
        self._blend, self._depth = diffuse_blend, optical_depth

    def meet(self, place: Vec2, view: Vec3, back: Mask) -> TexelPoint:
        """The texel that the view ray through a place on the plane z = 0 meets; see `hit`."""
        return self.point(self.hit(place, view, back))

    def point(self, hit: UInt) -> TexelPoint:
        """The numbers of a texel that `hit` has found."""
        types = self._types
        texel = hit & (_HOLE - 1)
        first_half = dr.gather(types.Vector4, self._features, 2 * texel)
        second_half = dr.gather(types.Vector4, self._features, 2 * texel + 1)
        return TexelPoint(
            place=texel,
            hole=hit >= _HOLE,
            is_warp=first_half.w > 0.5,
            thread=types.UInt32(maximum(second_half.w, 0)),
            normal=types.Vector3(first_half.x, first_half.y, first_half.z),
            tangent=types.Vector3(second_half.x, second_half.y, second_half.z),
        )

    def hit(self, place: Vec2, view: Vec3, back: Mask) -> UInt:
        """The index of the texel that the view ray through a place on the plane z = 0 meets.

        Both faces are counted. The highest bit is set where the ray passes through a hole.

        Args:
            place: millimetres [2].
            view: in the frame of the face that is seen [3].
        """
        types = self._types
        face = dr.select(back, self._face, 0)
        slope_x, slope_y = (part * dr.rcp(maximum(view.z, 0.02)) for part in (view.x, view.y))

        def gap_at(level: Float) -> Float:
            """Height of the ray over the cloth where it is `level` high."""
            texel = face + self.texel_at(place.x + slope_x * level, place.y + slope_y * level)
            return level - dr.gather(types.Float, self._heights, texel)

        # Steps across the cloth are a share of the finest thread, however flat the ray.
        travelled = self._relief * dr.sqrt(dr.square(slope_x) + dr.square(slope_y))
        count = clip(travelled / self._stride, _MIN_STEPS, _MAX_STEPS)
        step = self._relief / dr.ceil(count)
        width = dr.width(slope_x, place)
        start = self._high + dr.zeros(types.Float, width)

        def advance(upper: Float, over: Float, lower: Float, under: Float) -> tuple[Float, ...]:
            height = lower - step
            return lower, under, height, gap_at(height)

        upper, over, lower, under = dr.while_loop(
            (start, dr.zeros(types.Float, width) + 1, start, gap_at(start)),
            lambda upper, over, lower, under: (under > 0) & (lower > self._low),
            advance,
            label="clustered: parallax",
        )
        found = under <= 0
        for number in range(_REFINEMENTS):
            # Halves bound what steps of the height map do to the straight line.
            share = 0.5 if number % 2 else over * dr.rcp(maximum(over - under, 1e-9))
            middle = upper + share * (lower - upper)
            gap = gap_at(middle)
            is_over = gap > 0
            upper, over = dr.select(is_over, middle, upper), dr.select(is_over, gap, over)
            lower, under = dr.select(is_over, lower, middle), dr.select(is_over, under, gap)
        end = upper + over * dr.rcp(maximum(over - under, 1e-9)) * (lower - upper)
        texel = face + self.texel_at(place.x + slope_x * end, place.y + slope_y * end)
        # As in `yarn.visibility`: a ray through a hole of the plane that nothing above it stops.
        there = face + self.texel_at(place.x, place.y)
        passes = dr.gather(types.Float, self._heights, there) < self._low
        kind = dr.gather(types.Float, self._features, 8 * texel + 3)
        hole = ~found | (kind < 0) | (passes & (end <= 0))
        return texel | dr.select(hole, types.UInt32(_HOLE), 0)

    def lobes(self, point: TexelPoint, light: Vec3, view: Vec3) -> tuple[Float, Float, Float]:
        """Diffuse and specular term at albedo 1, cosine included, 1/sr, and visibility, 0 or 1.

        Args:
            light, view: in the frame of the face that is seen [3].
        """
        types = self._types
        transmits = light.z < 0
        roughness = dr.select(point.is_warp, *self._roughness)
        frame = (point.normal, point.tangent, roughness, types.Float(self._depth))
        diffuse = diffuse_reflection(
            dr.select(transmits, -light, light), point.normal, types.Float(self._blend)
        )
        specular = dr.select(transmits, transmission(light, view, *frame), reflection(light, view, *frame))
        lit = self._free(point, light, transmits) & ~point.hole
        return dr.select(lit, diffuse, 0), dr.select(lit, specular, 0), dr.select(lit, types.Float(1), 0)

    def colour(self, model: YarnScattering, point: TexelPoint, transmits: Mask, tint: Color3 | None) -> Any:
        """Diffuse and specular albedo of a texel's thread on the side of the light, Color3 each."""
        families = model.parameters(self._types)
        found = []
        for number in (0, 2):
            sides = []
            for side in (0, 1):
                warp, weft = (
                    family.albedo(number + side, self._clamped(point, family)) for family in families
                )
                sides.append(dr.select(point.is_warp, warp, weft))
            found.append(dr.select(transmits, sides[1], sides[0]))
        diffuse, specular = found
        return (diffuse if tint is None else diffuse * tint), specular

    def _clamped(self, point: TexelPoint, family: Any) -> UInt:
        # The number of a thread of the other family may be larger.
        return minimum(point.thread, self._types.UInt32(family.threads - 1))

    def _free(self, point: TexelPoint, light: Vec3, transmits: Mask) -> Mask:
        types = self._types
        # The other face has the same texels.
        there = dr.select(point.place >= self._face, point.place - self._face, point.place + self._face)
        word = dr.select(transmits, there, point.place) * (AZIMUTHS // 4)
        turns = dr.atan2(light.y, light.x) * (AZIMUTHS / dr.two_pi)
        turns = dr.select(turns < 0, turns + AZIMUTHS, turns)
        whole = dr.floor(turns)
        first = types.UInt32(whole) & (AZIMUTHS - 1)
        second = (first + 1) & (AZIMUTHS - 1)
        levels = [
            types.Float(
                (dr.gather(types.UInt32, self._horizon, word + (azimuth >> 2)) >> ((azimuth & 3) << 3)) & 255
            )
            for azimuth in (first, second)
        ]
        return 255 * abs(light.z) >= dr.lerp(levels[0], levels[1], turns - whole)

    def texel_at(self, x: Float, y: Float) -> UInt:
        """The texel around draft coordinates (millimetres), within the repeat: UInt32."""
        indices = []
        for position, per_mm, count, whole in zip(
            (x, y), self._per_mm, self._counts, self._wholes, strict=True
        ):
            turns = position * per_mm
            inside = (turns - dr.floor(turns)) * count
            indices.append(minimum(self._types.UInt32(inside), whole - 1))
        return indices[1] * self._wholes[0] + indices[0]
