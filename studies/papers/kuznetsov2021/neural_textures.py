"""Any `Design` as a torch module, trained on the queries of neumip by its loop: kuznetsov2021's baselines.

Latents are found by descent, as in neumip; those of Rainer et al. are encoded (`encoded_textures.py`). All
designs have the pyramid, the loss and the schedule of neumip, without which queries of all sizes would
contradict one another. That pyramid, loss and schedule are the paper's and its released code's: Adam from
random textures that are blurred at first. The model of the package has a recipe of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional

from loomlight.models.registry import btf_of
from loomlight.models.texture.neumip import EXPOSURE, MIN_COSINE, Weights, shifted
from loomlight.models.texture.neumip_training import (
    SLOPE,
    NeumipBatches,
    gains_of,
    rate_factor,
    taken_queries,
)
from loomlight.models.texture.pyramid import PyramidShape, Taps, bilinear_taps, trilinear_taps
from loomlight.models.texture.settings import NeumipSettings
from loomlight.sources.kinds import Source
from loomlight.training.layers import TorchTextures, fetched, numbers_of, numbers_of_layers, relu_layers
from loomlight.training.loop import Schedule, one_thread, train
from studies.papers.kuznetsov2021.designs import Design

_FUNCTIONS = TorchTextures()
# Of the first textures: deviation of latents, and mean and deviation of colours.
_LATENTS, _COLOUR = 0.1, 0.3
_CHUNK = 1 << 16
# A bound below outputs that keeps log(1 + x) finite.
_MIN_OUTPUT = -0.5
# Standard deviation of the first blur in texels, and how often it is halved in a training: 30 000 steps of a
# half-life of 3333. The textures of coarse levels have fewer texels, and less blur.
_FIRST_BLUR, _HALVINGS = 8.0, 9.0
# The first blur is at most so many times smaller than the texture; blurs of fewer texels change nothing.
_MIN_WIDTHS, _MIN_BLUR = 8, 0.05

# Called with (steps done, steps in all).
Report = Callable[[int, int], None]


class NeuralTextures(nn.Module):
    """A pyramid of neural textures and its networks, of one face; light is reflected alone.

    Attributes:
        blur: standard deviation of the Gaussian over the textures, in texels of level 0.
    """

    blur = 0.0

    def __init__(
        self,
        design: Design,
        shape: PyramidShape,
        scale: float = 1.0,
        gains: tuple[float, float] = (1.0, 1.0),
    ) -> None:
        """
        Args:
            scale: textures learn so many times as fast as networks.
            gains: see `gains_of`.
        """
        super().__init__()
        self.design, self.shape, self.scale, self.gains = design, shape, scale, gains
        self.features = self.first_textures()
        self.decoder = relu_layers(design.decoder_widths)
        nn.init.constant_(self.decoder[-1].bias, 0 if design.whitened else _COLOUR)
        self.offset_texture: nn.Parameter | None = None
        self.offset: nn.Sequential | None = None
        if design.offset:
            self.offset_texture = nn.Parameter(torch.zeros(design.latent, shape.rows, shape.columns))
            self.offset = relu_layers(design.offset_widths)
            nn.init.zeros_(self.offset[-1].bias)

    def first_textures(self) -> nn.ParameterList:
        """The textures of all levels [channels, rows, columns], as they begin."""
        first = torch.zeros(self.design.pyramid_channels)
        first[self.design.latent :] = _COLOUR / self.scale
        return nn.ParameterList(
            nn.Parameter(self._first(first, high, wide)) for wide, high in self.shape.sizes
        )

    def _first(self, first: Tensor, high: int, wide: int) -> Tensor:
        texture = first[:, None, None].expand(-1, high, wide).clone()
        texture[: self.design.latent] = _LATENTS / self.scale * torch.randn(self.design.latent, high, wide)
        return texture

    def forward(
        self,
        positions: Tensor,
        levels: Tensor,
        lights: Tensor,
        views: Tensor,
        faces: Tensor,
        offset_frozen: bool = False,
        is_transmission: Tensor | None = None,
    ) -> tuple[Tensor, None]:
        """π f·cos of queries [n, 3]; arguments as of `NeumipNetwork.forward`."""
        del is_transmission
        shape, (u, v) = self.shape, positions.T
        if self.offset is not None and self.offset_texture is not None:
            texture = self.offset_texture.detach() if offset_frozen else self.offset_texture
            taps = bilinear_taps(u, v, shape.columns, shape.rows, faces * 0, _FUNCTIONS)
            texel = fetched(self._rows([texture]), taps)
            depth = self.offset(torch.cat([texel, views], dim=1))[:, 0]
            cosine = torch.sqrt((1 - views.square().sum(1)).clamp(min=0))
            slope = 1 / cosine.clamp(min=MIN_COSINE)
            u, v = shifted(shape, u, v, depth, views[:, 0], views[:, 1], slope)
        taps = trilinear_taps(shape, u, v, levels, faces * 0, _FUNCTIONS)
        texel = self.texels(taps)
        latent, colours = texel[:, : self.design.latent], texel[:, self.design.latent :]
        outputs = self.decoder(torch.cat([latent, lights, views], dim=1))
        if self.design.whitened:
            outputs = torch.addcmul(colours[:, :3], colours[:, 3:], outputs)
        if self.training:
            return functional.leaky_relu(outputs, SLOPE).clamp(min=_MIN_OUTPUT), None
        return functional.relu(outputs), None

    def texels(self, taps: Taps) -> Tensor:
        """Interpolated texels of the pyramid [n, channels]."""
        return fetched(self.rows(), taps)

    def rows(self) -> Tensor:
        """Texels of all levels [texels, channels], blurred."""
        return self._rows(list(self.features))

    def weights(self) -> Weights:
        """The trained numbers, for the renderer; of ours, with or without the offset."""
        layers = {"decoder": numbers_of_layers(self.decoder)}
        # The final ReLU passes factors on.
        weight, bias = layers["decoder"][-1]
        layers["decoder"][-1] = weight / np.float32(self.gains[0]), bias / np.float32(self.gains[0])
        offset_texels = None
        if self.offset is not None and self.offset_texture is not None:
            layers["offset"] = numbers_of_layers(self.offset)
            offset_texels = numbers_of(self._rows([self.offset_texture]))
        return Weights(
            self.shape, numbers_of(self.rows()), offset_texels, layers, np.zeros((1, 3), np.float32)
        )

    def _rows(self, textures: list[Tensor]) -> Tensor:
        rows = [
            (self.scale * blurred(texture, self.blur / 2**level)).permute(1, 2, 0).flatten(0, 1)
            for level, texture in enumerate(textures)
        ]
        return torch.cat(rows)

    @torch.no_grad()
    def value(
        self,
        positions: NDArray[np.float32],
        levels: NDArray[np.float32],
        lights: NDArray[np.float32],
        views: NDArray[np.float32],
    ) -> NDArray[np.float32]:
        """f·cos [n, 3], 1/sr, of positions in repeats, levels, and x and y of directions."""
        self.eval()
        arrays = [torch.from_numpy(np.ascontiguousarray(part)) for part in (positions, levels, lights, views)]
        parts = []
        for first in range(0, len(positions), _CHUNK):
            u, level, light, view = (part[first : first + _CHUNK] for part in arrays)
            face = torch.zeros(len(u), dtype=torch.int64)
            parts.append(self(u - u.floor(), level, light, view, face)[0] / (EXPOSURE * self.gains[0]))
        return torch.cat(parts).numpy()


def trained_textures(
    design: Design,
    source: Source,
    settings: NeumipSettings,
    folder: Path,
    queries_folder: Path,
    report: Report | None = None,
    device: str = "cpu",
) -> NeuralTextures:
    """A design trained for a source of one opaque face. A training that was stopped goes on.

    Args:
        settings: of queries and schedule; `settings.offset` is not read.
        folder: holds the checkpoint.
        queries_folder: holds the queries, which designs share.
        device: of torch, "cpu" or "cuda"; what is returned is on the CPU.

    Raises:
        InputError: a damaged checkpoint, or one of another training.
    """
    folder.mkdir(parents=True, exist_ok=True)
    btf = btf_of(source, "neumip")
    queries = taken_queries(source, btf, settings, queries_folder)
    torch.manual_seed(settings.seed)
    scale = settings.texture_rate / settings.rate
    network = NeuralTextures(design, settings.shape(source, btf.faces), scale, gains_of(queries)).to(device)
    batches = NeumipBatches(network, network.gains, queries, settings, device, published_error)

    def losses(step: int) -> Iterator[Tensor]:
        network.blur = blur_of(network.shape, step / settings.steps)
        yield from batches.losses(step)

    optimiser = torch.optim.Adam(network.parameters(), settings.rate)
    with one_thread():
        train(
            network,
            optimiser,
            losses,
            Schedule(settings.steps, lambda done: settings.rate * rate_factor(done)),
            folder / "checkpoint.safetensors",
            f"{design} {settings.identity(source)}",
            None if report is None else lambda step, steps, _: report(step, steps),
        )
    network.blur = 0.0
    return network.to("cpu")


def published_error(predicted: Tensor, truth: Tensor) -> Tensor:
    """The released code's loss: squares of differences of log(1 + x), and a tenth of absolute ones."""
    logarithmic = functional.mse_loss(torch.log1p(predicted), torch.log1p(truth))
    return logarithmic + 0.1 * functional.l1_loss(predicted, truth)


def blur_of(shape: PyramidShape, progress: float) -> float:
    """Standard deviation of the blur in texels of level 0, at a progress from 0 to 1 (section 4)."""
    first = min(_FIRST_BLUR, max(shape.columns, shape.rows) / _MIN_WIDTHS)
    return first * 2 ** (-_HALVINGS * progress)


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
