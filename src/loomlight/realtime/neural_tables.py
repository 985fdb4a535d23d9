"""The model neural as shaders read it: the network once, and latents, fibres and corrections of each fabric.

Shaders are compiled for the shape of the network that comes with the package; other weights of that shape
serve as well.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.models.neural.decoder import split_matrices
from loomlight.models.neural.footprint_coding import mean_pitch
from loomlight.models.neural.model import NeuralModel
from loomlight.models.neural.weights import Weights, shipped_weights
from loomlight.realtime.networks import packed_layer, packed_numbers
from loomlight.realtime.word_table import Tables, fill
from loomlight.yarn.layout import ClothLayout

# Layers in the order of memory; see `neural_layers`.
LAYERS = ("FUSION_0", "FUSION_1", "HOLE_0", "HOLE_1", "VIEW", "LIGHT")
ANGULAR = ("ANGULAR", "ANGULAR_2", "ANGULAR_3")
LAST = "LAST"
Numbers: TypeAlias = NDArray[np.float32]
Layer: TypeAlias = tuple[Numbers, Numbers | None]


def neural_layers(weights: Weights) -> dict[str, Layer]:
    """Weights and biases of the decoder's layers, split by their inputs as `neural.slang` evaluates them.

    The hole reads the inputs of the view's layer, whose last ones it does not use.
    """
    parts = split_matrices(weights)
    hole = np.concatenate([parts["hole spatial"], parts["hole view"]], axis=1)
    view = np.concatenate([parts["spatial"], parts["view"]], axis=1)
    hole = np.pad(hole, ((0, 0), (0, view.shape[1] - hole.shape[1])))
    layers: list[Layer] = [
        (weights.tensor("decoder.fusion.0.weight"), weights.tensor("decoder.fusion.0.bias")),
        (parts["fusion"], parts["fusion bias"]),
        (hole, parts["hole bias"]),
        (parts["hole last"], parts["hole last bias"]),
        (view, parts["0 bias"]),
        (parts["light"], None),
        *((parts[f"{number}"], parts[f"{number} bias"]) for number in range(1, len(ANGULAR) + 2)),
    ]
    return dict(zip((*LAYERS, *ANGULAR, LAST), layers, strict=True))


def pack_neural(record: np.void, model: NeuralModel, layout: ClothLayout | None, tables: Tables) -> None:
    """Appends latents and correction of a fabric, and its network unless it is there.

    Args:
        record: of the fabric.

    Raises:
        InputError: a network of another shape than that of the shaders.
    """
    del layout  # the model's own has the repeat that the encoder saw
    encoded, cloth, table = model.encoded, model.fabric.layout(), tables.numbers
    picks, ends = cloth.warp_on_top.shape
    width, height = cloth.size
    warp, weft = encoded.fibres.face(False)
    lobe_warp, lobe_weft = encoded.fibres.lobe_roughness()
    values: dict[str, float] = {
        "is_encoded": 1,
        "network": _network(model.weights, tables),
        "latents": table.add(packed_numbers(np.concatenate(encoded.faces))),
        "texels": len(encoded.faces[0]),
        "top_level": len(encoded.levels) - 1,
        "ends": encoded.ends,
        "picks": encoded.picks,
        "ends_per_mm": ends / width,
        "picks_per_mm": picks / height,
        "pitch": mean_pitch(cloth),
        "warp_x": warp[0],
        "warp_y": warp[1],
        "warp_roughness": warp[2],
        "weft_x": weft[0],
        "weft_y": weft[1],
        "weft_roughness": weft[2],
        "warp_lobe_roughness": lobe_warp,
        "weft_lobe_roughness": lobe_weft,
    }
    if encoded.correction is not None:
        # In single precision, as in files: halves would round it.
        layer = packed_layer(encoded.correction[:, :-1], encoded.correction[:, -1], half=False)
        values |= {"is_corrected": 1, "correction": table.add(layer)}
    levels = [(level.first, level.columns, level.rows, level.per_thread) for level in encoded.levels]
    values["levels"] = tables.words.add(np.array(levels, np.float32))
    values["bundles"] = tables.words.add(encoded.fibres.bundles(False))
    fill(record["neural"], values)


def _network(weights: Weights, tables: Tables) -> int:
    """The first element of a network."""
    if weights.sha256 not in tables.networks:
        _require_shape(weights)
        layers = neural_layers(weights).values()
        elements = np.concatenate([packed_layer(weight, bias) for weight, bias in layers])
        tables.networks[weights.sha256] = tables.numbers.add(elements)
    return tables.networks[weights.sha256]


def _require_shape(weights: Weights) -> None:
    shipped = shipped_weights()
    if weights.table.model_copy(update={"width": shipped.table.width}) != shipped.table or (
        weights.linear_diffuse != shipped.linear_diffuse
    ):
        raise InputError(
            f"{weights.source}: real-time shaders are compiled for networks of the shape of the shipped one, "
            f"of width {shipped.table.hidden}: train such a network, or leave weights away."
        )
