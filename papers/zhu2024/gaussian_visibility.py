"""Visibility as one anisotropic spherical Gaussian a texel: the compact form of zhu2024 3.1.

    V(ν) = min(1, c·max(ν·z, 0)·exp(−λ(ν·x)² − μ(ν·y)²))

with an orthonormal frame x, y, z, bandwidths λ, μ and an amplitude c a texel (Xu et al. 2013). The minimum
matters: horizons are steps, and a lobe that may not saturate cannot follow them. The lobes are fitted to
a `HorizonMap` by gradient descent on the squared difference over the hemisphere; `error` says how well.
"""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum
from loomlight.yarn.horizon import AZIMUTHS, HorizonMap

PARAMETERS = 7  # z-axis (2, as a projection), rotation of x about it (2), ln λ, ln μ, ln c
_DIRECTIONS = 32  # a step, drawn anew each time: two an azimuth of the horizons
_STEPS = 240
_RATE = 0.06


class GaussianVisibility:
    """The fitted lobes of one repeat, both faces.

    Attributes:
        lobes: [2 faces, rows, columns, 7]; see `PARAMETERS`.
        error: mean absolute difference from the horizons over texels and the hemisphere, by face.
    """

    def __init__(self, table: HorizonMap, float_type: FloatType, saturates: bool = True) -> None:
        """Fits the lobes; `saturates` False leaves the minimum with 1 out, as a comparison."""
        self.size = table.size
        self.resolution = table.resolution
        self._saturates = saturates
        types = array_types(float_type)
        columns, rows = table.resolution
        fitted = [self._fit(types, table.sine[face].reshape(-1, AZIMUTHS)) for face in (0, 1)]
        self.lobes: NDArray[np.float32] = np.stack([lobes for lobes, _ in fitted]).reshape(
            2, rows, columns, PARAMETERS
        )
        self.error: tuple[float, float] = (fitted[0][1], fitted[1][1])

    def _fit(self, types: ArrayTypes, sines: NDArray[np.uint8]) -> tuple[NDArray[np.float32], float]:
        rng = np.random.default_rng(0)
        horizon = [types.Float(sines[:, a].astype(np.float32) / 255) for a in range(AZIMUTHS)]
        values = _start(types, sines)
        first = [dr.zeros(types.Float, len(sines)) for _ in values]
        second = [dr.zeros(types.Float, len(sines)) for _ in values]
        for step in range(1, _STEPS + 1):
            for value in values:
                dr.enable_grad(value)
            loss = self._squared_difference(types, values, horizon, _stratified(rng, _DIRECTIONS))
            dr.backward(loss)
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
            lights = _stratified(rng, _DIRECTIONS)
            difference = self._difference(types, values, horizon, lights)
            total: Float = sum(dr.abs(part) for part in difference)
            error += float(dr.mean(total).numpy().item())
        return np.stack([value.numpy() for value in values], axis=1), error / (8 * _DIRECTIONS)

    def _squared_difference(
        self, types: ArrayTypes, values: list[Float], horizon: list[Float], lights: NDArray[np.float64]
    ) -> Float:
        return sum(part * part for part in self._difference(types, values, horizon, lights))

    def _difference(
        self, types: ArrayTypes, values: list[Float], horizon: list[Float], lights: NDArray[np.float64]
    ) -> list[Float]:
        parts = []
        for index, light in enumerate(lights):
            before = _azimuth_bin(index)
            turns = math.atan2(light[1], light[0]) / (2 * math.pi) * AZIMUTHS
            share = dr.opaque(types.Float, (turns - before) % AZIMUTHS)
            level = dr.lerp(horizon[before], horizon[(before + 1) % AZIMUTHS], share)
            direction = types.Vector3(*(dr.opaque(types.Float, float(part)) for part in light))
            visible = dr.select(direction.z >= level, types.Float(1), 0)
            parts.append(lobe_value(types, values, direction, self._saturates) - visible)
        return parts

    def unoccluded(self, x: Float, y: Float, direction: Vec3, back: Mask) -> Float:
        """Share of light from `direction` that reaches draft coordinates x, y (millimetres), 0 to 1: Float.

        Args:
            direction: unit vector [3] in the frame of the face given by `back`.
        """
        types = array_types(x)
        columns, rows = self.resolution
        column = minimum(types.UInt32(_fraction(x / self.size[0]) * columns), columns - 1)
        row = minimum(types.UInt32(_fraction(y / self.size[1]) * rows), rows - 1)
        face = dr.select(types.Bool(back), types.UInt32(rows * columns), types.UInt32(0))
        texel = (face + row * columns + column) * PARAMETERS
        table = types.Float(self.lobes.ravel())
        values = [dr.gather(types.Float, table, texel + k) for k in range(PARAMETERS)]
        return dr.select(direction.z > 0, lobe_value(types, values, direction, self._saturates), 0)


def lobe_value(types: ArrayTypes, values: list[Float], direction: Vec3, saturates: bool = True) -> Float:
    """The lobe of seven parameters towards a direction [3]."""
    tilt_x, tilt_y, turn_x, turn_y, log_first, log_second, log_amplitude = values
    axis = dr.normalize(types.Vector3(tilt_x, tilt_y, 1))
    # A vector in the plane of the axis, turned by the two rotation parameters.
    side = dr.normalize(types.Vector3(axis.z, 0, -axis.x))
    other = dr.cross(axis, side)
    length = dr.rsqrt(turn_x * turn_x + turn_y * turn_y + 1e-8)
    turned = (side * turn_x + other * turn_y) * length
    across = dr.cross(axis, turned)
    exponent = dr.exp(log_first) * dr.square(dr.dot(direction, turned)) + dr.exp(log_second) * dr.square(
        dr.dot(direction, across)
    )
    value = dr.exp(log_amplitude - exponent) * maximum(dr.dot(direction, axis), 0)
    return minimum(value, 1) if saturates else value


def _start(types: ArrayTypes, sines: NDArray[np.uint8]) -> list[Float]:
    """Wide lobes about the mean free direction."""
    azimuth = 2 * math.pi * np.arange(AZIMUTHS) / AZIMUTHS
    free = 1 - sines.astype(np.float64) / 255
    tilt_x = (free * np.cos(azimuth)).mean(axis=1)
    tilt_y = (free * np.sin(azimuth)).mean(axis=1)
    flat = np.zeros(len(sines))
    columns = [tilt_x, tilt_y, flat + 1, flat + 0.1, flat, flat, flat + math.log(2.0)]
    return [types.Float(column.astype(np.float32)) for column in columns]


def _azimuth_bin(index: int) -> int:
    """Azimuth of the horizon below direction `index`: fixed, so that one kernel serves every step."""
    return 7 * index % AZIMUTHS


def _stratified(rng: np.random.Generator, count: int) -> NDArray[np.float64]:
    """Directions uniform over the hemisphere [count, 3], in strata of height and of azimuth."""
    z = (rng.permutation(count) + rng.random(count)) / count
    bins = np.array([_azimuth_bin(index) for index in range(count)])
    azimuth = 2 * math.pi * (bins + rng.random(count)) / AZIMUTHS
    radius = np.sqrt(1 - z * z)
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)


def _fraction(turns: Float) -> Float:
    return turns - dr.floor(turns)
