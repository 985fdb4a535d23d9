"""Colours over a footprint: the coverage of each family, and the mean albedos of its threads there.

Models give components by family; thread colours correlate with the weave (stripes, houndstooth), so a
component is multiplied by the mean of its family's albedos over its visible parts in the footprint, not by
one mean colour. Stripes shift with parallax, so the sums belong to a view. Exact colours of coloured fabrics
come from `FabricSlices(with_colours=True)`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.aggregate.components import trace_views, without_sheen_and_variation
from loomlight.aggregate.tables import TEXELS_PER_THREAD, box_means, fabric_grid, summed_areas, texel_boxes
from loomlight.core.arrays import FloatType
from loomlight.core.backend import array_types
from loomlight.scattering.point import YarnScattering

ALBEDOS = ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit")


@dataclass(frozen=True, eq=False)
class FootprintColours:
    """Means over n footprints.

    Attributes:
        coverage: fraction of rays that hit warp and weft [n, 2]; the rest are holes.
        albedos: mean over those rays [n, 2, 4, 3], in the order of `ALBEDOS`, linear RGB; 0 without rays.
    """

    coverage: NDArray[np.float64]
    albedos: NDArray[np.float64]


class ColourSums:
    """Summed areas of coverage and of albedos for one view."""

    def __init__(
        self,
        model: YarnScattering,
        view: ArrayLike,
        float_type: FloatType,
        texels_per_thread: float = TEXELS_PER_THREAD,
    ) -> None:
        """Traces the rays of unit vector `view` [3], z < 0 from behind; see `FabricSlices` for the rest.

        Raises:
            InputError: more than 16 million texels.
        """
        types = array_types(float_type)
        self.grid = fabric_grid(model.surface, texels_per_thread)
        self._float_type = float_type
        x, y = self.grid.points(types, dr.arange(types.UInt32, self.grid.texels))
        eye = types.Vector3(*(dr.opaque(types.Float, float(part)) for part in np.asarray(view, np.float64)))
        point = trace_views(
            without_sheen_and_variation(model), x, y, eye + dr.zeros(types.Vector3, self.grid.texels)
        ).point
        self._tables: list[list[Any]] = []
        for shows in (point.is_warp & ~point.hole, ~point.is_warp & ~point.hole):
            planes = [types.Float(1)]
            planes += [part for name in ALBEDOS for part in getattr(point.albedos, name)]
            masked = [dr.select(shows, plane, 0) for plane in planes]
            dr.eval(masked)
            self._tables.append([summed_areas(plane, self.grid.columns, self.grid.rows) for plane in masked])

    def over(self, centres: ArrayLike, sizes: ArrayLike) -> FootprintColours:
        """Means over axis-aligned boxes; centres and sizes [n, 2] in millimetres."""
        types = array_types(self._float_type)
        boxes = texel_boxes(self.grid, np.asarray(centres), np.asarray(sizes), self._float_type)
        means = np.array(
            [
                [box_means(table, types.UInt32(0), self.grid, boxes).numpy() for table in family]
                for family in self._tables
            ]
        ).transpose(2, 0, 1)
        coverage = means[..., 0]
        albedos = means[..., 1:] / np.maximum(coverage, 1e-9)[..., None]
        return FootprintColours(coverage, albedos.reshape(*coverage.shape, len(ALBEDOS), 3))
