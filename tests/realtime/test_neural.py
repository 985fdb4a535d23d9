"""What fabrics share of the model neural in shaders, and networks that these are not compiled for.

Queries, samples and frames are compared in tests/contract.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from loomlight.core.errors import InputError
from loomlight.fabric import fabric_from_text
from loomlight.models.neural.model import NeuralModel, NeuralOptions
from loomlight.models.neural.weights import shipped_weights
from loomlight.realtime.words import pack_fabrics


def open_twill() -> NeuralModel:
    return NeuralModel.for_source(fabric_from_text('weave = "twill 2/1"'), NeuralOptions(refined=False))


def test_fabrics_share_a_network() -> None:
    model = open_twill()
    looks = (model.fabric.layout(), model.fabric.appearance())
    alone = pack_fabrics([looks], None, [model.shader_tables()])
    both = pack_fabrics([looks, looks], None, [model.shader_tables(), model.shader_tables()])
    first, second = both.fabrics["neural"]
    assert first["network"] == second["network"] == 0
    assert second["latents"] > first["latents"]
    latents = 2 * len(model.encoded.faces[0]) * model.weights.table.latent_size // 8
    assert len(both.packed_numbers) == len(alone.packed_numbers) + latents
    assert alone.fabrics["neural"]["is_corrected"] == 0


def test_a_network_of_another_shape_is_one_sentence() -> None:
    model = open_twill()
    table = shipped_weights().table.model_copy(update={"hidden": 32})
    model.weights = replace(model.weights, table=table, source="mine.safetensors")
    with pytest.raises(InputError, match=r"^mine.safetensors: real-time shaders are compiled for networks"):
        model.shader_tables()
