"""Procedural variation from fibre to fibre and from thread to thread (Jin et al. 2022).

Every number comes from an integer hash of (seed, thread, cell), so the pattern repeats nowhere that a 32-bit
index does not, needs no table and is the same on every device. A gain multiplies albedos and is bounded by
the room that the energy bound leaves.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeAlias

import drjit as dr

from loomlight.core.arrays import Color3, Float, UInt, Vec2
from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum, opaque
from loomlight.scattering.appearance import Appearance

# Fibres side by side in the finest thread, each cell of their noise so many times as long as wide.
FIBRES_ACROSS = 30
FIBRE_CELL_LENGTH = 40.0
# Jin et al. clamp the exponential noise here; one fibre in 22 000 is brighter.
MAX_FIBRE_GAIN = 10.0
# Two streams that share a seed and a thread must not share numbers.
FIBRE_STREAM = 0x9E3779B9
THREAD_STREAM = 0x7F4A7C15

FourColours: TypeAlias = tuple[Color3, Color3, Color3, Color3]
# From fibre to fibre and from thread to thread, 0 to 1; the seed; κ of `albedo.layer_albedo_bound`.
NoiseNumbers: TypeAlias = tuple[Float, Float, UInt, Float]


@dataclass
class Gain:
    """A gain of albedos, before the energy bound.

    Attributes:
        excess: the gain is 1 + excess, ≥ 0; the mean of the excess is 0.
        largest: largest excess, ≥ 0.
    """

    excess: Float
    largest: Float


def _scramble(value: UInt) -> UInt:
    """PCG output permutation of one congruential step (Jarzynski and Olano 2020), UInt32 to UInt32."""
    state = value * 747796405 + 2891336453
    word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737
    return (word >> 22) ^ word


def hash_key(thread: UInt, stream: UInt) -> UInt:
    """The part of a hash that depends on a thread and a stream, UInt32; see `hash_bits`."""
    types = array_types(dr.float32_array_t(type(thread)))
    return _scramble(thread + _scramble(types.UInt32(stream)))


def hash_bits(key: UInt, cell: UInt) -> UInt:
    """Thirty-two bits that depend on a key of `hash_key` and a cell and on nothing else."""
    # Nested, not added: sums of multiples would make (thread, cell) pairs collide along lines.
    return _scramble(cell + key)


def uniform_hash(thread: UInt, cell: UInt, stream: UInt) -> Float:
    """A number in (0, 1) that depends on three integers (UInt32) and on nothing else; Float."""
    types = array_types(dr.float32_array_t(type(thread)))
    bits = hash_bits(hash_key(thread, stream), cell)
    # 23 bits and a half are exact in float32; with 24, the largest would round to 1.
    return (types.Float(bits >> 9) + 0.5) * 2**-23


def fibre_gain(thread: UInt, cell: UInt, amount: Float, seed: UInt) -> Float:
    """Gain of the specular albedo of one fibre: 1 blended with min(−ln ξ, 10) by `amount` (mean 1).

    Args:
        thread: UInt32, number of the thread over the whole cloth, not within the repeat.
        cell: UInt32, number of the fibre's cell on it.
        amount: 0 to 1 (`Variation.fibre_noise`).
        seed: any 32-bit number.
    """
    types = array_types(dr.float32_array_t(type(thread)))
    number = uniform_hash(thread, cell, types.UInt32(seed) ^ FIBRE_STREAM)
    return dr.fma(amount, minimum(-dr.log(number), MAX_FIBRE_GAIN) - 1, 1)


def thread_gain(thread: UInt, amount: Float, seed: UInt) -> Float:
    """Gain of one thread's albedo: uniform in 1 ± `amount` (`Variation.colour_noise`), mean 1; Float."""
    types = array_types(dr.float32_array_t(type(thread)))
    number = uniform_hash(thread, types.UInt32(0), types.UInt32(seed) ^ THREAD_STREAM)
    return dr.fma(amount, dr.fma(2, number, -1), 1)


def vary_albedos(
    albedos: FourColours, thread: UInt, cell: UInt, noise: NoiseNumbers, detail: Gain | None = None
) -> FourColours:
    """The four albedos of one point varied by fibre and thread, still inside the energy bound.

    The thread's gain applies to the diffuse terms first, then that of the yarn's detail, which is made
    flatter where its largest value has no room, so that its mean stays; the fibre's gain then has the room
    that they leave.

    Args:
        albedos: diffuse_reflect, diffuse_transmit, specular_reflect, specular_transmit; Color3 each.
        thread, cell: see `fibre_gain`.
        detail: of the diffuse albedos, by what the yarn shows close up; None for none.
    """
    fibre_noise, colour_noise, seed, layer_bound = noise
    diffuse_reflect, diffuse_transmit, specular_reflect, specular_transmit = albedos
    highlight = maximum(specular_reflect, specular_transmit)
    diffuse = diffuse_reflect + diffuse_transmit
    left = 1 - layer_bound * highlight
    colour = bounded_gain(thread_gain(thread, colour_noise, seed), diffuse, left)
    if detail is not None:
        colour *= dr.fma(flattened(detail.largest, colour * diffuse, left), detail.excess, 1)
    # A single-scattering albedo is at most 1, whatever the room.
    room = minimum((1 - colour * diffuse) * (1 / layer_bound), 1)
    fibre = bounded_gain(fibre_gain(thread, cell, fibre_noise, seed), highlight, room)
    return (
        colour * diffuse_reflect,
        colour * diffuse_transmit,
        fibre * specular_reflect,
        fibre * specular_transmit,
    )


