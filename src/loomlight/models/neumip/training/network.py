"""The model as torch modules: the reference that training updates and tests compare the others with."""

from __future__ import annotations

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional

from loomlight.models.mip_pyramid import PyramidShape, bilinear_taps, trilinear_taps
from loomlight.models.neumip.networks import (
    CHANNELS,
    DECODER_WIDTHS,
    EXPOSURE,
    OFFSET_WIDTHS,
    OPACITY_WIDTHS,
    Weights,
)
from loomlight.models.neumip.parallax import MIN_COSINE, shifted
from loomlight.training.relu_layers import numbers_of, numbers_of_layers, relu_layers
from loomlight.training.torch_functions import TorchTextures

# The textures begin at zero and at 0.1 N(0, 1), as in the released code.
_FEATURES = 0.1
# Biases of the last layer: of the final ReLU, which must not begin at 0, and of the ray depth.
_FIRST_VALUE = 0.3
# Of the final activation below 0 while it is trained, and a bound that keeps log(1 + x) finite.
SLOPE, MIN_OUTPUT = 0.05, -0.5
# Of the cross-entropy of holes, beside errors of colours.
_OPACITY_WEIGHT = 0.05
# Blurs of fewer texels change nothing.
_MIN_BLUR = 0.05


_TEXTURES = TorchTextures()


class NeumipNetwork(nn.Module):
    """Neural textures of all faces, and both networks.

    Textures are parameters divided by `scale`: with Adam their learning rate is then so many times that of
    the networks.
    """

    def __init__(
        self,
        shape: PyramidShape,
        with_offset: bool,
        scale: float = 1.0,
        transmits: bool = False,
        has_holes: bool = False,
        gains: tuple[float, float] = (1.0, 1.0),
    ) -> None:
        """
        Args:
            gains: factors of π f·cos while it is trained, of lights on the view's side and on the other one
                (`gains_of`).
        """
        super().__init__()
        self.shape, self.scale, self.gains = shape, scale, gains
        rows, columns = shape.rows, shape.columns
        self.features = nn.ParameterList(
            nn.Parameter(_FEATURES / scale * torch.randn(shape.faces, CHANNELS, high, wide))
            for wide, high in shape.sizes
        )
        self.decoder = relu_layers(DECODER_WIDTHS)
        nn.init.constant_(self.decoder[-1].bias, _FIRST_VALUE)
        self.offset_texture: nn.Parameter | None = None
        self.offset: nn.Sequential | None = None
        if with_offset:
            self.offset_texture = nn.Parameter(torch.zeros(shape.faces, CHANNELS, rows, columns))
            self.offset = relu_layers(OFFSET_WIDTHS)
            # No parallax at first.
            nn.init.zeros_(self.offset[-1].bias)
        self.transmission: nn.Sequential | None = None
        if transmits:
            self.transmission = relu_layers(DECODER_WIDTHS)
            nn.init.constant_(self.transmission[-1].bias, _FIRST_VALUE)
        self.opacity = relu_layers(OPACITY_WIDTHS) if has_holes else None

    def forward(
        self,
        positions: Tensor,
        levels: Tensor,
        lights: Tensor,
        views: Tensor,
        faces: Tensor,
        blur: float = 0.0,
        offset_frozen: bool = False,
        is_transmission: Tensor | None = None,
    ) -> tuple[Tensor, Tensor | None]:
        """π f·cos of queries [n, 3] times the gains, and log-odds of passing straight [n]; see `Queries`.

        While it is trained, colours below 0 have a slope.

        Args:
            blur: standard deviation of the Gaussian over the textures, in texels of level 0.
            offset_frozen: the offset texture gets no gradient.
            is_transmission: lights on the other side, which a source that transmits alone has.
        """
        latent = self.latent(positions, levels, views, faces, blur, offset_frozen)
        opacity = None if self.opacity is None else self.opacity(torch.cat([latent, views], dim=1))[:, 0]
        outputs = self._decoded(torch.cat([latent, lights, views], dim=1), is_transmission)
        if self.training:
            # With the final ReLU of section 3.2 a network whose first outputs are all below 0 learns nothing.
            return functional.leaky_relu(outputs, SLOPE).clamp(min=MIN_OUTPUT), opacity
        return functional.relu(outputs), opacity

    def latent(
        self,
        positions: Tensor,
        levels: Tensor,
        views: Tensor,
        faces: Tensor,
        blur: float = 0.0,
        offset_frozen: bool = False,
    ) -> Tensor:
        """Interpolated texels of the pyramid [n, 7]; arguments as of `forward`."""
        shape, (u, v) = self.shape, positions.T
        if self.offset is not None and self.offset_texture is not None:
            texture = self.offset_texture.detach() if offset_frozen else self.offset_texture
            table = _texels(self.scale * blurred(texture, blur))
            start = faces * (shape.columns * shape.rows)
            taps = bilinear_taps(u, v, shape.columns, shape.rows, start, _TEXTURES)
            depth = self.offset(torch.cat([_fetched(table, taps.texels, taps.weights), views], dim=1))[:, 0]
            cosine = torch.sqrt((1 - views.square().sum(1)).clamp(min=0))
            slope = 1 / cosine.clamp(min=MIN_COSINE)
            u, v = shifted(shape, u, v, depth, views[:, 0], views[:, 1], slope)
        # All levels of a face, one face after another.
        parts = [
            _texels(self.scale * blurred(texture, blur / 2**level)).reshape(shape.faces, -1, CHANNELS)
            for level, texture in enumerate(self.features)
        ]
        table = torch.cat(parts, dim=1).reshape(-1, CHANNELS)
        taps = trilinear_taps(shape, u, v, levels, faces * shape.texels, _TEXTURES)
        return _fetched(table, taps.texels, taps.weights)

    def _decoded(self, inputs: Tensor, is_transmission: Tensor | None) -> Tensor:
        if self.transmission is None or is_transmission is None:
            outputs: Tensor = self.decoder(inputs)
            return outputs
        near, far = torch.nonzero(~is_transmission)[:, 0], torch.nonzero(is_transmission)[:, 0]
        parts = torch.cat([self.decoder(inputs[near]), self.transmission(inputs[far])])
        return parts[torch.argsort(torch.cat([near, far]))]

    def weights(self, reflectance: NDArray[np.float32]) -> Weights:
        """The trained numbers, for the renderer.

        Args:
            reflectance: mean albedo of each face [faces, 3].
        """
        shape = self.shape
        texels = [
            _texels(self.scale * texture).reshape(shape.faces, -1, CHANNELS) for texture in self.features
        ]
        features = torch.cat(texels, dim=1).reshape(-1, CHANNELS)
        further = {"transmission": self.transmission, "opacity": self.opacity}
        layers = {"decoder": numbers_of_layers(self.decoder)}
        layers |= {
            name: numbers_of_layers(network) for name, network in further.items() if network is not None
        }
        # The final ReLU passes factors on.
        for name, gain in zip(("decoder", "transmission"), self.gains, strict=True):
            if name in layers:
                weight, bias = layers[name][-1]
                layers[name][-1] = weight / np.float32(gain), bias / np.float32(gain)
        offset_texels = None
        if self.offset is not None and self.offset_texture is not None:
            layers["offset"] = numbers_of_layers(self.offset)
            offset_texels = numbers_of(_texels(self.scale * self.offset_texture))
        return Weights(shape, numbers_of(features), offset_texels, layers, reflectance)


