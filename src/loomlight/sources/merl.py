"""Measured isotropic BRDFs as sources: a MERL file (Matusik et al. 2003), or a folder of them.

A `.binary` file is three int32, 90 90 180, then doubles: red, green and blue one after another, each over the
half vector's angle θ_h, the difference vector's angle θ_d and its azimuth φ_d (Rusinkiewicz 1998), φ_d
fastest. Bins of θ_h are finer towards the highlight: bin i begins at (i/90)²·90°. Red is stored times 1500,
green times 1500/1.15, blue times 1500/1.66; values below 0 mark what was not measured and are read as 0.

A folder is a library: its BRDFs stand in a grid over uv, in the order of their names, one a cell. Their
values are kept in half precision, 8.7 MB a BRDF.
"""

from __future__ import annotations

import hashlib
import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field

from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.core.sentences import speaking_of

_Floats = NDArray[np.float32]
_Halves = NDArray[np.float16]

SUFFIX = ".binary"
# Bins of θ_h, θ_d and φ_d.
BINS = (90, 90, 180)
_COUNT = math.prod(BINS)
SCALES = np.array([1 / 1500, 1.15 / 1500, 1.66 / 1500])
FILE_BYTES = 12 + 3 * 8 * _COUNT
MAX_BRDFS = 100
# A `.loom` holds the values of so many; of a larger library, a gigabyte, the names and checksums alone.
MAX_STORED = 8
_CELL_MM = 25.0
_MAX_HALF = 65504.0
_MIN_COSINE = 1e-4
# Stored numbers beyond it are no reflectance, and would overflow float32.
_MAX_STORED = 1e12


class _Record(BaseModel):
    """The header of a library in a `.loom` file; values are tensors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)

    name: str
    names: Annotated[list[str], Field(min_length=1, max_length=MAX_BRDFS)]
    sha256: list[str]


@dataclass(frozen=True, eq=False)
class MerlLibrary:
    """Isotropic BRDFs in a grid over uv.

    Attributes:
        name: in messages.
        names: of the BRDFs.
        values: f, linear RGB, 1/sr [BRDFs, θ_h, θ_d, φ_d, 3]; None of a library that a `.loom` only names.
        sha256: of each BRDF's values, as hexadecimal text.
    """

    name: str
    names: tuple[str, ...]
    values: _Halves | None
    sha256: tuple[str, ...]

    @property
    def grid(self) -> tuple[int, int]:
        """Columns and rows, powers of two; the BRDFs begin anew in the cells that are left over."""
        bits = math.ceil(math.log2(len(self.names)))
        return 1 << -(-bits // 2), 1 << bits // 2

    @property
    def repeat_mm(self) -> tuple[float, float]:
        """Width and height of the grid, millimetres."""
        columns, rows = self.grid
        return _CELL_MM * columns, _CELL_MM * rows

    @property
    def default_uv_size_mm(self) -> tuple[float, float]:
        """The same: uv from 0 to 1 shows the whole grid."""
        return self.repeat_mm

    def numbers_at(self, positions: _Floats) -> NDArray[np.intp]:
        """Indices of the BRDFs at positions [n, 2] of uv."""
        columns, rows = self.grid
        column = np.floor(positions[:, 0] * columns).astype(np.intp) % columns
        row = np.floor(positions[:, 1] * rows).astype(np.intp) % rows
        return (row * columns + column) % len(self.names)

    def evaluate(self, numbers: NDArray[np.intp], lights: _Floats, views: _Floats) -> _Floats:
        """f·cos [n, 3] of BRDFs by their index, linear between bins; 0 below the horizon.

        Raises:
            InputError: the values of this library are not at hand.
        """
        if self.values is None:
            raise InputError(
                f"{self.name} is a library of {len(self.names)} BRDFs, which a .loom only names: "
                "give its folder."
            )
        total = np.zeros((len(numbers), 3), np.float32)
        places = _places(lights, views)
        for corner in range(8):
            index, weight = [], np.ones(len(numbers), np.float32)
            for axis, (low, high, part) in enumerate(places):
                upper = corner >> axis & 1
                index.append(high if upper else low)
                weight = weight * (part if upper else 1 - part)
            total += weight[:, None] * self.values[numbers, index[0], index[1], index[2]].astype(np.float32)
        above = (lights[:, 2] > 0) & (views[:, 2] > 0)
        return np.where(above, lights[:, 2], 0)[:, None].astype(np.float32) * total


def is_merl_file(path: str | os.PathLike[str]) -> bool:
    """Whether a path is a `.binary` file, or a folder that holds some."""
    file = Path(path)
    if file.suffix.lower() == SUFFIX:
        return True
    return file.is_dir() and next(file.glob(f"*{SUFFIX}"), None) is not None


def load_merl(path: str | os.PathLike[str]) -> MerlLibrary:
    """The BRDF of a file, or those of a folder.

    Raises:
        InputError: no such file, a truncated one or another format; more than 100 in a folder.
    """
    file = Path(path)
    files = sorted(file.glob(f"*{SUFFIX}")) if file.is_dir() else [file]
    if not files:
        raise InputError(f"{file} holds no {SUFFIX} file.")
    if len(files) > MAX_BRDFS:
        raise InputError(f"{file} holds {len(files)} {SUFFIX} files: a library has at most {MAX_BRDFS}.")
    values = np.empty((len(files), *BINS, 3), np.float16)
    for number, each in enumerate(files):
        values[number] = np.clip(read_merl(each), 0, _MAX_HALF)
    return library_of(file.stem, [each.stem for each in files], values)


def library_of(name: str, names: Sequence[str], values: _Halves) -> MerlLibrary:
    """The library of BRDFs' values [BRDFs, θ_h, θ_d, φ_d, 3]."""
    digests = (hashlib.sha256(part.tobytes()).hexdigest() for part in values)
    return MerlLibrary(name, tuple(names), values, tuple(digests))


