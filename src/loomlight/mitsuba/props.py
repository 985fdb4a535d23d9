"""What users set on a cloth of a scene: properties, which make its model, and parameters, edited later.

Properties of a plugin are a material or a source, options, and a fabric's fields inline:

- ``fabric`` or ``source``: path of what the model is made of, found through Mitsuba's file resolver: for
  models of fabrics a fabric file, a draft or a weave's name; or a ``.loom``, whose model is used as it is if
  it is this one and nothing else is given.
- the model's options by name (`Model.options_class`), such as ``groups`` of ``woven_lobes``.
- of models of fabrics every field of the fabric file by its name, those of its tables with the table's name
  in front: ``weave``, ``ends_per_cm``, ``warp_color``, ``weft_roughness``, ``sheen_strength`` … Inline values
  replace those of the file. Colours are "#rrggbb", several with commas between them, or an rgb value.

A model that is trained takes a ``.loom`` of it alone: a scene is no place to train in for minutes.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.sentences import shown
from loomlight.core.settings import Setting, declared
from loomlight.fabric import Fabric
from loomlight.fabric.fields import FabricFile
from loomlight.fabric.read import edited_fabric, fabric_from_fields
from loomlight.models.interface import Model, Parameter, Values
from loomlight.models.options import is_source
from loomlight.models.registry import model_class, model_of_loom, untrained
from loomlight.sources.kinds import Source
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import is_loom, read_loom

_TABLES = ("warp", "weft", "sheen", "variation")
# Maps and artwork are left to fabric files: they are tables of tables, and of colours.
_IN_FILES = ("maps", "weaves", "artwork")
_TOP = tuple(name for name in FabricFile.model_fields if name not in (*_TABLES, *_IN_FILES))
_SOURCES = ("fabric", "source")
_DRAFT_FILES = ("draft", "image")
_DRAFTS = ("weave", *_DRAFT_FILES)
_DEFAULT_WEAVE = "plain"


def model_of_props(props: Any, name: str) -> Model:
    """The model `name` that the properties of a plugin describe.

    Raises:
        InputError: no such file, a field or an option that cannot be; the message names it.
    """
    kind = model_class(name)
    options = {
        option: _option(props, declaration, kind.source_kind)
        for option, declaration in declared(kind.options_class).items()
        if option in props
    }
    given = [key for key in _SOURCES if key in props]
    if len(given) == 2:
        raise InputError("fabric and source are both given: use one of them.")
    path = _resolved(str(props[given[0]])) if given else None
    inline = _inline(props) if kind.source_kind == "fabric" else {}
    if path is not None and is_loom(path):
        loom = read_loom(path)
        if kind.trains and (loom.model != name or options or inline):
            raise untrained(name, path)
        if loom.model != name or options:
            return kind.for_source(_edited(loom.source, inline), kind.options_class.of(options))
        model = model_of_loom(loom)
        return model.with_source(_edited(loom.source, inline)) if inline else model
    if kind.trains:
        raise untrained(name, path or "SOURCE")
    if path is not None:
        source = _edited(load_source(path, kind.source_kind), inline)
    elif kind.source_kind == "fabric":
        plain = {} if any(field in inline for field in _DRAFTS) else {"weave": _DEFAULT_WEAVE}
        source = fabric_from_fields(plain | inline)
    else:
        raise InputError(f"source is missing: give what the model {name} is made of.")
    return kind.for_source(source, kind.options_class.of(options))


def _edited(source: Source, inline: dict[str, Any]) -> Source:
    """The source with inline fields of a fabric."""
    return edited_fabric(source, inline) if inline and isinstance(source, Fabric) else source


def uv_size_of(props: Any, source: Source) -> tuple[float, float]:
    """Millimetres per unit of u and of v: ``uv_size`` (mm), or ``uv_scale`` (repeats); else the source's own.

    Raises:
        InputError: both are given, or one is no pair of positive numbers.
    """
    given = [name for name in ("uv_size", "uv_scale") if name in props]
    if len(given) == 2:
        raise InputError("uv_size and uv_scale are both given: use one of them.")
    if not given:
        return source.default_uv_size_mm
    u, v = _pair(given[0], props[given[0]])
    width, height = source.repeat_mm
    return (u, v) if given[0] == "uv_size" else (u * width, v * height)


def number_of_props(props: Any, name: str, default: float, expected: str, least: float = -math.inf) -> float:
    """A single number of a plugin: a property that may be left out.

    Args:
        expected: what would be right, the end of a sentence: "an angle in radians, such as 0.001".

    Raises:
        InputError: what is given is no finite number of `least` and more.
    """
    value = props.get(name, default)
    if not _is_number(value) or not math.isfinite(value) or value < least:
        raise InputError(f"{name} = {shown(value)} is wrong: give {expected}.")
    return float(value)


def _option(props: Any, option: Setting, source_kind: str) -> Any:
    """The value of an option that is given, not checked; Mitsuba's numbers may all be floats."""
    value = props[option.name]
    if option.kind is int and isinstance(value, float) and value.is_integer():
        return int(value)
    if is_source(option):
        return load_source(_resolved(str(value)), source_kind)
    return _resolved(str(value)) if option.kind is os.PathLike else value


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _resolved(name: str) -> str:
    """A path through Mitsuba's file resolver; what is no file stays as written: the name of a weave, say."""
    find: Any = mi.file_resolver
    found = str(find().resolve(name))
    return found if Path(found).is_file() else name


