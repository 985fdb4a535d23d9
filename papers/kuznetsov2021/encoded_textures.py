"""Rainer et al. 2019 and 2020 with their encoders: latents of texels come from what is measured of each.

The encoder sees the apparent BRDF of a texel: f·cos for a fixed set of pairs of light and view, less its mean
and over its deviation, which texels keep as colours. 2019 has an encoder and a decoder for each material,
2020 one of both for all materials. The published encoders are built for the grids of directions of measured
BTFs; here they are dense layers, as pairs are scattered. Texels of coarse levels have the means of the
apparent BRDFs below them, so that the pyramid needs no further queries. Networks learn by the queries, loss
and schedule of neumip; pictures are asked of the encoded textures alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from safetensors import SafetensorError
from safetensors.numpy import load_file, save_file
from torch import Tensor, nn
from torch.nn import functional

from loomlight.assets.sources import Source
from loomlight.core.files import replacing
from loomlight.models.mip_pyramid import SIZE_OF_SIGMA, PyramidShape
from loomlight.models.neumip.btf import BTFS
from loomlight.models.neumip.networks import EXPOSURE
from loomlight.models.neumip.settings import NeumipSettings
from loomlight.models.neumip.training.train import (
    Batches,
    gains_of,
    rate_factor,
    taken_queries,
)
from loomlight.models.query_parts import draw_directions
from loomlight.training.loop import Schedule, one_thread, train
from loomlight.training.relu_layers import relu_layers
from papers.kuznetsov2021.designs import Design
from papers.kuznetsov2021.neural_textures import NeuralTextures, published_error

_Floats = NDArray[np.float32]
# Pairs of light and view of an apparent BRDF, and hidden layers of an encoder.
PAIRS = 64
_HIDDEN = (128, 64)
# Added to deviations, which texels of one colour do not have.
_MIN_DEVIATION = 1e-3
_APPARENT = 11  # key of random numbers
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


def trained_encodings(
    design: Design,
    sources: Sequence[Source],
    settings: NeumipSettings,
    folder: Path,
    queries_folder: Path,
) -> list[EncodedTextures]:
    """A design trained for opaque sources of one face, with encoder and decoder shared by all of them.

    A step is of one source, in turn, so each source has the steps of the settings.

    Args:
        folder: holds the checkpoint.
        queries_folder: holds queries and apparent BRDFs, which designs share.

    Raises:
        InputError: a damaged checkpoint, or one of another training.
    """
    folder.mkdir(parents=True, exist_ok=True)
    torch.manual_seed(settings.seed)
    networks: tuple[nn.Sequential, nn.Sequential] | None = None
    textures: list[EncodedTextures] = []
    batches = []
    for source in sources:
        queries = taken_queries(source, settings, queries_folder, lambda done, total: None)
        apparent = apparent_brdfs(source, settings, queries_folder)
        made = EncodedTextures(design, settings.shape(source), apparent, gains_of(queries), networks)
        networks = made.encoder, made.decoder
        textures.append(made)
        batches.append(Batches(made, queries, settings, "cpu", published_error))

    def losses(step: int) -> Iterator[Any]:
        return batches[step % len(batches)].losses(step // len(batches))

    shared = nn.ModuleList(networks or ())
    identity = " ".join(settings.identity(source) for source in sources)
    with one_thread():
        train(
            shared,
            torch.optim.Adam(shared.parameters(), settings.rate),
            losses,
            Schedule(settings.steps * len(sources), lambda done: settings.rate * rate_factor(done)),
            folder / "checkpoint.safetensors",
            f"encoded {design} {identity}",
        )
    return textures


def apparent_brdfs(source: Source, settings: NeumipSettings, folder: Path) -> _Floats:
    """f·cos [rows, columns, `PAIRS`, 3], 1/sr, over the Gaussian of each texel; the folder keeps it.

    Args:
        settings: of texels, rays and seed.
    """
    shape = settings.shape(source)
    file = folder / f"apparent-{settings.query_identity(source)[:12]}.safetensors"
    try:
        found = load_file(file)["values"]
        if found.shape == (shape.rows, shape.columns, PAIRS, 3):
            return np.asarray(found, np.float32)
    except (OSError, SafetensorError, KeyError):
        pass
    rng = np.random.default_rng([settings.seed, _APPARENT])
    lights, views = draw_directions(rng, PAIRS), draw_directions(rng, PAIRS)
    btf, texels = BTFS.of(source), shape.rows * shape.columns
    place = np.stack([np.arange(texels) % shape.columns, np.arange(texels) // shape.columns], axis=1) + 0.5
    place *= np.array([shape.width_mm / shape.columns, shape.height_mm / shape.rows])
    parts = []
    for number, first in enumerate(range(0, texels * PAIRS, _CHUNK)):
        queries = np.arange(first, min(first + _CHUNK, texels * PAIRS))
        spread = rng.standard_normal((len(queries), settings.samples, 2), np.float32)
        points = place[queries // PAIRS, None] + shape.texel_mm / SIZE_OF_SIGMA * spread
        light, view = (np.repeat(part[queries % PAIRS], settings.samples, axis=0) for part in (lights, views))
        values = btf.values(
            points.reshape(-1, 2).astype(np.float32), light, view, (settings.seed, _APPARENT, number)
        )
        parts.append(values.reshape(len(queries), settings.samples, 3).mean(axis=1, dtype=np.float32))
    measured = np.concatenate(parts).reshape(shape.rows, shape.columns, PAIRS, 3)
    with replacing(file) as temporary:
        save_file({"values": measured}, temporary)
    return measured