def read_merl(path: str | os.PathLike[str]) -> _Floats:
    """f, linear RGB, 1/sr, of a file [θ_h, θ_d, φ_d, 3].

    Raises:
        InputError: no such file, a truncated one, another format, NaN, or numbers that are far too large.
    """
    require_file(path)
    file = Path(path)
    with speaking_of(str(file)):
        with file.open("rb") as stream:
            if stream.read(12) != np.array(BINS, "<i4").tobytes():
                raise InputError(f"it is no MERL file: one begins with the dimensions {BINS}.")
            size = file.stat().st_size
            if size != FILE_BYTES:
                fault = "truncated" if size < FILE_BYTES else "too long"
                raise InputError(f"it is {fault}: a MERL file has {FILE_BYTES} bytes, it has {size}.")
            stored = np.fromfile(stream, np.dtype("<f8"))
        # NaN compares as false.
        if not (np.abs(stored) <= _MAX_STORED).all():
            raise InputError("it holds NaN, infinity or numbers that no reflectance has: download it again.")
        planes = stored.reshape(3, *BINS).astype(np.float32)
        return np.maximum(np.moveaxis(planes, 0, -1) * SCALES.astype(np.float32), 0)


def merl_record(source: MerlLibrary) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The record of a library, as JSON, and its values where there are few."""
    record = _Record(name=source.name, names=list(source.names), sha256=list(source.sha256))
    stored = source.values is not None and len(source.names) <= MAX_STORED
    return record.model_dump(), {"values": source.values} if stored and source.values is not None else {}


def merl_from_record(
    record: Mapping[str, Any], tensors: Mapping[str, NDArray[Any]], folder: str
) -> MerlLibrary:
    """The library of a record and its tensor; nothing else is read.

    Raises:
        ValidationError: another record than `merl_record` makes.
        InputError: a tensor that is missing or of another kind.
    """
    del folder
    header = _Record.model_validate(record)
    values = tensors.get("values")
    wanted = (len(header.names), *BINS, 3)
    if values is None and len(header.names) <= MAX_STORED:
        raise InputError("the tensor source.values is missing: bake the file again.")
    if values is not None and (values.dtype != np.float16 or values.shape != wanted):
        raise InputError(f"the tensor source.values must be {list(wanted)} float16.")
    return MerlLibrary(header.name, tuple(header.names), values, tuple(header.sha256))


_Place = tuple[NDArray[np.intp], NDArray[np.intp], _Floats]


def _places(lights: _Floats, views: _Floats) -> tuple[_Place, _Place, _Place]:
    """Bins below and above each query along θ_h, θ_d and φ_d, and the share of the upper one."""
    light, view = lights.astype(np.float64), views.astype(np.float64)
    half = light + view
    half /= np.maximum(np.linalg.norm(half, axis=1, keepdims=True), _MIN_COSINE)
    theta_h = np.arccos(np.clip(half[:, 2], -1, 1))
    azimuth = np.arctan2(half[:, 1], half[:, 0])
    x = np.cos(azimuth) * light[:, 0] + np.sin(azimuth) * light[:, 1]
    y = np.cos(azimuth) * light[:, 1] - np.sin(azimuth) * light[:, 0]
    x, z = (
        np.cos(theta_h) * x - np.sin(theta_h) * light[:, 2],
        np.sin(theta_h) * x + np.cos(theta_h) * light[:, 2],
    )
    theta_d, phi_d = np.arccos(np.clip(z, -1, 1)), np.arctan2(y, x) % math.pi
    right = math.pi / 2
    return (
        _between(np.sqrt(theta_h / right) * BINS[0], BINS[0], False),
        _between(theta_d / right * BINS[1], BINS[1], False),
        _between(phi_d / math.pi * BINS[2], BINS[2], True),
    )


def _between(place: NDArray[np.float64], count: int, wraps: bool) -> _Place:
    """The bins whose middles a place lies between."""
    low = np.floor(place - 0.5)
    part = (place - 0.5 - low).astype(np.float32)
    below, above = low.astype(np.intp), low.astype(np.intp) + 1
    if wraps:
        return below % count, above % count, part
    return below.clip(0, count - 1), above.clip(0, count - 1), part