def _inline(props: Any) -> dict[str, Any]:
    """Fields by dotted name, in the order given."""
    found = {}
    for key in props.keys():  # noqa: SIM118 (Properties is no mapping)
        name = _field(key)
        if name is not None:
            value = _value(name, props[key])
            found[name] = _resolved(value) if name in _DRAFT_FILES and isinstance(value, str) else value
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
        return parts if len(parts) > 1 and name.endswith((".color", ".albedo")) else value
    try:
        return [float(part) for part in np.array(value, dtype=np.float64).ravel()]
    except (TypeError, ValueError) as error:
        raise InputError(f"{name} is a {type(value).__name__}: give a number or a colour.") from error


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


# ------------------------------------------------------------------------------------------------- live edits
# Edits of a BSDF's scene parameters are checked before anything follows them, and else taken back.


class LiveEdits:
    """The parameters of one BSDF, and their values as of the last edit that was right.

    Its slots keep these values out of `core.pytree.leaves`: no kernel reads them.

    Attributes:
        parameters: by name.
    """

    __slots__ = ("_kept", "parameters")

    def __init__(self, parameters: Values) -> None:
        self.parameters = parameters
        self._kept: dict[str, Any] = {}
        self.keep()

    def keep(self) -> None:
        """The present values are right."""
        self._kept = {name: _copy(parameter.value) for name, parameter in self.parameters.items()}

    def changed(self) -> frozenset[str]:
        """Names of the parameters that were edited since."""
        return frozenset(
            name
            for name, parameter in self.parameters.items()
            if not _same(parameter.value, self._kept[name])
        )

    def take_back(self) -> None:
        """Gives every parameter the value that was right."""
        for name in self.changed():
            mi.set_property(self.parameters[name].value, self._kept[name])

    def require_valid(self, cloth: str) -> None:
        """Checks the parameters that were edited since.

        Args:
            cloth: the name of the BSDF, for the message.

        Raises:
            InputError: numbers out of range, not finite, or of another count; derivatives of a parameter
                that has none. The message names parameter, value and range.
        """
        for name in self.changed():
            parameter = self.parameters[name]
            _require_valid(f"{cloth}.{name}", parameter, self._kept[name])
            if not parameter.differentiable and dr.grad_enabled(parameter.value):
                raise InputError(_without_derivatives(cloth, name, self.parameters))


def require_valid_edits(edits: Iterable[tuple[str, LiveEdits]]) -> None:
    """Checks the edits of several BSDFs, by name; of none is anything left where one of them is wrong.

    Raises:
        InputError: see `LiveEdits.require_valid`.
    """
    pending = list(edits)
    if dr.flag(dr.JitFlag.FreezingScope):
        # While a frozen function records, no array can be read.
        return
    try:
        for name, each in pending:
            each.require_valid(name)
    except InputError:
        for _, each in pending:
            each.take_back()
        raise


def _require_valid(name: str, parameter: Parameter, kept: Any) -> None:
    count, right = len(_numbers(kept)), _range(parameter)
    numbers = _numbers(parameter.value)
    if len(numbers) != count:
        raise InputError(f"{name} holds {len(numbers)} numbers: give {count}.")
    # In single precision, as they are kept, both bounds are allowed.
    low, high = np.float32(parameter.low), np.float32(parameter.high)
    wrong = ~(np.isfinite(numbers) & (numbers >= low) & (numbers <= high))
    if wrong.any():
        where = f"[{int(np.argmax(wrong))}]" if count > 3 else ""
        shown = ", ".join(f"{number:g}" for number in (numbers[wrong][:1] if where else numbers))
        raise InputError(f"{name}{where} = {shown} is wrong: give {right}.")


def _range(parameter: Parameter) -> str:
    """The expected value, the end of a sentence."""
    low, high = parameter.low, parameter.high
    if math.isinf(low) and math.isinf(high):
        return "a finite number"
    if math.isinf(high):
        return f"{low:g}{_unit(parameter)} or more"
    degrees = f", which is {math.degrees(low):.0f}° to {math.degrees(high):.0f}°"
    return f"{low:.4g} to {high:.4g}{_unit(parameter)}{degrees if parameter.unit == 'rad' else ''}"


def _unit(parameter: Parameter) -> str:
    return f" {parameter.unit}" if parameter.unit else ""


def _without_derivatives(cloth: str, name: str, parameters: Values) -> str:
    others = ", ".join(other for other, parameter in parameters.items() if parameter.differentiable)
    have = f"those that have some are {others}" if others else "no parameter of this model has"
    return f"{cloth}.{name} has no derivatives: {have}, and woven_point has more."


def _numbers(value: Any) -> np.ndarray:
    return np.array(dr.detach(value), np.float32).ravel()


def _copy(value: Any) -> Any:
    """Another array of the same variables."""
    return type(value)(value)


def _same(value: Any, other: Any) -> bool:
    """Whether two arrays are of the same variables, derivatives included."""
    if dr.depth_v(value) > 1:
        return len(value) == len(other) and all(map(_same, value, other))
    return bool(value.index == other.index and value.index_ad == other.index_ad)
