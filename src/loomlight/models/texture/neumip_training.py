"""Training of `neumip` for one source: queries of it, textures and networks, then directions that are drawn.

kuznetsov2021 section 4, with what `docs/research/models/neumip.md` says is different. The torch modules below
are also the reference that tests compare the evaluation with.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional

from loomlight.models.networks import Layers
from loomlight.models.registry import btf_of
from loomlight.models.texture.neumip import (
    CHANNELS,
    DECODER_WIDTHS,
    EXPOSURE,
    MIN_COSINE,
    OFFSET_WIDTHS,
    OPACITY_WIDTHS,
    Weights,
    quantised,
    sampler_widths,
    shifted,
)
from loomlight.models.texture.pyramid import PyramidShape, bilinear_taps, trilinear_taps
from loomlight.models.texture.queries import (
    Btf,
    NeumipStream,
    Progress,
    Queries,
    draw_directions,
    draw_levels,
    light_density,
)
from loomlight.models.texture.settings import NeumipSettings
from loomlight.models.texture.training import (
    QUERIES_DONE,
    WHOLE,
    Batches,
    TrainingFolder,
    folder_queries,
    half_cosine,
)
from loomlight.scattering.lobe_mixture import TwoSidedLobes
from loomlight.sources.kinds import Source
from loomlight.training.direction_sampler import two_sided_loss
from loomlight.training.layers import (
    TORCH,
    TorchTextures,
    fetched,
    numbers_of,
    numbers_of_layers,
    relu_layers,
)
from loomlight.training.loop import one_thread
from loomlight.training.soap import Soap

_WARM_UP = 0.02
# Mean of π f·cos that dark sources are scaled to while they are trained, and the largest factor.
_MEAN, _MAX_GAIN = 0.15, 1e3
# Weight of the cross-entropy of holes, beside errors of colours.
_OF_HOLES = 0.05


def train_neumip(
    source: Source,
    settings: NeumipSettings,
    folder: Path,
    progress: Progress | None = None,
    device: str = "cpu",
    keep_every: float = 30.0,
) -> Weights:
    """The weights of a material.

    Args:
        folder: holds queries and the checkpoint; made if need be, and used again to go on.
        device: of torch, "cpu" or "cuda".
        keep_every: seconds between checkpoints.

    Raises:
        InputError: a source of which no queries can be taken, or a damaged checkpoint.
    """
    network, queries, run = trained_network(source, settings, folder, progress, device, keep_every)
    density = light_density(queries, btf_of(source, "neumip").measured is not None)
    weights = network.weights(reflectances(queries, network.shape.faces, density))
    with one_thread():
        sampler = trained_sampler(network, settings, run)
    return replace(weights, open_area=float(queries.holes.mean()), sampler=sampler)


def trained_network(
    source: Source,
    settings: NeumipSettings,
    folder: Path,
    progress: Progress | None = None,
    device: str = "cpu",
    keep_every: float = 30.0,
) -> tuple[NeumipNetwork, Queries, TrainingFolder]:
    """Textures and networks that colours come of, the queries that they learned from, and their folder.

    Arguments and errors as of `train_neumip`, which trains directions too.
    """
    btf = btf_of(source, "neumip")
    shape = settings.shape(source, btf.faces)
    run = TrainingFolder(folder, settings.identity(source), progress, keep_every)
    queries = taken_queries(source, btf, settings, folder, progress)
    torch.manual_seed(settings.seed)
    scale = settings.texture_rate / settings.rate
    gains = gains_of(queries)
    network = NeumipNetwork(shape, settings.offset, scale, btf.transmits, btf.has_holes, gains).to(device)
    batches = NeumipBatches(network, gains, queries, settings, device)
    parts = dict(network.named_parameters())
    textures = [parts.pop(name) for name in ("features", "offset_texture") if name in parts]
    # Texels are seldom seen: the squares of their gradients are remembered longer, and no axes are turned.
    unturned = {"params": textures, "largest_side": 1, "memory": (0.9, 0.99)}
    optimiser = Soap([{"params": [*parts.values()]}, unturned], settings.rate)
    schedule = settings.steps, lambda done: settings.rate * rate_factor(done)
    with one_thread():
        run.train("checkpoint", network, optimiser, batches.losses, schedule, (QUERIES_DONE, WHOLE))
    return network, queries, run


def taken_queries(
    source: Source, btf: Btf, settings: NeumipSettings, folder: Path, progress: Progress | None = None
) -> Queries:
    """All queries of a training; parts that the folder holds are read."""
    samples = settings.fine_samples, settings.samples
    stream = NeumipStream(btf, settings.shape(source, btf.faces), samples, settings.seed)
    return folder_queries(stream, folder, settings.query_identity(source), settings.queries, progress)


def reflectances(queries: Queries, faces: int, density: NDArray[np.float32]) -> NDArray[np.float32]:
    """Mean albedo of each face [faces, 3], of light on the side of the view.

    Args:
        density: of the lights on their side [n], 1/sr.
    """
    near = queries.is_transmission == 0
    weighted = queries.values / density[:, None]
    means = [weighted[near & (queries.faces == face)].mean(axis=0) for face in range(faces)]
    return np.clip(np.stack(means), 0, 1).astype(np.float32)


def gains_of(queries: Queries) -> tuple[float, float]:
    """Factors of π f·cos for training: of lights on the view's side, and on the other one.

    Dark values are scaled up to a mean of `_MEAN`. Without that the first weights, which are about 1, give
    colours below 0 almost everywhere, errors are too small to pull them up, and dark cloth stays black.
    """
    near = queries.is_transmission == 0
    means = [float(queries.values[side].mean()) if side.any() else 0.0 for side in (near, ~near)]
    first, second = (min(max(_MEAN / max(EXPOSURE * mean, 1e-9), 1.0), _MAX_GAIN) for mean in means)
    return first, second


def rate_factor(progress: float) -> float:
    """The learning rate over the largest, at a progress from 0 to 1: a short rise, then a half cosine."""
    return min(1.0, (progress + 1e-9) / _WARM_UP) * half_cosine(progress)


class NeumipBatches(Batches):
    """Batches whose loss is of π f·cos, and of holes where there are any."""

    def __init__(
        self,
        network: nn.Module,
        gains: tuple[float, float],
        queries: Queries,
        settings: NeumipSettings,
        device: str,
        error: Callable[[Tensor, Tensor], Tensor] = functional.mse_loss,
    ) -> None:
        """
        Args:
            network: of the outputs of `NeumipNetwork.forward`.
            gains: see `gains_of`.
            error: of predicted and true π f·cos times the gains [n, 3].
        """
        super().__init__(network, queries, settings, device)
        self._gains, self._error = gains, error
        self._frozen_from = settings.offset_share * settings.steps

    def _loss(self, batch: Queries, step: int) -> Tensor:
        positions, levels, lights, views, values = self._tensors(
            batch.positions, batch.levels, batch.lights[:, :2], batch.views[:, :2], batch.values
        )
        faces, is_transmission = self._tensors(
            batch.faces.astype(np.int64), batch.is_transmission.astype(bool)
        )
        predicted, opacity = self._network(
            positions, levels, lights, views, faces, step >= self._frozen_from, is_transmission
        )
        near, far = (values.new_tensor(gain) for gain in self._gains)
        gains = torch.where(is_transmission, far, near)
        loss = self._error(predicted, EXPOSURE * gains[:, None] * values)
        if opacity is None:
            return loss
        (holes,) = self._tensors(batch.holes)
        return loss + _OF_HOLES * functional.binary_cross_entropy_with_logits(opacity, holes)


# ------------------------------------------------------------------------------------------------ the network

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


# ---------------------------------------------------------------------------------- directions that are drawn

# Views of a step, lights of a view, the largest rate and the smallest over it.
_VIEWS, _LIGHTS, _RATE, _LAST_RATE = 1024, 16, 3e-3, 0.05
_LUMINANCE = (0.2126, 0.7152, 0.0722)
# Key of random numbers.
_SAMPLER = 8


def trained_sampler(network: NeumipNetwork, settings: NeumipSettings, run: TrainingFolder) -> Layers:
    """The layers of the network that draws directions, trained by the decoders, which give any values.

    The loss is the relative entropy of its density to the luminance of f·cos (zeltner2024 section 5). No
    gradient reaches textures and decoders. A training that was stopped goes on.

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

    schedule = settings.sampler_steps, lambda done: _RATE * half_cosine(done, _LAST_RATE)
    run.train("sampler", sampler, Soap(sampler.parameters(), _RATE), losses, schedule)
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
