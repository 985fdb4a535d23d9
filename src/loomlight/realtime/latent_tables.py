"""The model latent as shaders read it: the pyramid of latents, the frames, and its three networks.

Networks are single precision. Latents may be halves: 16 bytes a texel instead of 32.
"""

from __future__ import annotations

import numpy as np

from loomlight.models.networks import Layers
from loomlight.models.texture.latent import CHANNELS, FRAMES, LatentModel, Weights, decoder_widths
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
    is_half = tables.half or model.precision == "float16"
    values: dict[str, float] = pyramid_fields(shape, tables) | {
        "decoder": table.add_mlp(_of_all_inputs(weights)),
        "hidden": weights.hidden[0],
        "frames": table.add(packed_layer(frames, half=False)),
        "sampler": table.add_mlp(weights.layers["sampler"]),
        "albedo": table.add_mlp(weights.layers["albedo"]),
        "texels": table.add(packed_numbers(weights.latents, is_half)),
        "texel_elements": 1 if is_half else 2,
        "width": shape.width_mm,
        "height": shape.height_mm,
        "is_trilinear": int(model.mips == "trilinear"),
        "is_apart": int(shape.is_apart),
    }
    fill(record["latent"], values)


def _of_all_inputs(weights: Weights) -> Layers:
    """The decoder with zeros for the inputs that it lacks: the second frame, and features."""
    (matrix, bias), *others = weights.layers["decoder"]
    wide = np.zeros((len(matrix), decoder_widths((), with_frames=True, with_features=True)[0]), np.float32)
    frames = 1 if weights.frames is None else FRAMES
    first = 6 * FRAMES
    wide[:, : 6 * frames] = matrix[:, : 6 * frames]
    wide[:, -CHANNELS:] = matrix[:, -CHANNELS:]
    if weights.with_features:
        features = matrix[:, 6 * frames : -CHANNELS]
        wide[:, first : first + frames] = features[:, :frames]
        wide[:, first + FRAMES : first + FRAMES + 2] = features[:, frames:]
    return [(wide, bias), *others]
