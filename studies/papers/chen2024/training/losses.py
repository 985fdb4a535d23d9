"""Losses of the universal network, and the map between its outputs and components."""

from __future__ import annotations

import torch
from torch import Tensor
from torch.nn import functional

from loomlight.models.neural.architecture import MAX_OUTPUT, REFLECTION_GAIN, TRANSMISSION_GAIN
from studies.papers.chen2024.training.config import TrainingTable

# λ of specular and diffuse terms (chen2024 eq. 11).
_SPECULAR_WEIGHT, _DIFFUSE_WEIGHT = 0.4, 0.1
# Albedos of the diffuse and specular components, as in the query benchmark; and a typical mean f·cos, 1/sr.
_ALBEDOS = (0.4, 0.4, 0.6, 0.6)
_MEAN_VALUE = 0.06
_LOGARITHMIC_WEIGHT = 0.1
# Holes are a few per cent of the area: with less weight, open cloths are confused with dense ones.
_HOLE_WEIGHT = 3.0
GROUP, _GROUP_WEIGHT = 256, 2.0
# Faint specular terms are compared as ln(10 k x + 1): relative errors down to 1/1000 per sr.
_FAINT_GAIN, _FAINT_WEIGHT = 10.0, 0.7
_BELOW = 0.1  # slope for outputs below 0, which keeps a gradient


def gain(light: Tensor) -> Tensor:
    """k of each query [n, 1] from lights [n, 3] in the frame of the face that is seen."""
    return torch.where(light[:, 2:] > 0, REFLECTION_GAIN, TRANSMISSION_GAIN)


def mapped(components: Tensor, light: Tensor, published: bool) -> Tensor:
    """Components [n, 4] as outputs of the network: logarithmic, or (published) the diffuse ones linear."""
    logarithmic = torch.log1p(gain(light) * components)
    if published:
        return torch.cat([components[:, :2], logarithmic[:, 2:]], 1)
    return logarithmic


def unmapped(output: Tensor, light: Tensor, published: bool) -> Tensor:
    """Components [n, 4], 1/sr, from outputs of the network."""
    linear = torch.expm1(torch.clamp(output, 0, MAX_OUTPUT)) / gain(light)
    if published:
        return torch.cat([torch.clamp(output[:, :2], min=0), linear[:, 2:]], 1)
    return linear


def published_loss(output: Tensor, hole: Tensor, truth: Tensor, light: Tensor) -> Tensor:
    """chen2024 eq. 9–11, and the square error of the hole fraction with the diffuse weight."""
    target = mapped(truth[:, :4], light, True)
    square = (output - target).square().mean(0)
    components = _DIFFUSE_WEIGHT * square[:2].sum() + _SPECULAR_WEIGHT * square[2:].sum()
    return components + _DIFFUSE_WEIGHT * (hole - truth[:, 4]).square().mean()


def balanced_loss(output: Tensor, hole: Tensor, truth: Tensor, light: Tensor) -> Tensor:
    """Absolute errors of components weighted by albedos and of their sum, and errors of logarithms.

    The diffuse terms are three quarters of the light; with the published weights they would be a hundredth of
    the loss.
    """
    albedos = torch.tensor(_ALBEDOS, device=output.device)
    target = truth[:, :4]
    bounded = torch.expm1(functional.leaky_relu(torch.clamp(output, max=MAX_OUTPUT), 0.1)) / gain(light)
    error = (bounded - target) * albedos
    linear = error.abs().sum(1).mean() + error.sum(1).abs().mean()
    # Absolute errors fit medians, which are darker than means where shadows are sharp: so means over groups
    # of random queries of one face are compared too.
    linear = linear + _GROUP_WEIGHT * _group_means(error).abs().sum(1).mean()
    logarithmic = (output - mapped(target, light, False)).square().sum(1).mean()
    missed = (hole - truth[:, 4])[:, None]
    holes = missed.abs().mean() + _group_means(missed).abs().mean()
    return linear / _MEAN_VALUE + _LOGARITHMIC_WEIGHT * logarithmic + _HOLE_WEIGHT * holes


def faint_loss(output: Tensor, hole: Tensor, truth: Tensor, light: Tensor) -> Tensor:
    """`balanced_loss` plus the relative error of faint specular terms.

    Dark silk beside its highlights shows faint specular terms alone, which absolute errors neglect.
    """
    target = torch.log1p(_FAINT_GAIN * gain(light) * truth[:, 2:4])
    specular = torch.clamp(output[:, 2:], max=MAX_OUTPUT)
    output_logarithms = torch.log1p(_FAINT_GAIN * torch.expm1(torch.clamp(specular, min=0)))
    # Outputs below 0 mean 0, and keep a constant gradient.
    output_logarithms = output_logarithms + _BELOW * torch.clamp(specular, max=0)
    relative = (output_logarithms - target).abs().sum(1).mean()
    return balanced_loss(output, hole, truth, light) + _FAINT_WEIGHT * relative


def _group_means(error: Tensor) -> Tensor:
    """Means over groups of consecutive queries [groups, k] of errors [n, k]."""
    size = min(GROUP, len(error))
    return error[: len(error) // size * size].reshape(-1, size, error.shape[1]).mean(1)


LOSSES = {"published": published_loss, "balanced": balanced_loss, "faint": faint_loss}


def is_published(training: TrainingTable) -> bool:
    """Whether the diffuse outputs are linear."""
    return training.loss == "published"
