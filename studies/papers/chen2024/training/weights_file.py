"""Writes what `loomlight.models.neural.weights` reads: the weights file, and the encoder beside it."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import save

from loomlight.core.files import replacing
from loomlight.models.neural.architecture import NetworkTable
from loomlight.models.neural.weights import ENTRY, SCHEMA, Header, encoder_metadata, encoder_path
from loomlight.sources.loom_file import checksum


def write_weights(
    path: str | os.PathLike[str],
    table: NetworkTable,
    tensors: Mapping[str, NDArray[Any]],
    *,
    linear_diffuse: bool,
    recipe: Mapping[str, Any],
    provenance: Mapping[str, Any],
    trained: bool = True,
    half: bool = True,
) -> None:
    """Writes a weights file, whole or not at all.

    Args:
        tensors: by the names of the torch module's state.
        half: in half precision, otherwise in single precision.

    Raises:
        InputError: a place that cannot be written to.
        ValueError: a weight that is not finite, or too large for half precision.
    """
    kept = {}
    for name, values in tensors.items():
        with np.errstate(over="ignore"):
            kept[name] = np.ascontiguousarray(values, np.float16 if half else np.float32)
        if not np.isfinite(kept[name]).all():
            raise ValueError(f"the weights {name} hold numbers that {kept[name].dtype} cannot")
    header = Header(
        schema=SCHEMA,
        shape=table,
        linear_diffuse=linear_diffuse,
        trained=trained,
        recipe=dict(recipe),
        provenance=dict(provenance),
    )
    content = json.loads(header.model_dump_json(by_alias=True))
    entry = json.dumps({"checksum": checksum(content, kept), "network": content}, sort_keys=True)
    with replacing(path) as temporary:
        temporary.write_bytes(save(kept, {ENTRY: entry}))


def write_encoder(weights_path: str | os.PathLike[str], model: bytes, sha256: str) -> Path:
    """Writes an exported encoder beside its weights, whole or not at all; returns its path.

    Args:
        model: the ONNX model.
        sha256: of the weights that it was exported from; see `Weights`.

    Raises:
        InputError: a place that cannot be written to.
    """
    path = encoder_path(weights_path)
    with replacing(path) as temporary:
        temporary.write_bytes(model + encoder_metadata(model, sha256))
    return path
