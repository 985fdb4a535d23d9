"""Text of a fabric file into its validated fields."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from loomlight.core.errors import InputError
from loomlight.fabric.file import FabricFile
from loomlight.fabric.sentences import sentence_of

# Thread colours of the longest draft take some 100 kB; what is larger is not a fabric file.
MAX_FILE = 4 * 2**20


@contextmanager
def speaking_of(source: str) -> Iterator[None]:
    """Names `source` (a file) at the start of every InputError raised inside that does not name it."""
    try:
        yield
    except InputError as error:
        text = one_line(str(error))
        raise InputError(text if not source or source in text else f"{source}: {text}") from error


def one_line(text: str) -> str:
    """`text` as one printable line: what a user's file holds must not steer a terminal."""
    spaced = " ".join(text.split())
    return "".join(char if char.isprintable() else "\N{REPLACEMENT CHARACTER}" for char in spaced)


def read_text(path: str | os.PathLike[str]) -> str:
    """Text of a UTF-8 file.

    Raises:
        InputError: no such file, no file but a folder or device, unreadable, too large, not UTF-8.
    """
    file = Path(path)
    try:
        if file.is_dir():
            raise InputError(f"{file} is a folder; give the name of a fabric file.")
        if not file.exists():
            raise InputError(f"{file} does not exist.")
        if not file.is_file():
            raise InputError(f"{file} is no ordinary file; give the name of a fabric file.")
        if file.stat().st_size > MAX_FILE:
            raise InputError(f"{file} is larger than {MAX_FILE >> 20} MiB; it is no fabric file.")
        return file.read_bytes().decode("utf-8-sig")
    except OSError as error:
        raise InputError(f"{file} cannot be read: {error.strerror or error}.") from error
    except UnicodeDecodeError as error:
        raise InputError(f"{file} is no fabric file: it is not UTF-8 text.") from error
    except ValueError as error:  # a NUL inside the path
        raise InputError(f"{str(file)!r} is no path of a file.") from error


def parse_fabric_file(text: str) -> FabricFile:
    """The fields of a fabric file's text, each valid by itself and all of them together.

    Raises:
        InputError: no TOML, an unknown field, a value of another type or range, contradicting fields.
    """
    if not text.strip():
        raise InputError('it is empty: weave = "twill 3/1" alone would be a fabric.')
    try:
        values = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"it is no valid TOML: {_reason(error)}.") from error
    except RecursionError as error:
        raise InputError("it is no fabric file: its values are nested too deeply.") from error
    except ValueError as error:  # an integer of thousands of digits, a month 13
        raise InputError(f"it is no valid TOML: {_reason(error)}.") from error
    return validate_fields(values)


def validate_fields(values: Mapping[str, Any]) -> FabricFile:
    """The fields of a fabric from plain values, tables as mappings.

    Raises:
        InputError: an unknown field, a value of another type or range, contradicting fields.
    """
    try:
        fields = FabricFile.model_validate(values)
    except ValidationError as error:
        raise InputError(sentence_of(error)) from error
    _require_consistent(fields)
    return fields


def _reason(error: ValueError) -> str:
    reason = str(error).split(";")[0].rstrip(".")
    return reason[:1].lower() + reason[1:]


def _require_consistent(fields: FabricFile) -> None:
    sources = [name for name in ("weave", "draft", "image") if getattr(fields, name) is not None]
    if not sources:
        raise InputError(
            'it has no weave: write weave = "twill 3/1", draft = "file.wif" or image = "file.png".'
        )
    _refuse_together(fields, sources[:2])
    _refuse_together(fields, ["ends_per_cm", "epi"])
    _refuse_together(fields, ["picks_per_cm", "ppi"])
    for family in ("warp", "weft"):
        _refuse_together(getattr(fields, family), ["width_mm", "gap"], f"{family}.")


def _refuse_together(table: object, names: list[str], prefix: str = "") -> None:
    given = [name for name in names if getattr(table, name) is not None]
    if len(given) > 1:
        first, second = (f"{prefix}{name} = {_value(table, name)}" for name in given[:2])
        raise InputError(f"{first} and {second} say the same thing twice: keep one of them.")


def _value(table: object, name: str) -> str:
    value = getattr(table, name)
    return f'"{value}"' if isinstance(value, str) else f"{value:g}"
