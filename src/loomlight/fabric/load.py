"""Fabrics from files and from text: the two ways in."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.file import FabricFile
from loomlight.fabric.measured_colours import with_measured_colours
from loomlight.fabric.plausibility import require_interlacing, warn_of_slips
from loomlight.fabric.reading import one_line, parse_fabric_file, read_text, speaking_of, validate_fields
from loomlight.fabric.sentences import sentence_of
from loomlight.weave.draft import Draft
from loomlight.weave.load import DRAFT_SUFFIXES, load_draft
from loomlight.weave.named import named_weave

FABRIC_SUFFIX = ".toml"
# A fabric has one of these, so a new one replaces what there was; the same holds for a density's two units.
_DRAFTS = ("weave", "draft", "image")
_SAME_DENSITY = {"ends_per_cm": "epi", "epi": "ends_per_cm", "picks_per_cm": "ppi", "ppi": "picks_per_cm"}


def load_fabric(path: str | os.PathLike[str]) -> Fabric:
    """The fabric of a fabric file (.toml), of a draft (.wif, a picture of a drawdown), or of a weave's name.

    A draft alone is a fabric in its own colours and spacing. What has no suffix and is no file is read as
    the name of a weave, such as "twill 3/1".

    Raises:
        InputError: no such file, no fabric, or values that cannot be; the message names file and field.

    Warns:
        LoomlightWarning: a family of threads that never interlaces, or yarns wider than their spacing.
    """
    file = Path(path)
    suffix = file.suffix.lower()
    folder = str(file.parent)
    if suffix in DRAFT_SUFFIXES:
        return _made(_only(draft=file.name), folder, file.stem, str(file))
    if suffix == FABRIC_SUFFIX:
        text = read_text(file)
        with speaking_of(str(file)):
            fields = parse_fabric_file(text)
        return _made(fields, folder, file.stem, str(file))
    if suffix or _exists(file) or file.is_absolute():
        shown = one_line(str(file)) if str(path) else '""'
        raise InputError(f"{shown} is no fabric: give a fabric file (.toml), a draft (.wif, .png), a weave.")
    return fabric_from_text(str(path))


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):
        return False


def fabric_from_text(text: str, folder: str | os.PathLike[str] = ".") -> Fabric:
    """The fabric of a weave's name ("twill 3/1") or of the text of a fabric file.

    Args:
        text: a name, or TOML; what holds an equals sign is TOML.
        folder: the folder that paths in the TOML are relative to.

    Raises:
        InputError: an unknown weave, or a text that is no fabric file.
    """
    if "=" not in text and text.strip():
        return _made(_only(weave=text.strip()), os.fspath(folder), text.strip(), "")
    with speaking_of("the fabric"):
        fields = parse_fabric_file(text)
    return _made(fields, os.fspath(folder), "fabric", "the fabric")


def fabric_from_fields(fields: Mapping[str, Any], folder: str | os.PathLike[str] = ".") -> Fabric:
    """The fabric of fields by their dotted names: "weave", "warp.roughness", "sheen.strength".

    Args:
        folder: the folder that paths among the fields are relative to.

    Raises:
        InputError: an unknown field, or values that make no fabric; the message names the field.
    """
    with speaking_of("the fabric"):
        valid = validate_fields(_merged({}, fields))
    return _made(valid, os.fspath(folder), "fabric", "the fabric")


def edited_fabric(fabric: Fabric, fields: Mapping[str, Any]) -> Fabric:
    """The fabric with other values of some fields, by their dotted names; see `fabric_from_fields`.

    No draft is read again unless another weave, draft or image is among the fields.

    Raises:
        InputError: an unknown field, or values that contradict the draft; the message names the field.
    """
    with speaking_of("the fabric"):
        valid = validate_fields(_merged(fabric.fields.model_dump(exclude_none=True), fields))
        if any(name in fields for name in _DRAFTS):
            return _made(valid, fabric.folder, "fabric", "the fabric")
        valid = with_measured_colours(valid, fabric.folder)
        return make_fabric(valid, fabric.named_draft, valid.name or fabric.name, fabric.folder)


def _merged(values: Mapping[str, Any], fields: Mapping[str, Any]) -> dict[str, Any]:
    """Values of a fabric file, tables as dictionaries, with fields by dotted name put in."""
    merged = dict(values)
    if any(name in fields for name in _DRAFTS):
        merged = {name: value for name, value in merged.items() if name not in _DRAFTS}
    for name, value in fields.items():
        merged.pop(_SAME_DENSITY.get(name, ""), None)
        table, _, field = name.rpartition(".")
        if table:
            merged[table] = {**merged.get(table, {}), field: value}
        else:
            merged[name] = value
    return merged


def _only(**field: str) -> FabricFile:
    """A fabric file of one field, which a user gave without writing one."""
    try:
        return FabricFile.model_validate(field)
    except ValidationError as error:  # a name from the system that is no UTF-8
        raise InputError(f"{one_line(next(iter(field.values())))}: {sentence_of(error)}") from error


def _made(fields: FabricFile, folder: str, fallback_name: str, source: str) -> Fabric:
    with speaking_of(source):
        fields = with_measured_colours(fields, folder)
        draft = _draft_of(fields, folder)
        require_interlacing(draft)
        name = fields.name or draft.title or fields.weave or fallback_name
        fabric = make_fabric(fields, draft, name, folder)
    warn_of_slips(fields, draft, fabric.layout(), source)
    return fabric


def _draft_of(fields: FabricFile, folder: str) -> Draft:
    """The draft of a fabric file's `weave`, `draft` or `image`; paths are relative to `folder`.

    Raises:
        InputError: an unknown weave, or a file that is no draft.
    """
    if fields.weave is not None:
        return named_weave(fields.weave)
    name = "draft" if fields.draft is not None else "image"
    given = str(getattr(fields, name))
    path = Path(folder) / given
    try:
        require_file(path)
    except InputError as error:
        raise InputError(f'{name} = "{given[:80]}" names no draft: {error}') from error
    return load_draft(path)
