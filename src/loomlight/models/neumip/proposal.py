"""Directions that a trained source draws: a cosine and a lobe of microfacets, fitted to each texel.

The density of a light l, seen from v, both in the frame of the face that is seen, is

    b·cosine(−l) + (1 − b)·[(1 − s)·cosine(l) + s·p_h(l)],

where b is the share of light that comes from the other side, and p_h the density of mirroring v at a facet.
Slopes of facets have the mean m and the GGX distribution of the matrix L (lower triangular):

    P(slope) = 1 / (π |L| (1 + |L⁻¹(slope − m)|²)²)
    p_h(l) = P / (h_z³ · 4 |v·h|),    h = ±(l + v) / |l + v| with h_z > 0.

A tilted mean stands for parallax and shadows, an anisotropic matrix for fibres. p_h is normalised over the
whole sphere: facets that mirror the view below the surface give directions like others. The numbers are those
of the nearest texel of a small pyramid; neither sampling nor the density asks a network (kuznetsov2021
section 7), except for holes.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import array_types, clip, maximum, upload
from loomlight.models.mip_pyramid import PyramidShape

# Numbers of a texel: mean slopes, the matrix, the shares of the lobe and of the other side, and a 0.
PARAMETERS = 8
# Texels a side of the finest level, at most.
MAX_TEXELS = 32
# Smallest diagonal of the matrix, about the roughness: narrower lobes miss what they were not fitted to.
MIN_ROUGHNESS = 0.1
_MIN_COSINE = 1e-6


def proposal_shape(shape: PyramidShape) -> PyramidShape:
    """The small pyramid of a pyramid of textures."""
    halvings = halvings_of(shape)
    return PyramidShape(
        max(1, shape.columns >> halvings),
        max(1, shape.rows >> halvings),
        shape.width_mm,
        shape.height_mm,
        shape.faces,
    )


def halvings_of(shape: PyramidShape) -> int:
    """Levels of textures that are finer than the small pyramid."""
    return max(0, int(math.log2(max(shape.columns, shape.rows) / MAX_TEXELS)))


def cosine_proposal(shape: PyramidShape) -> NDArray[np.float32]:
    """Texels that draw in proportion to the cosine [texels, `PARAMETERS`]."""
    small = proposal_shape(shape)
    texel = np.array([0, 0, 1, 0, 1, 0, 0, 0], np.float32)
    return np.tile(texel, (small.faces * small.texels, 1))


class DeviceProposal:
    """The texels on one backend."""

    def __init__(self, texels: NDArray[np.float32], shape: PyramidShape, float_type: FloatType) -> None:
        self._small, self._halvings = proposal_shape(shape), halvings_of(shape)
        self._types = array_types(float_type)
        self._texels = upload(float_type, texels)

    def at(self, u: Float, v: Float, level: Float, face: UInt) -> Proposal:
        """The density of directions at positions in repeats.

        Args:
            level: log2 of the footprint's size in texels of the finest texture.
        """
        types, small = self._types, self._small
        number = types.Int32(dr.floor(clip(level - self._halvings, 0, small.levels - 1) + 0.5))
        columns, rows, start = types.Int32(small.columns), types.Int32(small.rows), types.Int32(0)
        for other, (wide, high) in enumerate(small.sizes):
            chosen = number >= other
            columns, rows = dr.select(chosen, wide, columns), dr.select(chosen, high, rows)
            start = dr.select(chosen, small.starts[other], start)
        # Counts are powers of two; NaN becomes 0 before it is an index.
        u, v = (clip(value - dr.floor(value), 0, 1) for value in (u, v))
        column = types.Int32(u * columns) & (columns - 1)
        row = types.Int32(v * rows) & (rows - 1)
        texel = types.UInt32(types.Int32(face) * small.texels + start + row * columns + column) * 2
        low, high = (dr.gather(types.Vector4, self._texels, texel + half) for half in (0, 1))
        return Proposal((low.x, low.y), (low.z, low.w, high.x), high.y, high.z)


@dataclass
class Proposal:
    """Density of directions, in the frame of the face that is seen.

    Attributes:
        mean: slopes of the mean facet.
        matrix: L₁₁, L₂₁ and L₂₂.
        specular: share of the lobe, 0 to 1.
        transmission: share of the other side, 0 to 1.
    """

    mean: tuple[Float, Float]
    matrix: tuple[Float, Float, Float]
    specular: Float
    transmission: Float

    def density(self, light: Vec3, view: Vec3) -> Float:
        """1/sr, over the whole sphere."""
        cosine = dr.abs(light.z) * dr.inv_pi
        near = self.specular * self._facets(light, view)
        near += dr.select(light.z > 0, (1 - self.specular) * cosine, 0)
        return (1 - self.transmission) * near + dr.select(light.z < 0, self.transmission * cosine, 0)

    def sample(self, view: Vec3, choice: Float, u: Vec2) -> Vec3:
        """A direction.

        Args:
            choice: uniform number in [0, 1) that chooses the part.
            u: uniform numbers in [0, 1).
        """
        types = array_types(view.x)
        sine, cosine = dr.sincos(2 * math.pi * u.y)
        radius = dr.sqrt(u.x)
        diffuse = types.Vector3(radius * cosine, radius * sine, dr.sqrt(maximum(1 - u.x, 0)))
        slope = dr.sqrt(u.x / maximum(1 - u.x, 1e-7))
        (a, b, c), (mean_x, mean_y) = self.matrix, self.mean
        x = mean_x + a * slope * cosine
        y = mean_y + slope * (b * cosine + c * sine)
        facet = types.Vector3(-x, -y, 1) * dr.rsqrt(x * x + y * y + 1)
        mirrored = 2 * dr.dot(view, facet) * facet - view
        to_transmission: Mask = choice < self.transmission
        to_facet = choice < self.transmission + (1 - self.transmission) * self.specular
        return dr.select(to_transmission, -diffuse, dr.select(to_facet, mirrored, diffuse))

    def _facets(self, light: Vec3, view: Vec3) -> Float:
        """p_h."""
        half = light + view
        half *= dr.rsqrt(maximum(dr.squared_norm(half), 1e-20))
        half = dr.select(half.z < 0, -half, half)
        up = maximum(half.z, _MIN_COSINE)
        x, y = -half.x / up - self.mean[0], -half.y / up - self.mean[1]
        a, b, c = self.matrix
        first = x / a
        second = (y - b * first) / c
        area = 1 + first * first + second * second
        slopes = dr.rcp(math.pi * a * c * area * area)
        return slopes * dr.rcp(4 * up * up * up * maximum(dr.abs(dr.dot(view, half)), _MIN_COSINE))
