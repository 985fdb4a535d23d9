"""The model neumip as shaders read it: its networks, both textures, and the levels of the pyramid.

Networks are single precision, as they are trained. Texels may be halves: 16 bytes each instead of 32, at an
error of at most 2⁻¹² of each channel.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.models.texture.neumip import NeumipModel
from loomlight.realtime.networks import EIGHT, packed_numbers
from loomlight.realtime.word_table import Tables, fill, pyramid_fields
from loomlight.yarn.layout import ClothLayout


def pack_neumip(record: np.void, model: NeumipModel, layout: ClothLayout | None, tables: Tables) -> None:
    """Appends networks and textures of a trained source, and what shadows know of its holes.

    Args:
        record: of the fabric.
    """
    weights, shape, table = model.weights, model.weights.shape, tables.numbers

    def network(name: str) -> int:
        return table.add_mlp(weights.layers[name])

    def texels(values: NDArray[np.float32]) -> int:
        padded = np.pad(values, ((0, 0), (0, EIGHT - values.shape[1])))
        return table.add(packed_numbers(padded, tables.half))

    unit_x, unit_y = shape.unit
    values: dict[str, float] = pyramid_fields(shape, tables) | {
        "decoder": network("decoder"),
        "features": texels(weights.features),
        "texel_elements": 1 if tables.half else 2,
        "unit_x": unit_x,
        "unit_y": unit_y,
    }
    if weights.offset_texels is not None:
        values |= {
            "has_offset": 1,
            "offset": network("offset"),
            "offset_texels": texels(weights.offset_texels),
        }
    if weights.transmits:
        values |= {"transmits": 1, "transmission": network("transmission")}
    if weights.has_holes:
        values |= {"has_holes": 1, "opacity": network("opacity")}
    fill(record["neumip"], values)
    if layout is None:
        record["is_open"] = int(weights.has_holes)
        record["mean_hole"] = model.open_area