def blurred(texture: Tensor, sigma: float) -> Tensor:
    """A periodic texture [..., rows, columns] under a Gaussian of `sigma` texels, by Fourier transform."""
    if sigma < _MIN_BLUR:
        return texture
    rows, columns = texture.shape[-2:]
    along = torch.fft.fftfreq(rows, device=texture.device)
    across = torch.fft.rfftfreq(columns, device=texture.device)
    squared = along[:, None] ** 2 + across[None, :] ** 2
    response = torch.exp(-2 * (torch.pi * sigma) ** 2 * squared)
    return torch.fft.irfft2(torch.fft.rfft2(texture) * response, s=(rows, columns))


def loss_of(predicted: Tensor, truth: Tensor, gain: Tensor) -> Tensor:
    """The released code's loss: squares of differences of log(1 + x), plus a tenth of absolute differences.

    Args:
        predicted: π f·cos times the gain [n, 3].
        truth: f·cos [n, 3], 1/sr.
        gain: [n], or one for all.
    """
    exposed = EXPOSURE * gain[..., None] * truth
    logarithmic = functional.mse_loss(torch.log1p(predicted), torch.log1p(exposed))
    return logarithmic + 0.1 * functional.l1_loss(predicted, exposed)


def opacity_loss(log_odds: Tensor, holes: Tensor) -> Tensor:
    """Cross-entropy of shares that pass straight through, weighted to be of the size of `loss_of`."""
    return _OPACITY_WEIGHT * functional.binary_cross_entropy_with_logits(log_odds, holes)


def _texels(texture: Tensor) -> Tensor:
    """Rows of channels [faces · rows · columns, channels] of a texture [faces, channels, rows, columns]."""
    return texture.permute(0, 2, 3, 1).reshape(-1, CHANNELS)


def _fetched(table: Tensor, texels: list[Tensor], weights: list[Tensor]) -> Tensor:
    """Weighted sums of texels [n, channels]."""
    return functional.embedding_bag(
        torch.stack(texels, dim=1), table, per_sample_weights=torch.stack(weights, dim=1), mode="sum"
    )
