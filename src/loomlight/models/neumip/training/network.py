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
    OFFSET_WIDTHS,
    OPACITY_WIDTHS,
    Weights,
    quantised,
)
from loomlight.models.neumip.parallax import MIN_COSINE, shifted
from loomlight.training.layers import TorchTextures, fetched, numbers_of, numbers_of_layers, relu_layers

# Biases of the last layer: of the final ReLU, which must not begin at 0, and of the ray depth.
_FIRST_VALUE = 0.3
# Of the final activation below 0 while it is trained.
SLOPE = 0.05


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
        # Rows of all levels of a face, one face after another. From random ones, fine texels of noisy queries
        # are never learned: the networks ignore them first.
        self.features = nn.Parameter(torch.zeros(shape.faces * shape.texels, CHANNELS))
        self.decoder = relu_layers(DECODER_WIDTHS)
        nn.init.constant_(self.decoder[-1].bias, _FIRST_VALUE)
        self.offset_texture: nn.Parameter | None = None
        self.offset: nn.Sequential | None = None
        if with_offset:
            self.offset_texture = nn.Parameter(torch.zeros(shape.faces * shape.starts[1], CHANNELS))
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
        offset_frozen: bool = False,
        is_transmission: Tensor | None = None,
    ) -> tuple[Tensor, Tensor | None]:
        """π f·cos of queries [n, 3] times the gains, and log-odds of passing straight [n]; see `Queries`.

        While it is trained, colours below 0 have a slope.

        Args:
            offset_frozen: the offset texture gets no gradient.
            is_transmission: lights on the other side, which a source that transmits alone has.
        """
        latent = self.latent(positions, levels, views, faces, offset_frozen)
        opacity = None if self.opacity is None else self.opacity(torch.cat([latent, views], dim=1))[:, 0]
        outputs = self._decoded(torch.cat([latent, lights, views], dim=1), is_transmission)
        if self.training:
            # With the final ReLU of section 3.2 a network whose first outputs are all below 0 learns nothing.
            return functional.leaky_relu(outputs, SLOPE), opacity
        return functional.relu(outputs), opacity

    def latent(
        self, positions: Tensor, levels: Tensor, views: Tensor, faces: Tensor, offset_frozen: bool = False
    ) -> Tensor:
        """Interpolated texels of the pyramid [n, 7]; arguments as of `forward`."""
        shape, (u, v) = self.shape, positions.T
        if self.offset is not None and self.offset_texture is not None:
            texture = self.offset_texture.detach() if offset_frozen else self.offset_texture
            start = faces * (shape.columns * shape.rows)
            taps = bilinear_taps(u, v, shape.columns, shape.rows, start, _TEXTURES)
            depth = self.offset(torch.cat([self.scale * fetched(texture, taps), views], dim=1))[:, 0]
            cosine = torch.sqrt((1 - views.square().sum(1)).clamp(min=0))
            slope = 1 / cosine.clamp(min=MIN_COSINE)
            u, v = shifted(shape, u, v, depth, views[:, 0], views[:, 1], slope)
        taps = trilinear_taps(shape, u, v, levels, faces * shape.texels, _TEXTURES)
        return self.scale * fetched(self.features, taps)

    def _decoded(self, inputs: Tensor, is_transmission: Tensor | None) -> Tensor:
        if self.transmission is None or is_transmission is None:
            outputs: Tensor = self.decoder(inputs)
            return outputs
        near, far = torch.nonzero(~is_transmission)[:, 0], torch.nonzero(is_transmission)[:, 0]
        parts = torch.cat([self.decoder(inputs[near]), self.transmission(inputs[far])])
        return parts[torch.argsort(torch.cat([near, far]))]

    def weights(self, reflectance: NDArray[np.float32]) -> Weights:
        """The trained numbers, for the renderer: texels are rounded to what files store.

        Args:
            reflectance: mean albedo of each face [faces, 3].
        """
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
            offset_texels = np.multiply(*quantised(numbers_of(self.scale * self.offset_texture)))
        features = np.multiply(*quantised(numbers_of(self.scale * self.features)))
        return Weights(self.shape, features, offset_texels, layers, reflectance)
