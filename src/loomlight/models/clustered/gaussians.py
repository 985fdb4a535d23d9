"""Visibility as one anisotropic spherical Gaussian a texel (zhu2024 3.1; Xu et al. 2013).

    V(ν) = min(1, max(ν·c, 0) exp(−(ν·p)² − (ν·q)²))

with orthogonal vectors c, p and q: the axis times the amplitude, the others times the root of a bandwidth.
The minimum matters: horizons are steps, and a lobe that may not saturate, of an amplitude of at most 1, is
four times as far from them.
Lobes are fitted to horizons by gradient descent on the squared difference over the hemisphere.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum, upload
from loomlight.yarn.visibility import AZIMUTHS

LOBE_NUMBERS = 9
_DIRECTIONS = 32  # a step, drawn anew each time: two an azimuth of the horizons
_STEPS = 240
_RATE = 0.06


@dataclass(frozen=True, eq=False)
class Gaussians:
    """Lobes of one repeat, both faces.

    Attributes:
        lobes: c, p and q [2 faces, rows, columns, 9].
        error: mean absolute difference from the horizons over texels and the hemisphere, by face.
    """

    lobes: NDArray[np.float32]
    error: tuple[float, float]


def fitted_gaussians(horizon: NDArray[np.uint8], float_type: FloatType, saturating: bool = True) -> Gaussians:
    """The lobes of horizons [2, rows, columns, 16], sines of elevation in steps of 1/255.

    Args:
        saturating: amplitudes may be above 1.
    """
    types = array_types(float_type)
    found = [_fit(types, face.reshape(-1, AZIMUTHS), saturating) for face in horizon]
    lobes = np.stack([lobes for lobes, _ in found]).reshape(*horizon.shape[:3], LOBE_NUMBERS)
    return Gaussians(lobes, (found[0][1], found[1][1]))


def lobe_value(lobe: tuple[Vec3, Vec3, Vec3], direction: Vec3) -> Float:
    """V towards a direction with z ≥ 0, 0 to 1."""
    axis, first, second = lobe
    exponent = dr.square(dr.dot(direction, first)) + dr.square(dr.dot(direction, second))
    return minimum(maximum(dr.dot(direction, axis), 0) * dr.exp(-exponent), 1)


def lobe_values(lobes: NDArray[np.float32], direction: NDArray[np.float64]) -> NDArray[np.float32]:
    """The same of many lobes [n, 9] towards one direction [3]: [n]."""
    along = lobes.reshape(-1, 3, 3) @ direction.astype(np.float32)
    exponent = np.square(along[:, 1]) + np.square(along[:, 2])
    found: NDArray[np.float32] = np.minimum(np.maximum(along[:, 0], 0) * np.exp(-exponent), 1)
    return found


def _fit(types: ArrayTypes, sines: NDArray[np.uint8], saturating: bool) -> tuple[NDArray[np.float32], float]:
    rng = np.random.default_rng(0)
    horizon = [upload(types.Float, sines[:, a] / np.float32(255)) for a in range(AZIMUTHS)]
    values = _start(types, sines)
    first = [dr.zeros(types.Float, len(sines)) for _ in values]
    second = [dr.zeros(types.Float, len(sines)) for _ in values]
    for step in range(1, _STEPS + 1):
        for value in values:
            dr.enable_grad(value)
        difference = _difference(_lobe_of(types, values, saturating), horizon, _stratified(rng))
        dr.backward(sum(part * part for part in difference))
        # Adam, its rate falling to a tenth; literals would make every step a kernel of its own.
        rate = dr.opaque(types.Float, _RATE * 0.1 ** (step / _STEPS) * math.sqrt(1 - 0.999**step))
        scale = dr.opaque(types.Float, 1 / (1 - 0.9**step))
        for k, value in enumerate(values):
            gradient = dr.grad(value)
            first[k] = 0.9 * first[k] + 0.1 * gradient
            second[k] = 0.999 * second[k] + 0.001 * gradient * gradient
            move = rate * scale * first[k] / (dr.sqrt(second[k]) + 1e-6)
            values[k] = dr.detach(value) - move
        dr.eval(values, first, second)
    error = 0.0
    for _ in range(8):
        lobe = _lobe_of(types, values, saturating)
        total: Float = sum(dr.abs(part) for part in _difference(lobe, horizon, _stratified(rng)))
        error += float(dr.mean(total).numpy().item())
    vectors = [part.numpy() for vector in _lobe_of(types, values, saturating) for part in vector]
    return np.stack(vectors, axis=1).astype(np.float32), error / (8 * _DIRECTIONS)


def _difference(
    lobe: tuple[Vec3, Vec3, Vec3], horizon: list[Float], lights: NDArray[np.float64]
) -> list[Float]:
    types = array_types(lobe[0].x)
    parts = []
    for index, light in enumerate(lights):
        before = _azimuth_bin(index)
        turns = math.atan2(light[1], light[0]) / (2 * math.pi) * AZIMUTHS
        share = dr.opaque(types.Float, (turns - before) % AZIMUTHS)
        level = dr.lerp(horizon[before], horizon[(before + 1) % AZIMUTHS], share)
        direction = types.Vector3(*(dr.opaque(types.Float, float(part)) for part in light))
        visible = dr.select(direction.z >= level, types.Float(1), 0)
        parts.append(lobe_value(lobe, direction) - visible)
    return parts


def _lobe_of(types: ArrayTypes, values: list[Float], saturating: bool) -> tuple[Vec3, Vec3, Vec3]:
    """c, p and q of tilt and turn about the axis, two numbers each, and ln of bandwidths and amplitude."""
    tilt_x, tilt_y, turn_x, turn_y, log_first, log_second, log_amplitude = values
    if not saturating:
        log_amplitude = minimum(log_amplitude, 0)
    axis = dr.normalize(types.Vector3(tilt_x, tilt_y, 1))
    # A vector in the plane of the axis, turned by the two rotation parameters.
    side = dr.normalize(types.Vector3(axis.z, 0, -axis.x))
    length = dr.rsqrt(turn_x * turn_x + turn_y * turn_y + 1e-8)
    turned = (side * turn_x + dr.cross(axis, side) * turn_y) * length
    across = dr.cross(axis, turned)
    return axis * dr.exp(log_amplitude), turned * dr.exp(0.5 * log_first), across * dr.exp(0.5 * log_second)


def _start(types: ArrayTypes, sines: NDArray[np.uint8]) -> list[Float]:
    """Wide lobes about the mean free direction."""
    azimuth = 2 * math.pi * np.arange(AZIMUTHS) / AZIMUTHS
    free = 1 - sines.astype(np.float64) / 255
    tilt_x = (free * np.cos(azimuth)).mean(axis=1)
    tilt_y = (free * np.sin(azimuth)).mean(axis=1)
    flat = np.zeros(len(sines))
    columns = [tilt_x, tilt_y, flat + 1, flat + 0.1, flat, flat, flat + math.log(2.0)]
    return [upload(types.Float, column) for column in columns]


def _azimuth_bin(index: int) -> int:
    """Azimuth of the horizon below direction `index`: fixed, so that one kernel serves every step."""
    return 7 * index % AZIMUTHS


def _stratified(rng: np.random.Generator) -> NDArray[np.float64]:
    """Directions uniform over the hemisphere [`_DIRECTIONS`, 3], in strata of height and of azimuth."""
    z = (rng.permutation(_DIRECTIONS) + rng.random(_DIRECTIONS)) / _DIRECTIONS
    bins = np.array([_azimuth_bin(index) for index in range(_DIRECTIONS)])
    azimuth = 2 * math.pi * (bins + rng.random(_DIRECTIONS)) / AZIMUTHS
    radius = np.sqrt(1 - z * z)
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)
