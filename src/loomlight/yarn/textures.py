"""Textures of one repeat as a second source of geometry (zhu2024 3.1): hand-made maps, scans, thin knits."""

from __future__ import annotations

from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask
from loomlight.core.backend import ArrayTypes, array_types, maximum
from loomlight.yarn.families import Count
from loomlight.yarn.geometry import CellBounds, Probe, SurfacePoint
from loomlight.yarn.maps import SurfaceMaps

_ROW = 8  # floats a texel: normal and height, then tangent and a code for warp and hole


class TextureSurface:
    """One repeat given as maps, with the same interface as `YarnGeometry`.

    Height, normal and tangent are interpolated between the four nearest texels, family and holes are those
    of the nearest. Without maps of the back, that face is the same sheet from behind: heights and slopes
    change sign.
    """

    has_outline_distances = False

    def __init__(self, front: SurfaceMaps, back: SurfaceMaps | None = None) -> None:
        self.size = front.size
        rows, columns = front.height.shape
        self._shape = (columns, rows)
        behind = back if back is not None else _from_behind(front)
        heights = np.concatenate([front.height.ravel(), behind.height.ravel()])
        self._bounds = (float(heights.min()) - 1e-3, float(heights.max()) + 1e-3)
        self._texels = np.stack([_pack(front), _pack(behind)])
        self._uploaded: dict[FloatType, Any] = {}
        self.extents: dict[FloatType, Any] = {}

    @property
    def finest(self) -> tuple[float, float]:
        """Eight texels: what searches treat as a thread, so that no texel is stepped over."""
        columns, rows = self._shape
        return 8 * self.size[0] / columns, 8 * self.size[1] / rows

    @property
    def height_bounds(self) -> tuple[float, float]:
        """Bounds of all heights on either face, millimetres."""
        return self._bounds

    def height(self, x: Float, y: Float, back: Mask) -> tuple[Float, Mask]:
        """Height and hole at draft coordinates, millimetres."""
        point = self.surface(x, y, back)
        return point.height, point.hole

    def max_heights(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> list[tuple[float, Float]]:
        """No pyramid: maps are evaluated sample by sample."""
        return []

    def probe(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> Probe:
        """See `search.Surface.probe`."""
        point = self.surface(x, y, back)
        types = array_types(x)
        far = types.Float(1e9)
        slope_x, slope_y = -point.normal.x / point.normal.z, -point.normal.y / point.normal.z
        yarn = dr.select(point.is_warp, types.UInt32(1), types.UInt32(0))
        bounds = self.cell_bounds(x, y, back, right, up)
        return Probe(point.height, point.hole, slope_x, slope_y, yarn, bounds, far, far)

    def cell_bounds(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> CellBounds:
        """One cell of unbounded size, so that none is skipped."""
        del y, back, right, up
        types = array_types(x)
        far = types.Float(1e9)
        return CellBounds(types.Float(self._bounds[1]), far, far)

    def surface(self, x: Float, y: Float, back: Mask) -> SurfacePoint:
        """The point at draft coordinates x, y (millimetres, any number of repeats) of one face."""
        types = array_types(x)
        table = self._table(types)
        columns, rows = self._shape
        across = x * (columns / self.size[0]) - 0.5
        along = y * (rows / self.size[1]) - 0.5
        column, row = dr.floor(across), dr.floor(along)
        share_x, share_y = across - column, along - row
        around, upwards = Count(columns, types), Count(rows, types)
        left, right = (types.UInt32(around.divide(column + k)[1]) for k in (0, 1))
        lower, upper = (types.UInt32(upwards.divide(row + k)[1]) for k in (0, 1))
        face = dr.select(types.Bool(back), types.UInt32(rows * columns), types.UInt32(0))

        def texel(column: Any, row: Any) -> tuple[Float, Float]:
            index = (face + row * columns + column) * 2
            return (
                dr.gather(types.Vector4, table, index),
                dr.gather(types.Vector4, table, index + 1),
            )

        corners = [texel(left, lower), texel(right, lower), texel(left, upper), texel(right, upper)]
        blended = [
            dr.lerp(
                dr.lerp(corners[0][k], corners[1][k], share_x),
                dr.lerp(corners[2][k], corners[3][k], share_x),
                share_y,
            )
            for k in (0, 1)
        ]
        to_right, to_upper = share_x >= 0.5, share_y >= 0.5
        code = dr.select(
            to_upper,
            dr.select(to_right, corners[3][1].w, corners[2][1].w),
            dr.select(to_right, corners[1][1].w, corners[0][1].w),
        )
        is_warp = (code == 1) | (code == 3)
        normal = dr.normalize(types.Vector3(blended[0].x, blended[0].y, maximum(blended[0].z, 1e-3)))
        fibre = types.Vector3(blended[1].x, blended[1].y, blended[1].z)
        # Interpolated vectors are brought back into the tangent plane.
        fibre -= normal * dr.dot(normal, fibre)
        fallback = types.Vector3(0, normal.z, -normal.y)
        length = dr.squared_norm(fibre)
        tangent = dr.normalize(dr.select(length > 1e-8, fibre, fallback))
        zero = dr.zeros(types.UInt32, dr.width(x))
        return SurfacePoint(
            hole=code >= 2,
            is_warp=is_warp,
            warp_thread=zero,
            weft_thread=zero,
            height=blended[0].w,
            normal=normal,
            tangent=tangent,
            across=dr.select(is_warp, x, y),
            fibre_across=dr.select(is_warp, x, y),
            fibre_along=dr.select(is_warp, y, -x),
        )

    def _table(self, types: ArrayTypes) -> Any:
        if types.Float not in self._uploaded:
            self._uploaded[types.Float] = types.Float(self._texels.ravel())
        return self._uploaded[types.Float]


def _pack(maps: SurfaceMaps) -> NDArray[np.float32]:
    code = maps.warp.astype(np.float32) + 2 * maps.hole.astype(np.float32)
    parts = [maps.normal, maps.height[..., None], maps.tangent, code[..., None]]
    return np.concatenate(parts, axis=-1).reshape(-1, _ROW)


def _from_behind(front: SurfaceMaps) -> SurfaceMaps:
    return SurfaceMaps(
        height=-front.height,
        normal=front.normal * np.asarray([-1, -1, 1], np.float32),
        tangent=front.tangent * np.asarray([1, 1, -1], np.float32),
        warp=front.warp,
        hole=front.hole,
        size=front.size,
    )
