"""A library of analytic isotropic BRDFs in the format of MERL: stand-ins for measurements, labelled as such.

Each is Lambert's law plus one GGX lobe with Smith's shadowing (heights correlated) and Schlick's Fresnel.
Parameters cover the whole range: roughness from mirrors that bins barely resolve to chalk, dielectrics and
metals of all colours. Nothing here was measured.
"""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.files import replacing
from loomlight.sources.merl import BINS, SCALES, MerlLibrary, library_of

_Floats = NDArray[np.float32]
_MIN_ALPHA, _MAX_ALPHA = 0.03, 1.0
_SEED = 100
LIBRARY_SIZE = 16


@dataclass(frozen=True)
class AnalyticBrdf:
    """Parameters of a BRDF.

    Attributes:
        name: begins with "analytic".
        diffuse: albedo of Lambert's law, linear RGB.
        specular: reflectance at normal incidence, linear RGB.
        alpha: of GGX.
    """

    name: str
    diffuse: tuple[float, float, float]
    specular: tuple[float, float, float]
    alpha: float


def analytic_parameters(count: int) -> list[AnalyticBrdf]:
    """So many BRDFs over the whole range of parameters, roughness evenly in its logarithm."""
    found = []
    for number in range(count):
        rng = np.random.default_rng([_SEED, number])
        share = (number + 0.5) / count
        alpha = float(_MIN_ALPHA * (_MAX_ALPHA / _MIN_ALPHA) ** share)
        metal = number % 3 == 2
        colour = rng.uniform(0.02, 0.9, 3)
        diffuse, specular = (np.zeros(3), colour) if metal else (colour, np.full(3, rng.uniform(0.02, 0.08)))
        kind = "metal" if metal else "plastic"
        r, g, b = map(float, diffuse)
        x, y, z = map(float, specular)
        found.append(AnalyticBrdf(f"analytic-{kind}-{number:03d}", (r, g, b), (x, y, z), alpha))
    return found


def analytic_brdf(parameters: AnalyticBrdf, lights: _Floats, views: _Floats) -> _Floats:
    """f, linear RGB, 1/sr [n, 3]; 0 where a direction lies below the horizon."""
    light, view = lights.astype(np.float64), views.astype(np.float64)
    half = light + view
    half /= np.maximum(np.linalg.norm(half, axis=1, keepdims=True), 1e-9)
    cos_light, cos_view = np.maximum(light[:, 2], 1e-4), np.maximum(view[:, 2], 1e-4)
    squared = parameters.alpha**2
    density = squared / (np.pi * (half[:, 2] ** 2 * (squared - 1) + 1) ** 2)
    visibility = 0.5 / (
        cos_view * np.sqrt(squared + (1 - squared) * cos_light**2)
        + cos_light * np.sqrt(squared + (1 - squared) * cos_view**2)
    )
    falling = (1 - np.clip(np.sum(light * half, axis=1), 0, 1)) ** 5
    specular = np.array(parameters.specular)
    fresnel = specular + (1 - specular) * falling[:, None]
    value = np.array(parameters.diffuse) / np.pi + fresnel * (density * visibility)[:, None]
    above = (light[:, 2] > 0) & (view[:, 2] > 0)
    return np.where(above[:, None], value, 0).astype(np.float32)


def analytic_library(count: int) -> MerlLibrary:
    """The library as if it had been read from files."""
    chosen = analytic_parameters(count)
    directions = bin_directions()
    values = np.empty((count, *BINS, 3), np.float16)
    for number, parameters in enumerate(chosen):
        values[number] = analytic_brdf(parameters, *directions).reshape(*BINS, 3).clip(0, 6e4)
    return library_of(f"{count} analytic BRDFs", [each.name for each in chosen], values)


def write_analytic_library(folder: str | os.PathLike[str], count: int = LIBRARY_SIZE) -> None:
    """Writes the library as `.binary` files of 35 MB each.

    Raises:
        InputError: a folder that does not exist or cannot be written to.
    """
    directions = bin_directions()
    for parameters in analytic_parameters(count):
        values = analytic_brdf(parameters, *directions).reshape(*BINS, 3)
        write_merl(Path(folder) / f"{parameters.name}.binary", values)


def write_merl(path: str | os.PathLike[str], values: NDArray[np.floating[Any]]) -> None:
    """Writes f, linear RGB, 1/sr [θ_h, θ_d, φ_d, 3], as a `.binary` file, whole or not at all.

    Raises:
        InputError: a place that cannot be written to.
        ValueError: another shape.
    """
    if values.shape != (*BINS, 3):
        raise ValueError(f"values {values.shape}: a MERL file has {(*BINS, 3)}")
    planes = np.moveaxis(np.asarray(values, np.float64) / SCALES, -1, 0)
    with replacing(path) as temporary, temporary.open("wb") as stream:
        stream.write(np.array(BINS, np.dtype("<i4")).tobytes())
        stream.write(np.ascontiguousarray(planes, np.dtype("<f8")).tobytes())


def bin_directions() -> tuple[_Floats, _Floats]:
    """Lights and views at the middles of all bins [θ_h · θ_d · φ_d, 3]; some lie below the horizon."""
    h, d, phi = np.meshgrid(*(np.arange(count) + 0.5 for count in BINS), indexing="ij")
    half = (h.ravel() / BINS[0]) ** 2 * (math.pi / 2)
    difference, azimuth = d.ravel() / BINS[1] * (math.pi / 2), phi.ravel() / BINS[2] * math.pi
    along = np.sin(difference) * np.cos(azimuth)
    y, z = np.sin(difference) * np.sin(azimuth), np.cos(difference)
    # The difference vector, turned about y so that the pole becomes the half vector.
    light = np.stack([np.cos(half) * along + np.sin(half) * z, y, np.cos(half) * z - np.sin(half) * along], 1)
    normal = np.stack([np.sin(half), np.zeros_like(half), np.cos(half)], 1)
    view = 2 * np.sum(normal * light, axis=1, keepdims=True) * normal - light
    return light.astype(np.float32), view.astype(np.float32)
