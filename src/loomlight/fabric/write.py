"""The fields of a fabric file as its text; omitted fields are not written."""

from __future__ import annotations

import os
import re
from pathlib import Path

from loomlight.fabric.fields import FabricFile
from loomlight.weave.load import DRAFT_SUFFIXES

_PATHS = ("draft", "image")
_BARE = re.compile(r"[A-Za-z0-9_.-]+")


def fabric_toml(fields: FabricFile, read_from: str, written_to: str | os.PathLike[str]) -> str:
    """TOML of `fields`, whose paths are relative to the folder `read_from`, for the folder `written_to`."""
    values = fields.model_dump(exclude_none=True)
    for key in _PATHS:
        if key in values:
            values[key] = _moved(values[key], read_from, written_to)
    values["weaves"] = {
        colour: [_moved_weave(weave, read_from, written_to) for weave in given]
        if isinstance(given, list)
        else _moved_weave(given, read_from, written_to)
        for colour, given in values["weaves"].items()
    }
    for table in values["maps"].values():
        table["picture"] = _moved(table["picture"], read_from, written_to)
        if "fabrics" in table:
            table["fabrics"] = [_moved(path, read_from, written_to) for path in table["fabrics"]]
    tables = {key: value for key, value in values.items() if isinstance(value, dict)}
    lines = [f"{key} = {_literal(value)}" for key, value in values.items() if key not in tables]
    for name, table in tables.items():
        if table:
            lines += ["", f"[{name}]", *(f"{_key(key)} = {_literal(value)}" for key, value in table.items())]
    return "\n".join(lines) + "\n"


def _moved_weave(weave: str, read_from: str, written_to: str | os.PathLike[str]) -> str:
    """A weave of an artwork: a draft's file, or a name, which stays."""
    return _moved(weave, read_from, written_to) if Path(weave).suffix.lower() in DRAFT_SUFFIXES else weave


def _moved(path: str, read_from: str, written_to: str | os.PathLike[str]) -> str:
    if os.path.isabs(path) or os.path.abspath(read_from) == os.path.abspath(written_to):
        return path
    try:
        relative = os.path.relpath(os.path.join(read_from, path), written_to)
    except ValueError:  # another drive
        relative = os.path.abspath(os.path.join(read_from, path))
    return relative.replace(os.sep, "/")


def _key(key: str) -> str:
    """A key as TOML has it: without quotes where it may be, and dotted names of maps as they are."""
    return key if _BARE.fullmatch(key) else _quoted(key)


def _literal(value: object) -> str:
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(_literal(part) for part in value) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(key)} = {_literal(part)}" for key, part in value.items()) + " }"
    return repr(value)


def _quoted(text: str) -> str:
    named = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t", "\r": "\\r"}
    return (
        '"' + "".join(named.get(char, char if char.isprintable() else _escape(char)) for char in text) + '"'
    )


def _escape(char: str) -> str:
    return f"\\U{ord(char):08X}"
