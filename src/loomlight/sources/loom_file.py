"""The material file, `.loom`: a source, such as a fabric, and what a model baked or trained for it.

It is one safetensors file. The metadata has one entry, `loom`, whose JSON is

    {"checksum": SHA-256 of the rest, "material": {"schema", "model", "units", "settings", "networks",
                                                   "source": {"kind", …}}}

Tensors named `source.…` belong to the source (`sources.py`), those named `model.…` to the model. Nothing else
is needed to read the source; networks that many materials share are named by their SHA-256 instead.

Of files of schema 1, whose source was always a fabric, the source is still read; models must be baked again.
Fabrics of schema 1 and 2 that do not speak of light between yarns were made without it and keep their look.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NoReturn, TypeVar

import numpy as np
from numpy.typing import DTypeLike
from pydantic import BaseModel, ConfigDict, Field, ValidationError
from safetensors import SafetensorError, safe_open
from safetensors.numpy import save

from loomlight.core.errors import InputError
from loomlight.core.files import replacing, require_file
from loomlight.core.sentences import shown, speaking_of
from loomlight.core.tables import VERSION_SETTING, Tables, expected_shape, fault_of
from loomlight.sources.fabric import Tensor, of_former_defaults
from loomlight.sources.kinds import SOURCE_KINDS, Source, kind_of_source

SCHEMA = 4
# The first schema whose models are those of today.
FIRST_USABLE_SCHEMA = 2
LOOM_SUFFIX = ".loom"
UNITS = {"length": "mm", "angle": "rad", "colour": "linear RGB", "value": "1/sr"}
_ENTRY = "loom"
_SOURCE, _MODEL = "source.", "model."
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

_DAMAGED = "its header is damaged: bake the file again"

Setting = bool | int | float | str
_Kind = TypeVar("_Kind", bool, int, float, str)
_Tables = TypeVar("_Tables", bound=Tables)


@dataclass(frozen=True, eq=False)
class LoomFile:
    """The contents of a `.loom` file.

    Attributes:
        model: name of the model, as `loomlight bake --model` calls it.
        source: what it is a material of.
        tensors: the model's arrays by name, in the layout and units that the model states.
        settings: the model's single values by name.
        networks: SHA-256, as hexadecimal text, of networks that it needs and does not hold, by name.
        file: what messages call the file.
        schema: of the file.
    """

    model: str
    source: Source
    tensors: Mapping[str, Tensor] = field(default_factory=dict)
    settings: Mapping[str, Setting] = field(default_factory=dict)
    networks: Mapping[str, str] = field(default_factory=dict)
    file: str = "the .loom file"
    schema: int = SCHEMA

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

    def tables(self, kind: type[_Tables], sizes: Mapping[str, int] | None = None, **known: object) -> _Tables:
        """The tables of a class, by its declarations.

        Args:
            sizes: that are known from elsewhere, by name.
            known: fields that are not read.

        Raises:
            InputError: tables of another version, tensors or settings that are missing, of another kind, or
                do not belong together.
        """
        if kind.version and self.settings.get(VERSION_SETTING) != kind.version:
            self._refuse("its tables are of another version of loomlight: bake it again")
        made = kind.of_parts(known)
        for name, of in kind.tables_in_files().items():
            if name in known:
                continue
            tensor = of.tensor or name
            if kind.may_lack(name) and tensor not in self.tensors:
                made.put(name, None)
                continue
            made.put(name, self.tensor(tensor, expected_shape(of, made, sizes or {}), kind.dtype_of(name)))
            if fault := fault_of(name, made):
                self._refuse(f"the tensor {_MODEL}{tensor} {fault}")
        for name, number in kind.settings_in_files().items():
            value = self.setting(name, float)
            if not number.above < value < math.inf:
                self._refuse(
                    f"the setting {name} is {value:g}: it should be above {number.above:g} {number.unit}"
                )
            made.put(name, value)
        return made

    def require_network(self, name: str, installed: str) -> None:
        """Raises InputError unless the file was made with the network whose SHA-256 is `installed`."""
        made_with = self.networks.get(name)
        if made_with == installed:
            return
        given = "does not say which" if made_with is None else f"has SHA-256 {made_with[:12]}…"
        self._refuse(
            f"the network {name} that it was made with {given}, the installed one has {installed[:12]}…: "
            "bake it again"
        )

    def require_model(self, name: str) -> None:
        """Raises InputError unless the file is a material of the model `name`."""
        if self.model != name:
            self._refuse(f'it holds the model "{shown(self.model)[1:-1]}", not "{name}": bake it with that')

    def _refuse(self, reason: str) -> NoReturn:
        raise InputError(f"{self.file}: {reason}.")


class _Material(BaseModel):
    """The JSON of the header."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)

    schema_version: int = Field(alias="schema")
    model: str = Field(min_length=1, max_length=100)
    units: dict[str, str]
    settings: dict[str, Setting]
    networks: dict[str, str]
    source: dict[str, Any]


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
    kind = kind_of_source(loom.source)
    record, source_tensors = SOURCE_KINDS[kind].record(loom.source)
    tensors = {_SOURCE + name: _plain(name, values) for name, values in source_tensors.items()}
    tensors |= {_MODEL + name: _plain(name, values) for name, values in loom.tensors.items()}
    material = _Material(
        schema=SCHEMA,
        model=loom.model,
        units=UNITS,
        settings=dict(loom.settings),
        networks=dict(loom.networks),
        source={"kind": kind, **record},
    ).model_dump(by_alias=True)
    header = {"checksum": checksum(material, tensors), "material": material}
    data = save(tensors, {_ENTRY: json.dumps(header, sort_keys=True)})
    with replacing(path) as temporary:
        temporary.write_bytes(data)


