"""Visibility from light and eye: searches along rays over the analytic height field.

A hit is bracketed and refined, so results hold at any zoom and the cost does not grow with the draft. A ray
passes through a *hole* when it meets nothing above the plane z = 0 from the front and nothing below it from
the back, so both faces agree about which rays pass.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum
from loomlight.core.errors import InputError
from loomlight.yarn.rays import (
    DEFAULT_QUALITY,
    SearchQuality,
    ShadowRay,
    Surface,
    extent_of,
    shadow_ray,
    shadow_ray_below,
    view_ray,
)


@dataclass
class Hit:
    """Where a view ray meets the cloth.

    Attributes:
        x, y: draft coordinates of the yarn point, millimetres; of no meaning in holes.
        hole: the ray passes through the cloth.
        height: where the ray ends. On continuous yarn that is the surface; on a wall, below its upper edge.
    """

    x: Float
    y: Float
    hole: Mask
    height: Float


def unoccluded(
    surface: Surface,
    x: Float,
    y: Float,
    height: Float,
    direction: Vec3,
    back: Mask,
    active: Mask = True,
    quality: SearchQuality = DEFAULT_QUALITY,
) -> Mask:
    """Whether nothing stands between a point of the cloth and a direction: Bool.

    What lies below the tangent plane of the point is for the caller to leave out.

    Args:
        x, y: draft coordinates, millimetres.
        height: of the point, millimetres, on the face given by `back`.
        direction: unit vector [3] in the frame of that face; with z ≤ 0 nothing is visible.
        back: Bool, the face the height counts from.
        active: lanes to search; the others return False.
    """
    active = array_types(x).Bool(active)
    return _is_free(shadow_ray(surface, x, y, height, direction, back, quality), active)


def _is_free(ray: ShadowRay, active: Mask) -> Mask:
    """True where the shadow ray hits nothing."""
    start = ray.initial_state(active & (ray.direction.z > 0))
    return dr.while_loop(
        (start,),
        lambda state: state.searching,
        lambda state: (ray.next_state(state),),
        label="cloth: unoccluded",
    )[0].free


def first_hit(
    surface: Surface,
    x: Float,
    y: Float,
    view: Vec3,
    back: Mask,
    active: Mask = True,
    quality: SearchQuality = DEFAULT_QUALITY,
    passing: bool = True,
) -> Hit:
    """The first point of the cloth along the view ray that crosses the plane z = 0 at x, y.

    Exact parallax (zhu2024 eq. 2 without its table and clamp). Rays that meet a wall end at the edge of the
    yarn that stands there.

    Args:
        x, y: draft coordinates where the ray meets the plane of the crown lines, millimetres.
        view: unit vector [3] towards the eye in the frame of the face seen, z > 0.
        back: Bool, which face is seen.
        passing: look whether rays pass through; if not, none is said to.
    """
    ray = view_ray(surface, x, y, view, back, quality)
    active = array_types(x).Bool(active)
    hole = array_types(x).Bool(False)
    if passing:
        # Decided by this search alone, whatever the view ray would meet: the hole is the same without the
        # hit, and for a ray from the other side.
        hole = passes_through(surface, x, y, view, ray.back, active, quality)
        active = active & ~hole
    state = dr.while_loop(
        (ray.initial_state(active),),
        lambda state: state.searching,
        lambda state: (ray.next_state(state),),
        label="cloth: first hit",
    )[0]
    height = ray.refined_height(state, quality.refinements)
    return Hit(dr.fma(ray.slope.x, height, x), dr.fma(ray.slope.y, height, y), hole, height)


def passes_through(
    surface: Surface,
    x: Float,
    y: Float,
    view: Vec3,
    back: Mask,
    active: Mask = True,
    quality: SearchQuality = DEFAULT_QUALITY,
) -> Mask:
    """Whether the line through x, y on the plane z = 0 along `view` meets no yarn at all: Bool.

    The same for a direction and its opposite seen from the other face, so delta transmission is reciprocal.
    """
    types = array_types(x)
    back = types.Bool(back)
    _, hole = surface.height(x, y, back)
    candidate = types.Bool(active) & hole
    # Unlifted again: the ray starts on the plane.
    extent = extent_of(surface, types)
    zero, high = -extent.lift, extent.high
    in_front = _is_free(shadow_ray_below(surface, x, y, zero, view, back, high, quality), candidate)
    # Seen from the other face the line goes on along (−x, −y, +z) of its mirrored frame.
    beyond = types.Vector3(-view.x, -view.y, view.z)
    passed = candidate & in_front
    return passed & _is_free(shadow_ray_below(surface, x, y, zero, beyond, ~back, high, quality), passed)


def horizon(
    surface: Surface,
    x: Float,
    y: Float,
    height: Float,
    azimuth: Float,
    back: Mask,
    quality: SearchQuality = DEFAULT_QUALITY,
) -> Float:
    """Tangent of the elevation below which the cloth hides the sky along an azimuth (radians), ≥ 0.

    Searched outwards until even the highest yarn could no longer raise it.
    """
    types = array_types(x)
    outwards: tuple[Float, Float] = dr.sincos(azimuth)
    sine, cosine = outwards
    extent = extent_of(surface, types)
    high = extent.high
    step = dr.rcp(extent.threads(cosine, sine) * quality.steps_per_thread)
    start = height + extent.lift
    back = types.Bool(back)

    def could_rise(distance: Float, steepest: Float, count: UInt) -> Mask:
        return (high - start > steepest * distance) & (count < quality.steps)

    def advance(distance: Float, steepest: Float, count: UInt) -> tuple[Any, ...]:
        level, hole = surface.height(dr.fma(cosine, distance, x), dr.fma(sine, distance, y), back)
        rise = dr.select(hole, types.Float(0), (level - start) / distance)
        return distance + step, maximum(steepest, rise), count + 1

    # The yarn itself hides what lies below its tangent plane. Without any rise the search would only end
    # with the budget; 1e-3 is a horizon of 0.06°.
    here = surface.probe(x, y, back, cosine > 0, sine > 0)
    own = dr.fma(here.slope_x, cosine, here.slope_y * sine)
    state = (types.Float(0.25 * step), maximum(own, 1e-3), types.UInt32(0))
    return dr.while_loop(state, could_rise, advance, label="cloth: horizon")[1]


# --------------------------------------------------------------------------------------- tabulated visibility
# Tabulated visibility: the horizon of every texel of one repeat, for both faces.
#
# As coarse as its grid: for the models that prefilter visibility. Close-ups search along the light ray.


# Azimuths a texel: more than 16 change the light that cloth reflects by less than 0.5 %.
AZIMUTHS = 16
_BATCH = 1 << 22
_QUALITY = SearchQuality(steps_per_thread=8)


class HorizonMap:
    """Horizons of one repeat: sine of the elevation [2 faces, rows, columns, azimuths] in 1/255 steps.

    Between azimuths the horizon is interpolated; a texel holds the horizon of its middle.
    """

    def __init__(
        self,
        surface: Surface,
        resolution: tuple[int, int],
        float_type: FloatType,
        quality: SearchQuality = _QUALITY,
    ) -> None:
        """Searches the horizons.

        Args:
            resolution: columns and rows.
            float_type: the Dr.Jit Float type to compute with.

        Raises:
            InputError: more than 16 million texels.
        """
        columns, rows = resolution
        if columns * rows > 1 << 24:
            raise InputError(
                f"A horizon map of {columns}x{rows} texels is too large; 16 million can be tabulated."
            )
        self.size = surface.size
        self.resolution = resolution
        self.sine: NDArray[np.uint8] = np.stack(
            [self._search(surface, array_types(float_type), back, quality) for back in (False, True)]
        )

    def _search(
        self, surface: Surface, types: ArrayTypes, back: bool, quality: SearchQuality
    ) -> NDArray[np.uint8]:
        columns, rows = self.resolution
        total = columns * rows * AZIMUTHS
        parts = []
        for first in range(0, total, _BATCH):
            index = dr.arange(types.UInt32, first, min(first + _BATCH, total))
            texel = index // AZIMUTHS
            row = texel // columns
            x = (types.Float(texel - row * columns) + 0.5) * (self.size[0] / columns)
            y = (types.Float(row) + 0.5) * (self.size[1] / rows)
            azimuth = types.Float(index - texel * AZIMUTHS) * (dr.two_pi / AZIMUTHS)
            face = dr.full(types.Bool, back, dr.width(index))
            level, _ = surface.height(x, y, face)
            tangent = horizon(surface, x, y, level, azimuth, face, quality)
            sine = tangent * dr.rsqrt(dr.fma(tangent, tangent, 1))
            parts.append(np.rint(np.clip(sine.numpy(), 0, 1) * 255).astype(np.uint8))
        return np.concatenate(parts).reshape(rows, columns, AZIMUTHS)
