"""Height fields as sources: a height map with maps of albedo, roughness, metallicity and normals.

A height field file is TOML:

    height_map = "wool-height.png"     # 8 or 16 bits, or .exr; black is low; it repeats
    size_mm = [8.0, 8.0]               # of one repeat
    height_mm = 0.8                    # from black to white
    albedo = "wool-albedo.png"         # or a colour
    roughness = 0.6                    # or a picture
    metallic = 0.0                     # or a picture
    specular = 0.5                     # reflectance at normal incidence is 8 % of it
    normal_map = "wool-normal.png"     # optional, in the frame of the displaced surface

Pictures are found beside the file. Maps are stored with their first row at y = 0, the bottom of a picture.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field

from loomlight.core.colour import linear_to_srgb, parse_colour, srgb_to_linear
from loomlight.core.errors import InputError
from loomlight.core.images import read_map
from loomlight.core.sentences import shown, speaking_of
from loomlight.sources.toml_source import Lengths, SizedSource, SourceFields, has_field, read_fields

_Map = NDArray[np.float32]
_FIELD = "height_map"
_MAPS = {"height": 1, "albedo": 3, "roughness": 1, "metallic": 1, "normal": 3}
# Texels a side of a height map: nine copies of its triangles take a gigabyte.
_MAX_TEXELS = 1024


class _Record(BaseModel):
    """The header of a height field in a `.loom` file; its maps are tensors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)

    name: str
    size_mm: list[Annotated[float, Field(gt=0, le=1e6)]] = Field(min_length=2, max_length=2)
    height_mm: Annotated[float, Field(ge=0, le=1e6)]
    specular: Annotated[float, Field(ge=0, le=1)]


class _File(SourceFields):
    """The fields of a height field file."""

    noun = "a height field"
    expected: ClassVar[Mapping[str, str]] = {
        "height_map": "the name of a picture in quotes",
        "size_mm": "two lengths above 0, such as [8.0, 8.0]",
        "height_mm": "a length from 0, such as 0.8",
        "roughness": "a number from 0.01 to 1, or the name of a picture",
        "metallic": "a number from 0 to 1, or the name of a picture",
        "specular": "a number from 0 to 1",
        "normal_map": "the name of a picture in quotes",
    }

    height_map: str
    size_mm: Lengths
    height_mm: Annotated[float, Field(ge=0, le=1e6)]
    albedo: Any = 0.5
    roughness: Annotated[float, Field(ge=0.01, le=1)] | str = 0.6
    metallic: Annotated[float, Field(ge=0, le=1)] | str = 0.0
    specular: Annotated[float, Field(ge=0, le=1)] = 0.5
    normal_map: str | None = None


@dataclass(frozen=True, eq=False)
class Heightfield(SizedSource):
    """A displaced plane that repeats.

    Attributes:
        name: in messages.
        size_mm: width and height of a repeat, millimetres.
        height_mm: from the lowest value, 0, to the highest, 1, of the height map, millimetres.
        specular: 0 to 1; 8 % of it is reflected at normal incidence.
        height: 0 to 1 [rows, columns]; row 0 is at y = 0.
        albedo: linear RGB, 0 to 1 [rows, columns, 3]; 1 × 1 where it is one colour, as all that follow.
        roughness: of the principled BSDF, 0.01 to 1 [rows, columns].
        metallic: 0 to 1 [rows, columns].
        normal: of a normal map, 0 to 1 for −1 to 1 [rows, columns, 3]; None without one.
    """

    name: str
    size_mm: tuple[float, float]
    height_mm: float
    specular: float
    height: _Map
    albedo: _Map
    roughness: _Map
    metallic: _Map
    normal: _Map | None = None


def is_heightfield_file(path: str | os.PathLike[str]) -> bool:
    """Whether a path is a TOML file that names a height map."""
    return has_field(path, _FIELD)


