"""Tiles as sources: a Mitsuba scene of one repeat of any geometry, fibres included.

A tile file is TOML:

    tile = "basket.xml"          # a Mitsuba scene; shapes alone count, in millimetres, z upwards
    size_mm = [2.0, 2.0]         # of one repeat, which begins at x = y = 0
    reference_height_mm = 0.1    # z of the reference plane; by default 0
    two_sided = true             # the back and light from the other side too; by default false
    bounces = 16                 # vertices of a path; by default 8

Files that the scene names lie in its folder or below it. They are parts of the source, as the scene is.
"""

from __future__ import annotations

import os
import xml.etree.ElementTree as ElementTree
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field

from loomlight.core.errors import InputError
from loomlight.core.files import read_text, require_file
from loomlight.core.sentences import shown, speaking_of
from loomlight.sources import scene_text
from loomlight.sources.toml_source import Lengths, SizedSource, SourceFields, has_field, read_fields

_FIELD = "tile"
_MAX_BOUNCES = 64
# Bytes of all files of a scene together.
_MAX_FILES = 1 << 28
_FILE = "file."
# Elements of a scene that are left out.
_UNUSED = ("sensor", "integrator", "film", "sampler", "rfilter")

_Height = Annotated[float, Field(ge=-1e6, le=1e6)]
_Bounces = Annotated[int, Field(ge=1, le=_MAX_BOUNCES)]


class _Record(BaseModel):
    """The header of a tile in a `.loom` file; the files of its scene are tensors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)

    name: str
    scene: str
    size_mm: Lengths
    reference_height_mm: _Height
    two_sided: bool
    bounces: _Bounces


class _File(SourceFields):
    """The fields of a tile file."""

    noun = "a tile"
    expected: ClassVar[Mapping[str, str]] = {
        "tile": "the name of a Mitsuba scene in quotes",
        "size_mm": "two lengths above 0, such as [2.0, 2.0]",
        "reference_height_mm": "a height, such as 0.0",
        "two_sided": "true or false",
        "bounces": f"a whole number from 1 to {_MAX_BOUNCES}",
    }

    tile: str
    size_mm: Lengths
    reference_height_mm: _Height = 0.0
    two_sided: bool = False
    bounces: _Bounces = 8


@dataclass(frozen=True, eq=False)
class TileScene(SizedSource):
    """A Mitsuba scene of one repeat.

    Attributes:
        name: in messages.
        scene: the text of the scene, which reads `files` alone.
        files: bytes of the files that it names, by the names it gives them.
        size_mm: width and height of a repeat, millimetres.
        reference_height_mm: z of the reference plane, millimetres.
        two_sided: whether front and back differ, and light passes.
        bounces: vertices of a path, at most.
    """

    name: str
    scene: str
    files: Mapping[str, bytes]
    size_mm: tuple[float, float]
    reference_height_mm: float
    two_sided: bool
    bounces: int


def is_tile_file(path: str | os.PathLike[str]) -> bool:
    """Whether a path is a TOML file that names a tile."""
    return has_field(path, _FIELD)


def load_tile(path: str | os.PathLike[str]) -> TileScene:
    """The tile of a file.

    Raises:
        InputError: no such file or scene, an unknown field, or a value that cannot be; it is named.
    """
    file = Path(path)
    with speaking_of(str(file)):
        fields = read_fields(file, _File)
        with speaking_of(f"tile = {shown(fields.tile)}"):
            scene_file = file.parent / fields.tile
            root = _read_scene(read_text(scene_file))
            files = _files_of(root, scene_file.parent)
            scene_text.put_spectra_in(root, lambda name: scene_file.parent / scene_text.require_inside(name))
            scene = _checked_text(root, files)
        width, length = fields.size_mm
        return TileScene(
            fields.name or file.stem,
            scene,
            files,
            (width, length),
            fields.reference_height_mm,
            fields.two_sided,
            fields.bounces,
        )


def _read_scene(text: str) -> ElementTree.Element:
    """The scene of a tile without what is not used of it: sensors, films and integrators."""
    root = scene_text.parsed_text(text)
    if root.tag != "scene":
        raise InputError(f"it is no Mitsuba scene: it begins with <{root.tag}>, not with <scene>.")
    scene_text.without(root, _UNUSED)
    return root


def _checked_text(root: ElementTree.Element, files: Collection[str]) -> str:
    """The text of a scene that reads `files` alone."""
    scene_text.require_closed(root, files)
    return ElementTree.tostring(root, encoding="unicode")


def _files_of(scene: ElementTree.Element, folder: Path) -> dict[str, bytes]:
    files: dict[str, bytes] = {}
    for node in scene_text.naming_files(scene):
        name = node.get("value", "")
        if name in files:
            continue
        file = folder / scene_text.require_inside(name)
        require_file(file)
        files[name] = file.read_bytes()
        if sum(map(len, files.values())) > _MAX_FILES:
            raise InputError(f"its files are larger than {_MAX_FILES >> 20} MiB.")
    return files


def tile_record(source: TileScene) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The record of a tile, as JSON, and the tensors beside it: the files of its scene."""
    record = _Record(
        name=source.name,
        scene=source.scene,
        size_mm=list(source.size_mm),
        reference_height_mm=source.reference_height_mm,
        two_sided=source.two_sided,
        bounces=source.bounces,
    )
    files = {_FILE + name: np.frombuffer(held, np.uint8).copy() for name, held in source.files.items()}
    return record.model_dump(), files


def tile_from_record(
    record: Mapping[str, Any], tensors: Mapping[str, NDArray[Any]], folder: str
) -> TileScene:
    """The tile of a record and its tensors; nothing else is read.

    Raises:
        ValidationError: another record than `tile_record` makes.
        InputError: files that do not lie in a scene's folder, or that are no bytes; a scene that could read
            others.
    """
    del folder
    header = _Record.model_validate(record)
    files = {}
    for key, values in tensors.items():
        name = key.removeprefix(_FILE)
        if values.dtype != np.uint8 or values.ndim != 1:
            raise InputError(f"the tensor source.{key} must hold bytes of a file.")
        files[scene_text.require_inside(name)] = values.tobytes()
    width, height = header.size_mm
    return TileScene(
        header.name,
        _checked_text(_read_scene(header.scene), files),
        files,
        (width, height),
        header.reference_height_mm,
        header.two_sided,
        header.bounces,
    )
