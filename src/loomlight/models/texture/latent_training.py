"""Training of `latent` for one source: queries of it, then encoder, textures and sampler, one after another.

Section 1 of the supplemental of zeltner2024, in phases that each have a checkpoint: encoder and decoder;
textures, which begin as what the encoder gives, and decoder; sampler and albedo, which change nothing of the
others; what guides denoisers, which learns from sampler and albedo. The torch modules below are also the
reference that tests compare the evaluation with.
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

from loomlight.models.registry import btf_of
from loomlight.models.texture.latent import (
    ALBEDO_OFFSET,
    ALBEDO_WIDTHS,
    AUXILIARY_WIDTHS,
    CHANNELS,
    FRAMES,
    MAX_AUXILIARY_SLOPE,
    MAX_EXPONENT,
    SAMPLER_WIDTHS,
    VALUE_OFFSET,
    Weights,
    decoder_widths,
    half_vector_features,
)
from loomlight.models.texture.pyramid import PyramidShape, level_taps
from loomlight.models.texture.queries import (
    ALPHAS,
    RESOLVED_ALPHA,
    EncodedBtf,
    LatentStream,
    Progress,
    Queries,
    Texels,
    draw_directions,
    draw_whole_levels,
)
from loomlight.models.texture.settings import AUTO, DECODERS, FEATURES, LatentSettings, loss_of_kind
from loomlight.models.texture.training import (
    QUERIES_DONE,
    WHOLE,
    Batches,
    TrainingFolder,
    folder_queries,
    half_cosine,
)
from loomlight.scattering.lobe_mixture import lobe_mixture, output_roughness
from loomlight.sources.kinds import Source, kind_of_source
from loomlight.training.direction_sampler import sampler_loss
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

# The smallest rate over the largest (eq. 1).
_LAST_RATE = 0.1
# Lights of a view in a step of the sampler.
_LIGHTS = 16
# Of libraries, steps are so many times as many, with batches so many times as small: in equal time their
# error is three quarters. Of others a step costs too much, whose textures have thousands of texels.
_SMALL = 4
# Keys that separate the random numbers of the sampler, of albedos and of batches of mollified queries from
# those of queries and other batches.
_SAMPLER, _ALBEDOS, _CONES, _AUXILIARY = 6, 7, 9, 10
# Largest rate of the network of what guides denoisers.
_AUXILIARY_RATE = 1e-2
# Thousandths of the progress after textures.
_TEXTURES_DONE = 850
# Views and places of which a face's mean albedo is taken.
_ALBEDO_VIEWS = 4096


def train_latent(
    source: Source,
    settings: LatentSettings,
    folder: Path,
    progress: Progress | None = None,
    device: str = "cpu",
    keep_every: float = 30.0,
    shared: Path | None = None,
) -> Weights:
    """The weights of a material.

    Args:
        folder: holds queries and checkpoints; made if need be, and used again to go on.
        device: of torch, "cpu" or "cuda".
        keep_every: seconds between checkpoints.
        shared: folder of the queries, which trainings share that differ in nothing that they depend on; by
            default `folder`.

    Raises:
        InputError: a source of which no queries can be taken, or a damaged checkpoint.
    """
    btf = btf_of(source, "latent")
    assert isinstance(btf, EncodedBtf)  # as all that the registry lists for this model
    texels = btf.texels(settings.resolution)
    shape = PyramidShape(*texels.resolution, *source.repeat_mm, btf.faces, texels.is_apart)
    run = TrainingFolder(folder, settings.identity(source), progress, keep_every)
    finest_alpha = RESOLVED_ALPHA if settings.features == FEATURES[0] else ALPHAS[0]
    stream = LatentStream(
        btf,
        texels,
        shape.levels,
        settings.samples,
        settings.seed,
        settings.mollified_queries,
        finest_alpha,
    )
    folder.mkdir(parents=True, exist_ok=True)
    asked = settings.query_identity(source)
    queries = folder_queries(stream, shared or folder, asked, settings.queries, progress)
    torch.manual_seed(settings.seed)
    network = LatentNetwork(
        shape,
        texel_inputs(texels, shape),
        DECODERS[settings.decoder],
        # Measured BRDFs are about the normal of their face.
        settings.rung == "frames" and not texels.is_apart,
        settings.features == FEATURES[0],
        settings.texture_rate / settings.rate,
    ).to(device)
    if settings.loss == AUTO:
        settings = replace(settings, loss=loss_of_kind(kind_of_source(source)))
    if texels.is_apart:
        settings = replace(settings, steps=_SMALL * settings.steps, batch=max(1, settings.batch // _SMALL))
    with one_thread():
        _train_phases(network, queries, settings, run, device)
        auxiliary = train_auxiliary(network, settings, run)
        return network.weights(_face_albedos(network, settings.seed), auxiliary)


def _train_phases(
    network: LatentNetwork, queries: Queries, settings: LatentSettings, run: TrainingFolder, device: str
) -> None:
    with_encoder = settings.rung != "mlp"
    encoder_steps = round(settings.encoder_share * settings.steps) if with_encoder else 0
    common = [network.decoder, *([network.frames] if network.frames is not None else [])]
    # One cosine over encoder and textures, which begin where the encoder's phase ends.
    share = encoder_steps / settings.steps
    middle = QUERIES_DONE + round((_TEXTURES_DONE - QUERIES_DONE) * share)

    def rate(begin: float, end: float) -> Callable[[float], float]:
        return lambda done: settings.rate * rate_factor(begin + (end - begin) * done)

    def optimiser(kind: str, parts: list[nn.Parameter]) -> torch.optim.Optimizer:
        if kind == "soap":
            return Soap(parts, settings.rate)
        return torch.optim.Adam(parts, settings.rate, eps=1e-7)

    def parameters(*modules: nn.Module) -> list[nn.Parameter]:
        return [parameter for module in modules for parameter in module.parameters()]

    # Encoder and decoder.
    if encoder_steps:
        batches = LatentBatches(network, queries, settings, device, encoded=True)
        trained = optimiser(settings.optimiser, parameters(network.encoder, *common))
        schedule = encoder_steps, rate(0.0, share)
        run.train("encoder", network, trained, batches.losses, schedule, (QUERIES_DONE, middle))
        network.encode_texels()
    # Textures and decoder.
    batches = LatentBatches(network, queries, settings, device, first=encoder_steps)
    trained = optimiser(settings.optimiser, [network.latents, *parameters(*common)])
    schedule = max(1, settings.steps - encoder_steps), rate(share, 1.0)
    run.train("textures", network, trained, batches.losses, schedule, (middle, _TEXTURES_DONE))
    # Sampler and albedo.
    sampler = _SamplerLosses(network, settings)
    trained = optimiser("adam", parameters(network.sampler, network.albedo))
    schedule = settings.sampler_steps, rate(0.0, 1.0)
    run.train("sampler", network, trained, sampler.losses, schedule, (_TEXTURES_DONE, WHOLE))


def train_auxiliary(network: LatentNetwork, settings: LatentSettings, run: TrainingFolder) -> nn.Sequential:
    """The network of what guides denoisers: albedo, roughness and normal of a latent; see `Auxiliary`.

    Its teachers are the networks of lobes and albedos, so that any source has it, whatever its textures are.
    """
    auxiliary = relu_layers(AUXILIARY_WIDTHS).to(network.latents.device)
    trained = torch.optim.Adam(auxiliary.parameters(), _AUXILIARY_RATE)

    def losses(step: int) -> Iterator[Tensor]:
        rng = np.random.default_rng([settings.seed, _AUXILIARY, step])
        latent, _ = _places(network, rng, settings.sampler_batch)
        yield functional.mse_loss(auxiliary_numbers(auxiliary(latent)), _taught(network, latent, rng))

    schedule = settings.sampler_steps, lambda done: _AUXILIARY_RATE * rate_factor(done)
    run.train("auxiliary", auxiliary, trained, losses, schedule)
    return auxiliary


def auxiliary_numbers(outputs: Tensor) -> Tensor:
    """Albedo, roughness and slopes [n, 6] of outputs of the auxiliary network [n, 6]."""
    albedo = torch.exp((outputs[:, :3] - ALBEDO_OFFSET).clamp(max=MAX_EXPONENT))
    roughness = output_roughness(outputs[:, 3:4], TORCH)
    return torch.cat([albedo, roughness, outputs[:, 4:]], dim=1)


@torch.no_grad()
def _taught(network: LatentNetwork, latent: Tensor, rng: np.random.Generator) -> Tensor:
    """What the auxiliary network learns of latents [n, 6]."""
    above = latent.new_tensor([0.0, 0.0, 1.0]).expand(len(latent), 3)
    outputs, _ = network.sampler_outputs(latent, above)
    lobes = lobe_mixture(outputs.unbind(1), TORCH)
    share = lobes.specular_share
    area = lobes.alpha[0] * lobes.alpha[1] * torch.sqrt(1 - lobes.correlation.square())
    roughness = share * torch.sqrt(area) + (1 - share)
    slopes = [
        (share * specular + (1 - share) * diffuse).clamp(-MAX_AUXILIARY_SLOPE, MAX_AUXILIARY_SLOPE)
        for specular, diffuse in zip(lobes.specular_slope, lobes.diffuse_slope, strict=True)
    ]
    # Squared errors make the mean over views the optimum.
    views = torch.from_numpy(draw_directions(rng, len(latent))).to(latent.device)
    _, log_albedo = network.sampler_outputs(latent, views)
    albedo = torch.exp(log_albedo).clamp(max=1)
    return torch.cat([albedo, torch.stack([roughness, *slopes], dim=1)], dim=1)


def rate_factor(progress: float) -> float:
    """The learning rate over the largest, at a progress from 0 to 1 (eq. 1)."""
    return half_cosine(progress, _LAST_RATE)


class LatentBatches(Batches):
    """Batches whose loss is that of the settings: of mollified queries first, then passes over the others."""

    def __init__(
        self,
        network: LatentNetwork,
        queries: Queries,
        settings: LatentSettings,
        device: str,
        encoded: bool = False,
        first: int = 0,
    ) -> None:
        """
        Args:
            encoded: whether latents are the encoder's.
            first: steps before this phase, whose queries are not repeated.
        """
        super().__init__(network, queries, settings, device)
        self._kind, self._encoded, self._first = settings.loss, encoded, first
        self._mollified, self._mollified_steps = settings.mollified_queries, settings.mollified_steps
        self._order_passes(range(self._mollified, len(queries)))

    def _chosen(self, step: int) -> NDArray[np.intp]:
        number = self._first + step
        if number >= self._mollified_steps:
            return super()._chosen(number - self._mollified_steps)
        # Cones narrow along these queries, so steps go along them too, a sixteenth of them at a time.
        span = min(self._mollified, max(self._batch, self._mollified // 16))
        start = round((self._mollified - span) * number / max(1, self._mollified_steps - 1))
        rng = np.random.default_rng([self._seed, _CONES, number])
        return start + rng.integers(span, size=min(self._batch, self._mollified))

    def _loss(self, batch: Queries, step: int) -> Tensor:
        del step
        positions, lights, views, values = self._tensors(
            batch.positions, batch.lights, batch.views, batch.values
        )
        levels, faces = self._tensors(batch.levels.astype(np.int64), batch.faces.astype(np.int64))
        latent = self._network.latent(positions, levels, faces, self._encoded)
        return loss_of(self._network(latent, lights, views), values, self._kind)


class _SamplerLosses:
    """Losses of the sampler: it learns what the trained decoder scatters, at places drawn anew each step."""

    def __init__(self, network: LatentNetwork, settings: LatentSettings) -> None:
        self._network, self._settings = network, settings

    def losses(self, step: int) -> Iterator[Tensor]:
        """The loss of one step."""
        network, settings = self._network, self._settings
        rng = np.random.default_rng([settings.seed, _SAMPLER, step])
        latent, views = _places(network, rng, settings.sampler_batch)
        generator = torch.Generator().manual_seed(int(rng.integers(2**62)))

        def reflected(lights: Tensor) -> Tensor:
            # Each view and latent is that of a row of lights.
            latents, seen = (part[:, None].expand(-1, lights.shape[1], -1) for part in (latent, views))
            values: Tensor = network(latents, lights, seen)
            return values

        yield sampler_loss(*network.sampler_outputs(latent, views), views, reflected, _LIGHTS, generator)


@torch.no_grad()
def _places(
    network: LatentNetwork, rng: np.random.Generator, count: int, face: int | None = None
) -> tuple[Tensor, Tensor]:
    """Latents and views at random places of all levels."""
    shape, device = network.shape, network.latents.device
    levels = draw_whole_levels(rng, count, shape.levels).astype(np.int64)
    faces = rng.integers(shape.faces, size=count) if face is None else np.full(count, face)
    positions = torch.from_numpy(rng.random((count, 2), np.float32)).to(device)
    latent = network.latent(
        positions, torch.from_numpy(levels).to(device), torch.from_numpy(faces).to(device), encoded=False
    )
    return latent, torch.from_numpy(draw_directions(rng, count)).to(device)


@torch.no_grad()
def _face_albedos(network: LatentNetwork, seed: int) -> NDArray[np.float32]:
    """Mean albedo of each face [faces, 3], by the trained network."""
    means = []
    for face in range(network.shape.faces):
        rng = np.random.default_rng([seed, _ALBEDOS, face])
        _, log_albedo = network.sampler_outputs(*_places(network, rng, _ALBEDO_VIEWS, face))
        means.append(torch.exp(log_albedo).mean(dim=0).clamp(0, 1).cpu().numpy())
    return np.stack(means).astype(np.float32)


# ------------------------------------------------------------------------------------------------ the network

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

    def weights(self, reflectance: NDArray[np.float32], auxiliary: nn.Sequential) -> Weights:
        """The trained numbers, for the renderer.

        Args:
            reflectance: mean albedo of each face [faces, 3].
            auxiliary: see `train_auxiliary`.
        """
        frames = None if self.frames is None else numbers_of(self.frames.weight)
        layers = {name: numbers_of_layers(getattr(self, name)) for name in ("decoder", "sampler", "albedo")}
        layers["auxiliary"] = numbers_of_layers(auxiliary)
        return Weights(self.shape, numbers_of(self.scale * self.latents), frames, layers, reflectance)


def texel_inputs(texels: Texels, shape: PyramidShape) -> NDArray[np.float32]:
    """Inputs of the encoder for all texels [faces · texels, K], in the order of `Weights.latents`."""
    count = len(texels.inputs)
    parts = [
        texels.encoder_inputs(level, face).reshape(-1, count)
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
