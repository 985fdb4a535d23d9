"""Trains the network that draws directions for all fabrics (`sampler_network.py`), beside a trained decoder.

Fabrics are random ones of the decoder's training; the decoder's SIMD kernel gives components, and albedos are
drawn anew for each view. The loss is the relative entropy of the density to the luminance of f·cos over the
sphere, estimated with lights that are drawn evenly by the density itself and by cosines on either side.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from safetensors.numpy import save_file
from torch import Tensor, nn

from loomlight.core.files import replacing
from loomlight.core.llvm import llvm_float
from loomlight.models.networks import Layers
from loomlight.models.neural.decoder import columns, compiled_decoder, one_square
from loomlight.models.neural.encoded_fabric import EncodedFabric
from loomlight.models.neural.encoding import run_encoder
from loomlight.models.neural.latent_table import LatentTable
from loomlight.models.neural.proposal import FURTHER_INPUTS, further_inputs
from loomlight.models.neural.weights import TRAINING_RANGES, Weights
from loomlight.scattering.lobe_mixture import OUTPUTS, TwoSidedLobes
from loomlight.training.direction_sampler import two_sided_loss
from loomlight.training.layers import TORCH, relu_layers
from loomlight.training.loop import Report, Schedule, train
from loomlight.training.soap import Soap
from studies.papers.chen2024.training.random_fabrics import random_fabric
from studies.papers.chen2024.training.weaves import training_draft

_Floats = NDArray[np.float32]
_HIDDEN = (40, 40)
# Sides of footprints in threads, and the smallest cosine of a view.
_SIDES, _MIN_COSINE = (1 / 64, 32.0), 0.03
# Shares of views whose albedos are the same in both families, and whose cloth is opaque.
_ALIKE, _OPAQUE = 0.4, 0.4
# Keys of random numbers: of fabrics, of steps, of the inputs' scale.
_FABRICS, _STEPS, _SCALE = 1, 2, 3


@dataclass(frozen=True)
class SamplerSettings:
    """How the sampler is trained.

    Attributes:
        fabrics: random ones, each encoded once.
        steps: updates.
        together: fabrics of a step.
        views: of each fabric in a step.
        lights: of each view.
        rate: largest learning rate, which falls to a fiftieth by a half cosine.
        seed: of all.
    """

    fabrics: int = 64
    steps: int = 1500
    together: int = 4
    views: int = 256
    lights: int = 16
    rate: float = 3e-3
    seed: int = 0


class SamplerNetwork(nn.Module):
    """Dense layers of scaled inputs."""

    def __init__(self, hidden: int) -> None:
        """
        Args:
            hidden: width of the decoder.
        """
        super().__init__()
        self.layers = relu_layers((hidden + FURTHER_INPUTS, *_HIDDEN, OUTPUTS))
        self.register_buffer("mean", torch.zeros(hidden + FURTHER_INPUTS))
        self.register_buffer("scale", torch.ones(hidden + FURTHER_INPUTS))

    mean: Tensor
    scale: Tensor

    def forward(self, inputs: Tensor) -> Tensor:
        """The `OUTPUTS` numbers of `TwoSidedLobes` [n, 19]."""
        outputs: Tensor = self.layers((inputs - self.mean) / self.scale)
        return outputs

    @torch.no_grad()
    def exported(self) -> Layers:
        """Layers of plain inputs."""
        linear = [layer for layer in self.layers if isinstance(layer, nn.Linear)]
        first = linear[0].weight / self.scale
        pairs = [(first, linear[0].bias - first @ self.mean)]
        pairs += [(layer.weight, layer.bias) for layer in linear[1:]]
        return [(weight.numpy().copy(), bias.numpy().copy()) for weight, bias in pairs]


class Scenes:
    """Random fabrics under a decoder: views with what they fix, and values for lights."""

    def __init__(self, weights: Weights, count: int, seed: int) -> None:
        self._decoder, self._hidden = compiled_decoder(weights), weights.table.hidden
        self.fabrics: list[tuple[EncodedFabric, LatentTable]] = []
        for number in range(count):
            rng = np.random.default_rng([seed, _FABRICS, number])
            fabric = random_fabric(rng, training_draft(rng, "all"), ranges=TRAINING_RANGES)
            encoded = run_encoder(fabric, weights, llvm_float())
            self.fabrics.append((encoded, LatentTable(weights, encoded)))

    def views(self, rng: np.random.Generator, fabric: int, count: int) -> Views:
        """Random footprints, views and albedos of a fabric."""
        encoded, table = self.fabrics[fabric]
        views, back = _directions(rng, count), rng.random(count) < 0.5
        place = rng.random((2, count)) * np.array([[encoded.ends], [encoded.picks]])
        low, high = (math.log(side) for side in _SIDES)
        sides = np.exp(rng.uniform(low, high, count))
        taps = one_square(np.stack([*place, sides]).astype(np.float32))
        outputs = np.empty((self._hidden + 2, count), np.float32)
        shared = [*columns(views), back.astype(np.float32)]
        self._decoder.run("view", table, [*taps, *shared], [*outputs])
        albedos = _albedos(rng, count)
        faces = np.stack([encoded.fibres.face(False), encoded.fibres.face(True)])[back.astype(int)]
        fibres = [tuple(faces[:, family, k] for k in range(3)) for family in range(2)]
        further = further_inputs([*views.T], fibres, [*albedos.T])
        inputs = np.stack([*outputs[:-2], *further], axis=1).astype(np.float32)
        return Views(inputs, views, np.delete(outputs, self._hidden, axis=0), back, albedos, table)

    def luminances(self, views: Views, lights: _Floats) -> _Floats:
        """f·cos [n, m] of lights [n, m, 3], 1/sr."""
        count, each = lights.shape[:2]

        def repeated(part: _Floats) -> _Floats:
            return np.repeat(part, each)

        outputs = np.empty((4, count * each), np.float32)
        inputs = [repeated(part) for part in views.activations]
        inputs += [repeated(part) for part in (*columns(views.directions), views.back.astype(np.float32))]
        self._decoder.run("components", views.table, [*inputs, *columns(lights.reshape(-1, 3))], [*outputs])
        # Albedos in the order of components: diffuse of warp and weft, then specular.
        reflect, transmit = views.albedos[:, [0, 4, 2, 6]], views.albedos[:, [1, 5, 3, 7]]
        albedos = np.where(lights[..., 2:] > 0, reflect[:, None], transmit[:, None])
        found: _Floats = (albedos * outputs.T.reshape(count, each, 4)).sum(axis=-1, dtype=np.float32)
        return found


@dataclass(frozen=True, eq=False)
class Views:
    """Views of one fabric.

    Attributes:
        inputs: of the sampler [n, hidden + `FURTHER_INPUTS`].
        directions: unit vectors [n, 3], z > 0.
        activations: inputs of the decoder's entry point "components" [hidden + 1, n].
        back: the back is seen [n].
        albedos: in the order of `further_inputs` [n, 8].
        table: of the fabric.
    """

    inputs: _Floats
    directions: _Floats
    activations: _Floats
    back: NDArray[np.bool_]
    albedos: _Floats
    table: LatentTable


def train_sampler(
    weights: Weights, settings: SamplerSettings, folder: Path, report: Report | None = None
) -> Layers:
    """The layers of a sampler for a decoder. A training that was stopped goes on from its folder.

    Args:
        folder: holds the checkpoint; made if need be.

    Raises:
        InputError: a damaged checkpoint, or one of other settings.
    """
    folder.mkdir(parents=True, exist_ok=True)
    scenes = Scenes(weights, settings.fabrics, settings.seed)
    torch.manual_seed(settings.seed)
    network = SamplerNetwork(weights.table.hidden)
    rng = np.random.default_rng([settings.seed, _SCALE])
    inputs = torch.from_numpy(
        np.concatenate([scenes.views(rng, fabric, 256).inputs for fabric in range(settings.fabrics)])
    )
    network.mean.copy_(inputs.mean(0))
    network.scale.copy_(inputs.std(0).clamp(min=1e-3))

    def losses(step: int) -> Iterator[Tensor]:
        rng = np.random.default_rng([settings.seed, _STEPS, step])
        parts = [
            scenes.views(rng, int(fabric), settings.views)
            for fabric in rng.integers(settings.fabrics, size=settings.together)
        ]
        yield sampler_divergence(network, scenes, parts, settings.lights, rng)

    train(
        network,
        Soap(network.layers.parameters(), settings.rate),
        losses,
        Schedule(settings.steps, lambda done: settings.rate * (0.02 + 0.49 * (1 + math.cos(math.pi * done)))),
        folder / "sampler.safetensors",
        f"{settings} {weights.sha256}",
        report,
    )
    return network.exported()


def sampler_divergence(
    network: SamplerNetwork, scenes: Scenes, parts: list[Views], lights: int, rng: np.random.Generator
) -> Tensor:
    """Relative entropy of the network's density to f·cos, up to a number that no weight changes."""
    lobes = TwoSidedLobes.of(
        [
            column[:, None]
            for column in network(torch.from_numpy(np.concatenate([p.inputs for p in parts]))).T
        ],
        TORCH,
    )
    directions = torch.from_numpy(np.concatenate([part.directions for part in parts]))

    def values(lights: Tensor) -> Tensor:
        found, first = [], 0
        for part in parts:
            chosen = lights[first : first + len(part.directions)]
            found.append(torch.from_numpy(scenes.luminances(part, np.ascontiguousarray(chosen.numpy()))))
            first += len(part.directions)
        return torch.cat(found)

    generator = torch.Generator().manual_seed(int(rng.integers(2**62)))
    return two_sided_loss(lobes, directions, values, lights, generator)


