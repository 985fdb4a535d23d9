"""The surface form of the aggregated BSDF (chen2024 eq. 3–5), and its relation to the truth.

chen2024 averages over points of the surface instead of over view rays. With p on the plane z = 0 below the
surface point, ρ = f·cos of the point, V visibility and

    A(p, view) = ⟨view·n_p⟩ / ⟨n_s·n_p⟩ · V(p, view)                                              (eq. 4)

the surface form is ∫ρ V(light) A dp / ∫A dp (eq. 3 and 5). The parallel rays of a view meet the surface with
density A/⟨view·n_s⟩ per area of the plane, so over whole repeats, walls excluded, the truth is the same
average times the share of rays that meet continuous yarn:

    truth = surface form × (1 − hole − wall),    1 − hole − wall = mean of A / ⟨view·n_s⟩

Walls have no extent on the plane, so no surface point stands for them. Over less than a repeat the two see
different points, since a ray that crosses the plane in a footprint meets yarn beside it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.aggregate.components import COMPONENTS, components, meet, without_extras
from loomlight.aggregate.grid import Grid
from loomlight.core.backend import array_types
from loomlight.scattering.point import PointModel, on_face
from loomlight.yarn.visibility import unoccluded


@dataclass(frozen=True, eq=False)
class SurfaceForm:
    """Surface form and truth over one grid of points.

    Attributes:
        surface_form: the four components [4], 1/sr; NaN where no point is visible.
        truth: the four components by view rays, walls excluded [4], 1/sr.
        truth_with_walls: the same with walls, as everywhere else [4], 1/sr.
        continuous: share of view rays that meet continuous yarn.
        wall: share that meets a wall.
        hole: share that passes through.
        projected: mean of A over ⟨view·n_s⟩, which `continuous` should be over whole repeats.
    """

    surface_form: NDArray[np.float64]
    truth: NDArray[np.float64]
    truth_with_walls: NDArray[np.float64]
    continuous: float
    wall: float
    hole: float
    projected: float


def projected_area(model: PointModel, point: Any, view: Any) -> Any:
    """A(p, view) of points of the surface (chen2024 eq. 4): Float, ≥ 0; zero in holes.

    Args:
        point: from `PointModel.at` on the face that the view sees.
        view: unit vectors [3].
    """
    seen = on_face(view, point.back)
    facing = dr.maximum(dr.dot(seen, point.normal), 0) / dr.maximum(point.normal.z, 1e-6)
    worth = (facing > 0) & ~point.hole
    free = unoccluded(model.surface, point.x, point.y, point.height, seen, point.back, worth, model.quality)
    return dr.select(free & worth, facing, 0)


def surface_form(
    model: PointModel, grid: Grid, light: ArrayLike, view: ArrayLike, float_type: type
) -> SurfaceForm:
    """Both averages of the four components over the points of a grid.

    Args:
        grid: a whole repeat for the relation to hold; any window to see what parallax makes of it.
        light, view: unit vectors [3]; z < 0 is the back.
        float_type: the Dr.Jit Float type to compute with.
    """
    types = array_types(float_type)
    plain = without_extras(model)
    texel = dr.arange(types.UInt32, grid.texels)
    x, y = grid.points(types, texel)
    towards, eye = (_everywhere(types, direction, grid.texels) for direction in (light, view))

    met = meet(plain, x, y, eye)
    by_rays = _shaded(plain, met.point, towards, eye)
    continuous = ~met.wall & ~met.point.hole

    back = types.Bool(eye.z < 0)
    _, hole = plain.surface.height(x, y, back)
    below = plain.at(x, y, back, hole)
    by_points = _shaded(plain, below, towards, eye)
    area = _numbers(projected_area(plain, below, eye))

    total = area.sum()
    shown = _numbers(dr.select(continuous, types.Float(1), 0))
    return SurfaceForm(
        surface_form=(by_points * area).sum(axis=1) / total
        if total > 0
        else np.full(len(COMPONENTS), np.nan),
        truth=(by_rays * shown).mean(axis=1),
        truth_with_walls=by_rays.mean(axis=1),
        continuous=float(shown.mean()),
        wall=float(np.mean(met.wall.numpy())),
        hole=float(np.mean(met.point.hole.numpy())),
        projected=float(area.mean()) / abs(float(np.asarray(view)[2])),
    )


def _shaded(model: PointModel, point: Any, light: Any, view: Any) -> NDArray[np.float64]:
    visible = model.visibility(point, light)
    return np.stack([_numbers(part) for part in components(model.appearance, point, light, view, visible)])


def _numbers(value: Any) -> NDArray[np.float64]:
    return np.asarray(value.numpy(), np.float64)


def _everywhere(types: Any, direction: ArrayLike, count: int) -> Any:
    # Opaque, so that one kernel serves every direction.
    parts = (dr.opaque(types.Float, float(part)) for part in np.asarray(direction, np.float64))
    return types.Vector3(*parts) + dr.zeros(types.Vector3, count)
