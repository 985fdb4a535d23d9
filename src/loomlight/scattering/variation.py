"""Procedural variation from fibre to fibre and from thread to thread (Jin et al. 2022).

Every number comes from an integer hash of (seed, thread, cell), so the pattern repeats nowhere that a 32-bit
index does not, needs no table and is the same on every device. A gain multiplies albedos and is bounded by
the room that the energy bound leaves.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

import drjit as dr

from loomlight.core.arrays import Color3, Float, UInt
from loomlight.core.backend import array_types, maximum, minimum

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
