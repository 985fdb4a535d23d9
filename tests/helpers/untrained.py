"""Models of random numbers, as large as trained ones, and small tables: parity needs no training."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from loomlight.core.llvm import llvm_float
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.fabric.read import edited_fabric
from loomlight.models.clustered.model import ClusteredModel, ClusteredOptions
from loomlight.models.clustered.tables import bake_tables
from loomlight.models.networks import Layers
from loomlight.models.texture import latent, neumip
from loomlight.models.texture.latent import LatentModel, decoder_widths
from loomlight.models.texture.neumip import NeumipModel
from loomlight.models.texture.pyramid import PyramidShape
from loomlight.models.texture.settings import DECODERS
from loomlight.sources.heightfield import Heightfield
from loomlight.yarn.geometry import YarnGeometry

PLAIN = fabric_from_text('weave = "plain"')
# Open cloth, whose threads differ in tone, under a sheen.
OPEN_TWILL = fabric_from_text(
    'weave = "twill 2/1"\nends_per_cm = 14\npicks_per_cm = 11\n[warp]\ncolor = "#2a4680"\nwidth_mm = 0.5\n'
    "[sheen]\nstrength = 0.3\n[variation]\ncolour_noise = 0.4\n"
)
# The same of yarns that vary along themselves and have neps.
IRREGULAR_TWILL = edited_fabric(OPEN_TWILL, {"yarn": "linen", "warp.neps": 9, "weft.melange": 0.3})


def _random_layers(rng: np.random.Generator, widths: Sequence[int], gain: float) -> Layers:
    """Layers whose outputs are as large as their inputs, times √gain."""
    return [
        (
            np.float32(rng.normal(0, np.sqrt(gain / before), (after, before))),
            np.float32(rng.normal(0, 0.1, after)),
        )
        for before, after in pairwise(widths)
    ]


def random_latent(
    decoder: str = "2x32",
    mips: str = "trilinear",
    frames: bool = True,
    features: bool = True,
    is_apart: bool = False,
) -> LatentModel:
    """`latent` of plain cloth."""
    rng = np.random.default_rng(11)
    shape = PyramidShape(16, 8, *PLAIN.repeat_mm, 2, is_apart)
    widths = {
        "decoder": decoder_widths(DECODERS[decoder], frames, features),
        "sampler": latent.SAMPLER_WIDTHS,
        "albedo": latent.ALBEDO_WIDTHS,
        "auxiliary": latent.AUXILIARY_WIDTHS,
    }
    layers = {name: _random_layers(rng, of, 1) for name, of in widths.items()}
    layers["decoder"][-1][1][:] = [2.5, 2, 1.5]
    weights = latent.Weights(
        shape,
        np.float32(rng.normal(0, 0.5, (2 * shape.texels, latent.CHANNELS))),
        np.float32(rng.normal(0, 0.3, (12, latent.CHANNELS))) if frames else None,
        layers,
        np.full((2, 3), 0.5, np.float32),
    )
    return LatentModel(PLAIN, weights, mips)


def flat_tile() -> Heightfield:
    """A source of one face, 4 × 2 mm."""
    one = np.ones((1, 1), np.float32)
    return Heightfield("tile", (4.0, 2.0), 0.5, 0.5, one, np.ones((1, 1, 3), np.float32), one, 0 * one)


def random_neumip(faces: int = 2, offset: bool = True, half: bool = False) -> NeumipModel:
    """`neumip` of plain cloth, or of a tile of one face: depths of a few texels, values of a colour.

    Args:
        half: texels are numbers of half precision, so that packing them as such rounds nothing.
    """
    rng = np.random.default_rng(3)
    source = PLAIN if faces == 2 else flat_tile()
    shape = PyramidShape(16, 8, *source.repeat_mm, faces)

    def network(name: str, rng: np.random.Generator) -> Layers:
        return _random_layers(rng, neumip.NETWORKS[name], 2)

    layers = {name: network(name, rng) for name in (("decoder", "offset") if offset else ("decoder",))}
    if faces == 2:
        # Networks of sources that light passes through.
        further = ("transmission", "opacity")
        layers |= {name: network(name, np.random.default_rng(4)) for name in further}
    for name in set(layers) & {"decoder", "transmission"}:
        layers[name][-1] = (layers[name][-1][0], np.float32([1, 0.8, 0.6]))

    def texels(count: int) -> NDArray[np.float32]:
        numbers = np.float32(rng.normal(0, 0.5, (faces * count, neumip.CHANNELS)))
        return numbers.astype(np.float16).astype(np.float32) if half else numbers

    of_offset = texels(shape.columns * shape.rows) if offset else None
    colour = np.full((faces, 3), 0.5, np.float32)
    return NeumipModel(source, neumip.Weights(shape, texels(shape.texels), of_offset, layers, colour))


@cache
def small_clustered(rank: int, fabric: Fabric = OPEN_TWILL) -> ClusteredModel:
    """`clustered` with small tables."""
    appearance = fabric.appearance()
    roughness = appearance.warp.roughness, appearance.weft.roughness
    tables = bake_tables(YarnGeometry(fabric.layout()), roughness, 8, rank, llvm_float(), 32)
    return ClusteredModel(fabric, tables, ClusteredOptions(samples=2, texels=32))


def with_samples(model: ClusteredModel, samples: int) -> ClusteredModel:
    """The model with another number of texels of the residual; both share the tables."""
    made = copy(model)
    made.options = replace(model.options, samples=samples)
    return made