def read_loom(path: str | os.PathLike[str]) -> LoomFile:
    """Reads a `.loom` file.

    Raises:
        InputError: no such file, no `.loom`, a newer schema, or a damaged file.
    """
    require_file(path)
    file = str(path)
    with speaking_of(file):
        header, tensors = _opened(file)
        material, tensors, schema = _parsed(header, tensors)
        for name, values in tensors.items():
            if values.dtype.kind == "f" and not np.isfinite(values).all():
                raise InputError(f"the tensor {name} holds NaN or infinity: bake the file again.")
        source = _source(material.source, _those_named(tensors, _SOURCE), str(Path(file).parent))
    return LoomFile(
        model=material.model,
        source=source,
        tensors=_those_named(tensors, _MODEL),
        settings=material.settings,
        networks=material.networks,
        file=file,
        schema=schema,
    )


def _source(record: dict[str, Any], tensors: Mapping[str, Tensor], folder: str) -> Source:
    content = dict(record)
    kind = content.pop("kind", None)
    if not isinstance(kind, str) or kind not in SOURCE_KINDS:
        raise InputError(
            f"its source is of the kind {shown(kind)}, which does not exist here: install a newer loomlight."
        )
    try:
        source: Source = SOURCE_KINDS[kind].from_record(content, tensors, folder)
    except ValidationError as error:
        raise InputError(f"{_DAMAGED}{_place(error, 'source.')}.") from error
    return source


def checksum(material: Mapping[str, object], tensors: Mapping[str, Tensor]) -> str:
    """SHA-256 of the header's material and of all tensors, as hexadecimal text."""
    digest = hashlib.sha256(json.dumps(material, sort_keys=True).encode())
    for name in sorted(tensors):
        values = tensors[name]
        digest.update(f"\n{name} {values.dtype.str} {values.shape}\n".encode())
        digest.update(values.data if values.size else b"")
    return digest.hexdigest()


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


def _parsed(header: str, tensors: dict[str, Tensor]) -> tuple[_Material, dict[str, Tensor], int]:
    """The header and the tensors as of today's schema, and the schema of the file."""
    try:
        content = json.loads(header, parse_constant=_refuse_constant)
    except (ValueError, RecursionError) as error:
        raise InputError(f"{_DAMAGED}.") from error
    raw = content.get("material") if isinstance(content, dict) else None
    if not isinstance(raw, dict):
        raise InputError(f"{_DAMAGED}: it holds no material.")
    schema = raw.get("schema")
    if not isinstance(schema, int) or isinstance(schema, bool) or schema < 1:
        raise InputError(f"its schema is {shown(schema)}: a whole number from 1 to {SCHEMA} is right.")
    if schema > SCHEMA:
        raise InputError(
            f"its schema is {shown(schema)}, and this loomlight reads up to {SCHEMA}: install a newer one."
        )
    if content.get("checksum") != checksum(raw, tensors):
        raise InputError("its content does not fit its checksum, so it is damaged: bake the file again.")
    if schema == 1:
        raw, tensors = _of_first_schema(raw, tensors)
    if schema < SCHEMA and isinstance(raw.get("source"), dict):
        raw = raw | {"source": of_former_defaults(raw["source"], schema)}
    if raw.get("model") == "woven":  # the former name of the network of chen2024, and of its file of weights
        raw = raw | {"model": "neural", "networks": {"neural": (raw.get("networks") or {}).get("woven", "")}}
    try:
        material = _Material.model_validate(raw)
    except (ValidationError, RecursionError) as error:
        raise InputError(f"{_DAMAGED}{_place(error)}.") from error
    if material.units != UNITS:
        raise InputError(f"its units are {shown(json.dumps(material.units))}: they must be {UNITS}.")
    strangers = [name for name in tensors if not name.startswith((_SOURCE, _MODEL))]
    if strangers:
        raise InputError(f"the tensor {shown(strangers[0])} is neither the source's nor the model's.")
    return material, tensors, schema


def _of_first_schema(
    raw: dict[str, Any], tensors: dict[str, Tensor]
) -> tuple[dict[str, Any], dict[str, Tensor]]:
    """A material of schema 1 as one of today's: its source was a fabric and bore that name."""
    fabric = raw.get("fabric")
    today = {name: value for name, value in raw.items() if name != "fabric"}
    if isinstance(fabric, dict):
        today["source"] = {"kind": "fabric", **fabric}
    old = "fabric."
    renamed = {
        _SOURCE + name.removeprefix(old) if name.startswith(old) else name: values
        for name, values in tensors.items()
    }
    return today, renamed


def _refuse_constant(name: str) -> NoReturn:
    raise ValueError(f"{name} is no JSON")


def _place(error: Exception, within: str = "") -> str:
    if not isinstance(error, ValidationError):
        return ""
    fault = error.errors(include_url=False)[0]
    return f" at {within}{'.'.join(str(part) for part in fault['loc'])}: {fault['msg']}"


def _those_named(tensors: Mapping[str, Tensor], prefix: str) -> dict[str, Tensor]:
    return {name[len(prefix) :]: values for name, values in tensors.items() if name.startswith(prefix)}
