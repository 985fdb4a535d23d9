"""Models that are trained for one source, with random numbers for trained ones: they cost the same."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric
from loomlight.models.networks import Layers
from loomlight.models.texture import latent as latent
from loomlight.models.texture import neumip as neumip
from loomlight.models.texture.latent import LatentModel
from loomlight.models.texture.neumip import CHANNELS, NeumipModel
from loomlight.models.texture.pyramid import PyramidShape
from loomlight.models.texture.pyramid import PyramidShape as NeumipShape
from loomlight.models.texture.settings import DECODERS

# Texels along the longer side that a `preview` has.
_NEUMIP_TEXELS, _LATENT_TEXELS = 64, 128


def random_neumip(fabric: Fabric) -> NeumipModel:
    """With both faces, offset, transmission and holes: all that a fabric has."""
    rng = np.random.default_rng(0)
    shape = NeumipShape.of(fabric.repeat_mm, _NEUMIP_TEXELS, 2)
    layers = {name: random_layers(widths, rng) for name, widths in neumip.NETWORKS.items()}
    features, offset = (
        random_numbers(rng, 0.5, (2 * count, CHANNELS))
        for count in (shape.texels, shape.columns * shape.rows)
    )
    return NeumipModel(
        fabric, neumip.Weights(shape, features, offset, layers, np.full((2, 3), 0.5, np.float32))
    )


def random_latent(fabric: Fabric, decoder: str) -> LatentModel:
    """With both faces and learned frames; `decoder` is a name of `DECODERS`."""
    rng = np.random.default_rng(0)
    shape = PyramidShape.of(fabric.repeat_mm, _LATENT_TEXELS, 2)
    widths = {
        "decoder": latent.decoder_widths(DECODERS[decoder], True, True),
        "sampler": latent.SAMPLER_WIDTHS,
        "albedo": latent.ALBEDO_WIDTHS,
        "auxiliary": latent.AUXILIARY_WIDTHS,
    }
    weights = latent.Weights(
        shape,
        random_numbers(rng, 0.5, (2 * shape.texels, latent.CHANNELS)),
        random_numbers(rng, 0.3, (6 * latent.FRAMES, latent.CHANNELS)),
        {name: random_layers(each, rng) for name, each in widths.items()},
        np.full((2, 3), 0.5, np.float32),
    )
    return LatentModel(fabric, weights)


def random_layers(widths: Sequence[int], rng: np.random.Generator) -> Layers:
    """A network whose outputs are of the size of its inputs.

    Args:
        widths: of all layers, inputs first.
    """
    return [
        (random_numbers(rng, before**-0.5, (after, before)), np.zeros(after, np.float32))
        for before, after in pairwise(widths)
    ]


def random_numbers(rng: np.random.Generator, scale: float, shape: tuple[int, ...]) -> NDArray[np.float32]:
    """Gaussian numbers of mean 0 and a deviation of `scale`."""
    return rng.normal(0, scale, shape).astype(np.float32)
