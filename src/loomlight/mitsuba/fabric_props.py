"""The fabric of a BSDF plugin: a file, the text of one, or parameters inline, in load_dict and in XML alike.

- ``fabric``: path of a fabric file, a draft or a ``.loom``, found through Mitsuba's file resolver; or a
  weave's name.
- ``toml``: the text of a fabric file; ``folder`` is what its paths are relative to, or the ``.loom`` that
  holds its draft.
- inline: every field of the fabric file by its name, those of its tables with the table's name in front:
  ``weave``, ``ends_per_cm``, ``warp_color``, ``weft_roughness``, ``sheen_strength`` … Inline values replace
  those of the file. Colours are "#rrggbb", several with commas between them, or an rgb value.
"""

from __future__ import annotations

import json
import math
import tomllib
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np

from loomlight.assets.fabrics import fabric_of_path, fabric_of_text
from loomlight.assets.loom_file import is_loom
from loomlight.core.errors import InputError
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.fabric.file import FabricFile
from loomlight.fabric.load import edited_fabric
from loomlight.fabric.sentences import shown

_TABLES = ("warp", "weft", "sheen", "variation")
_TOP = tuple(name for name in FabricFile.model_fields if name not in _TABLES)
# Of these a fabric has one, so an inline one replaces the file's.
_SOURCES = ("weave", "draft", "image")
_DENSITIES = {"ends_per_cm": "epi", "epi": "ends_per_cm", "picks_per_cm": "ppi", "ppi": "picks_per_cm"}


def fabric_of(props: Any) -> Fabric:
    """The fabric that the properties of a plugin describe; plain weave where they name none.

    Raises:
        InputError: no such file, or a field that cannot be; the message names it.
    """
    base = _base(props)
    inline = _inline(props)
    if not inline:
        return base or fabric_from_text("plain")
    fields: dict[str, Any] = tomllib.loads(base.to_toml()) if base else {}
    if not base and not any(source in inline for source in _SOURCES):
        fields["weave"] = "plain"
    text = _toml(_merged(fields, inline))
    folder = base.folder if base else _folder(props)
    if is_loom(folder) and any(source in inline for source in _SOURCES):
        return fabric_from_text(text, Path(folder).parent)
    return fabric_of_text(text, folder)


def other_fabric_of(props: Any) -> Fabric | None:
    """The fabric that the parameter ``other`` names, as ``fabric`` does; None where there is none.

    Raises:
        InputError: no such file, or a field that cannot be.
    """
    return _named(str(props["other"])) if "other" in props else None


def with_fields(fabric: Fabric, fields: dict[str, Any]) -> Fabric:
    """The fabric with other values of some fields, by their dotted names: "warp.roughness", "sheen.strength".

    Raises:
        InputError: a value that cannot be; the message names its field.
    """
    return edited_fabric(fabric, _toml(_merged(tomllib.loads(fabric.to_toml()), fields)))


def uv_size_of(props: Any, fabric: Fabric) -> tuple[float, float]:
    """Millimetres per unit of u and of v: ``uv_size`` (mm), or ``uv_scale`` (repeats); 100 mm by default.

    Raises:
        InputError: both are given, or one is no pair of positive numbers.
    """
    given = [name for name in ("uv_size", "uv_scale") if name in props]
    if len(given) == 2:
        raise InputError("uv_size and uv_scale are both given: use one of them.")
    if not given:
        return 100.0, 100.0
    u, v = _pair(given[0], props[given[0]])
    width, height = fabric.repeat_mm
    return (u, v) if given[0] == "uv_size" else (u * width, v * height)


def number_of_props(props: Any, name: str, default: float, such_as: str, least: float = -math.inf) -> float:
    """A single number of a plugin: a property that may be left out.

    Args:
        such_as: what would be right, the end of a sentence: "an angle in radians, such as 0.001".

    Raises:
        InputError: what is given is no finite number of `least` and more.
    """
    value = props.get(name, default)
    if not _is_number(value) or not math.isfinite(value) or value < least:
        raise InputError(f"{name} = {shown(value)} is wrong: give {such_as}.")
    return float(value)


