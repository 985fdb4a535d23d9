"""Records of neumip and latent as shaders read them: networks, texels, and the levels of their pyramids.

Networks are single precision, as they are trained. Texels may be halves: 16 bytes each instead of 32, at an
error of at most 2⁻¹² of each channel.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.tables import Layer, Tables, flag, given
from loomlight.models.texture.pyramid import PyramidShape

# Numbers that a shader reads at a time.
_EIGHT = 8


class NeumipTables(Tables):
    """The record of a source that neumip is trained for."""

    record = "neumip"

    is_trained = flag("0 where the source has no trained textures")
    decoder = given("uint", "first element of the decoder in packed_numbers, singles", "layers")
    has_offset = given("uint", "1 with the offset module")
    offset = given("uint", "first element of its network, singles", "layers")
    offset_texels = given("uint", "first element of the offset texture [faces, rows, columns, 8]", "elements")
    features = given("uint", "first element of the pyramid [faces, texels, 8]", "elements")
    texel_elements = given("uint", "of a texel: 1 for halves, 2 for singles")
    levels = given("uint", "first texel, columns, rows of each level, three words each", "words")
    last_level = given("float", "number of the level of one texel")
    face_texels = given("uint", "texels of the pyramid of a face")
    back = given("uint", "number of the textures of the back: 0 where both sides look alike")
    repeats_per_x = given("float", "1 / width of the repeat")
    repeats_per_y = given("float", "1 / height of the repeat")
    texels_per_mm = given("float", "of level 0")
    unit_x = given("float", "unit of the ray depth, in repeats of x")
    unit_y = given("float", "and of y")
    transmits = given("uint", "1 with a decoder for lights on the other side")
    transmission = given("uint", "first element of that decoder, singles", "layers")
    has_holes = given("uint", "1 with a network of holes")
    opacity = given("uint", "first element of that network, singles", "layers")


class LatentTables(Tables):
    """The record of a source that latent is trained for."""

    record = "latent"

    is_trained = flag("0 where the source has no trained latents")
    decoder = given("uint", "first element of the decoder in packed_numbers, singles", "layers")
    hidden = given("uint", "width of its hidden layers: 16 or 32 of two, 64 of three")
    frames = given("uint", "first element of the layer of frames, singles", "layers")
    sampler = given("uint", "first element of the network that describes the density of directions", "layers")
    albedo = given("uint", "first element of the network of albedos", "layers")
    auxiliary = given("uint", "first element of the network of what guides denoisers", "layers")
    texels = given("uint", "first element of the latents [faces, texels, 8]", "elements")
    texel_elements = given("uint", "of a texel: 1 for halves, 2 for singles")
    levels = given("uint", "first texel, columns, rows of each level, three words each", "words")
    last_level = given("float", "number of the level of one texel")
    face_texels = given("uint", "texels of the pyramid of a face")
    back = given("uint", "number of the latents of the back: 0 where both sides look alike")
    repeats_per_x = given("float", "1 / width")
    repeats_per_y = given("float", "1 / height")
    texels_per_mm = given("float", "of level 0")
    width = given("float", "of the repeat")
    height = given("float", "")
    is_trilinear = given("uint", "1 where levels are interpolated, 0 where one of two is chosen at random")
    is_apart = given(
        "uint", "1 where texels are materials of their own, between which nothing is interpolated"
    )


def pyramid_numbers(shape: PyramidShape) -> dict[str, Any]:
    """Fields that describe the mip pyramid of a trained source."""
    levels = [(start, *size) for start, size in zip(shape.starts, shape.sizes, strict=False)]
    return {
        "levels": np.array(levels, np.uint32),
        "last_level": shape.levels - 1,
        "face_texels": shape.texels,
        "back": shape.faces - 1,
        "repeats_per_x": 1 / shape.width_mm,
        "repeats_per_y": 1 / shape.height_mm,
        "texels_per_mm": 1 / shape.footprint_mm,
    }


def texel_numbers(values: NDArray[np.floating], half: bool) -> NDArray[np.floating]:
    """Texels [n, channels] as shaders read them: eight numbers each, halves or singles."""
    padded = np.pad(values, ((0, 0), (0, _EIGHT - values.shape[1])))
    return padded.astype(np.float16 if half else np.float32)


def network_layers(layers: Sequence[Layer]) -> list[Layer]:
    """The layers of `MLP<…>`, singles.

    Raises:
        ValueError: layers that do not fit each other.
    """
    if any(after.shape[1] != before.shape[0] for (before, _), (after, _) in pairwise(layers)):
        raise ValueError("the inputs of each layer are the outputs of the one before")
    return [*layers]
