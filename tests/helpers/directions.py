"""Random directions: unit vectors [n, 3]."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray


def directions(
    rng: np.random.Generator, count: int, lowest: float = 0.1, back: bool | None = None
) -> NDArray[np.float64]:
    """Unit vectors [count, 3], uniform where |z| is above `lowest`, by default 6° of elevation.

    Args:
        back: whether they lie on the side of −z; None is either side.
    """
    z = rng.uniform(lowest, 1, count)
    z *= rng.choice([-1.0, 1.0], count) if back is None else -1.0 if back else 1.0
    azimuth = rng.uniform(0, 2 * math.pi, count)
    radius = np.sqrt(1 - z**2)
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)


def unit_vectors(rng: np.random.Generator, count: int) -> NDArray[np.float32]:
    """Unit vectors all over the sphere [count, 3], single precision."""
    vectors = rng.normal(size=(count, 3))
    return np.float32(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


def clear_of_the_plane(rng: np.random.Generator, count: int) -> NDArray[np.float32]:
    """Unit vectors all over the sphere [count, 3], at least 3° above or below the cloth."""
    vectors = rng.normal(size=(count, 3))
    vectors /= np.linalg.norm(vectors, axis=1, keepdims=True)
    vectors[:, 2] = np.where(np.abs(vectors[:, 2]) < 0.05, 0.05, vectors[:, 2])
    return np.float32(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


def upper_directions(rng: np.random.Generator, count: int, raised: float = 0.0) -> NDArray[np.float32]:
    """Unit vectors above the cloth [count, 3], single precision; `raised` keeps them off its plane."""
    vectors = rng.standard_normal((count, 3))
    vectors[:, 2] = np.abs(vectors[:, 2]) + raised
    return np.float32(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))
