"""Sources that a TOML file describes: recognised by one field, read into checked values."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, ClassVar, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from loomlight.core.errors import InputError
from loomlight.core.files import read_text
from loomlight.core.sentences import closest, shown

Length = Annotated[float, Field(ge=1e-3, le=1e6)]
# Width and height.
Lengths = Annotated[list[Length], Field(min_length=2, max_length=2)]


class SizedSource:
    """A source that repeats every `size_mm`, width and height in millimetres."""

    size_mm: tuple[float, float]

    @property
    def repeat_mm(self) -> tuple[float, float]:
        """Width and height of one repeat, millimetres."""
        return self.size_mm

    @property
    def default_uv_size_mm(self) -> tuple[float, float]:
        """A unit of u and v is 100 mm, as of fabrics."""
        return 100.0, 100.0


class SourceFields(BaseModel):
    """The fields of a file that describes a source.

    Attributes:
        noun: the kind of source in messages, "a tile".
        expected: right values of each field, as messages say them.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)
    noun: ClassVar[str]
    expected: ClassVar[Mapping[str, str]]

    name: str | None = None


FieldsT = TypeVar("FieldsT", bound=SourceFields)


def has_field(path: str | os.PathLike[str], field: str) -> bool:
    """Whether a path is a TOML file with a field."""
    file = Path(path)
    if file.suffix.lower() != ".toml":
        return False
    try:
        return field in tomllib.loads(read_text(file))
    except (InputError, ValueError, RecursionError):
        return False


def read_fields(file: Path, kind: type[FieldsT]) -> FieldsT:
    """The fields of a file.

    Raises:
        InputError: no such file, no TOML, an unknown field, or a value that cannot be; it is named.
    """
    try:
        return kind.model_validate(tomllib.loads(read_text(file)))
    except ValidationError as error:
        raise InputError(_sentence(error, kind)) from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"it is no valid TOML: {error}.") from error


def _sentence(error: ValidationError, kind: type[SourceFields]) -> str:
    fault = error.errors(include_url=False)[0]
    field = str(fault["loc"][0])
    if fault["type"] == "extra_forbidden":
        return f"{shown(field)} is no field that {kind.noun} has: {closest(field, kind.model_fields)}"
    expected = {"name": "text in quotes", **kind.expected}.get(field, "another value")
    if fault["type"] == "missing":
        return f"{field} is missing: write {expected}."
    return f"{field} = {shown(fault['input'])} cannot be used: write {expected}."
