"""Messages about faults in a fabric file, one sentence each: field, value, and what would be right."""

from __future__ import annotations

from typing import get_args

from annotated_types import Ge, Le
from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo

from loomlight.core.sentences import closest, shown
from loomlight.fabric.file import FIELD, FabricFile


def sentence_of(error: ValidationError) -> str:
    """The first fault that pydantic found, as one sentence without the file's name."""
    fault = error.errors(include_url=False)[0]
    path = [str(part) for part in fault["loc"]]
    name = ".".join(path)
    if fault["type"] == "extra_forbidden":
        return _unknown(path)
    if fault["type"] == "sentence":
        return str(fault["ctx"]["text"]).replace(FIELD, name)
    if fault["type"] == "string_too_short":
        return f'{name} = "" is empty: write a value, or leave the field out.'
    if fault["type"] == "string_unicode":
        return f"{name} holds bytes that are no text in UTF-8: rename the file, or write the value anew."
    field = _field_at(path)
    if field is None:
        return f"{name} = {shown(fault['input'])} cannot be used: {fault['msg']}."
    return f"{name} = {shown(fault['input'])} cannot be used: {_expected(field, fault['input'])}."


def _tables(model: type[BaseModel]) -> dict[str, type[BaseModel]]:
    return {
        name: field.annotation
        for name, field in model.model_fields.items()
        if isinstance(field.annotation, type) and issubclass(field.annotation, BaseModel)
    }


def _unknown(path: list[str]) -> str:
    *parents, key = path
    model: type[BaseModel] = FabricFile
    for parent in parents:
        model = _tables(model)[parent]
    place = f"[{'.'.join(parents)}] has" if parents else "a fabric file has"
    return f"{shown(key)} is no field that {place}: {_place_of(key, model)}"


def _place_of(key: str, model: type[BaseModel]) -> str:
    tables = _tables(FabricFile)
    homes = [f"[{name}]" for name, table in tables.items() if key in table.model_fields]
    if homes:
        return f"it belongs under {' or '.join(homes)}."
    if key in FabricFile.model_fields and model is not FabricFile:
        return "it belongs at the top of the file, above the first table."
    return closest(key, model.model_fields)


def _field_at(path: list[str]) -> FieldInfo | None:
    model: type[BaseModel] = FabricFile
    for position, part in enumerate(path):
        field = model.model_fields.get(part)
        if field is None or position == len(path) - 1:
            return field
        table = _tables(model).get(part)
        if table is None:
            return field
        model = table
    return None


def _expected(field: FieldInfo, given: object) -> str:
    annotation = field.annotation
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return "it is a table of fields"
    kinds, bounds = _kinds_and_bounds(annotation)
    low = next((bound.ge for bound in bounds if isinstance(bound, Ge)), None)
    high = next((bound.le for bound in bounds if isinstance(bound, Le)), None)
    if bool in kinds and not kinds & {int, float, str}:
        meant = {0: "false", 1: "true"}.get(given) if isinstance(given, int) else None
        return f"write {meant or 'true or false'}"
    if float in kinds:
        return f"write a number from {_number(low)} to {_number(high)}"
    if int in kinds:
        return f"write a whole number from {_number(low)} to {_number(high)}"
    return "write text in quotes" if str in kinds else "write a value of another kind"


def _number(bound: object) -> str:
    return str(bound) if isinstance(bound, int) else f"{bound:g}"


def _kinds_and_bounds(annotation: object) -> tuple[set[type], list[object]]:
    """The plain types and the bounds anywhere inside an annotation such as Annotated[float, …] | None."""
    if isinstance(annotation, type):
        return {annotation}, []
    kinds: set[type] = set()
    bounds: list[object] = []
    for part in get_args(annotation):
        if isinstance(part, FieldInfo):
            bounds += part.metadata
        elif isinstance(part, type):
            kinds.add(part)
        else:
            inner_kinds, inner_bounds = _kinds_and_bounds(part)
            kinds |= inner_kinds
            bounds += inner_bounds
    return kinds, bounds
