"""The model latent as shaders read it: the pyramid of latents, the frames, and its three networks.

Networks are single precision. Latents may be halves: 16 bytes a texel instead of 32.
"""

from __future__ import annotations

import numpy as np

from loomlight.models.latent.model import LatentModel
from loomlight.models.latent.networks import CHANNELS, FRAMES
from loomlight.models.relu_network import Layers
from loomlight.realtime.networks import packed_layer, packed_numbers
from loomlight.realtime.word_table import Tables, fill, pyramid_fields
from loomlight.yarn.layout import ClothLayout


def pack_latent(record: np.void, model: LatentModel, layout: ClothLayout | None, tables: Tables) -> None:
    """Appends networks and latents of a trained source.

    Args:
        record: of the fabric.
    """
    del layout
    weights, shape, table = model.weights, model.weights.shape, tables.numbers

    # Without learned frames both are the axes: their weights are 0.
    frames = np.zeros((6 * FRAMES, CHANNELS), np.float32) if weights.frames is None else weights.frames
    decoder = weights.layers["decoder"]
    if weights.frames is None:
        decoder = _with_frames(decoder)
    is_half = tables.half or model.precision == "float16"
    values: dict[str, float] = pyramid_fields(shape, tables) | {
        "decoder": table.add_mlp(decoder),
        "hidden": weights.hidden[0],
        "frames": table.add(packed_layer(frames, half=False)),
        "sampler": table.add_mlp(weights.layers["sampler"]),
        "albedo": table.add_mlp(weights.layers["albedo"]),
        "texels": table.add(packed_numbers(weights.latents, is_half)),
        "texel_elements": 1 if is_half else 2,
        "width": shape.width_mm,
        "height": shape.height_mm,
        "is_trilinear": int(model.mips == "trilinear"),
    }
    fill(record["latent"], values)


def _with_frames(decoder: Layers) -> Layers:
    """A decoder of view, light and latent as one of both directions in two frames; it ignores the second."""
    (matrix, bias), *others = decoder
    without = np.zeros((len(matrix), 6), np.float32)
    return [(np.concatenate([matrix[:, :6], without, matrix[:, 6:]], axis=1), bias), *others]
