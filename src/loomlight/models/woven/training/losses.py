"""Losses of the universal network, and the map between what it puts out and components."""

from __future__ import annotations

import torch
from torch import Tensor
from torch.nn import functional

from loomlight.models.woven.architecture import LARGEST_OUTPUT, REFLECTION_GAIN, TRANSMISSION_GAIN
from loomlight.models.woven.training.config import TrainingTable

# λ of specular and diffuse terms (chen2024 eq. 11).
_SPECULAR_WEIGHT, _DIFFUSE_WEIGHT = 0.4, 0.1
# Weights of the two terms in a picture of cloth, as in the query benchmark; and about their mean, 1/sr.
_ALBEDOS = (0.4, 0.4, 0.6, 0.6)
_MEAN_VALUE = 0.06
_LOGARITHMIC_SHARE = 0.1
# Holes are a few per cent of the area: with less weight light passes through the wrong cloths.
_HOLE_WEIGHT = 3.0
_GROUP, _GROUP_WEIGHT = 256, 2.0
# Beside highlights, specular terms are counted as ln(10 k x + 1): by shares down to 1/1000 per sr.
_FAINT_GAIN, _FAINT_SHARE = 10.0, 0.7
_BELOW = 0.1  # of outputs below 0, so that they can be learnt from


def gain(light: Tensor) -> Tensor:
    """k of each query [n, 1] from lights [n, 3] in the frame of the face that is seen."""
    return torch.where(light[:, 2:] > 0, REFLECTION_GAIN, TRANSMISSION_GAIN)


def mapped(components: Tensor, light: Tensor, published: bool) -> Tensor:
    """Components [n, 4] as the network puts them out: logarithmic, or (published) the diffuse ones linear."""
    logarithmic = torch.log1p(gain(light) * components)
    if published:
        return torch.cat([components[:, :2], logarithmic[:, 2:]], 1)
    return logarithmic


def unmapped(output: Tensor, light: Tensor, published: bool) -> Tensor:
    """Components [n, 4], 1/sr, of what the network puts out."""
    linear = torch.expm1(torch.clamp(output, 0, LARGEST_OUTPUT)) / gain(light)
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
    """Absolute error of a picture: of components weighted by albedos, of their sum, and of logarithms.

    With the published weights the diffuse terms, three quarters of the light, are a hundredth of the loss.
    """
    albedos = torch.tensor(_ALBEDOS, device=output.device)
    target = truth[:, :4]
    bounded = torch.expm1(functional.leaky_relu(torch.clamp(output, max=LARGEST_OUTPUT), 0.1)) / gain(light)
    error = (bounded - target) * albedos
    linear = error.abs().sum(1).mean() + error.sum(1).abs().mean()
    # Absolute errors make medians, which are darker than means where shadows are sharp: groups of queries of
    # one face, drawn at random, must be right in their mean.
    linear = linear + _GROUP_WEIGHT * _group_means(error).abs().sum(1).mean()
    logarithmic = (output - mapped(target, light, False)).square().sum(1).mean()
    missed = (hole - truth[:, 4])[:, None]
    holes = missed.abs().mean() + _group_means(missed).abs().mean()
    return linear / _MEAN_VALUE + _LOGARITHMIC_SHARE * logarithmic + _HOLE_WEIGHT * holes


def faint_loss(output: Tensor, hole: Tensor, truth: Tensor, light: Tensor) -> Tensor:
    """`balanced_loss`, and the relative error of specular terms where they are faint.

    Dark dyed silk shows little else beside its highlights; in absolute errors that is nothing.
    """
    reached = torch.log1p(_FAINT_GAIN * gain(light) * truth[:, 2:4])
    specular = torch.clamp(output[:, 2:], max=LARGEST_OUTPUT)
    found = torch.log1p(_FAINT_GAIN * torch.expm1(torch.clamp(specular, min=0)))
    # What is below 0 stands for 0, and is still told to rise, evenly, however far below it lies.
    found = found + _BELOW * torch.clamp(specular, max=0)
    relative = (found - reached).abs().sum(1).mean()
    return balanced_loss(output, hole, truth, light) + _FAINT_SHARE * relative


def _group_means(error: Tensor) -> Tensor:
    """Means over groups of consecutive queries [groups, k] of errors [n, k]."""
    size = min(_GROUP, len(error))
    return error[: len(error) // size * size].reshape(-1, size, error.shape[1]).mean(1)


LOSSES = {"published": published_loss, "balanced": balanced_loss, "faint": faint_loss}


def is_published(training: TrainingTable) -> bool:
    """Whether the diffuse outputs are linear."""
    return training.loss == "published"
