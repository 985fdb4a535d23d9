"""What every engine knows of a material: base colour, opacity, normal, one roughness, one reflectance.

Of a fitted material the mean reflection is kept: light that the sheen reflects becomes colour, light that
passes is left out, highlights are as wide as those along and across fibres in the mean, and their reflectance
at normal incidence is what gives the engines' rise towards grazing the albedo of the fit's own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb
from loomlight.exporters.fit import FittedMaterial
from loomlight.exporters.gltf import eight_bits
from loomlight.exporters.standards import Numbers, sheen_albedo

# Mean of Schlick's (1 − cos θ)⁵ over the hemisphere.
_SCHLICK_MEAN = 1 / 21
# What Unreal, Unity's HDRP and Godot reflect at grazing angles over what they do at normal incidence, at most
# all: what reflects less than 2 % is taken for a crevice.
ENGINES_RISE = 50.0
# Engines take half of it, that of glass, for the middle of what a surface may reflect.
_MAX_REFLECTANCE = 0.08


@dataclass(frozen=True, eq=False)
class MetalRough:
    """Textures [rows, columns, ...], linear, row 0 at the lower edge; and numbers for all texels.

    Attributes:
        size: of what the textures hold, millimetres.
        base: base colour [..., 3]. opacity: 0 to 1. normal: unit vectors [..., 3], z away from the cloth.
        roughness: the root of GGX's α, 0 to 1.
        reflectance: at normal incidence, 0 to 0.08.
    """

    size: tuple[float, float]
    base: Numbers
    opacity: Numbers
    normal: Numbers
    roughness: Numbers
    reflectance: float

    def base_color(self, opaque: bool = False) -> NDArray[np.uint8]:
        """sRGB and, unless it is opaque, opacity, row 0 at the upper edge."""
        colour = linear_to_srgb(self.base)
        return eight_bits(colour if opaque else np.concatenate([colour, self.opacity[..., None]], axis=-1))

    def normal_map(self, y_down: bool = False) -> NDArray[np.uint8]:
        """Of OpenGL, whose green is up, or of DirectX, where it is down; row 0 at the upper edge."""
        return eight_bits(0.5 + 0.5 * self.normal * [1, -1 if y_down else 1, 1])


def metal_rough(material: FittedMaterial, rise: float = math.inf) -> MetalRough:
    """The nearest such material.

    Args:
        rise: what is reflected at grazing angles over the reflectance at normal incidence; at most all is.
    """
    sheen = material.sheen * _mean_sheen(material.sheen_roughness)
    reflected = material.base * (1 - material.transmission)[..., None]
    glossy = material.weight * (material.specular.mean() * (1 - _SCHLICK_MEAN) + _SCHLICK_MEAN)
    reflectance = _reflectance(glossy, rise)
    # What is more than a reflectance may say is in the base.
    missing = max(glossy - _glossy_albedo(reflectance, rise), 0.0)
    return MetalRough(
        size=material.size,
        base=np.clip(reflected * (1 - sheen.max()) + sheen + missing, 0, 1),
        opacity=material.cover,
        normal=material.normal,
        roughness=(material.alpha_x * material.alpha_y) ** 0.25,
        reflectance=reflectance,
    )


def _glossy_albedo(reflectance: float, rise: float) -> float:
    """Share of the light that is reflected, in the mean over directions."""
    grazing = min(rise * reflectance, 1) if reflectance > 0 else float(math.isinf(rise))
    return reflectance * (1 - _SCHLICK_MEAN) + grazing * _SCHLICK_MEAN


def _reflectance(albedo: float, rise: float) -> float:
    """The reflectance at normal incidence of such a mean; the least or the largest where none has it."""
    if albedo < _glossy_albedo(1 / rise, rise):
        return albedo / (1 - _SCHLICK_MEAN + rise * _SCHLICK_MEAN)
    return min((albedo - _SCHLICK_MEAN) / (1 - _SCHLICK_MEAN), _MAX_REFLECTANCE)


def _mean_sheen(roughness: float) -> float:
    """Share of the light that white sheen reflects, in the mean over directions."""
    cosines = (np.arange(64) + 0.5) / 64
    return float((2 * cosines * sheen_albedo(cosines, max(roughness**2, 1e-3))).mean())
