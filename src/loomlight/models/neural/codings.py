"""Encodings of positions and directions before the layers of the decoder, and components after them.

Each formula serves Dr.Jit and SIMD kernels: `math` is the module drjit or a kernel's `SimdMath`, and numbers
are Floats or `SimdValue`s accordingly.
"""

from __future__ import annotations

import math as scalar
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import drjit as dr

from loomlight.core.arrays import Float, Mask, Vec3
from loomlight.core.backend import maximum
from loomlight.models.neural.architecture import (
    BINS,
    BLOB_RADIUS,
    BUNDLE_POSITIONS,
    BUNDLE_UNIT,
    BUNDLES,
    DENSITY_GAIN,
    DENSITY_SCALE,
    INCLINATION_BINS,
    INCLINATION_CROWDING,
    INCLINATION_RADIUS,
    LEAKY_SLOPE,
    MAX_OUTPUT,
    OPPOSITE,
    REFLECTION_GAIN,
    TRANSMISSION_GAIN,
)

# The first components are the diffuse ones.
DIFFUSE = 2

ElementaryFunctions: TypeAlias = Any
"""The module drjit or a `SimdMath`."""


@dataclass
class Direction:
    """A unit vector in the frame of the face that is seen."""

    x: Float
    y: Float
    z: Float


@dataclass
class Fibre:
    """Fibres of one family at a yarn's crown.

    Attributes:
        x, y: fibre direction, a unit vector in the plane of the cloth.
        roughness: α of GGX.
    """

    x: Float
    y: Float
    roughness: Float

    def cosine(self, x: Float, y: Float) -> Float:
        """Scalar product with (x, y): the cosine with a unit vector."""
        return self.x * x + self.y * y


def one_blob(position: Sequence[Float], math: ElementaryFunctions) -> list[Float]:
    """One-blob encoding of x, y and size, `BINS` numbers each; see `network.one_blob`."""
    coded = []
    for number, value in enumerate(position):
        for bin_ in range(BINS):
            offset = value - (bin_ + 0.5) / BINS
            if number < 2:
                offset -= math.round(offset)
            distance = offset * (BINS / BLOB_RADIUS)
            coded.append(_bump(distance, math))
    return coded


def fibre_features(
    light: Vec3, view: Vec3, fibres: Sequence[Fibre], math: ElementaryFunctions
) -> list[Float]:
    """The part of `network.fibre_features` that depends on the light: `LIGHT_FEATURES` numbers."""
    x, y, z = light.x + view.x, light.y + view.y, light.z + view.z
    height = math.fma(z, z, OPPOSITE)
    inverse_square = math.rcp(math.fma(x, x, math.fma(y, y, height)))
    cosines, bins, densities = [], [], []
    for fibre in fibres:
        cosines.append(fibre.cosine(light.x, light.y))
        cosine = fibre.cosine(x, y)
        square = math.square(cosine)
        length = math.fma(INCLINATION_CROWDING, math.sqrt(square + height), math.abs(cosine))
        position = (0.5 * (1 + INCLINATION_CROWDING)) * cosine * math.rcp(length)
        position = (position + 0.5) * (INCLINATION_BINS / INCLINATION_RADIUS)
        for bin_ in range(INCLINATION_BINS):
            bins.append(_bump(position - (bin_ + 0.5) / INCLINATION_RADIUS, math))
        squared = math.square(fibre.roughness)
        q = math.fma(square * inverse_square, 1 - squared, squared)
        density = (DENSITY_GAIN / scalar.pi) * squared * fibre.roughness * math.rcp(math.square(q))
        densities.append(DENSITY_SCALE * math.log(1 + density))
    return [*cosines, *bins, *densities]


def _bump(distance: Float, math: ElementaryFunctions) -> Float:
    """Quartic kernel: (1 − d²)², 0 beyond |d| = 1."""
    return math.square(math.maximum(math.fma(-distance, distance, 1), 0))


