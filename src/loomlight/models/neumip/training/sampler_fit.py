"""Trains the network that draws directions, from the trained decoders: they give any number of values.

The loss is the relative entropy of its density to the luminance of f·cos (zeltner2024 section 5). No gradient
reaches textures and decoders.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import torch
from torch import Tensor
from torch.nn import functional

from loomlight.models.neumip.btf import draw_levels
from loomlight.models.neumip.networks import Layers, sampler_widths
from loomlight.models.neumip.settings import NeumipSettings
from loomlight.models.neumip.training.network import NeumipNetwork
from loomlight.models.query_parts import draw_directions
from loomlight.scattering.lobe_mixture import TwoSidedLobes
from loomlight.training.direction_sampler import two_sided_loss
from loomlight.training.layers import TORCH, numbers_of_layers, relu_layers
from loomlight.training.loop import Schedule, train
from loomlight.training.soap import Soap

# Views of a step, lights of a view, the largest rate and the smallest over it.
_VIEWS, _LIGHTS, _RATE, _LAST_RATE = 1024, 16, 3e-3, 0.05
_LUMINANCE = (0.2126, 0.7152, 0.0722)
# Key of random numbers.
_SAMPLER = 8


def trained_sampler(
    network: NeumipNetwork, settings: NeumipSettings, checkpoint: Path, identity: str
) -> Layers:
    """The layers of the sampler of a trained material. A training that was stopped goes on.

    Args:
        identity: of everything that the weights depend on.

    Raises:
        InputError: a damaged checkpoint, or one of another training.
    """
    network.eval()
    torch.manual_seed(settings.seed)
    sampler = relu_layers(sampler_widths(network.transmission is not None))
    sampler.to(network.features.device)

    def losses(step: int) -> Iterator[Tensor]:
        rng = np.random.default_rng([settings.seed, _SAMPLER, step])
        yield sampler_divergence(network, sampler, rng, min(_VIEWS, settings.batch))

    def rate(done: float) -> float:
        return _RATE * (_LAST_RATE + 0.5 * (1 - _LAST_RATE) * (1 + math.cos(math.pi * done)))

    optimiser = Soap(sampler.parameters(), _RATE)
    train(sampler, optimiser, losses, Schedule(settings.sampler_steps, rate), checkpoint, identity)
    return numbers_of_layers(sampler)


def sampler_divergence(
    network: NeumipNetwork, sampler: torch.nn.Module, rng: np.random.Generator, count: int
) -> Tensor:
    """The loss of a step, of views at random places and sizes."""
    device, shape = network.features.device, network.shape
    views = torch.from_numpy(draw_directions(rng, count)).to(device)
    with torch.no_grad():
        latent = network.latent(
            torch.from_numpy(rng.random((count, 2), np.float32)).to(device),
            torch.from_numpy(draw_levels(rng, count, shape.levels - 1)).to(device),
            views[:, :2],
            torch.from_numpy(rng.integers(shape.faces, size=count)).to(device),
        )

    def values(lights: Tensor) -> Tensor:
        each = lights.shape[1]
        seen, latents = (part[:, None].expand(-1, each, -1) for part in (views[:, :2], latent))
        inputs = torch.cat([latents, lights[..., :2], seen], dim=-1)
        gains = network.gains
        luminance = inputs.new_tensor(_LUMINANCE)
        near = functional.relu(network.decoder(inputs)) @ luminance / gains[0]
        far = torch.zeros_like(near)
        if network.transmission is not None:
            far = functional.relu(network.transmission(inputs)) @ luminance / gains[1]
        return torch.where(lights[..., 2] > 0, near, far)

    outputs = sampler(torch.cat([latent, views], dim=1))
    lobes = TwoSidedLobes.of([column[:, None] for column in outputs.T], TORCH)
    generator = torch.Generator().manual_seed(int(rng.integers(2**62)))
    return two_sided_loss(lobes, views, values, _LIGHTS, generator)
