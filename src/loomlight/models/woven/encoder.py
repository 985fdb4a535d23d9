"""The encoder through ONNX Runtime: maps and parameters of a fabric in, latents of both faces out.

torch exported its graph when the network was trained (`training/export.py`); it lies beside the weights.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.extras import import_extra
from loomlight.fabric.fabric import Fabric
from loomlight.models.woven.architecture import FIELD_MAP, VECTOR_MAP
from loomlight.models.woven.encoded_fabric import EncodedFabric
from loomlight.models.woven.encoder_inputs import fabric_parameters, face_maps, shortest_repeat
from loomlight.models.woven.fibres import Fibres
from loomlight.models.woven.weights import Weights
from loomlight.yarn.geometry import YarnGeometry


def run_encoder(
    fabric: Fabric, weights: Weights, float_type: type, repeats: tuple[int, int] = (1, 1)
) -> EncodedFabric:
    """Latents of both faces, each of one run of the encoder.

    Args:
        float_type: the Dr.Jit Float type that the maps are computed with.
        repeats: how often the repeat is laid along picks and along ends.
    """
    layout = shortest_repeat(fabric.layout())
    picks, ends = layout.warp_on_top.shape
    geometry = YarnGeometry(layout)
    field = weights.table.latent == "field"
    rows, columns = (FIELD_MAP * picks, FIELD_MAP * ends) if field else (VECTOR_MAP, VECTOR_MAP)
    parameters = fabric_parameters(fabric)
    faces = []
    for back in (False, True):
        maps = face_maps(geometry, back, rows, columns, float_type)
        if field:
            maps = np.tile(maps, (1, *repeats))
        (latents,) = encoder_session(weights).run(None, {"maps": maps[None], "parameters": parameters})
        faces.append(latents.astype(np.float16))
    shape = picks * repeats[0], ends * repeats[1]
    return EncodedFabric(*shape, (faces[0], faces[1]), Fibres.of(fabric))


@cache
def encoder_session(weights: Weights) -> Any:
    """ONNX Runtime's session of the encoder.

    Inputs are `maps` [1, 7, rows, columns] of one face and `parameters` [4], the output is `latents`
    [texels, latent_size] in the order of `pyramid.levels_of` ("field"), or [1, latent_size] ("vector").
    """
    # Not needed where latents are at hand, and slow to import.
    onnxruntime = import_extra("onnxruntime", "woven", "Encoding a fabric for the network")
    options = onnxruntime.SessionOptions()
    options.log_severity_level = 3
    try:
        return onnxruntime.InferenceSession(weights.encoder, options, providers=["CPUExecutionProvider"])
    # What ONNX Runtime raises on models that it cannot read has no public base.
    except Exception as error:
        raise InputError(f"{weights.source}: ONNX Runtime cannot read the encoder beside it.") from error