def write_sampler(path: Path, layers: Layers, weights: Weights) -> None:
    """Writes a sampler in half precision, with the checksum of the decoder that it belongs to."""
    tensors: dict[str, NDArray[np.generic]] = {
        f"{number}.{name}": part.astype(np.float16)
        for number, pair in enumerate(layers)
        for name, part in zip(("weight", "bias"), pair, strict=True)
    }
    tensors["network"] = np.frombuffer(bytes.fromhex(weights.sha256), np.uint8)
    with replacing(path) as temporary:
        save_file(tensors, temporary)


def _directions(rng: np.random.Generator, count: int) -> _Floats:
    """Unit vectors [count, 3] with z > 0, half uniform in solid angle, half on the projected disk."""
    u, azimuth = rng.random(count), 2 * math.pi * rng.random(count)
    cosine = _MIN_COSINE + (1 - _MIN_COSINE) * np.where(rng.random(count) < 0.5, u, np.sqrt(u))
    sine = np.sqrt(1 - cosine**2)
    return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=1).astype(np.float32)


def _albedos(rng: np.random.Generator, count: int) -> _Floats:
    """Albedos [count, 8] in the order of `further_inputs`: dark and light, matt and glossy, opaque or not."""
    diffuse, specular = 0.8 * rng.random((2, count, 2)) ** 1.5
    transmitted = rng.random((2, count, 2)) * (rng.random((count, 1)) > _OPAQUE)
    rows = np.stack(
        [diffuse, diffuse * transmitted[0], specular, specular * transmitted[1]], axis=2
    )  # [count, family, term]
    rows[:, 1] = np.where(rng.random((count, 1)) < _ALIKE, rows[:, 0], rows[:, 1])
    return rows.reshape(count, 8).astype(np.float32)
