"""Files of a fabric that the editor asks its server for, as bytes."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.models.bake import bake, save
from loomlight.models.registry import model_class
from loomlight.weave.wif_writer import wif_text_of

# Media types of the files, by their suffix.
FORMATS = {"toml": "application/toml", "loom": "application/octet-stream", "wif": "text/plain; charset=utf-8"}
# Models whose tables the page does not bake itself.
TABLES = ("neural", "clustered")


def saved(fabric: Fabric, form: str, model: str) -> bytes:
    """A fabric as the content of a file.

    Args:
        form: "toml", a fabric file; "wif", its draft with the colours of every thread; "loom", `model` baked.

    Raises:
        InputError: another format, or a model that does not take the fabric or is trained for minutes.
    """
    if form == "toml":
        return fabric.to_toml().encode()
    if form == "wif":
        return wif_text_of(fabric.draft).encode("utf-8", errors="replace")
    if form != "loom":
        raise InputError(f'format = "{form}" is unknown: use one of {", ".join(FORMATS)}.')
    if model_class(model).trains:
        raise InputError(f"{model} is trained for minutes: use `loomlight bake` for it.")
    with tempfile.TemporaryDirectory(prefix="loomlight-") as folder:
        file = Path(folder) / "fabric.loom"
        save(bake(fabric, model), file)
        return file.read_bytes()


def tables_of(fabric: Fabric, model: str) -> bytes:
    """Buffers of one fabric for the shaders of `model`, as the content of a safetensors file.

    Its tensors are the buffers of `realtime.tables.Packed` as bytes, by name.

    Raises:
        InputError: a model whose tables the page bakes itself, or that does not take the fabric.
    """
    if model not in TABLES:
        raise InputError(f'model = "{model}" has no tables to send: use {" or ".join(TABLES)}.')
    from safetensors.numpy import save

    from loomlight.core.llvm import require_llvm
    from loomlight.realtime.models import prepared_for
    from loomlight.realtime.tables import pack_fabrics

    require_llvm()
    packed = pack_fabrics([(fabric.layout(), fabric.appearance())], prepared=[prepared_for(fabric, model)])
    return bytes(
        save({name: np.frombuffer(values.tobytes(), np.uint8) for name, values in packed.buffers().items()})
    )
