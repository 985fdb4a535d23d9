"""Fits what directions are drawn from (`proposal.py`) to queries: the density nearest to f·cos.

Nearest by relative entropy: the mean of −log p(light | view, texel) over queries, each of the weight f·cos
over the density of its light. Queries are of any footprint; each teaches the level that its size asks for.
What is learned of a texel is its difference from the texel of the next level that covers it, which is drawn
towards 0: texels with few queries resemble their neighbours.
"""

from __future__ import annotations

import math

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from loomlight.models.mip_pyramid import PyramidShape
from loomlight.models.neumip.btf import TRANSMISSION_SHARE, Queries
from loomlight.models.neumip.proposal import MIN_ROUGHNESS, halvings_of, proposal_shape
from loomlight.models.neumip.settings import NeumipSettings

_STEPS, _BATCH, _RATE = 300, 1 << 14, 0.05
# Queries that a texel needs before it differs from its neighbours: the strength of a Gaussian prior.
_PRIOR = 30.0
# Weights of queries are at most so many times their mean: rare bright ones would move texels far.
_MAX_WEIGHT = 20.0
# Shares of parts: a part that is missing has unbounded weights.
_MIN_SHARE, _MAX_SPECULAR = 0.05, 0.9
# Key that separates the random numbers of these batches.
_FIT = 6


def fitted_proposal(
    queries: Queries, density: NDArray[np.float32], shape: PyramidShape, settings: NeumipSettings
) -> NDArray[np.float32]:
    """Texels of the proposal [texels, `PARAMETERS`].

    Args:
        density: of the lights of queries on their side [n], 1/sr.
        shape: of the textures.
    """
    small = proposal_shape(shape)
    transmits = bool(queries.is_transmission.any())
    side = (
        np.where(queries.is_transmission == 1, TRANSMISSION_SHARE, 1 - TRANSMISSION_SHARE)
        if transmits
        else 1.0
    )
    weights = queries.values.mean(axis=1) / (density * side)
    weights = np.minimum(weights / max(float(weights.mean()), 1e-20), _MAX_WEIGHT)
    levels = np.clip(queries.levels - halvings_of(shape), 0, small.levels - 1)
    chains = _chains(small, np.floor(levels + 0.5).astype(int), queries.positions, queries.faces)
    free = torch.zeros(small.faces * small.texels + 1, 7, requires_grad=True)
    optimiser = torch.optim.Adam([free], _RATE)
    rng = np.random.default_rng([settings.seed, _FIT])
    steps, batch = min(_STEPS, settings.steps), min(_BATCH, settings.batch, len(queries))
    for step in range(steps):
        chosen = rng.integers(len(queries), size=batch)
        light, view = (
            _unit(part[chosen], below)
            for part, below in (
                (queries.lights, queries.is_transmission[chosen] == 1),
                (queries.views, np.zeros(len(chosen), bool)),
            )
        )
        rows = _parameters(_summed(free, chains[chosen]), transmits)
        loss = -(
            torch.from_numpy(weights[chosen].astype(np.float32)) * torch.log(density_of(rows, light, view))
        )
        optimiser.param_groups[0]["lr"] = _RATE * 0.5 * (1 + math.cos(math.pi * step / steps))
        optimiser.zero_grad(set_to_none=True)
        # A sum over its own queries is what moves a texel.
        (loss.sum() + 0.5 * _PRIOR * batch / len(queries) * free.square().sum()).backward()
        optimiser.step()
        with torch.no_grad():
            # The place of levels that are finer than a query's.
            free[-1] = 0
    fitted = _parameters(_summed(free.detach(), _chains_of_texels(small)), transmits)
    return np.ascontiguousarray(torch.nn.functional.pad(fitted, (0, 1)).numpy(), np.float32)


def density_of(rows: Tensor, light: Tensor, view: Tensor) -> Tensor:
    """The density of `Proposal.density` [n], of parameters [n, 7] and unit vectors [n, 3]."""
    mean_x, mean_y, a, b, c, specular, transmission = rows.unbind(1)
    cosine = light[:, 2].abs() / math.pi
    half = torch.nn.functional.normalize(light + view, dim=1)
    half = torch.where(half[:, 2:] < 0, -half, half)
    up = half[:, 2].clamp(min=1e-6)
    x, y = -half[:, 0] / up - mean_x, -half[:, 1] / up - mean_y
    first = x / a
    second = (y - b * first) / c
    slopes = 1 / (math.pi * a * c * (1 + first**2 + second**2) ** 2)
    facets = slopes / (4 * up**3 * (view * half).sum(1).abs().clamp(min=1e-6))
    above = light[:, 2] > 0
    near = specular * facets + torch.where(above, (1 - specular) * cosine, torch.zeros_like(cosine))
    return (1 - transmission) * near + torch.where(above, torch.zeros_like(cosine), transmission * cosine)


def _parameters(free: Tensor, transmits: bool) -> Tensor:
    """Parameters [n, 7] of numbers that may be any; 0 is a lobe of roughness 0.6."""
    mean = 2 * torch.tanh(0.5 * free[:, :2])
    first, second = (MIN_ROUGHNESS + 0.5 * free[:, k].exp() for k in (2, 4))
    specular = _MIN_SHARE + (_MAX_SPECULAR - _MIN_SHARE) * torch.sigmoid(free[:, 5])
    transmission = _MIN_SHARE + (1 - 2 * _MIN_SHARE) * torch.sigmoid(free[:, 6])
    if not transmits:
        transmission = torch.zeros_like(transmission)
    columns = [mean[:, 0], mean[:, 1], first, free[:, 3], second, specular, transmission]
    return torch.stack(columns, dim=1)


def _summed(free: Tensor, chains: NDArray[np.int64]) -> Tensor:
    """Sums of rows [n, 7] over texels and those that cover them."""
    return free[torch.from_numpy(chains)].sum(1)


def _chains(
    small: PyramidShape,
    levels: NDArray[np.int64],
    positions: NDArray[np.float32],
    faces: NDArray[np.uint8],
) -> NDArray[np.int64]:
    """Texels of some levels at positions in repeats, and all that cover them [n, levels].

    Places of finer levels hold the number after the last texel.
    """
    chains = np.full((len(levels), small.levels), small.faces * small.texels, np.int64)
    for level, (columns, rows) in enumerate(small.sizes):
        column = (positions[:, 0] * columns).astype(np.int64) % columns
        row = (positions[:, 1] * rows).astype(np.int64) % rows
        texel = faces.astype(np.int64) * small.texels + small.starts[level] + row * columns + column
        chains[:, level] = np.where(levels <= level, texel, chains[:, level])
    return chains


def _chains_of_texels(small: PyramidShape) -> NDArray[np.int64]:
    """The same of every texel, in their order."""
    parts = []
    for face in range(small.faces):
        for level, (columns, rows) in enumerate(small.sizes):
            row, column = np.divmod(np.arange(columns * rows), columns)
            middle = np.column_stack([(column + 0.5) / columns, (row + 0.5) / rows]).astype(np.float32)
            numbers = np.full(len(middle), level)
            parts.append(_chains(small, numbers, middle, np.full(len(middle), face, np.uint8)))
    return np.concatenate(parts)


def _unit(xy: NDArray[np.float32], below: NDArray[np.bool_]) -> Tensor:
    """Unit vectors [n, 3] of x and y."""
    z = np.sqrt(np.maximum(1 - np.square(xy).sum(axis=1), 0))
    return torch.from_numpy(np.column_stack([xy, np.where(below, -z, z)]).astype(np.float32))
