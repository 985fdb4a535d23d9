"""What Python makes of a fabric for the page, which asks through a server or a widget of a notebook."""

from __future__ import annotations

import io
import json
import re
import tempfile
import warnings
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.fabric.fabric import Fabric
from loomlight.models.bake import bake, save
from loomlight.models.registry import model_class
from loomlight.viewer.messages import fabric_of_json, openness_json
from loomlight.weave.wif_writer import wif_text_of

Asked = dict[str, Any]


@dataclass(frozen=True)
class Answer:
    """Bytes, their media type, and the name of the file that they are."""

    content: bytes
    media_type: str = "application/octet-stream"
    name: str | None = None


def answer(place: str, asked: Asked) -> Answer:
    """The answer to what a page posts to `place`, one of `ANSWERS`: keys of `FabricJson`, and what is asked.

    Warnings about the fabric are left out: the page shows its own while the user edits.

    Raises:
        LoomlightError: a fabric or a request that cannot be, or a missing dependency.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", LoomlightWarning)
        return ANSWERS[place](asked)


def _save(asked: Asked) -> Answer:
    form = str(asked.get("format"))
    model, size = str(asked.get("model") or "lobes"), asked.get("size", 1024)
    if not isinstance(size, int):
        raise InputError(f"size = {size!r} is no whole number of texels.")
    content = saved(fabric_of_json(asked), form, model, size)
    stem = re.sub(r"[^\w-]+", "-", str(asked.get("name") or "fabric")).strip("-").lower()[:80] or "fabric"
    return Answer(content, FORMATS[form], f"{stem}.{form}")


def _tables(asked: Asked) -> Answer:
    return Answer(tables_of(fabric_of_json(asked), str(asked.get("model"))))


def _openness(asked: Asked) -> Answer:
    return Answer(json.dumps(openness_json(fabric_of_json(asked))).encode(), "application/json")


ANSWERS: dict[str, Callable[[Asked], Answer]] = {
    "api/save": _save,
    "api/tables": _tables,
    "api/openness": _openness,
}


# ------------------------------------------------------------------------------------------ files of a fabric
# Files of a fabric that the editor asks its server for, as bytes.


# Media types of the files, by their suffix.
FORMATS = {
    "toml": "application/toml",
    "wif": "text/plain; charset=utf-8",
    "loom": "application/octet-stream",
    "zip": "application/zip",
    "glb": "model/gltf-binary",
}
# Models whose tables the page does not bake itself, and those whose layers of cloth it does not find.
TABLES = ("neural", "clustered", "lobes", "point")
# Texels of the longer side of maps; more than these take gigabytes meanwhile.
MAP_SIZES = (16, 4096)


def saved(fabric: Fabric, form: str, model: str = "lobes", size: int = 1024) -> bytes:
    """A fabric as the content of a file.

    Args:
        form: "toml", a fabric file; "wif", its draft with the colours of every thread; "loom", `model` baked;
            "zip", the pictures of `loomlight bake-maps`, of `size` texels along the longer side of a repeat;
            "glb", the file of `loomlight export --to gltf`.

    Raises:
        InputError: another format or size, or a model that does not take the fabric or trains for minutes.
    """
    if form == "toml":
        return fabric.to_toml().encode()
    if form == "wif":
        return wif_text_of(fabric.draft).encode("utf-8", errors="replace")
    if form not in FORMATS:
        raise InputError(f'format = "{form}" is unknown: use one of {", ".join(FORMATS)}.')
    with tempfile.TemporaryDirectory(prefix="loomlight-") as folder:
        if form == "zip":
            return _zipped(_maps(fabric, Path(folder), size))
        if form == "glb":
            from loomlight.exporters.exporter import export

            return (export(fabric, "gltf", Path(folder) / "export", "lobes") / "cloth.glb").read_bytes()
        if model_class(model).trains:
            raise InputError(f"{model} is trained for minutes: use `loomlight bake` for it.")
        save(bake(fabric, model), file := Path(folder) / "fabric.loom")
        return file.read_bytes()


def _maps(fabric: Fabric, folder: Path, size: int) -> list[Path]:
    """The pictures of one repeat, of square texels."""
    from loomlight.core.llvm import llvm_float
    from loomlight.fabric.maps import resolution_of, sample_maps, write_maps

    if not MAP_SIZES[0] <= size <= MAP_SIZES[1]:
        raise InputError(f"size = {size} is out of range: write {MAP_SIZES[0]} to {MAP_SIZES[1]} texels.")
    resolution = resolution_of(fabric.repeat_mm, size / max(fabric.repeat_mm))
    return write_maps(sample_maps(fabric, resolution, llvm_float()), folder / "maps.png")


def _zipped(files: list[Path]) -> bytes:
    with zipfile.ZipFile(stream := io.BytesIO(), "w") as packed:  # pictures are compressed already
        for file in files:
            packed.write(file, file.name)
    return stream.getvalue()


def tables_of(fabric: Fabric, model: str) -> bytes:
    """Buffers of one fabric for the shaders of `model`, as the content of a safetensors file.

    Its tensors are the buffers of `realtime.tables.Packed` as bytes, by name.

    Raises:
        InputError: a model without tables for pages, or that does not take the fabric.
    """
    if model not in TABLES:
        raise InputError(f'model = "{model}" has no tables to send: use {", ".join(TABLES)}.')
    from safetensors.numpy import save

    from loomlight.core.llvm import require_llvm
    from loomlight.realtime.materials import tables_for
    from loomlight.realtime.words import pack_fabrics

    require_llvm()
    packed = pack_fabrics([(fabric.layout(), fabric.appearance())], models=[tables_for(fabric, model)])
    return bytes(
        save({name: np.frombuffer(values.tobytes(), np.uint8) for name, values in packed.buffers().items()})
    )
