"""Where view rays meet the tubes of yarns that the height field cuts off.

The height field has walls along outlines and dives steeply where a yarn ends, so a ray may end beside the
yarn or within it. Its yarn is round there: the cross-section goes on below the edge, and the centre line
under the yarn that crosses. A ray that ends at depth d below the yarn's surface, x across and
q = sqrt(a² − x²) − d·cos φ above the middle of the circle, in its plane (φ the inclination, s = tan φ), meets
the circle at

    |(x, q) + t·(v_x, (v_z − s·v_y)·cos φ)| = a,

the largest t, towards the eye; where it passes by, it takes the nearest point of the circle. Silhouettes
and hits stay those of the height field.
"""

from __future__ import annotations

from dataclasses import dataclass

import drjit as dr

from loomlight.core.arrays import Float, Mask, UInt, Vec3
from loomlight.core.backend import array_types, clip, maximum

# On a wall lights are searched from beside it, this share of the tube's radius.
FLANK_BESIDE = 0.01
# Gaps in half widths of the yarn that crosses: up to the one yarn fills the cloth and has no room to dive, so
# that the other one's flank covers its end; from the other on the height field's dive is its shape.
FILLED_GAP, OPEN_GAP = 0.2, 0.45


@dataclass
class SurfacePoint:
    """A point of the cloth. Seen from behind, in the mirrored frame of the back face.

    Attributes:
        hole: neither family is here; nothing below then means anything.
        is_warp: the family that shows.
        warp_thread, weft_thread: index of the end and the pick whose cells meet here.
        height: above the plane of the crown lines, millimetres.
        normal: unit normal n_p of the yarn [3].
        tangent: unit fibre direction t [3], in the tangent plane.
        across: distance from the middle of the thread, millimetres, signed.
        fibre_across, fibre_along: position on the yarn's unrolled section across and along its fibres, which
            are straight there, millimetres.
        shown_share: part of its thread that is on this face around here, 0 to 1.
        x, y: draft coordinates, millimetres; of rays that end on walls, right beside them.
        depth: how far below its yarn's tube the ray has ended, millimetres; 0 without a ray.
        plane: height of the plane that its yarn lies in, millimetres; 0 in cloth of one.
        layer: number of the layer of its yarn; 0 in cloth of one.
    """

    hole: Mask
    is_warp: Mask
    warp_thread: UInt
    weft_thread: UInt
    height: Float
    normal: Vec3
    tangent: Vec3
    across: Float
    fibre_across: Float
    fibre_along: Float
    shown_share: Float
    x: Float
    y: Float
    depth: Float
    plane: Float
    layer: UInt


@dataclass
class Sheet:
    """Yarn behind the one that shows, in another layer of the cloth.

    Attributes:
        covered: whether the layer lies behind, and has yarn there.
        is_warp, warp_thread, weft_thread: see `SurfacePoint`.
    """

    covered: Mask
    is_warp: Mask
    warp_thread: UInt
    weft_thread: UInt


@dataclass
class Tube:
    """The yarn around a point of its surface, straight along its centre line, heights before the scale β.

    Attributes:
        radius: a, of the circular cross-section, millimetres.
        across: distance from the middle, millimetres, signed.
        slope: s, of the centre line along the axis.
        scale: β.
        height: of the surface, millimetres, where nothing pushes the yarn down.
    """

    radius: Float
    across: Float
    slope: Float
    scale: Float
    height: Float


def filled_share(gap: Float, half_width: Float) -> Float:
    """How far yarn goes on undiverted where it ends: 1 in filled cloth, 0 where a gap lets it dive."""
    share = clip((OPEN_GAP - gap / half_width) * (1 / (OPEN_GAP - FILLED_GAP)), 0, 1)
    return dr.square(share) * (3 - 2 * share)


