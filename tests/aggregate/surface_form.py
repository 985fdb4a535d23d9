"""The surface form of the aggregated BSDF (chen2024 eq. 3–5), and its relation to the truth.

chen2024 averages over points of the surface instead of over view rays. With p on the plane z = 0 below the
surface point, ρ = f·cos of the point, V visibility and

    A(p, view) = ⟨view·n_p⟩ / ⟨n_s·n_p⟩ · V(p, view)                                              (eq. 4)

the surface form is ∫ρ V(light) A dp / ∫A dp (eq. 3 and 5). The parallel rays of a view meet the surface with
density A/⟨view·n_s⟩ per area of the plane, so over whole repeats, walls excluded, the truth is the same
average times the fraction of rays that hit continuous yarn:

    truth = surface form × (1 − hole − wall),    1 − hole − wall = mean of A / ⟨view·n_s⟩

Walls have no extent on the plane, so they have no surface points. V(view) is 0 as well where the view ray
through a point passes through the cloth: that ray is counted as a hole (else A would sum to 4 % too much on
plain weave). Over less than a repeat the two averages are over different points, since a ray that crosses the
plane in a footprint hits yarn beside it.
"""

from __future__ import annotations

from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.aggregate.components import COMPONENTS, components, trace_views, without_sheen_and_variation
from loomlight.aggregate.tables import Grid
from loomlight.core.arrays import Float, FloatType, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum
from loomlight.scattering.point import YarnPoint, YarnScattering, to_face_frame
from loomlight.yarn.visibility import passes_through, unoccluded


@dataclass(frozen=True, eq=False)
class SurfaceForm:
    """Surface form and truth over one grid of points.

    Attributes:
        surface_form: the four components [4], 1/sr; NaN where no point is visible.
        truth: the four components by view rays, walls excluded [4], 1/sr.
        truth_with_walls: the same with walls, as everywhere else [4], 1/sr.
        continuous: fraction of view rays that hit continuous yarn.
        wall: fraction that hits a wall.
        hole: fraction that passes through the cloth.
        projected: mean of A over ⟨view·n_s⟩; over whole repeats it equals `continuous`.
    """

    surface_form: NDArray[np.float64]
    truth: NDArray[np.float64]
    truth_with_walls: NDArray[np.float64]
    continuous: float
    wall: float
    hole: float
    projected: float


@dataclass(frozen=True, eq=False)
class SurfaceSamples:
    """Samples that `surface_form` averages, one for each position on the plane z = 0.

    Attributes:
        by_rays: components at the hit of the view ray through each position [4, n], 1/sr.
        continuous, wall, hole: kind of that hit [n], bool, exactly one of them true.
        by_points: the same where the ray through the surface point below each position meets yarn.
        area: its visible projected area A [n].
    """

    by_rays: NDArray[np.float64]
    continuous: NDArray[np.bool_]
    wall: NDArray[np.bool_]
    hole: NDArray[np.bool_]
    by_points: NDArray[np.float64]
    area: NDArray[np.float64]


def projected_area(model: YarnScattering, point: YarnPoint, view: Vec3) -> Float:
    """A(p, view) of points of the surface (chen2024 eq. 4): Float, ≥ 0; zero in holes.

    Args:
        point: from `YarnScattering.at` on the face that the view sees.
        view: unit vectors [3].
    """
    seen = to_face_frame(view, point.back)
    facing = maximum(dr.dot(seen, point.normal), 0) / maximum(point.normal.z, 1e-6)
    worth = (facing > 0) & ~point.hole
    surface, quality = model.surface, model.quality
    free = unoccluded(surface, point.x, point.y, point.height, seen, point.back, worth, quality)
    rise = point.height / maximum(seen.z, 1e-4)
    through = passes_through(
        surface, point.x - seen.x * rise, point.y - seen.y * rise, seen, point.back, free & worth, quality
    )
    return dr.select(free & worth & ~through, facing, 0)


def surface_samples(
    model: YarnScattering, x: Float, y: Float, light: ArrayLike, view: ArrayLike
) -> SurfaceSamples:
    """Both kinds of samples at positions x, y (draft millimetres) of the plane z = 0.

    Args:
        light, view: unit vectors [3]; z < 0 is the back.
    """
    types = array_types(x)
    plain = without_sheen_and_variation(model)
    towards, eye = (_everywhere(types, direction, dr.width(x)) for direction in (light, view))
    met = trace_views(plain, x, y, eye)
    back = types.Bool(eye.z < 0)
    _, hole = plain.surface.height(x, y, back)
    below = plain.at(x, y, back, hole)
    ray = to_face_frame(eye, back), below.height
    # Where yarns dive, points lie well below the tubes that rays meet: they count as walls.
    dives = plain.surface.surface(x, y, back, ray).depth > 1e-3 * min(plain.surface.finest)
    area = dr.select(dives, 0, projected_area(plain, below, eye))
    is_null, wall = np.asarray(met.point.hole.numpy(), bool), np.asarray(met.wall.numpy(), bool)
    return SurfaceSamples(
        by_rays=_shaded(plain, met.point, towards, eye),
        continuous=~wall & ~is_null,
        wall=wall,
        hole=is_null,
        by_points=_shaded(plain, plain.at(x, y, back, hole, ray=ray), towards, eye),
        area=np.asarray(area.numpy(), np.float64),
    )


def surface_form(
    model: YarnScattering, grid: Grid, light: ArrayLike, view: ArrayLike, float_type: FloatType
) -> SurfaceForm:
    """Both averages of the four components over the points of a grid.

    Args:
        grid: of a whole repeat, where the relation holds, or of any window.
        light, view: unit vectors [3]; z < 0 is the back.
        float_type: the Dr.Jit Float type to compute with.
    """
    types = array_types(float_type)
    x, y = grid.points(types, dr.arange(types.UInt32, grid.texels))
    samples = surface_samples(model, x, y, light, view)
    total = samples.area.sum()
    nothing = np.full(len(COMPONENTS), np.nan)
    return SurfaceForm(
        surface_form=(samples.by_points * samples.area).sum(axis=1) / total if total > 0 else nothing,
        truth=(samples.by_rays * samples.continuous).mean(axis=1),
        truth_with_walls=samples.by_rays.mean(axis=1),
        continuous=float(samples.continuous.mean()),
        wall=float(samples.wall.mean()),
        hole=float(samples.hole.mean()),
        projected=float(samples.area.mean()) / abs(float(np.asarray(view, np.float64)[2])),
    )


def _shaded(model: YarnScattering, point: YarnPoint, light: Vec3, view: Vec3) -> NDArray[np.float64]:
    visible = model.visibility(point, light)
    parts = components(model.appearance, point, light, view, visible)
    return np.stack([np.asarray(part.numpy(), np.float64) for part in parts])


def _everywhere(types: ArrayTypes, direction: ArrayLike, count: int) -> Vec3:
    # Opaque, so that one kernel serves every direction.
    parts = (dr.opaque(types.Float, float(part)) for part in np.asarray(direction, np.float64))
    return types.Vector3(*parts) + dr.zeros(types.Vector3, count)
