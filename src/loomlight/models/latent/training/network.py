"""The model as torch modules: the reference that training updates and tests compare the others with."""

from __future__ import annotations

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional

from loomlight.models.latent.networks import (
    ALBEDO_OFFSET,
    ALBEDO_WIDTHS,
    CHANNELS,
    FRAMES,
    MAX_EXPONENT,
    SAMPLER_WIDTHS,
    VALUE_OFFSET,
    Weights,
    decoder_widths,
    half_vector_features,
)
from loomlight.models.latent.queries import Reflectance
from loomlight.models.mip_pyramid import PyramidShape, level_taps
from loomlight.training.layers import (
    TORCH,
    TorchTextures,
    fetched,
    numbers_of,
    numbers_of_layers,
    relu_layers,
)

# Added to values before cube roots, whose slope at 0 is infinite, and to what relative errors are divided by.
_ROOT, _RELATIVE = 1e-4, 1e-2
# Of latents of the rung without an encoder, at the start.
_LATENTS = 0.1
_ENCODER = (64, 64, 64, 64, CHANNELS)
_TEXTURES = TorchTextures()


class LatentNetwork(nn.Module):
    """Latent textures of all faces, and all networks.

    The textures are parameters divided by `scale`: with Adam their learning rate is then so many times that
    of the networks.
    """

    inputs: Tensor

    def __init__(
        self,
        shape: PyramidShape,
        inputs: NDArray[np.float32],
        hidden: tuple[int, ...],
        with_frames: bool = True,
        with_features: bool = True,
        scale: float = 1.0,
    ) -> None:
        """
        Args:
            inputs: of the encoder, for each texel [faces · shape.texels, K].
            hidden: widths of the decoder's hidden layers.
        """
        super().__init__()
        self.shape, self.scale, self.with_features = shape, scale, with_features
        self.register_buffer("inputs", torch.from_numpy(inputs), persistent=False)
        self.encoder = relu_layers((inputs.shape[1], *_ENCODER))
        self.latents = nn.Parameter(_LATENTS / scale * torch.randn(len(inputs), CHANNELS))
        self.frames = nn.Linear(CHANNELS, 6 * FRAMES, bias=False) if with_frames else None
        self.decoder = relu_layers(decoder_widths(hidden, with_frames, with_features))
        self.sampler = relu_layers(SAMPLER_WIDTHS)
        self.albedo = relu_layers(ALBEDO_WIDTHS)

    def latent(self, positions: Tensor, levels: Tensor, faces: Tensor, encoded: bool) -> Tensor:
        """Latents of queries [n, 8]; see `Queries`.

        Args:
            encoded: by the encoder; otherwise those of the textures.
        """
        shape, (u, v) = self.shape, positions.T
        taps = level_taps(shape, u, v, levels, faces * shape.texels, _TEXTURES)
        if not encoded:
            return self.scale * fetched(self.latents, taps)
        # The encoder costs ten times as much as the decoder: it runs for queries or for texels, the fewer.
        if len(self.inputs) <= len(positions):
            return fetched(self.encoder(self.inputs), taps)
        latent: Tensor = self.encoder(fetched(self.inputs, taps))
        return latent

    @torch.no_grad()
    def encode_texels(self) -> None:
        """Replaces the textures by what the encoder makes of its inputs."""
        self.latents.copy_(self.encoder(self.inputs) / self.scale)

    def forward(self, latent: Tensor, lights: Tensor, views: Tensor) -> Tensor:
        """f·cos [..., 3] of directions in the frame of the face that is seen."""
        pair = views.unbind(-1), lights.unbind(-1)
        seen = [pair]
        if self.frames is not None:
            seen = []
            for sums in self.frames(latent).split(6, dim=-1):
                normal = functional.normalize(sums[..., :3] + sums.new_tensor([0.0, 0.0, 1.0]), dim=-1)
                tangent = functional.normalize(sums[..., 3:] + sums.new_tensor([1.0, 0.0, 0.0]), dim=-1)
                axes = (tangent, torch.linalg.cross(normal, tangent), normal)
                coordinates = [[(part * axis).sum(-1) for axis in axes] for part in (views, lights)]
                seen.append((coordinates[0], coordinates[1]))
        inputs = [number for both in seen for direction in both for number in direction]
        if self.with_features:
            inputs += half_vector_features(seen, *pair, TORCH)
        exponent = self.decoder(torch.cat([torch.stack(inputs, dim=-1), latent], dim=-1)) - VALUE_OFFSET
        return torch.exp(exponent.clamp(max=MAX_EXPONENT))

    def sampler_outputs(self, latent: Tensor, views: Tensor) -> tuple[Tensor, Tensor]:
        """Outputs of the sampler [n, 9], and logarithms of albedos [n, 3]."""
        inputs = torch.cat([views, latent], dim=-1)
        return self.sampler(inputs), (self.albedo(inputs) - ALBEDO_OFFSET).clamp(max=MAX_EXPONENT)

    def weights(self, reflectance: NDArray[np.float32]) -> Weights:
        """The trained numbers, for the renderer.

        Args:
            reflectance: mean albedo of each face [faces, 3].
        """
        frames = None if self.frames is None else numbers_of(self.frames.weight)
        layers = {name: numbers_of_layers(getattr(self, name)) for name in ("decoder", "sampler", "albedo")}
        return Weights(self.shape, numbers_of(self.scale * self.latents), frames, layers, reflectance)


def texel_inputs(reflectance: Reflectance, shape: PyramidShape) -> NDArray[np.float32]:
    """Inputs of the encoder for all texels [faces · texels, K], in the order of `Weights.latents`."""
    count = len(reflectance.inputs)
    parts = [
        reflectance.encoder_inputs(level, face).reshape(-1, count)
        for face in range(shape.faces)
        for level in range(shape.levels)
    ]
    return np.ascontiguousarray(np.concatenate(parts), np.float32)


def loss_of(predicted: Tensor, truth: Tensor, kind: str) -> Tensor:
    """Mean absolute difference of logarithms or of cube roots, or mean squared relative difference.

    Of noisy values the first two learn medians, which are too dark; the third learns means.

    Args:
        predicted, truth: f·cos [n, 3], 1/sr.
        kind: of `LOSSES`.
    """
    if kind == "log":
        return functional.l1_loss(torch.log1p(predicted), torch.log1p(truth))
    if kind == "relative":
        scale = predicted.detach().mean(dim=-1, keepdim=True) + _RELATIVE
        return ((predicted - truth) / scale).square().mean()
    return 3 * functional.l1_loss((predicted + _ROOT).pow(1 / 3), (truth + _ROOT).pow(1 / 3))