def meet_tube(point: SurfacePoint, tube: Tube, twist: Float, ray: tuple[Vec3, Float]) -> None:
    """Moves a point of the height field to where the ray that has ended there meets the yarn's tube.

    Args:
        twist: ψ, radians.
        ray: unit vector [3] towards the eye, and the height where the ray has ended.
    """
    types, is_warp, (view, end) = array_types(tube.height), point.is_warp, ray
    point.depth = tube.height - end
    # Where a ray ends has no derivatives.
    ahead, sine, cosine = dr.detach(_meet(tube, is_warp, view, point.depth))
    point.normal, point.tangent = _frame(tube, is_warp, sine, cosine, twist)
    sideways = dr.select(is_warp, view.x, view.y)
    point.across = dr.fma(ahead, sideways, point.across)
    unrolled = tube.radius * dr.atan2(sine, cosine)
    lengthwise = dr.select(is_warp, dr.fma(ahead, view.y, point.y), -dr.fma(ahead, view.x, point.x))
    twist_sine, twist_cosine = dr.sincos(twist)
    point.fibre_across = dr.fma(unrolled, twist_cosine, lengthwise * twist_sine)
    point.fibre_along = dr.fma(lengthwise, twist_cosine, -unrolled * twist_sine)
    beside = FLANK_BESIDE * tube.radius
    on_wall = ahead < -beside
    aside, forward = dr.copysign(beside, sideways), types.Vector2(view.x, view.y) * maximum(ahead, 0)
    # No in-place sum, which would change the arguments of the caller.
    point.x = point.x + dr.select(on_wall, dr.select(is_warp, aside, 0), forward.x)
    point.y = point.y + dr.select(on_wall, dr.select(is_warp, 0, aside), forward.y)
    point.height = dr.select(on_wall, end, dr.fma(ahead, view.z, end))


def _meet(tube: Tube, is_warp: Mask, view: Vec3, depth: Float) -> tuple[Float, Float, Float]:
    """Where a ray that ends `depth` millimetres below a tube's surface meets it; `view` points to the eye.

    Returns:
        how far from its end towards the eye, millimetres, and x/a, q/a there, a unit vector.
    """
    types = array_types(depth)
    cosine = dr.rsqrt(dr.fma(tube.slope, tube.slope, 1))
    inverse_scale = dr.rcp(tube.scale)
    sideways, lengthwise = dr.select(is_warp, view.x, view.y), dr.select(is_warp, view.y, view.x)
    upwards = dr.fma(view.z, inverse_scale, -tube.slope * lengthwise) * cosine
    up = dr.sqrt(maximum(dr.square(tube.radius) - dr.square(tube.across), 0)) - depth * inverse_scale * cosine
    square = dr.fma(sideways, sideways, dr.square(upwards)) + 1e-12
    half = dr.fma(tube.across, sideways, up * upwards)
    excess = dr.fma(tube.across, tube.across, dr.square(up)) - dr.square(tube.radius)
    root = dr.sqrt(maximum(dr.fma(half, half, -square * excess), 0))
    ahead = dr.select(half > 0, -excess * dr.rcp(maximum(half + root, 1e-12)), (root - half) * dr.rcp(square))
    ahead = clip(ahead, -tube.radius, tube.radius)
    x, q = dr.fma(ahead, sideways, tube.across), dr.fma(ahead, upwards, up)
    inverse = dr.rsqrt(maximum(dr.fma(x, x, dr.square(q)), 1e-12))
    return types.Float(ahead), x * inverse, q * inverse


def _frame(tube: Tube, is_warp: Mask, x: Float, q: Float, twist: Float) -> tuple[Vec3, Vec3]:
    """Normal of the yarn and direction of its fibres [3] at x/a, q/a of the cross-section; `twist` is ψ."""
    types = array_types(x)
    cosine = dr.rsqrt(dr.fma(tube.slope, tube.slope, 1))
    # Weft local frame: its y runs along −x, a proper rotation, so the twist keeps its sign.
    slope = dr.select(is_warp, tube.slope, -tube.slope)
    twist_sine, twist_cosine = dr.sincos(twist)
    around = twist_sine * x * cosine
    across, along = tube.scale * x, -tube.scale * slope * cosine * q
    fibre_across, fibre_along = -twist_sine * q, dr.fma(twist_cosine, cosine, -slope * around)
    lifted = tube.scale * dr.fma(twist_cosine * slope, cosine, around)
    normal = types.Vector3(dr.select(is_warp, across, -along), dr.select(is_warp, along, across), cosine * q)
    tangent = types.Vector3(
        dr.select(is_warp, fibre_across, -fibre_along), dr.select(is_warp, fibre_along, fibre_across), lifted
    )
    return dr.normalize(normal), dr.normalize(tangent)
