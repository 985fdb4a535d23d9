"""Unit vectors: by angles, and drawn at random above cloth."""

from __future__ import annotations

import numpy as np
from drjit.llvm import Array3f
from numpy.typing import NDArray

from loomlight.core.backend import upload_vector

Floats = NDArray[np.float64]


def direction(angle: float, azimuth: float) -> Floats:
    """Unit vector [3] so many degrees from the normal."""
    theta, phi = np.radians([angle, azimuth])
    return np.array([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)])


def above(rng: np.random.Generator, count: int, least_cosine: float) -> Floats:
    """Unit vectors [3, count], uniform over the hemisphere but for those beneath a cosine."""
    cosine, azimuth = rng.uniform(least_cosine, 1, count), rng.uniform(0, 2 * np.pi, count)
    sine = np.sqrt(1 - cosine * cosine)
    return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine])


def by_cosine(rng: np.random.Generator, count: int) -> Floats:
    """Unit vectors [3, count] whose density is their cosine over π: light of a dome."""
    u, azimuth = rng.random(count), 2 * np.pi * rng.random(count)
    return np.stack([np.sqrt(u) * np.cos(azimuth), np.sqrt(u) * np.sin(azimuth), np.sqrt(1 - u)])


def as_vectors(columns: Floats) -> Array3f:
    """Vectors [3, n] for Dr.Jit."""
    return upload_vector(Array3f, columns)


def copies(vector: Floats | tuple[float, float, float], count: int) -> Array3f:
    """The unit vector along a vector, so many times."""
    row = np.array(vector) / np.linalg.norm(vector)
    return as_vectors(np.tile(row[:, None], (1, count)))