def whole_number_of_props(props: Any, name: str, such_as: str) -> int | None:
    """A whole number of a plugin; None where it is left out.

    Raises:
        InputError: what is given is no whole number; `such_as` says what would be right.
    """
    if name not in props:
        return None
    value = props[name]
    if not _is_number(value) or not float(value).is_integer():
        raise InputError(f"{name} = {shown(value)} is no whole number: give {such_as}.")
    return int(value)


def truth_of_props(props: Any, name: str, default: bool) -> bool:
    """A yes or no of a plugin: a property that may be left out.

    Raises:
        InputError: what is given is neither.
    """
    value = props.get(name, default)
    if not isinstance(value, bool):
        raise InputError(f"{name} = {shown(value)} is wrong: give true or false.")
    return value


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _base(props: Any) -> Fabric | None:
    if "toml" in props:
        return fabric_of_text(str(props["toml"]), _folder(props))
    if "fabric" not in props:
        return None
    return _named(str(props["fabric"]))


def _named(name: str) -> Fabric:
    resolved = Path(_resolved(name))
    # What is no file is left as it was written: the name of a weave, or a message's subject.
    return fabric_of_path(resolved if resolved.is_file() else name)


def _resolved(name: str) -> str:
    find: Any = mi.file_resolver
    resolver = find()
    return str(resolver.resolve(name))


def _folder(props: Any) -> str:
    if "folder" in props:
        return str(props["folder"])
    return _resolved(".")


def _inline(props: Any) -> dict[str, Any]:
    """Fields by dotted name, in the order given."""
    found = {}
    for key in props.keys():  # noqa: SIM118 (Properties is no mapping)
        name = _field(key)
        if name is not None:
            found[name] = _value(name, props[key])
    return found


def _field(key: str) -> str | None:
    if key in _TOP:
        return key
    for table in _TABLES:
        model = FabricFile.model_fields[table].annotation
        field = key.removeprefix(f"{table}_")
        if field != key and field in getattr(model, "model_fields", {}):
            return f"{table}.{field}"
    return None


def _value(name: str, value: Any) -> Any:
    if isinstance(value, bool | int | float):
        return value
    if isinstance(value, str):
        # One colour is for every thread; commas make a list in thread order.
        parts = [part.strip() for part in value.split(",")]
        return parts if len(parts) > 1 and name.endswith(".color") else value
    try:
        return [float(part) for part in np.array(value, dtype=np.float64).ravel()]
    except (TypeError, ValueError) as error:
        raise InputError(f"{name} is a {type(value).__name__}: give a number or a colour.") from error


def _merged(fields: dict[str, Any], inline: dict[str, Any]) -> dict[str, Any]:
    if any(source in inline for source in _SOURCES):
        fields = {key: value for key, value in fields.items() if key not in _SOURCES}
    for name, value in inline.items():
        table, _, field = name.rpartition(".")
        fields.pop(_DENSITIES.get(name, ""), None)
        if table:
            fields[table] = {**fields.get(table, {}), field: value}
        else:
            fields[field] = value
    return fields


def _toml(fields: dict[str, Any]) -> str:
    lines = [f"{key} = {_written(value)}" for key, value in fields.items() if not isinstance(value, dict)]
    for name, table in fields.items():
        if isinstance(table, dict):
            lines += [f"[{name}]", *(f"{key} = {_written(value)}" for key, value in table.items())]
    return "\n".join(lines) + "\n"


def _written(value: Any) -> str:
    # TOML's strings, numbers, booleans and lists are JSON's, but for escaped surrogates.
    return json.dumps(value, ensure_ascii=False)


def _pair(name: str, value: Any) -> tuple[float, float]:
    wrong = f'{name} = {value} is wrong: give two numbers above 0, such as "100,100".'
    try:
        if isinstance(value, str):
            numbers = [float(part) for part in value.split(",")]
        else:
            numbers = [float(part) for part in np.array(value, dtype=np.float64).ravel()]
    except (TypeError, ValueError) as error:
        raise InputError(wrong) from error
    if len(numbers) == 1:
        numbers *= 2
    if len(numbers) != 2 or not all(np.isfinite(number) and number > 0 for number in numbers):
        raise InputError(wrong)
    return numbers[0], numbers[1]
