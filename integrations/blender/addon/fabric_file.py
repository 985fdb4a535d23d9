# SPDX-License-Identifier: GPL-3.0-or-later
"""The fabric file that loomlight is given: a file, draft or weave, with what the panel changes."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

# Files that are read as drafts, not as fabric files.
DRAFT_SUFFIXES = (".wif", ".dtx", ".png", ".bmp", ".tif", ".tiff", ".gif", ".jpg", ".jpeg")
MAX_FILE = 1 << 20
_BARE = re.compile(r"[A-Za-z0-9_-]+")


class FileError(Exception):
    """A file that cannot be used; the message is one sentence."""


def fabric_text(source: dict[str, Any], changes: dict[str, Any]) -> str:
    """The text of a fabric file: the fields `source` with `changes`, of which None takes one away."""
    merged = _merged(source, changes)
    tables = {key: value for key, value in merged.items() if isinstance(value, dict)}
    lines = [f"{_key(key)} = {_literal(value)}" for key, value in merged.items() if key not in tables]
    for name, table in tables.items():
        lines += [
            "",
            f"[{_key(name)}]",
            *(f"{_key(key)} = {_literal(value)}" for key, value in table.items()),
        ]
    return "\n".join(lines) + "\n"


def _merged(fields: dict[str, Any], changes: dict[str, Any]) -> dict[str, Any]:
    merged = dict(fields)
    for key, value in changes.items():
        if isinstance(value, dict):
            own = merged.get(key, {})
            merged[key] = _merged(own if isinstance(own, dict) else {}, value)
        elif value is None:
            merged.pop(key, None)
        else:
            merged[key] = value
    return merged


def fields_of_file(path: str) -> dict[str, Any]:
    """The fields of a fabric file, or of one that names the draft `path`; paths within are absolute.

    Raises:
        FileError: no such file, or no fabric file.
    """
    file = Path(path)
    if not file.is_file():
        raise FileError(f"{path or 'The path of the fabric'} is no file: choose a fabric file or a draft.")
    if file.suffix.lower() in DRAFT_SUFFIXES:
        return {"draft": str(file.resolve())}
    if file.stat().st_size > MAX_FILE:
        raise FileError(f"{file.name} is larger than a fabric file can be: choose a .toml or a draft.")
    try:
        fields = tomllib.loads(file.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        reason = " ".join(str(error).split())
        raise FileError(f"{file.name} is no fabric file: {reason}.") from error
    return _absolute(fields, file.resolve().parent)


def _absolute(value: Any, folder: Path) -> Any:
    """The value with texts that name files beside the fabric file as absolute paths.

    A weave's name has no suffix, so that no file can be taken for one.
    """
    if isinstance(value, dict):
        return {key: _absolute(part, folder) for key, part in value.items()}
    if isinstance(value, list):
        return [_absolute(part, folder) for part in value]
    if isinstance(value, str) and "\0" not in value and len(value) < 1024:
        name, mark, entry = value.partition("#")
        if name and Path(name).suffix and (folder / name).is_file():
            return f"{folder / name}{mark}{entry}"
    return value


def _key(key: str) -> str:
    return key if _BARE.fullmatch(key) else _quoted(key)


def _literal(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        return "[" + ", ".join(map(_literal, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(key)} = {_literal(part)}" for key, part in value.items()) + " }"
    return _quoted(value) if isinstance(value, str) else repr(value)


def _quoted(text: str) -> str:
    escaped = (char if char.isprintable() and char not in '"\\' else f"\\U{ord(char):08X}" for char in text)
    return f'"{"".join(escaped)}"'
