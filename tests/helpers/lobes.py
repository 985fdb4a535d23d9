"""Cases of the lobes that yarns scatter by, and grids of directions to integrate over."""

from __future__ import annotations

import math

import numpy as np
from drjit.llvm.ad import Array3f
from numpy.typing import NDArray

from tests.helpers.references.microflakes import unit

# Of the diffuse term: upright, leaning, nearly along the cloth, and below it.
NORMALS = [unit(normal) for normal in ([0, 0, 1], [0.3, -0.4, 0.8], [0.98, 0.1, 0.17], [0.6, 0, -0.2])]
FIBRE_ROUGHNESSES = (0.01, 0.03, 0.1, 0.3, 0.6, 1.0)
# Of the sheen: cosine of the view, and roughness.
SHEENS = [(0.02, 0.3), (0.3, 0.05), (0.3, 0.4), (0.7, 0.4), (0.999, 1.0), (0.1, 1.0)]
# Of the sampler network: roughness x and y, correlation, slopes of both lobes, logarithms of weights; before
# their activations.
MIXTURES = {
    "round": [-0.5, -0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    "off-centre": [-0.8, 0.3, 0.9, 0.4, -0.3, 0.2, 0.5, 1.0, 0.0],
    "steep": [0.0, -1.0, -2.0, -1.2, 0.8, -2.0, 1.0, 0.5, 0.0],
    "diffuse alone": [0.0, 0.0, 0.0, 0.0, 0.0, 0.7, -0.4, -50.0, 50.0],
}
MIXTURE_VIEWS = [(0.0, 0.0, 1.0), (0.6, 0.2, math.sqrt(0.6)), (-0.3, 0.86, math.sqrt(1 - 0.09 - 0.7396))]


def view_at(cosine: float, azimuth: float = 2.1) -> Array3f:
    """A view on a device."""
    sine = math.sqrt(1 - cosine**2)
    return Array3f(sine * math.cos(azimuth), sine * math.sin(azimuth), cosine)


def jittered_sphere(size: tuple[int, int] = (1200, 1000)) -> tuple[NDArray[np.float64], float]:
    """Directions all over the sphere, and the solid angle of each."""
    row, column = (np.indices(size) + np.random.default_rng(0).random((2, *size))).reshape(2, -1)
    z, azimuth = 1 - 2 * row / size[0], 2 * np.pi * column / size[1]
    radius = np.sqrt(1 - z**2)
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], -1), 4 * np.pi / len(z)


def jittered_upper_half(
    size: tuple[int, int] = (2000, 600),
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Directions above the cloth, denser towards the horizon, and the solid angle of each."""
    row, column = (np.indices(size) + np.random.default_rng(0).random((2, *size))).reshape(2, -1)
    z, azimuth = (row / size[0]) ** 2, 2 * np.pi * column / size[1]
    radius = np.sqrt(1 - z**2)
    directions = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], -1)
    return directions, 2 * row / size[0] / size[0] * 2 * np.pi / size[1]