def load_heightfield(path: str | os.PathLike[str]) -> Heightfield:
    """The height field of a file.

    Raises:
        InputError: no such file or picture, an unknown field, or a value that cannot be; it is named.
    """
    file = Path(path)
    with speaking_of(str(file)):
        fields = read_fields(file, _File)
        folder = file.parent
        height = _picture(folder, _FIELD, fields.height_map, 1)
        if max(height.shape[:2]) > _MAX_TEXELS:
            raise InputError(
                f"height_map = {shown(fields.height_map)} has {height.shape[1]} × {height.shape[0]} pixels: "
                f"at most {_MAX_TEXELS} a side can be traced."
            )
        width, length = fields.size_mm
        normal = fields.normal_map
        return Heightfield(
            fields.name or file.stem,
            (width, length),
            fields.height_mm,
            fields.specular,
            height[..., 0],
            _albedo(folder, fields.albedo),
            _number_map(folder, "roughness", fields.roughness).clip(0.01, 1),
            _number_map(folder, "metallic", fields.metallic),
            None if normal is None else _picture(folder, "normal_map", normal, 3),
        )


def _picture(folder: Path, field: str, name: str, channels: int) -> _Map:
    """Numbers of a picture [rows, columns, channels], 0 to 1, the bottom row first."""
    with speaking_of(f"{field} = {shown(name)}"):
        pixels = read_map(folder / name, channels)
    if not np.isfinite(pixels).all():
        raise InputError(f"{field} = {shown(name)} holds NaN or infinity.")
    return np.ascontiguousarray(pixels[::-1].clip(0, 1), np.float32)


def _albedo(folder: Path, value: object) -> _Map:
    if isinstance(value, str) and not value.startswith("#"):
        linear = srgb_to_linear(_picture(folder, "albedo", value, 3))
        return np.asarray(linear, np.float32)
    colour = [value] * 3 if isinstance(value, int | float) else value
    return np.asarray(parse_colour(colour, "albedo"), np.float32).reshape(1, 1, 3)


def _number_map(folder: Path, field: str, value: float | str) -> _Map:
    if isinstance(value, str):
        return _picture(folder, field, value, 1)[..., 0]
    return np.full((1, 1), value, np.float32)


def heightfield_record(source: Heightfield) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The record of a height field, as JSON, and the tensors beside it."""
    record = _Record(
        name=source.name, size_mm=list(source.size_mm), height_mm=source.height_mm, specular=source.specular
    )
    maps = {name: getattr(source, name) for name in _MAPS}
    return record.model_dump(), {name: _stored(map_) for name, map_ in maps.items() if map_ is not None}


def _stored(values: _Map) -> NDArray[Any]:
    """A map as its pixels, of 16 bits or bytes of sRGB, if it is made of those."""
    numbers, colours = 65535 * values, 255 * linear_to_srgb(values)
    for codes in (np.rint(numbers).astype(np.uint16), np.rint(colours).astype(np.uint8)):
        if np.array_equal(_read(codes), values):
            return codes
    return values


def _read(stored: NDArray[Any]) -> NDArray[Any]:
    """The map of `_stored`."""
    if stored.dtype == np.uint8:
        return np.asarray(srgb_to_linear(stored.astype(np.float32) / 255), np.float32)
    return (stored / 65535).astype(np.float32) if stored.dtype == np.uint16 else stored


def heightfield_from_record(
    record: Mapping[str, Any], tensors: Mapping[str, NDArray[Any]], folder: str
) -> Heightfield:
    """The height field of a record and its tensors; nothing else is read.

    Raises:
        ValidationError: another record than `heightfield_record` makes.
        InputError: tensors that make no height field; the message names the one at fault.
    """
    del folder
    header = _Record.model_validate(record)
    maps: dict[str, Any] = {"normal": None}
    for name, channels in _MAPS.items():
        if name not in tensors and name == "normal":
            continue
        values = _read(tensors[name]) if name in tensors else None
        shape = 2 if channels == 1 else 3
        if values is None or values.dtype != np.float32 or values.ndim != shape or values.size == 0:
            raise InputError(f"the tensor source.{name} must hold a map of float32 numbers.")
        if (channels == 3 and values.shape[2] != 3) or not ((values >= 0) & (values <= 1)).all():
            raise InputError(f"the tensor source.{name} must hold {channels} numbers from 0 to 1 a texel.")
        maps[name] = values
    width, height = header.size_mm
    return Heightfield(header.name, (width, height), header.height_mm, header.specular, **maps)
