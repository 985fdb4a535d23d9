"""Rainer et al. 2019 and 2020 with their encoders: latents of texels come from what is measured of each.

The encoder sees the apparent BRDF of a texel: f·cos for a fixed set of pairs of light and view, less its mean
and over its deviation, which texels keep as colours. 2019 has an encoder and a decoder for each material,
2020 one of both for all materials. The published encoders are built for the grids of directions of measured
BTFs; here they are dense layers, as pairs are scattered. Texels of coarse levels have the means of the
apparent BRDFs below them, so that the pyramid needs no further queries. Networks learn by random queries, and
by the optimiser, loss and schedule of neumip; pictures are asked of the encoded textures alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from safetensors import SafetensorError
from safetensors.numpy import load_file, save_file
from torch import Tensor, nn
from torch.nn import functional

from loomlight.core.files import replacing
from loomlight.models.registry import btf_of
from loomlight.models.texture.neumip import EXPOSURE
from loomlight.models.texture.neumip_training import NeumipBatches, rate_factor
from loomlight.models.texture.pyramid import SIZE_OF_SIGMA, PyramidShape, Taps
from loomlight.models.texture.queries import Queries, draw_directions
from loomlight.models.texture.settings import NeumipSettings
from loomlight.sources.kinds import Source
from loomlight.training.layers import fetched, relu_layers
from loomlight.training.loop import Schedule, one_thread, train
from loomlight.training.soap import Soap
from studies.papers.kuznetsov2021.designs import Design
from studies.papers.kuznetsov2021.neural_textures import NeuralTextures

_Floats = NDArray[np.float32]
# Pairs of light and view of an apparent BRDF, and hidden layers of an encoder.
PAIRS = 64
_HIDDEN = (128, 64)
# Added to deviations, which texels of one colour do not have.
_MIN_DEVIATION = 1e-3
_APPARENT, _TILE_ORDER = 11, 12  # keys of random numbers
_TILES = 4  # of a side of the repeat, in training
_CHUNK = 1 << 14  # texels evaluated at once


class EncodedTextures(NeuralTextures):
    """The textures of one material, as an encoder gives them, under a decoder."""

    def __init__(
        self,
        design: Design,
        shape: PyramidShape,
        apparent: _Floats,
        gains: tuple[float, float] = (1.0, 1.0),
        networks: tuple[nn.Sequential, nn.Sequential] | None = None,
    ) -> None:
        """
        Args:
            apparent: f·cos of the texels of the finest level [rows, columns, `PAIRS`, 3], 1/sr.
            networks: encoder and decoder that other materials share; by default its own.
        """
        super().__init__(design, shape, gains=gains)
        self.encoder, self.decoder = networks or (
            relu_layers((3 * PAIRS, *_HIDDEN, design.latent)),
            self.decoder,
        )
        inputs, colours, first = [], [], EXPOSURE * gains[0] * torch.from_numpy(apparent).permute(2, 3, 0, 1)
        for wide, high in shape.sizes:
            pooled = functional.adaptive_avg_pool2d(first.flatten(0, 1), (high, wide))
            pooled = pooled.reshape(PAIRS, 3, -1).permute(2, 0, 1)  # [texels, pairs, 3]
            mean, deviation = pooled.mean(1), pooled.std(1) + _MIN_DEVIATION
            inputs.append(((pooled - mean[:, None]) / deviation[:, None]).flatten(1))
            colours.append(torch.cat([mean, deviation], dim=1))
        self.register_buffer("inputs", torch.cat(inputs), persistent=False)
        self.register_buffer("colours", torch.cat(colours), persistent=False)

    inputs: Tensor
    colours: Tensor

    def first_textures(self) -> nn.ParameterList:
        """None: all are encoded."""
        return nn.ParameterList()

    def rows(self) -> Tensor:
        """Latents and colours of all texels [texels, channels]; encoded textures are not blurred."""
        return torch.cat([self.encoder(self.inputs), self.colours], dim=1)

    def texels(self, taps: Taps) -> Tensor:
        """Interpolated texels [n, channels]; those that no query reads are not encoded."""
        read, places = torch.unique(torch.stack(taps.texels, dim=1), return_inverse=True)
        rows = torch.cat([self.encoder(self.inputs[read]), self.colours[read]], dim=1)
        return fetched(rows, Taps([*places.unbind(1)], taps.weights))


class TiledBatches(NeumipBatches):
    """Batches of one tile of the repeat each, in random order: their queries share encoded texels."""

    def __init__(
        self, network: EncodedTextures, queries: Queries, settings: NeumipSettings, device: str
    ) -> None:
        super().__init__(network, network.gains, queries, settings, device)
        column, row = np.minimum(_TILES * queries.positions, _TILES - 1).astype(np.intp).T
        self._tiles, self._tiled = _TILES * row + column, (-1, np.zeros((0, 0), np.intp))

    def _chosen(self, step: int) -> NDArray[np.intp]:
        number, place = divmod(step, self._per_pass)
        if self._tiled[0] != number:
            rng = np.random.default_rng([self._seed, _TILE_ORDER, number])
            shuffled = rng.permutation(len(self._tiles))
            by_tile = shuffled[np.argsort(self._tiles[shuffled], kind="stable")]
            whole = by_tile[: self._per_pass * self._batch].reshape(self._per_pass, -1)
            self._tiled = number, rng.permutation(whole)
        return self._tiled[1][place]


def trained_encodings(
    design: Design,
    textures: Sequence[EncodedTextures],
    queries: Sequence[Queries],
    settings: NeumipSettings,
    folder: Path,
    identity: str,
    report: Callable[[int, int], None] | None = None,
    device: str = "cpu",
) -> None:
    """Trains the encoder and the decoder that textures share, by the optimiser and the loss of `neumip`.

    A step is of one material, in turn. A training that was stopped goes on.

    Args:
        queries: of each of the textures.
        settings: of the schedule; `steps` is of all materials together.
        folder: holds the checkpoint.
        identity: of all that the weights depend on.
        report: called with (steps done, steps in all).
        device: of torch, "cpu" or "cuda"; afterwards the textures are on the CPU again.

    Raises:
        InputError: a damaged checkpoint, or one of another training.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for each in textures:
        each.to(device)
    batches = [TiledBatches(*each, settings, device) for each in zip(textures, queries, strict=True)]
    shared = nn.ModuleList([textures[0].encoder, textures[0].decoder])

    def losses(step: int) -> Iterator[Any]:
        return batches[step % len(batches)].losses(step // len(batches))

    with one_thread():
        train(
            shared,
            Soap(shared.parameters(), settings.rate),
            losses,
            Schedule(settings.steps, lambda done: settings.rate * rate_factor(done)),
            folder / "checkpoint.safetensors",
            f"encoded {design} {identity}",
            None if report is None else lambda step, steps, _: report(step, steps),
        )
    for each in textures:
        each.to("cpu")


def apparent_brdfs(source: Source, settings: NeumipSettings, folder: Path, samples: int) -> _Floats:
    """f·cos [rows, columns, `PAIRS`, 3], 1/sr, over the Gaussian of each texel; the folder keeps it.

    Args:
        settings: of texels and seed.
        samples: rays of a pair.
    """
    btf = btf_of(source, "neumip")
    shape = settings.shape(source, btf.faces)
    file = folder / f"apparent-{samples}-{settings.query_identity(source)[:12]}.safetensors"
    try:
        found = load_file(file)["values"]
        if found.shape == (shape.rows, shape.columns, PAIRS, 3):
            return np.asarray(found, np.float32)
    except (OSError, SafetensorError, KeyError):
        pass
    rng = np.random.default_rng([settings.seed, _APPARENT])
    lights, views = draw_directions(rng, PAIRS), draw_directions(rng, PAIRS)
    texels = shape.rows * shape.columns
    place = np.stack([np.arange(texels) % shape.columns, np.arange(texels) // shape.columns], axis=1) + 0.5
    place *= np.array([shape.width_mm / shape.columns, shape.height_mm / shape.rows])
    parts = []
    for number, first in enumerate(range(0, texels * PAIRS, _CHUNK)):
        queries = np.arange(first, min(first + _CHUNK, texels * PAIRS))
        spread = rng.standard_normal((len(queries), samples, 2), np.float32)
        points = place[queries // PAIRS, None] + shape.texel_mm / SIZE_OF_SIGMA * spread
        light, view = (np.repeat(part[queries % PAIRS], samples, axis=0) for part in (lights, views))
        values = btf.values(
            points.reshape(-1, 2).astype(np.float32), light, view, (settings.seed, _APPARENT, number)
        )
        parts.append(values.reshape(len(queries), samples, 3).mean(axis=1, dtype=np.float32))
    measured = np.concatenate(parts).reshape(shape.rows, shape.columns, PAIRS, 3)
    with replacing(file) as temporary:
        save_file({"values": measured}, temporary)
    return measured