def mixed_bundles(
    lobe_weights: Sequence[Float],
    light: Vec3,
    view: Vec3,
    bundles: Sequence[Sequence[Sequence[Float]]],
    back: Mask,
    math: ElementaryFunctions,
) -> list[Float]:
    """The specular components of both families, mixed from a basis of lobes: `network.mixed_bundles`.

    Args:
        lobe_weights: outputs of the network for the lobes of the face that is seen [2 · `BUNDLES`].
        light, view: unit vectors in the frame of that face.
        bundles: lobes of the front, b and a for both families [2][`BUNDLES`][4]; see `Fibres.bundles`.
        back: whether the back is seen.
    """
    across, along, z = light.x + view.x, light.y + view.y, light.z + view.z
    squared_norm = math.fma(across, across, math.fma(along, along, math.square(z)))
    inverse = math.rcp(squared_norm + OPPOSITE)
    mixed = []
    for family, of_front in enumerate(bundles):
        # Lobes of the back are mirrored across the yarn, and so is the order of their positions.
        x = across if family else math.select(back, -across, across)
        y = math.select(back, -along, along) if family else along
        family_weights = lobe_weights[family * BUNDLES : (family + 1) * BUNDLES]
        terms = []
        for number, (along_x, along_y, along_z, width) in enumerate(of_front):
            cosine = math.fma(along_x, x, math.fma(along_y, y, along_z * z))
            root = math.fma(math.square(cosine), inverse, width)
            mirrored = _mirrored(number)
            weight = family_weights[number]
            if mirrored != number:
                weight = math.select(back, family_weights[mirrored], weight)
            terms.append((math.maximum(weight, weight * LEAKY_SLOPE), math.square(root)))
        mixed.append(BUNDLE_UNIT * _sum_of_fractions(terms, math))
    return mixed


def _sum_of_fractions(terms: Sequence[tuple[Float, Float]], math: ElementaryFunctions) -> Float:
    """Σ numerator / denominator, with one division for two fractions."""
    total: Float = 0
    for (weight, square), (other, others) in zip(terms[::2], terms[1::2], strict=False):
        above = math.fma(weight, others, other * square)
        total = math.fma(above, math.rcp(square * others), total)
    if len(terms) % 2:
        weight, square = terms[-1]
        total = math.fma(weight, math.rcp(square), total)
    return total


def _mirrored(bundle: int) -> int:
    """The number that a lobe of the front has on the back."""
    slope, position = divmod(bundle, BUNDLE_POSITIONS)
    return bundle if bundle == BUNDLES - 1 else slope * BUNDLE_POSITIONS + BUNDLE_POSITIONS - 1 - position


def unmapped(
    output: Sequence[Float],
    specular: Sequence[Float] | None,
    height: Float,
    linear_diffuse: bool,
    math: ElementaryFunctions,
) -> list[Float]:
    """The four components, 1/sr, ≥ 0: `losses.unmapped`.

    Args:
        output: outputs of the network for all components, or for the diffuse ones if `specular` is given.
        specular: components from `mixed_bundles`.
        height: z of the light, in the frame of the face that is seen.
        linear_diffuse: whether the network's diffuse outputs are the components themselves, not logarithms.
    """
    scale = math.select(height > 0, 1 / REFLECTION_GAIN, 1 / TRANSMISSION_GAIN)
    components = []
    for number, value in enumerate(output):
        if linear_diffuse and number < DIFFUSE:
            components.append(math.maximum(value, 0))
        else:
            components.append((math.exp(math.clip(value, 0, MAX_OUTPUT)) - 1) * scale)
    # The bound that `MAX_OUTPUT` sets to logarithms.
    most = scalar.expm1(MAX_OUTPUT) * scale
    return [*components, *(math.clip(component, 0, most) for component in specular or ())]


# ------------------------------------------------------------------------------------------- light visibility
# Light visibility of a footprint from its diffuse component, for the sheen: the network does not know it.
#
# The diffuse term of a yarn point that light reaches is (1 − w) cos θ_l + w n_p·l, over π, that of others
# is 0. The mean of n_p·l over the points of a footprint that the view sees and light reaches is close to
#
#     (a + b cos θ_l) (1 + c sin θ_v cos Δφ)
#
# with Δφ between the azimuths of light and view: lit points face the light, the more so the lower it is,
# and views from its side see them better. The diffuse component over that is the fraction of the points.
# Constants are fitted to slices by `tools/fits/light_visibility.py`.


# a, b, c.
FACING = 0.166, 0.597, 0.216
# Cosines of light and view with the cloth's normal are kept above this.
FACING_MIN_COSINE = 1e-3


def light_visibility_of(diffuse: Float, light: Vec3, view: Vec3, blend: float) -> Float:
    """Fraction of view rays that meet yarn which the light reaches; ≥ 0, about 1 at most.

    Args:
        diffuse: mean diffuse component of both families over the footprint, 1/sr.
        light, view: unit vectors [3].
        blend: w, the weight of the yarn normal in the diffuse term, 0 to 1.
    """
    constant, by_cosine, by_azimuth = FACING
    cos_light = maximum(dr.abs(light.z), FACING_MIN_COSINE)
    # sin θ_v cos Δφ; a light along the normal has no azimuth.
    together = dr.fma(light.x, view.x, light.y * view.y)
    together *= dr.rsqrt(maximum(dr.fma(light.x, light.x, light.y * light.y), 1e-6))
    facing = dr.fma(by_cosine, cos_light, constant) * dr.fma(by_azimuth, together, 1)
    return dr.pi * maximum(diffuse, 0) * dr.rcp(dr.lerp(cos_light, facing, blend))
