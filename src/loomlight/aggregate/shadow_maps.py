"""Shadow maps: visibility of points of the cloth, tabulated once per light for all views.

The search along shadow rays is the largest cost of a slice. Where pairs share lights, it is done once a
light, on a grid of points of the face that the light is on. Yarn points read their nearest texel, which moves
shadow edges by up to half a texel.
"""

from __future__ import annotations

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.grid import Grid, divide
from loomlight.core.arrays import Float, FloatType, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, upload
from loomlight.scattering.point import YarnScattering
from loomlight.scattering.yarn_point import to_face_frame
from loomlight.yarn.visibility import unoccluded

_BATCH = 1 << 22


class ShadowMaps:
    """Visibility of several lights over one repeat of cloth.

    Attributes:
        grid: of the points, one repeat.
        visible: Bool, [lights, rows, columns] flattened.
    """

    def __init__(
        self, model: YarnScattering, grid: Grid, lights: NDArray[np.float64], float_type: FloatType
    ) -> None:
        """Computes the maps of unit vectors `lights` [n, 3], z < 0 from behind."""
        types = array_types(float_type)
        self.grid = grid
        directions = upload_vectors(lights, types)
        total = len(lights) * grid.texels
        self.visible = dr.empty(types.Bool, total)
        for first in range(0, total, _BATCH):
            lane = dr.arange(types.UInt32, first, min(first + _BATCH, total))
            index, texel = divide(lane, grid.texels)
            light = dr.gather(types.Vector3, directions, index)
            x, y = grid.points(types, texel)
            back = light.z < 0
            point = model.surface.surface(x, y, back)
            facing = to_face_frame(light, back)
            # The yarn itself occludes lights below its tangent plane.
            rises = dr.dot(point.normal, facing) > 0
            visible = unoccluded(model.surface, x, y, point.height, facing, back, rises, model.quality)
            dr.scatter(self.visible, visible, lane)
        dr.eval(self.visible)

    def texel(self, x: Float, y: Float) -> UInt:
        """The texel of draft coordinates, millimetres: UInt32."""
        return self.grid.nearest(array_types(x), x, y)

    def at(self, light: Vec3, texel: UInt) -> Mask:
        """Whether light number `light` (UInt32) reaches a texel: Bool."""
        texels = dr.opaque(type(texel), self.grid.texels)
        return dr.gather(type(self.visible), self.visible, light * texels + texel)


def upload_vectors(directions: NDArray[np.float64], types: ArrayTypes) -> Vec3:
    """Vectors [n, 3] as a Vector3 of n lanes, axis by axis: one array would compile n into the kernels."""
    return types.Vector3(*(upload(types.Float, axis.astype(np.float32)) for axis in directions.T))
