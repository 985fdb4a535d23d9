"""The density that a sampler network describes: an off-centre Trowbridge–Reitz lobe and a tilted cosine lobe.

The formulas are those of listings 3 and 4 of the supplemental of zeltner2024. Half vectors of the first lobe
have slopes distributed by an anisotropic Trowbridge–Reitz density about a slope that is not that of the
normal; the second lobe is a cosine about a tilted normal. Both cover directions below the surface too: those
carry no light.

Formulas take Dr.Jit, torch or NumPy arrays; the module of array functions is an argument, as in
`core/backend.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi
from typing import Any

from loomlight.core.arrays import Float
from loomlight.core.backend import DRJIT

# Outputs of a sampler network.
LOBE_OUTPUTS = 9
# Bounds of outputs, which no training reaches: densities stay finite in float32.
MAX_SLOPE_OUTPUT, MAX_OUTPUT, MAX_LOG_RATIO = 6.0, 50.0, 8.0
# Least roughness of a lobe.
MIN_ALPHA = 1e-4
# Half vectors with a smaller cosine have density 0 (listing 4).
MIN_COSINE = 1e-4


@dataclass(frozen=True)
class LobeMixture:
    """Parameters of the density, one number a lane.

    Attributes:
        alpha: roughnesses along x and y.
        correlation: ρ of both slopes, −1 to 1.
        specular_slope, diffuse_slope: slopes (x, y) of the middles of the lobes.
        specular_share: probability of the specular lobe.
    """

    alpha: tuple[Float, Float]
    correlation: Float
    specular_slope: tuple[Float, Float]
    diffuse_slope: tuple[Float, Float]
    specular_share: Float


def lobe_mixture(outputs: Sequence[Float], math: Any = DRJIT) -> LobeMixture:
    """The mixture of a network's outputs (listing 3).

    Args:
        outputs: `LOBE_OUTPUTS` numbers: roughness x and y, correlation, four slopes, two logarithms of
        weights.
    """

    def slope(x: Float) -> Float:
        """An approximation of sinh."""
        x = math.clip(x, -MAX_SLOPE_OUTPUT, MAX_SLOPE_OUTPUT)
        return x * math.sqrt(1 + x * x)

    alpha_x, alpha_y = (output_roughness(x, math) for x in outputs[:2])
    specular_x, specular_y, diffuse_x, diffuse_y = map(slope, outputs[3:7])
    ratio = math.clip(outputs[8] - outputs[7], -MAX_LOG_RATIO, MAX_LOG_RATIO)
    return LobeMixture(
        (alpha_x, alpha_y),
        _bounded(outputs[2], math),
        (specular_x, specular_y),
        (diffuse_x, diffuse_y),
        1 / (1 + math.exp(ratio)),
    )


def output_roughness(output: Float, math: Any = DRJIT) -> Float:
    """The roughness α that an output of a network stands for, 1e-4 to 1.0001."""
    return MIN_ALPHA + 0.5 * (1 + _bounded(output, math))


def _bounded(x: Float, math: Any) -> Float:
    """An approximation of tanh."""
    x = math.clip(x, -MAX_OUTPUT, MAX_OUTPUT)
    return x / math.sqrt(1 + x * x)


def mixture_density(
    mixture: LobeMixture, light: Sequence[Float], view: Sequence[Float], math: Any = DRJIT
) -> Float:
    """Density of lights per solid angle over the whole sphere, 1/sr.

    Args:
        light, view: unit vectors, three arrays each; the view has z ≥ 0.
    """
    share = mixture.specular_share
    return share * specular_density(mixture, light, view, math) + (1 - share) * _diffuse_density(
        mixture, light, math
    )


def specular_density(
    mixture: LobeMixture, light: Sequence[Float], view: Sequence[Float], math: Any = DRJIT
) -> Float:
    """Density of the specular lobe, 1/sr (`pdf_specular` of listing 4)."""
    x, y, z = (a + b for a, b in zip(light, view, strict=True))
    scale = 1 / math.sqrt(math.maximum(x * x + y * y + z * z, 1e-20))
    scale = math.select(z < 0, -scale, scale)
    x, y, z = x * scale, y * scale, z * scale
    cosine = math.maximum(z, MIN_COSINE)
    (alpha_x, alpha_y), correlation = mixture.alpha, mixture.correlation
    slope_x = -x / cosine - mixture.specular_slope[0]
    slope_y = -y / cosine - mixture.specular_slope[1]
    normalisation = 1 / (alpha_x * alpha_y * math.sqrt(1 - correlation * correlation))
    across = slope_x / alpha_x
    along = (alpha_x * slope_y - correlation * alpha_y * slope_x) * normalisation
    # 1/(π (1 + r²)²), of standard slopes.
    falloff = 1 + across * across + along * along
    of_slopes = normalisation / (pi * falloff * falloff)
    half = math.abs(view[0] * x + view[1] * y + view[2] * z)
    density = of_slopes / (4 * cosine * cosine * cosine * math.maximum(half, 1e-6))
    return math.select(z > MIN_COSINE, density, 0 * density)


def _diffuse_density(mixture: LobeMixture, light: Sequence[Float], math: Any) -> Float:
    slope_x, slope_y = mixture.diffuse_slope
    scale = 1 / math.sqrt(1 + slope_x * slope_x + slope_y * slope_y)
    cosine = (light[2] - slope_x * light[0] - slope_y * light[1]) * scale
    return math.maximum(cosine, 0.0) * (1 / pi)


def sample_mixture(
    mixture: LobeMixture, view: Sequence[Float], choice: Float, u: Sequence[Float], math: Any = DRJIT
) -> tuple[Float, Float, Float]:
    """A light direction, which may lie below the surface: x, y and z.

    Args:
        view: unit vector, three arrays, z ≥ 0.
        choice: uniform number in [0, 1) that chooses the lobe.
        u: two uniform numbers in [0, 1).
    """
    sine, cosine = math.sincos(2 * pi * u[1])
    specular = _sample_specular(mixture, view, u[0], sine, cosine, math)
    diffuse = _sample_diffuse(mixture, u[0], sine, cosine, math)
    chosen = choice < mixture.specular_share
    x, y, z = (math.select(chosen, a, b) for a, b in zip(specular, diffuse, strict=True))
    return x, y, z


def _sample_specular(
    mixture: LobeMixture, view: Sequence[Float], u: Float, sine: Float, cosine: Float, math: Any
) -> list[Float]:
    """Mirrors the view about a half vector (`sample_specular` of listing 4)."""
    radius = math.sqrt(u / math.maximum(1 - u, 1e-7))
    x, y = radius * cosine, radius * sine
    (alpha_x, alpha_y), correlation = mixture.alpha, mixture.correlation
    slope_x = alpha_x * x + mixture.specular_slope[0]
    rest = math.sqrt(1 - correlation * correlation)
    slope_y = alpha_y * (correlation * x + rest * y) + mixture.specular_slope[1]
    scale = 1 / math.sqrt(1 + slope_x * slope_x + slope_y * slope_y)
    half = (-slope_x * scale, -slope_y * scale, scale)
    double = 2 * (view[0] * half[0] + view[1] * half[1] + view[2] * half[2])
    return [double * a - b for a, b in zip(half, view, strict=True)]


def _sample_diffuse(mixture: LobeMixture, u: Float, sine: Float, cosine: Float, math: Any) -> list[Float]:
    """A cosine distribution about a tilted normal (`sample_diffuse` of listing 4)."""
    slope_x, slope_y = mixture.diffuse_slope
    scale = 1 / math.sqrt(1 + slope_x * slope_x + slope_y * slope_y)
    normal_x, normal_y, normal_z = -slope_x * scale, -slope_y * scale, scale
    # The tangent is the x axis made orthogonal to the normal; the bitangent normal × tangent has no x.
    length = math.sqrt(normal_y * normal_y + normal_z * normal_z)
    tangent = (length, -normal_x * normal_y / length, -normal_x * normal_z / length)
    bitangent_y, bitangent_z = normal_z / length, -normal_y / length
    radius, height = math.sqrt(u), math.sqrt(math.maximum(1 - u, 0.0))
    across, along = radius * cosine, radius * sine
    return [
        across * tangent[0] + height * normal_x,
        across * tangent[1] + along * bitangent_y + height * normal_y,
        across * tangent[2] + along * bitangent_z + height * normal_z,
    ]


# ---------------------------------------------------------------------------------- both sides of the surface
# Two mixtures of lobes that a sampler network describes: of the view's side, and of the other one,
# mirrored.
#
# Both cover directions below their own side too, so both count in the density everywhere. Formulas take
# Dr.Jit, torch or NumPy arrays, as those of `lobe_mixture.py`.


# Of a network that describes both sides, and of one for sources that transmit no light.
OUTPUTS, OPAQUE_OUTPUTS = 2 * LOBE_OUTPUTS + 1, LOBE_OUTPUTS
# Bound of the log-odds of the sides: neither is left out.
_MAX_LOG_ODDS = 5.0
_TINY = 1e-6


@dataclass
class TwoSidedLobes:
    """The density that the network describes, without its uniform part.

    Attributes:
        near: lobes of lights on the view's side.
        far: lobes of lights on the other side, mirrored to the view's side.
        reflect: probability of `near`.
    """

    near: LobeMixture
    far: LobeMixture
    reflect: Float

    @classmethod
    def of(cls, outputs: Sequence[Float], math: Any = DRJIT) -> TwoSidedLobes:
        """The lobes of a network's `OUTPUTS` numbers, or of the `OPAQUE_OUTPUTS` of the view's side alone."""
        if len(outputs) == OPAQUE_OUTPUTS:
            near = lobe_mixture(outputs, math)
            return cls(near, near, 1 + 0 * outputs[0])
        odds = math.clip(outputs[-1], -_MAX_LOG_ODDS, _MAX_LOG_ODDS)
        near, far = (lobe_mixture(outputs[k : k + LOBE_OUTPUTS], math) for k in (0, LOBE_OUTPUTS))
        return cls(near, far, 1 / (1 + math.exp(-odds)))

    def density(self, light: Sequence[Float], view: Sequence[Float], math: Any = DRJIT) -> Float:
        """Density of lights over the sphere, 1/sr, in the frame of the face that is seen."""
        mirrored = [light[0], light[1], -light[2]]
        return self.reflect * mixture_density(self.near, light, view, math) + (
            1 - self.reflect
        ) * mixture_density(self.far, mirrored, view, math)

    def sample(
        self, view: Sequence[Float], choice: Float, u: Sequence[Float], math: Any = DRJIT
    ) -> list[Float]:
        """A light: x, y and z.

        Args:
            choice: uniform number in [0, 1) that chooses side and lobe.
            u: two uniform numbers in [0, 1).
        """
        reflects = choice < self.reflect
        # Given the side, the number is uniform again.
        behind = (choice - self.reflect) / math.maximum(1 - self.reflect, _TINY)
        rest = math.select(reflects, choice / self.reflect, behind)
        near = sample_mixture(self.near, view, rest, u, math)
        far = sample_mixture(self.far, view, rest, u, math)
        return [math.select(reflects, a, b) for a, b in zip(near, (far[0], far[1], -far[2]), strict=True)]
