"""Environments: equirectangular radiance, and the tables by which shaders choose directions from it."""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.environment_map import read_environment_map
from loomlight.core.errors import InputError

# Larger maps are averaged down: a texel of 0.35° is smaller than the sun.
MAX_COLUMNS = 1024


@dataclass(frozen=True, eq=False)
class Environment:
    """Light from all directions, infinitely far away.

    Attributes:
        radiance: linear RGB [rows, columns, 3], equirectangular: +y is above, columns turn from −z over +x.
        turn: degrees about the vertical, as of `loomlight render --env-turn`.
    """

    radiance: NDArray[np.floating]
    turn: float = 0.0

    def __post_init__(self) -> None:
        if self.radiance.ndim != 3 or self.radiance.shape[2] != 3 or 0 in self.radiance.shape:
            raise InputError(f"An environment needs radiance [rows, columns, 3], not {self.radiance.shape}.")
        if not np.isfinite(self.radiance).all() or self.radiance.min() < 0:
            raise InputError("The environment holds radiance that is negative or no finite number.")

    @classmethod
    def read(cls, path: str | os.PathLike[str], turn: float = 0.0) -> Environment:
        """An environment from a latitude-longitude picture: .exr, .hdr, .png or .jpg.

        Raises:
            InputError: what `read_environment_map` raises.
        """
        return cls(read_environment_map(path), turn)

    def tables(self) -> EnvironmentTables:
        """Distributions for shaders, of a map of at most 1024 columns."""
        radiance = _at_most(np.asarray(self.radiance, np.float64), MAX_COLUMNS)
        rows, columns = radiance.shape[:2]
        edges = np.cos(np.arange(rows + 1) / rows * np.pi)
        solid_angles = (edges[:-1] - edges[1:]) * (2 * np.pi / columns)
        weights = radiance.mean(axis=2) * solid_angles[:, None]
        by_row = weights.sum(axis=1)
        total = float(by_row.sum())
        return EnvironmentTables(
            _distribution(by_row[None])[0].astype(np.float32),
            _distribution(weights).astype(np.float32),
            radiance.astype(np.float32),
            total,
        )


@dataclass(frozen=True, eq=False)
class EnvironmentTables:
    """Distributions that shaders choose directions by.

    Attributes:
        rows: cumulative distribution of rows [rows + 1].
        columns: of columns within each row [rows, columns + 1].
        radiance: of each texel [rows, columns, 3].
        total: integral of the mean of red, green and blue over the sphere.
    """

    rows: NDArray[np.float32]
    columns: NDArray[np.float32]
    radiance: NDArray[np.float32]
    total: float

    def words(self) -> NDArray[np.uint32]:
        """All of them, one behind the other."""
        parts = (self.rows, self.columns, self.radiance)
        return np.concatenate([part.ravel() for part in parts]).view(np.uint32)


def _distribution(weights: NDArray[np.float64]) -> NDArray[np.float64]:
    """Cumulative distributions along the last axis, from 0 to 1; uniform where all weights are 0."""
    sums = np.cumsum(weights, axis=-1)
    total = sums[..., -1:]
    count = weights.shape[-1]
    uniform = np.broadcast_to(np.arange(1, count + 1) / count, sums.shape)
    shares = np.where(total > 0, sums / np.where(total > 0, total, 1), uniform)
    return np.concatenate([np.zeros((*shares.shape[:-1], 1)), shares], axis=-1)


def _at_most(radiance: NDArray[np.float64], columns: int) -> NDArray[np.float64]:
    """Means over equal groups of texels, so that there are at most so many columns."""
    step = -(-radiance.shape[1] // columns)
    if step == 1:
        return radiance
    for axis in (0, 1):
        pad = -radiance.shape[axis] % step
        widths = [(0, pad) if a == axis else (0, 0) for a in range(3)]
        radiance = np.pad(radiance, widths, mode="edge")
    rows, width = radiance.shape[0] // step, radiance.shape[1] // step
    return radiance.reshape(rows, step, width, step, 3).mean(axis=(1, 3))
