"""The material file, `.loom`: a fabric together with what a model baked or trained for it.

It is one safetensors file. The metadata has one entry, `loom`, whose JSON is

    {"checksum": SHA-256 of the rest, "material": {"schema", "model", "units", "settings", "networks",
                                                   "fabric": {"name", "title", "toml"}}}

Tensors named `fabric.…` are the draft (`fabric_record.py`), those named `model.…` the model's own. Nothing
else is needed to read the fabric; networks that many materials share are named by their SHA-256 instead.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn, TypeVar

import numpy as np
from numpy.typing import DTypeLike
from pydantic import BaseModel, ConfigDict, Field, ValidationError
from safetensors import SafetensorError, safe_open
from safetensors.numpy import save

from loomlight.assets.fabric_record import FabricRecord, Tensor, fabric_from_record, fabric_record
from loomlight.core.errors import InputError
from loomlight.core.files import replacing, require_file
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.reading import speaking_of
from loomlight.fabric.sentences import shown

SCHEMA = 1
LOOM_SUFFIX = ".loom"
UNITS = {"length": "mm", "angle": "rad", "colour": "linear RGB", "value": "1/sr"}
_ENTRY = "loom"
_FABRIC, _MODEL = "fabric.", "model."
# safetensors' names of what a `.loom` may hold; numpy has no bfloat16 and no 8-bit floats.
_KINDS = {
    "BOOL": np.bool_,
    "U8": np.uint8,
    "I8": np.int8,
    "U16": np.uint16,
    "I16": np.int16,
    "U32": np.uint32,
    "I32": np.int32,
    "U64": np.uint64,
    "I64": np.int64,
    "F16": np.float16,
    "F32": np.float32,
    "F64": np.float64,
}

Setting = bool | int | float | str
_Kind = TypeVar("_Kind", bool, int, float, str)


@dataclass(frozen=True, eq=False)
class LoomFile:
    """What a `.loom` holds.

    Attributes:
        model: name of the model, as `loomlight bake --model` calls it.
        fabric: what it is a material of.
        tensors: the model's arrays by name, in the layout and units that the model states.
        settings: the model's single values by name.
        networks: SHA-256, as hexadecimal text, of networks that it needs and does not hold, by name.
        source: what messages call the file.
    """

    model: str
    fabric: Fabric
    tensors: Mapping[str, Tensor] = field(default_factory=dict)
    settings: Mapping[str, Setting] = field(default_factory=dict)
    networks: Mapping[str, str] = field(default_factory=dict)
    source: str = "the .loom file"

    def tensor(self, name: str, shape: tuple[int | None, ...], dtype: DTypeLike) -> Tensor:
        """The tensor `name`; None in `shape` stands for any extent.

        Raises:
            InputError: it is missing, or of another shape or type.
        """
        values = self.tensors.get(name)
        wanted = (
            f"[{', '.join('any' if extent is None else str(extent) for extent in shape)}] {np.dtype(dtype)}"
        )
        if values is None:
            self._refuse(f"the tensor {_MODEL}{name} is missing: it should be {wanted}")
        fits = len(shape) == values.ndim and all(
            extent in (None, found) for extent, found in zip(shape, values.shape, strict=True)
        )
        if values.dtype != np.dtype(dtype) or not fits:
            self._refuse(
                f"the tensor {_MODEL}{name} is {list(values.shape)} {values.dtype}: it should be {wanted}"
            )
        return values

    def setting(self, name: str, kind: type[_Kind]) -> _Kind:
        """The setting `name`, a bool, int, float or str as `kind` says.

        Raises:
            InputError: it is missing, or of another type.
        """
        value = self.settings.get(name)
        if type(value) is not kind:
            given = "missing" if value is None else shown(value)
            self._refuse(f"the setting {name} is {given}: it should be of type {kind.__name__}")
        return value

    def require_network(self, name: str, installed: str) -> None:
        """Returns if the file was made with the network whose SHA-256 is `installed`.

        Raises:
            InputError: it was made with another one, or does not say with which.
        """
        made_with = self.networks.get(name)
        if made_with == installed:
            return
        given = "does not say which" if made_with is None else f"has SHA-256 {made_with[:12]}…"
        self._refuse(
            f"the network {name} that it was made with {given}, the installed one has {installed[:12]}…: "
            "bake it again"
        )

    def require_model(self, name: str) -> None:
        """Returns if the file is a material of the model `name`.

        Raises:
            InputError: it is another model's.
        """
        if self.model != name:
            self._refuse(f'it holds the model "{shown(self.model)[1:-1]}", not "{name}": bake it with that')

    def _refuse(self, reason: str) -> NoReturn:
        raise InputError(f"{self.source}: {reason}.")


class _Material(BaseModel):
    """The JSON of the header."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)

    schema_version: int = Field(alias="schema")
    model: str = Field(min_length=1, max_length=100)
    units: dict[str, str]
    settings: dict[str, Setting]
    networks: dict[str, str]
    fabric: FabricRecord


def is_loom(path: str | os.PathLike[str]) -> bool:
    """Whether a path names a `.loom` file, by its suffix."""
    return Path(path).suffix.lower() == LOOM_SUFFIX