def bounded_gain(gain: Float, albedo: Color3, room: Float) -> Float:
    """`gain`, lowered to where gain·albedo ≤ room in every channel; one number, so the hue stays.

    Args:
        gain: Float ≥ 0.
        albedo: Color3, what it is going to multiply.
        room: Color3 ≥ 0, the largest allowed product. Where it is below the albedo, the gain falls below 1.
    """
    ratio = room * dr.rcp(maximum(albedo, 1e-6))
    return minimum(gain, maximum(minimum(minimum(ratio.x, ratio.y), ratio.z), 0))


def flattened(largest: Float, albedo: Color3, room: Float) -> Float:
    """Factor of at most 1 of gains 1 + x with x ≤ `largest`, so that no gain times albedo exceeds `room`.

    Args:
        largest: Float ≥ 0.
        albedo: Color3; room: Color3, at least as large.
    """
    ratio = room * dr.rcp(maximum(albedo, 1e-6)) - 1
    most = maximum(minimum(minimum(ratio.x, ratio.y), ratio.z), 0)
    return minimum(most * dr.rcp(maximum(largest, 1e-6)), 1)


# --------------------------------------------------------------------------------------------- uneven threads
# Where threads run in cloth: no yarn is a ruled line.
#
# Every family's coordinate across its threads moves by noise of mean 0 that is smooth along them, in cells
# of a thread and of half of one that repeat nowhere: threads wander, and are thick here and thin there.


# Largest displacement at slub = 1, in spacings; it grows with the root of `slub`.
UNEVENNESS = 0.2
# Cells along threads, in spacings; those of the second octave are half of it.
UNEVEN_CELL = 4.0
UNEVEN_STREAM = 0x2545F491


class Unevenness:
    """How the threads of one fabric wander; `spacings` are mean distances in warp and weft, millimetres."""

    def __init__(self, appearance: Appearance, spacings: tuple[float, float]) -> None:
        slubs = (appearance.warp.detail.slub, appearance.weft.detail.slub)
        self._is_on = max(slubs) > 0
        amounts = [UNEVENNESS * math.sqrt(slub) * size for slub, size in zip(slubs, spacings, strict=True)]
        self._numbers = amounts, spacings, appearance.variation.seed
        self._uploaded: dict[type, tuple[Vec2, Vec2, UInt]] = {}

    def upload(self, types: ArrayTypes) -> tuple[Vec2, Vec2, UInt]:
        """Amounts and spacings of both families, millimetres, and the seed, on a backend."""
        if types.Float not in self._uploaded:
            pairs = [
                types.Vector2(*(opaque(types.Float, size) for size in pair)) for pair in self._numbers[:2]
            ]
            self._uploaded[types.Float] = *pairs, opaque(types.UInt32, self._numbers[2])
        return self._uploaded[types.Float]

    def place(self, centre: Vec2) -> Vec2:
        """Where in the draft the cloth at a place [2] is, both in millimetres."""
        if not self._is_on:
            return centre
        types = array_types(centre.x)
        amounts, spacings, seed = self.upload(types)
        keys = [hash_key(types.UInt32(family), seed ^ UNEVEN_STREAM) for family in (0, 1)]
        warp = _noise(keys[0], centre.x / spacings.x, centre.y / spacings.x)
        weft = _noise(keys[1], centre.y / spacings.y, centre.x / spacings.y)
        return dr.fma(amounts, types.Vector2(warp, weft), centre)


def _noise(key: UInt, across: Float, along: Float) -> Float:
    """Two octaves of noise in ±1 at a place in spacings: one moves threads, the other their edges."""
    first = _smooth(key, across, along * (1 / UNEVEN_CELL))
    return (2 / 3) * first + (1 / 3) * _smooth(key + 1, 2 * across + 0.5, along * (2 / UNEVEN_CELL))


def _smooth(key: UInt, across: Float, along: Float) -> Float:
    """Noise in ±1, smooth between the corners of unit cells."""
    types = array_types(across)
    column, row = dr.floor(across), dr.floor(along)
    s, t = across - column, along - row
    s, t = dr.square(s) * dr.fma(-2, s, 3), dr.square(t) * dr.fma(-2, t, 3)
    cell = types.UInt32(types.Int32(column)) * 65536 + types.UInt32(types.Int32(row))

    def corner(step: int) -> Float:
        return dr.fma(types.Float(hash_bits(key, cell + step) >> 9), 2**-22, -1)

    return dr.lerp(dr.lerp(corner(0), corner(65536), s), dr.lerp(corner(1), corner(65537), s), t)
