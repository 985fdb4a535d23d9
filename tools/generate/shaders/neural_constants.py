"""Constants of `neural.slang` that follow from the network that comes with the package."""

from __future__ import annotations

import numpy as np

from loomlight.models.neural import architecture, codings, encoded_fabric
from loomlight.models.neural.decoder import ANGULAR, LAST, LAYERS, neural_layers
from loomlight.models.neural.weights import shipped_weights
from loomlight.realtime.words import layer_size


def neural_constants() -> dict[str, float]:
    """Constants of `neural.slang` that follow from the shipped network and from numbers of the model: widths,
    where layers begin, and what shaders compute with in the place of those numbers."""
    weights = shipped_weights()
    table = weights.table
    layers = neural_layers(weights)
    sizes = [layer_size(weight.shape[1], weight.shape[0]) for weight, _ in layers.values()]
    starts = [sum(sizes[:number]) for number in range(len(sizes) + 1)]
    at = dict(zip(layers, starts, strict=False))
    smallest, largest = encoded_fabric.FIELD_SIZES
    first, full = (
        float(encoded_fabric.log_fraction(np.float64(threads), smallest, largest))
        for threads in encoded_fabric.CORRECTED_SIZES
    )
    return {
        "NEURAL_HIDDEN": table.hidden,
        "NEURAL_LATENT": table.latent_size,
        "NEURAL_HOLE_HIDDEN": layers["HOLE_0"][0].shape[0],
        "NEURAL_LIGHT_INPUTS": 3 + architecture.LIGHT_FEATURES,
        "NEURAL_VIEW_INPUTS": table.hidden + 2 + architecture.VIEW_FEATURES,
        "NEURAL_ANGULAR_LAYERS": len(ANGULAR),
        "NEURAL_ANGULAR_SIZE": layer_size(table.hidden, table.hidden),
        **{f"NEURAL_{name}": at[name] for name in (*LAYERS, ANGULAR[0], LAST)},
        "REFLECTION_SCALE": 1 / architecture.REFLECTION_GAIN,
        "TRANSMISSION_SCALE": 1 / architecture.TRANSMISSION_GAIN,
        "MAX_COMPONENT": float(np.expm1(architecture.MAX_OUTPUT)),
        "MIN_CODED_SIZE": smallest,
        "PER_LOG_SIZE": 1 / float(np.log(largest / smallest)),
        "CORRECTED_FROM": first,
        "PER_CORRECTED_SPAN": 1 / (full - first),
        "NEURAL_PARALLAX": float(table.parallax),
        "NEAR_SIZE": encoded_fabric.NEAR_SIZES[0],
        "PER_LOG_NEAR_SIZE": 1 / float(np.log(encoded_fabric.NEAR_SIZES[1] / encoded_fabric.NEAR_SIZES[0])),
        "FACING_CONSTANT": codings.FACING[0],
        "FACING_BY_COSINE": codings.FACING[1],
        "FACING_BY_AZIMUTH": codings.FACING[2],
    }
