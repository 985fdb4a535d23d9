"""Trains an importance sampler for any reflectance that torch can evaluate (zeltner2024 section 5).

The loss is the Kullback–Leibler divergence from the normalised reflectance to the density of a lobe mixture,
estimated with lights drawn from an even mixture of that density and a cosine. A second network learns the
share of light that is scattered, by the same lights. Gradients reach these two networks alone.
"""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import torch
from torch import Tensor

from loomlight.scattering.lobe_mixture import TwoSidedLobes, lobe_mixture, mixture_density, sample_mixture
from loomlight.training.layers import TORCH

# f·cos [n, m, 3] of lights [n, m, 3] on the view's side.
Reflected = Callable[[Tensor], Tensor]
# Share of the lights that are drawn by the mixture itself.
_BY_MIXTURE = 0.5
# Weights of linear RGB in the luminance.
_LUMINANCE = (0.2126, 0.7152, 0.0722)
# Densities and albedos below this are none.
_MIN = 1e-8


def sampler_loss(
    outputs: Tensor,
    log_albedo: Tensor,
    views: Tensor,
    reflected: Reflected,
    lights: int,
    generator: torch.Generator,
) -> Tensor:
    """The divergence, up to a number that no weight changes, plus the error of the albedo.

    Args:
        outputs: of the sampler network [n, 9].
        log_albedo: logarithms of the shares of light that are scattered [n, 3].
        views: unit vectors [n, 3], z > 0.
        reflected: the reflectance that is learned.
        lights: how many are drawn for each view.
        generator: of random numbers.
    """
    mixture = lobe_mixture([column[:, None] for column in outputs.T], TORCH)
    view = [column[:, None] for column in views.T]
    with torch.no_grad():
        choice, *u = torch.rand(3, len(views), lights, generator=generator).to(views.device)
        drawn = torch.stack(sample_mixture(mixture, view, choice, u, TORCH), dim=-1)
        by_cosine = torch.rand(len(views), lights, generator=generator).to(views.device) >= _BY_MIXTURE
        drawn = torch.where(by_cosine[..., None], _cosine_directions(*u), drawn)
        z = drawn[..., 2]
        own = mixture_density(mixture, drawn.unbind(-1), view, TORCH)
        density = _BY_MIXTURE * own + (1 - _BY_MIXTURE) * z.clamp(min=0) / pi
        values = torch.where((z > 0)[..., None], reflected(drawn), torch.zeros_like(drawn))
        weights = values / density.clamp(min=_MIN)[..., None]
        albedo = weights.mean(dim=1)
        luminance = weights @ weights.new_tensor(_LUMINANCE)
        shares = luminance / luminance.mean(dim=1, keepdim=True).clamp(min=_MIN)
        # Views of black texels have no distribution to learn.
        shares = torch.where(albedo.sum(dim=1, keepdim=True) > 1e-5, shares, torch.zeros_like(shares))
    log_density = torch.log(mixture_density(mixture, drawn.unbind(-1), view, TORCH).clamp(min=_MIN))
    divergence = -(shares * log_density).mean()
    # Squared errors make the estimates' mean the optimum.
    return divergence + (torch.exp(log_albedo) - albedo).square().mean()


def two_sided_loss(
    lobes: TwoSidedLobes,
    views: Tensor,
    values: Callable[[Tensor], Tensor],
    lights: int,
    generator: torch.Generator,
) -> Tensor:
    """The divergence of densities over the whole sphere, up to a number that no weight changes.

    Args:
        lobes: columns [n, 1] of a network's outputs.
        views: unit vectors [n, 3], z > 0.
        values: luminance of f·cos [n, m] of lights [n, m, 3] on either side.
        lights: how many are drawn for each view, half of them by cosines on either side.
        generator: of random numbers.
    """
    view = [column[:, None] for column in views.T]
    with torch.no_grad():
        numbers = torch.rand(5, len(views), lights, generator=generator).to(views.device)
        choice, *u = numbers[:3]
        own = torch.stack(lobes.sample(view, choice, u, TORCH), dim=-1)
        cosine = _cosine_directions(*u)
        cosine[..., 2] *= torch.where(numbers[3] < 0.5, 1.0, -1.0)
        drawn = torch.where((numbers[4] < _BY_MIXTURE)[..., None], own, cosine)
        density = _BY_MIXTURE * lobes.density([*drawn.unbind(-1)], view, TORCH)
        density += (1 - _BY_MIXTURE) * drawn[..., 2].abs() / (2 * pi)
        weights = values(drawn) / density.clamp(min=_MIN)
        mean = weights.mean(dim=1, keepdim=True)
        # Views of black places have no distribution to learn.
        shares = torch.where(mean > 1e-6, weights / mean.clamp(min=_MIN), torch.zeros_like(weights))
    log_density = torch.log(lobes.density([*drawn.unbind(-1)], view, TORCH).clamp(min=_MIN))
    return -(shares * log_density).mean()


def _cosine_directions(u: Tensor, v: Tensor) -> Tensor:
    radius, azimuth = torch.sqrt(u), 2 * pi * v
    height = torch.sqrt((1 - u).clamp(min=0))
    return torch.stack([radius * torch.cos(azimuth), radius * torch.sin(azimuth), height], dim=-1)