def write_loom(path: str | os.PathLike[str], loom: LoomFile) -> None:
    """Writes a `.loom` file, whole or not at all; the same content gives the same bytes.

    Raises:
        InputError: another suffix, or a place that cannot be written to.
        ValueError: a model's tensor of a type that safetensors and numpy do not share, or not finite.
    """
    if not is_loom(path):
        raise InputError(f"{path}: a material file ends in {LOOM_SUFFIX}.")
    record, fabric_tensors = fabric_record(loom.fabric)
    tensors = {_FABRIC + name: _plain(name, values) for name, values in fabric_tensors.items()}
    tensors |= {_MODEL + name: _plain(name, values) for name, values in loom.tensors.items()}
    material = _Material(
        schema=SCHEMA,
        model=loom.model,
        units=UNITS,
        settings=dict(loom.settings),
        networks=dict(loom.networks),
        fabric=record,
    ).model_dump(by_alias=True)
    header = {"checksum": checksum(material, tensors), "material": material}
    data = save(tensors, {_ENTRY: json.dumps(header, sort_keys=True)})
    with replacing(path) as temporary:
        temporary.write_bytes(data)


def read_loom(path: str | os.PathLike[str]) -> LoomFile:
    """What a `.loom` file holds.

    Raises:
        InputError: no such file, no `.loom`, a newer one, or one that is damaged.
    """
    require_file(path)
    source = str(path)
    with speaking_of(source):
        header, tensors = _opened(source)
        material = _parsed(header, tensors)
        for name, values in tensors.items():
            if values.dtype.kind == "f" and not np.isfinite(values).all():
                raise InputError(f"the tensor {name} holds NaN or infinity: bake the file again.")
        fabric = fabric_from_record(material.fabric, _those_named(tensors, _FABRIC), source)
    return LoomFile(
        model=material.model,
        fabric=fabric,
        tensors=_those_named(tensors, _MODEL),
        settings=material.settings,
        networks=material.networks,
        source=source,
    )


def checksum(material: Mapping[str, object], tensors: Mapping[str, Tensor]) -> str:
    """SHA-256 of the header's material and of all tensors, as hexadecimal text."""
    digest = hashlib.sha256(json.dumps(material, sort_keys=True).encode())
    for name in sorted(tensors):
        values = tensors[name]
        digest.update(f"\n{name} {values.dtype.str} {values.shape}\n".encode())
        digest.update(values.data if values.size else b"")
    return digest.hexdigest()


def file_sha256(path: str | os.PathLike[str]) -> str:
    """SHA-256 of a file, as `LoomFile.networks` holds it."""
    with Path(path).open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _plain(name: str, values: Tensor) -> Tensor:
    """Contiguous and little-endian, as safetensors writes arrays without asking."""
    if values.dtype.newbyteorder("=") not in {np.dtype(kind) for kind in _KINDS.values()}:
        raise ValueError(f"the tensor {name} is {values.dtype}, which a .loom file cannot hold")
    if values.dtype.kind == "f" and not np.isfinite(values).all():
        raise ValueError(f"the tensor {name} holds NaN or infinity")
    return np.ascontiguousarray(values, values.dtype.newbyteorder("<"))


def _opened(path: str) -> tuple[str, dict[str, Tensor]]:
    """The header's text and all tensors."""
    try:
        with safe_open(path, framework="numpy") as file:
            header = (file.metadata() or {}).get(_ENTRY)
            if header is None:
                raise InputError(
                    f"it is a safetensors file without the entry {_ENTRY}, so no material: "
                    "`loomlight bake` writes one."
                )
            names = list(file.keys())
            for name in names:
                kind = file.get_slice(name).get_dtype()
                if kind not in _KINDS:
                    raise InputError(f"the tensor {shown(name)} is of type {kind}: use {', '.join(_KINDS)}.")
            return header, {name: file.get_tensor(name) for name in names}
    except (SafetensorError, OSError, ValueError, OverflowError, MemoryError) as error:
        raise InputError("it is no .loom file, or damaged: `loomlight bake` writes one.") from error


def _parsed(header: str, tensors: Mapping[str, Tensor]) -> _Material:
    damaged = "its header is damaged: bake the file again"
    try:
        content = json.loads(header, parse_constant=_refuse_constant)
    except (ValueError, RecursionError) as error:
        raise InputError(f"{damaged}.") from error
    raw = content.get("material") if isinstance(content, dict) else None
    if not isinstance(raw, dict):
        raise InputError(f"{damaged}: it holds no material.")
    schema = raw.get("schema")
    if not isinstance(schema, int) or isinstance(schema, bool) or schema < 1:
        raise InputError(f"its schema is {shown(schema)}: a whole number from 1 to {SCHEMA} is right.")
    if schema > SCHEMA:
        raise InputError(
            f"its schema is {shown(schema)}, and this loomlight reads up to {SCHEMA}: install a newer one."
        )
    if content.get("checksum") != checksum(raw, tensors):
        raise InputError("its content does not fit its checksum, so it is damaged: bake the file again.")
    try:
        material = _Material.model_validate(raw)
    except (ValidationError, RecursionError) as error:
        raise InputError(f"{damaged}{_place(error)}.") from error
    if material.units != UNITS:
        raise InputError(f"its units are {shown(json.dumps(material.units))}: they must be {UNITS}.")
    strangers = [name for name in tensors if not name.startswith((_FABRIC, _MODEL))]
    if strangers:
        raise InputError(f"the tensor {shown(strangers[0])} is neither the fabric's nor the model's.")
    return material


def _refuse_constant(name: str) -> NoReturn:
    raise ValueError(f"{name} is no JSON")


def _place(error: Exception) -> str:
    if not isinstance(error, ValidationError):
        return ""
    fault = error.errors(include_url=False)[0]
    return f" at {'.'.join(str(part) for part in fault['loc'])}: {fault['msg']}"


def _those_named(tensors: Mapping[str, Tensor], prefix: str) -> dict[str, Tensor]:
    return {name[len(prefix) :]: values for name, values in tensors.items() if name.startswith(prefix)}
