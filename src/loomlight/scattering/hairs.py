"""Hairs: fibres that have left the yarns and hang over the cloth, across outlines.

They are curves in planes above the highest yarns, so that they slide over the cloth as the view turns; one
may begin in each cell of a square grid of each plane. Each has the colour of one family, is lit as what lies
above all yarns, and casts a soft shadow below. They fade before pixels are as wide as their cells.

Source: the fly-away fibres of the procedural yarns of Zhao, Luan and Bala 2016.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import drjit as dr

from loomlight.core.arrays import Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import array_types, clip, maximum, minimum
from loomlight.scattering.detail import DetailNumbers, Frame, fade
from loomlight.scattering.variation import hash_bits, hash_key

# Grids of cells, a hair a cell; in widths of a fibre the side of cells, half the width of hairs, half their
# length from and to, and the heights of the planes above the highest yarn and over one another.
HAIR_LAYERS = 2
HAIR_CELL = 17.0
HAIR_HALF_WIDTH = 0.28
HAIR_MIN, HAIR_MAX = 5.0, 16.0
HAIR_HEIGHT, HAIR_LIFT = 2.0, 6.0
# Largest sagitta over half the length, and displacement of the ends of an S.
HAIR_CURL, HAIR_BEND = 0.7, 0.5
# Sine of the turn of a hair's normal at its edges.
HAIR_EDGE_SINE = 0.8
# Share of light that a hair takes from what lies below, the widths of a fibre over which its shadow is
# blurred, and the largest shift of hairs over their height.
HAIR_SHADOW, HAIR_BLUR, HAIR_LEAN = 0.5, 1.0, 3.0
# What hairs take at a hairiness of 1 of one family: half of the area of all, a fifth less as they taper, and
# twice as much, as specular terms and light between yarns gain nothing (`studies/accuracy/yarn_detail.py`).
MEAN_SHADE = 1.6 * HAIR_SHADOW * HAIR_LAYERS * HAIR_HALF_WIDTH * (HAIR_MIN + HAIR_MAX) / HAIR_CELL**2
HAIR_STREAM = 0x3C6EF372


@dataclass
class Hair:
    """The hair on top of a point.

    Attributes:
        cover: share of the footprint that it covers, 0 to 1.
        normal, tangent: of the hair [3].
        is_warp: the family whose colour it has.
        shade: share of light that hairs take from points around, in the mean.
    """

    cover: Float
    normal: Vec3
    tangent: Vec3
    is_warp: Mask
    shade: Float

    def family(self, is_warp: Mask) -> Mask:
        """The family that shows where that of the yarn beneath is given."""
        return dr.select(self.cover > 0.5, self.is_warp, is_warp)


@dataclass
class Hairs:
    """The hairs over the points of one face.

    Attributes:
        numbers: of the fabric.
        place: draft coordinates [2], millimetres.
        below: how far the points are below the highest yarn, millimetres.
        back: the face behind is seen.
        size: side of the footprint, millimetres.
    """

    numbers: DetailNumbers
    place: Vec2
    below: Float
    back: Mask
    size: Float

    def seen(self, view: Vec3) -> Hair:
        """The hair that a ray towards the eye, unit vector [3] with z > 0, passes."""
        return _hair_towards(self, view, self.size)

    def lit(self, light: Vec3) -> Float:
        """Share of light from a unit vector [3] that hairs let by, 0 to 1."""
        blurred = self.size + HAIR_BLUR * self.numbers.fibre_size
        return dr.fma(-HAIR_SHADOW, _hair_towards(self, light, blurred).cover, 1)


def _hair_towards(hairs: Hairs, towards: Vec3, size: Float) -> Hair:
    types = array_types(hairs.below)
    numbers, size, fibre = hairs.numbers, dr.detach(types.Float(size)), hairs.numbers.fibre_size
    lean = dr.detach(types.Vector2(towards.x, towards.y) * dr.rcp(maximum(towards.z, 1 / HAIR_LEAN)))
    place, below = dr.detach((hairs.place, hairs.below))
    weight = fade(size, HAIR_CELL * fibre)
    key = hash_key(dr.select(hairs.back, types.UInt32(1), types.UInt32(0)), numbers.seed ^ HAIR_STREAM)
    # A bar of the hair's width, seen by a box of the footprint's side.
    bar = fibre * dr.rcp(maximum(size, 0.25 * HAIR_HALF_WIDTH * fibre))

    def add(number: Any, *best: Any) -> tuple[Any, ...]:
        layer = number // 9
        row = number // 3 - 3 * layer
        column = number - 3 * row - 9 * layer
        rise = dr.fma(dr.fma(types.Float(layer), HAIR_LIFT, HAIR_HEIGHT), fibre, below)
        position = dr.fma(rise, lean, place) * dr.rcp(HAIR_CELL * fibre)
        cell = dr.floor(position) + types.Vector2(types.Float(column) - 1, types.Float(row) - 1)
        index = types.UInt32(types.Int32(cell.x)) * 65536 + types.UInt32(types.Int32(cell.y))
        first = hash_bits(key + layer, index)
        second = hash_bits(key, first)
        offset = position - cell - types.Vector2(_share(first), _share(first >> 10))
        sine, cosine = dr.sincos(math.pi * _share(first >> 20))
        half = dr.fma(_share(second >> 10), HAIR_MAX - HAIR_MIN, HAIR_MIN) * (1 / HAIR_CELL)
        along = (offset.x * cosine + offset.y * sine) * dr.rcp(half)
        across = offset.y * cosine - offset.x * sine
        curl = HAIR_CURL * dr.fma(2, _share(second >> 20), -1)
        bend = HAIR_BEND * dr.fma(2, _share(first ^ second), -1)
        slope = along * dr.fma(3 * bend, along, 2 * curl)
        inverse_length = dr.rsqrt(dr.fma(slope, slope, 1))
        # Distance from the curve, in widths of a fibre.
        curve = dr.square(along) * dr.fma(bend, along, curl)
        away = dr.fma(-half, curve, across) * inverse_length * HAIR_CELL
        # Hairs taper towards their ends.
        half_width = HAIR_HALF_WIDTH * maximum(dr.fma(-dr.square(along), dr.square(along), 1), 0) * bar
        cover = clip(dr.fma(-abs(away), bar, half_width + 0.5), 0, minimum(2 * half_width, 1))
        is_warp = (second >> 30) & 1 == 1
        exists = (_share(second) < numbers.of("hairiness", is_warp)) & (abs(along) < 1)
        taken = exists & (cover > best[0])
        # Across the hair's own direction.
        normal = types.Vector2(-sine - slope * cosine, cosine - slope * sine) * inverse_length
        found = cover, normal, away, is_warp
        return number + 1, *(dr.select(taken, new, old) for new, old in zip(found, best, strict=True))

    width, active = dr.width(place, size, hairs.back, lean), types.Bool(weight > 0)
    kinds = types.UInt32, types.Float, types.Vector2, types.Float, types.Bool
    _, cover, across, away, is_warp = dr.while_loop(
        tuple(dr.zeros(kind, width) for kind in kinds),
        lambda number, *_: active & (number < 9 * HAIR_LAYERS),
        add,
        label="detail: hairs",
    )
    sine = clip(away * (HAIR_EDGE_SINE / HAIR_HALF_WIDTH), -HAIR_EDGE_SINE, HAIR_EDGE_SINE)
    normal = types.Vector3(sine * across.x, sine * across.y, dr.sqrt(dr.fma(-sine, sine, 1)))
    shade = weight * MEAN_SHADE * (numbers.of("hairiness", True) + numbers.of("hairiness", False))
    return Hair(weight * cover, normal, types.Vector3(across.y, -across.x, 0), is_warp, shade)


def _share(bits: UInt) -> Float:
    """The lowest ten bits as a number in (0, 1)."""
    types = array_types(dr.float32_array_t(type(bits)))
    return (types.Float(bits & 1023) + 0.5) * 2**-10


def under_hair(frame: Frame, hair: Hair) -> Frame:
    """The frame of a yarn point, blended with that of the hair on top by what it covers."""
    # A fibre has no front and no rear.
    hair_tangent = dr.select(dr.dot(frame.tangent, hair.tangent) < 0, -hair.tangent, hair.tangent)
    normal = dr.normalize(dr.lerp(frame.normal, hair.normal, hair.cover))
    tangent = dr.lerp(frame.tangent, hair_tangent, hair.cover)
    tangent = dr.fma(-dr.dot(tangent, normal), normal, tangent)
    tangent *= dr.rsqrt(maximum(dr.squared_norm(tangent), 1e-12))
    return Frame(normal, tangent, frame.loss * (1 - hair.cover), hair.shade)
