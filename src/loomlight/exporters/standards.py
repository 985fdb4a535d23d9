"""Standard materials: what other programs shade, each by the formulas of its standard.

All have the same parameters, of which `restricted` takes what a standard can say:

* glTF 2.0 with its extensions, as Khronos' specification and three.js since r182 evaluate it;
* the principled material of U3M, Disney's of 2012 (Burley 2012).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]
DIELECTRIC = 0.04
# Reflectance at normal incidence of a specular value of 1 of principled materials.
PRINCIPLED_SPECULAR = 0.08
# α along an axis over that across it is at least this at an anisotropy of 1: Disney's aspect² is 1 − 0.9 a.
PRINCIPLED_RATIO = 0.1


@dataclass(frozen=True, eq=False)
class StandardMaterial:
    """Parameters [n, ...] of n places.

    Attributes:
        base: base colour [n, 3].
        transmission: share of diffuse light that passes [n]; transmit: its colour [n, 3].
        specular: reflectance at normal incidence [n, 3], before `weight`, the specularFactor.
        alpha_x, alpha_y: GGX roughness along `axis_x` and across it [n]; the axes are unit vectors [n, 3].
        normal: shading normal [n, 3].
        sheen: sheen colour [3], grey; sheen_roughness: its roughness, 0 to 1.
    """

    base: Numbers
    transmission: Numbers
    transmit: Numbers
    specular: Numbers
    weight: float
    alpha_x: Numbers
    alpha_y: Numbers
    normal: Numbers
    axis_x: Numbers
    axis_y: Numbers
    sheen: Numbers
    sheen_roughness: float


@dataclass(frozen=True)
class Standard:
    """A standard.

    Attributes:
        evaluate: f·|cos θ_light| [n, 3], 1/sr, of unit vectors [n, 3] away from the surface, light and view;
            the view is above.
        restricted: the nearest material that the standard can describe.
    """

    evaluate: Callable[[StandardMaterial, Numbers, Numbers], Numbers]
    restricted: Callable[[StandardMaterial], StandardMaterial]


def _dot(a: Numbers, b: Numbers) -> Numbers:
    return (a * b).sum(-1)


def evaluate_gltf(material: StandardMaterial, light: Numbers, view: Numbers) -> Numbers:
    """f·|cos θ_light| [n, 3], 1/sr, of unit vectors [n, 3] away from the surface; the view is above."""
    n = material.normal
    n_l, n_v = _dot(n, light), np.maximum(_dot(n, view), 1e-4)
    half = light + view
    half /= np.maximum(np.linalg.norm(half, axis=-1, keepdims=True), 1e-9)
    front = np.maximum(n_l, 0.0)
    schlick = np.clip(1 - _dot(view, half), 0, 1) ** 5
    f0 = material.weight * material.specular
    fresnel = f0 + (material.weight - f0) * schlick[:, None]
    glossy = fresnel * _ggx(material, light, view, half, front, n_v)[:, None]
    diffuse = (1 - fresnel.max(-1, keepdims=True)) * material.base / np.pi
    reflected = diffuse * (1 - material.transmission)[:, None] + glossy
    scale: Numbers | float = 1.0
    if material.sheen.max() > 0:
        alpha = max(material.sheen_roughness**2, 1e-3)
        sheen = material.sheen * _charlie(_dot(n, half), front, n_v, alpha)[:, None]
        taken = np.maximum(sheen_albedo(n_v, alpha), sheen_albedo(np.abs(n_l), alpha))
        scale = 1 - material.sheen.max() * taken[:, None]
        reflected = sheen + reflected * scale
    passed = (
        material.transmit * material.transmission[:, None] / np.pi * np.maximum(-n_l, 0.0)[:, None] * scale
    )
    return np.where((light[:, 2] > 0)[:, None], reflected * front[:, None], passed)


def _ggx(
    material: StandardMaterial, light: Numbers, view: Numbers, half: Numbers, n_l: Numbers, n_v: Numbers
) -> Numbers:
    """Distribution times visibility of anisotropic GGX, height-correlated."""
    ax, ay = material.alpha_x, material.alpha_y

    def local(vector: Numbers) -> tuple[Numbers, Numbers, Numbers]:
        return _dot(vector, material.axis_x), _dot(vector, material.axis_y), _dot(vector, material.normal)

    hx, hy, hz = local(half)
    square = (hx / ax) ** 2 + (hy / ay) ** 2 + hz**2
    distribution = 1 / (np.pi * ax * ay * np.maximum(square, 1e-9) ** 2)
    vx, vy, _ = local(view)
    lx, ly, _ = local(light)
    of_view = n_l * np.sqrt((ax * vx) ** 2 + (ay * vy) ** 2 + n_v**2)
    of_light = n_v * np.sqrt((ax * lx) ** 2 + (ay * ly) ** 2 + n_l**2)
    return distribution * 0.5 / np.maximum(of_view + of_light, 1e-9)


def _charlie(n_h: Numbers, n_l: Numbers, n_v: Numbers, alpha: float) -> Numbers:
    """Distribution (Estevez and Kulla 2017) times the visibility of Ashikhmin and Premoze 2007."""
    sine = np.sqrt(np.clip(1 - n_h**2, 1e-8, 1))
    distribution = (2 + 1 / alpha) * sine ** (1 / alpha) / (2 * np.pi)
    return distribution / np.maximum(4 * (n_l + n_v - n_l * n_v), 1e-6)


_ALPHAS = np.linspace(0.02, 1, 24)
_COSINES = (np.arange(24) + 0.5) / 24


@cache
def _sheen_table() -> Numbers:
    """Directional albedo of white sheen [alpha, cos θ_view], by summing over the hemisphere."""
    cosine, azimuth = np.meshgrid((np.arange(48) + 0.5) / 48, (np.arange(96) + 0.5) * 2 * np.pi / 96)
    sine = np.sqrt(1 - cosine**2)
    light = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1).reshape(-1, 3)
    table = np.zeros((len(_ALPHAS), len(_COSINES)))
    for column, mu in enumerate(_COSINES):
        view = np.array([np.sqrt(1 - mu**2), 0, mu])
        half = light + view
        half /= np.linalg.norm(half, axis=-1, keepdims=True)
        for row, alpha in enumerate(_ALPHAS):
            value = _charlie(half[:, 2], light[:, 2], np.full(len(light), mu), float(alpha)) * light[:, 2]
            table[row, column] = value.mean() * 2 * np.pi
    return table


def sheen_albedo(n_v: Numbers, alpha: float) -> Numbers:
    """Directional albedo of white sheen, 0 to 1."""
    table = _sheen_table()
    row = [np.interp(alpha, _ALPHAS, table[:, column]) for column in range(len(_COSINES))]
    return np.minimum(np.interp(n_v, _COSINES, row), 1)


def evaluate_principled(material: StandardMaterial, light: Numbers, view: Numbers) -> Numbers:
    """Burley 2012, section 5, without clear coat and subsurface; what passes is diffuse, as through paper."""
    n = material.normal
    n_l, n_v = _dot(n, light), np.maximum(_dot(n, view), 1e-4)
    front = np.maximum(n_l, 0.0)
    half = light + view
    half /= np.maximum(np.linalg.norm(half, axis=-1, keepdims=True), 1e-9)
    cosine = np.clip(_dot(view, half), 0, 1)
    of_half = (1 - cosine) ** 5
    f0 = material.specular
    glossy = (f0 + (1 - f0) * of_half[:, None]) * _ggx(material, light, view, half, front, n_v)[:, None]
    roughness = (material.alpha_x * material.alpha_y) ** 0.25
    at_light, at_view = (1 - front) ** 5, (1 - n_v) ** 5
    bent = 2 * roughness * cosine**2
    diffuse = (1 - 0.5 * at_light) * (1 - 0.5 * at_view) + bent * (
        at_light + at_view + at_light * at_view * (bent - 1)
    )
    below = material.base * ((1 - material.transmission) * diffuse / np.pi)[:, None]
    reflected = below + glossy + material.sheen * of_half[:, None]
    passed = material.transmit * (material.transmission / np.pi * np.maximum(-n_l, 0.0))[:, None]
    return np.where((light[:, 2] > 0)[:, None], reflected * front[:, None], passed)


def _principled(material: StandardMaterial) -> StandardMaterial:
    """One colour for what is reflected and what passes, grey gloss up to 8 %, bounded anisotropy."""
    share = material.transmission[..., None]
    reflected, passed = material.base * (1 - share), material.transmit * share
    base = np.clip(reflected + passed, 0, 1)
    grey = np.clip(material.weight * material.specular.mean(-1, keepdims=True), 0, PRINCIPLED_SPECULAR)
    return replace(
        material,
        base=base,
        transmission=np.clip(passed.max(-1) / np.maximum(base.max(-1), 1e-6), 0, 1),
        transmit=base,
        specular=np.repeat(grey, 3, axis=-1),
        weight=1.0,
        alpha_y=np.maximum(material.alpha_y, PRINCIPLED_RATIO * material.alpha_x),
    )


STANDARDS = {
    "gltf": Standard(evaluate_gltf, lambda material: material),
    "principled": Standard(evaluate_principled, _principled),
}
