"""The reference of the fibre layer: NumPy in float64, derived from the physics and not from the code.

A slab 0 < z < 1 of microflakes of density ρ = Tρ; `view` points away from it, so walks start along −view.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import stats

Array = NDArray[np.float64]


def unit(vector: object) -> Array:
    v = np.asarray(vector, dtype=np.float64)
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def random_frames(rng: np.random.Generator, count: int, tilt: float = 0.0) -> tuple[Array, Array, Array]:
    """Views above random normals, the normals, and tangents up to `tilt` radians out of their planes."""
    normal = unit(rng.normal(size=(count, 3)))
    flat = unit(np.cross(normal, rng.normal(size=(count, 3))))
    angle = rng.uniform(-tilt, tilt, (count, 1))
    tangent = np.cos(angle) * flat + np.sin(angle) * normal
    across = np.cross(normal, flat)
    cos = rng.uniform(0.02, 1, (count, 1))
    azimuth = rng.uniform(0, 2 * np.pi, (count, 1))
    side = np.cos(azimuth) * flat + np.sin(azimuth) * across
    return cos * normal + np.sqrt(1 - cos**2) * side, normal, tangent


def frame_about(axis: Array) -> Array:
    """Rows: two vectors perpendicular to `axis`, and `axis`."""
    helper = np.eye(3)[np.argmin(np.abs(axis))]
    first = unit(np.cross(axis, helper))
    return np.stack([first, np.cross(axis, first), axis])


def area(direction: Array, tangent: Array, roughness: float) -> Array:
    """Projected area by the matrix form sqrt(ωᵀ S ω)."""
    matrix = np.eye(3) - (1 - roughness**2) * np.outer(tangent, tangent)
    return np.sqrt(np.einsum("...i,ij,...j", direction, matrix, direction))


def cosine_table(roughness: float, size: int = 20001) -> tuple[Array, Array]:
    """Cumulative fraction of normals up to each cosine c with the fibre: density ∝ (1 + c²(1/α² − 1))⁻²."""
    c = np.sinh(np.linspace(-1, 1, size) * np.arcsinh(1 / roughness)) * roughness
    c /= c[-1]
    density = (1 + c**2 * (1 / roughness**2 - 1)) ** -2
    share = np.concatenate([[0], np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(c))])
    return c, share


def sample_normals(rng: np.random.Generator, tangent: Array, roughness: float, count: int) -> Array:
    """Normals by their own distribution D (not the visible one), by inverting a table of its cosine."""
    c, share = cosine_table(roughness)
    cos = np.interp(rng.uniform(0, share[-1], count), share, c)
    azimuth = rng.uniform(0, 2 * np.pi, count)
    radius = np.sqrt(1 - cos**2)
    local = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), cos], -1)
    return local @ frame_about(tangent)


def visible_normals(
    rng: np.random.Generator, view: Array, tangent: Array, roughness: float, count: int
) -> Array:
    """Normals as `view` sees them, by rejecting those of D with probability 1 − |view·m|; view·m > 0."""
    actual: list[Array] = []
    missing = count
    while missing > 0:
        normals = sample_normals(rng, tangent, roughness, 1 << 18)
        cos = normals @ view
        # The largest cosine that occurs for fibres seen end-on is small; dividing by it spares rejections.
        kept = rng.uniform(0, np.abs(cos).max(), len(cos)) < np.abs(cos)
        actual.append((normals * np.sign(cos)[:, None])[kept])
        missing -= int(kept.sum())
    return np.concatenate(actual)[:count]


def walk(
    rng: np.random.Generator,
    view: Array,
    normal: Array,
    tangent: Array,
    roughness: float,
    optical_depth: float,
    count: int,
) -> tuple[Array, Array]:
    """Directions in which walks leave after one scattering [count, 3], and what survives of each.

    Free flight, one reflection off a visible flake, attenuation to the boundary that lies ahead. A walk that
    crosses the slab unscattered has weight 0. The weighted distribution is f·cos_light by reciprocity.
    """
    cos_view = view @ normal
    extinction = optical_depth * area(view, tangent, roughness)
    depth = rng.exponential(1 / extinction, count) * cos_view
    flake = visible_normals(rng, view, tangent, roughness, count)
    light = 2 * (flake @ view)[:, None] * flake - view
    cos = light @ normal
    inside = np.minimum(depth, 1)
    left = np.where(cos > 0, inside, 1 - inside) / np.maximum(np.abs(cos), 1e-12)
    survives = np.exp(-optical_depth * area(light, tangent, roughness) * left)
    return light, np.where(depth < 1, survives, 0)


def light_grid(view: Array, tangent: Array, roughness: float, size: tuple[int, int]) -> tuple[Array, Array]:
    """Light directions and the solid angle that each stands for, dense where the fibre sends light.

    A point in each cell of a grid over the half vector, where in the cell by chance: regular points would
    fall in rows along the edges of bins. Cosines with the fibre follow 1/(1 + c²(1/α² − 1)), which leaves
    more points than D to its tails: seen along the fibre, those send the light. dω_light = 4 |view·h| dω_h.
    """
    jitter = np.random.default_rng(0).random((2, *size))
    row, column = (np.indices(size) + jitter).reshape(2, -1)
    steepness = np.sqrt(max(1 / roughness**2 - 1, 1e-6))
    widest = np.arctan(steepness)
    cos = np.tan((2 * row / size[0] - 1) * widest) / steepness
    density = steepness / (2 * widest * (1 + (steepness * cos) ** 2))
    azimuth = column / size[1] * 2 * np.pi
    radius = np.sqrt(1 - cos**2)
    half = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), cos], -1) @ frame_about(tangent)
    towards = half @ view
    seen = towards > 0
    half, towards, density = half[seen], towards[seen], density[seen]
    light = 2 * towards[:, None] * half - view
    return light, 4 * towards * 2 * np.pi / (size[0] * size[1] * density)


def bins_of(direction: Array, frame: Array, counts: tuple[int, int]) -> NDArray[np.intp]:
    """Number of the bin in cosine with the frame's last row and azimuth around it."""
    local = direction @ frame.T
    row = np.clip(((local[:, 2] + 1) / 2 * counts[0]).astype(np.intp), 0, counts[0] - 1)
    turn = np.arctan2(local[:, 1], local[:, 0]) / (2 * np.pi) + 0.5
    return row * counts[1] + np.clip((turn * counts[1]).astype(np.intp), 0, counts[1] - 1)


def chi_square_p(observed: Array, expected: Array) -> float:
    """p-value of counts against expected counts; bins that expect fewer than 10 are one."""
    rare = expected < 10
    observed = np.append(observed[~rare], observed[rare].sum())
    expected = np.append(expected[~rare], expected[rare].sum())
    if expected[-1] < 10:
        # Too little for the statistic; a sampler that strays there would still show up as a miss elsewhere.
        observed, expected = observed[:-1], expected[:-1]
    return float(stats.chi2.sf(np.sum((observed - expected) ** 2 / expected), len(expected) - 1))
