"""PLY files, ASCII and binary: polygons with uv of vertices or of corners.

A header's counts are compared with the file's size before anything is allocated, which plyfile does not do.
"""

from __future__ import annotations

import re
import struct
import warnings
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.mesh.cloth_mesh import (
    ClothMesh,
    MeshPart,
    check_indices,
    strip_triangles,
    triangulate,
    vertex_normals,
)

_TYPES = {
    **dict.fromkeys(("char", "int8"), "i1"), **dict.fromkeys(("uchar", "uint8"), "u1"),
    **dict.fromkeys(("short", "int16"), "i2"), **dict.fromkeys(("ushort", "uint16"), "u2"),
    **dict.fromkeys(("int", "int32"), "i4"), **dict.fromkeys(("uint", "uint32"), "u4"),
    **dict.fromkeys(("float", "float32"), "f4"), **dict.fromkeys(("double", "float64"), "f8"),
}  # fmt: skip
_ORDERS = {"ascii": "<", "binary_little_endian": "<", "binary_big_endian": ">"}
_UV = (("u", "v"), ("s", "t"), ("texture_u", "texture_v"), ("texture_s", "texture_t"))
_END = re.compile(rb"(?:^|\n)end_header[ \t]*\r?\n")


@dataclass(eq=False)
class _Element:
    """Rows of a kind.

    Attributes:
        count: of rows.
        properties: type of the length of a list ("" of a single number), type of a number, and name.
    """

    name: str
    count: int
    properties: list[tuple[str, str, str]] = field(default_factory=list)


@dataclass(frozen=True, eq=False)
class _Lists:
    """A property of lists: their lengths [rows], and all numbers, one list after the other."""

    lengths: NDArray[np.int64]
    values: NDArray[np.float64]


_Columns = dict[str, "NDArray[np.float64] | _Lists"]


def read_ply(file: Path) -> list[MeshPart]:
    """The one part of a PLY file; its uv are NaN where faces have none.

    Raises:
        InputError: a damaged header, rows that are cut off, or an index out of range.
    """
    rows = _elements(file)
    vertices, faces = rows.get("vertex", {}), rows.get("face", {})
    positions = _together(vertices, ("x", "y", "z"))
    if positions is None:
        raise InputError(f"{file} is damaged: its vertices have no x, y and z.")
    normals = _together(vertices, ("nx", "ny", "nz"))
    uv = next((found for names in _UV if (found := _together(vertices, names)) is not None), np.zeros((0, 2)))
    corners = next((faces[name] for name in ("vertex_indices", "vertex_index") if name in faces), None)
    of_corners = faces.get("texcoord")
    triangles = _strips(rows.get("tristrips", {}))
    check_indices(triangles, len(positions), str(file))
    if isinstance(corners, _Lists):
        named = corners.values.astype(np.int64)
        check_indices(named, len(positions), str(file))
        cut = triangulate(positions, named, corners.lengths)
        if len(uv) == 0 and len(triangles) == 0 and isinstance(of_corners, _Lists):
            normals = vertex_normals(positions, named[cut]) if normals is None else normals
            uv = _uv_of_corners(corners.lengths, of_corners)
            positions, normals, triangles = positions[named], normals[named], cut
        else:
            triangles = np.concatenate([triangles, named[cut]])
    mesh = ClothMesh(positions, np.zeros((0, 3)) if normals is None else normals, uv, triangles, str(file))
    return [MeshPart("", "", mesh)]


def _elements(file: Path) -> dict[str, _Columns]:
    content = file.read_bytes()
    end = _END.search(content)
    if not content.startswith(b"ply") or end is None:
        raise InputError(f'{file} is no PLY file: it has no header from "ply" to "end_header".')
    form, elements = _header(content[: end.start()].decode("ascii", "replace"), file)
    data = content[end.end() :]
    if form == "ascii":
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error")  # of NumPy before 2.4
                data = np.fromstring(data, dtype="<f8", sep=" ").tobytes()
        except (DeprecationWarning, ValueError) as error:
            raise InputError(f"{file} is damaged: what follows its header is no list of numbers.") from error
    rows: dict[str, _Columns] = {}
    offset = 0
    for element in elements:
        columns, offset = _rows(element, data, offset, _ORDERS[form], file)
        rows.setdefault(element.name, columns)
    return rows


def _header(text: str, file: Path) -> tuple[str, list[_Element]]:
    form, elements = "", []
    for line in text.splitlines()[1:]:
        match line.split():
            case ["format", str() as word, *_] if word in _ORDERS:
                form = word
            case ["element", name, count] if count.isascii() and count.isdigit() and len(count) < 16:
                elements.append(_Element(name, int(count)))
            case ["property", "list", length, kind, name] if (
                elements and _TYPES.get(length, "f")[0] in "iu" and kind in _TYPES
            ):
                elements[-1].properties.append((_TYPES[length], _TYPES[kind], name))
            case ["property", kind, name] if elements and kind in _TYPES:
                elements[-1].properties.append(("", _TYPES[kind], name))
            case ["comment" | "obj_info", *_] | []:
                pass
            case _:
                raise InputError(f'{file} is damaged: its header holds the line "{line[:80]}".')
    if not form:
        raise InputError(f"{file} is damaged: its header names no format of PLY, such as ascii.")
    if form == "ascii":  # numbers of text are held as doubles
        for element in elements:
            lists = [(length and "f8", name) for length, _, name in element.properties]
            element.properties = [(length, "f8", name) for length, name in lists]
    return form, elements


def _rows(element: _Element, data: bytes, offset: int, order: str, file: Path) -> tuple[_Columns, int]:
    """The columns of an element, and where the next one begins."""
    smallest = sum(np.dtype(length or kind).itemsize for length, kind, _ in element.properties)
    if not smallest or element.count == 0:
        return {}, offset
    if element.count * smallest > len(data) - offset:
        raise _cut_off(element, file)
    starts, lengths, end = _walk(element, data, offset, order, 1, file)
    size = end - offset
    like_first = element.count * size <= len(data) - offset
    for (length, _, _), start, count in zip(element.properties, starts[0], lengths[0], strict=True):
        if like_first and length:
            at = int(start) - np.dtype(length).itemsize
            like_first = bool((np.ndarray(element.count, order + length, data, at, size) == count).all())
    if like_first:
        end = offset + element.count * size
    else:
        starts, lengths, end = _walk(element, data, offset, order, element.count, file)
    columns: _Columns = {}
    for number, (length, kind, name) in enumerate(element.properties):
        width, counts = np.dtype(kind).itemsize, lengths[:, number]
        if like_first:
            shape = element.count, int(counts[0])
            values = np.ndarray(shape, order + kind, data, int(starts[0, number]), (size, width)).ravel()
            counts = np.full(element.count, counts[0])
        else:
            within = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
            at = np.repeat(starts[:, number], counts) + width * within
            values = np.frombuffer(data, np.uint8)[at[:, None] + np.arange(width)].view(order + kind).ravel()
        numbers = values.astype(np.float64)
        columns[name] = _Lists(counts, numbers) if length else numbers
    return columns, end


def _walk(
    element: _Element, data: bytes, offset: int, order: str, rows: int, file: Path
) -> tuple[NDArray[np.int64], NDArray[np.int64], int]:
    """Where the numbers of each property begin [rows, properties], how many they are, and the rows' end."""
    readers = [
        (struct.Struct(order + np.dtype(length).char) if length else None, np.dtype(kind).itemsize)
        for length, kind, _ in element.properties
    ]
    starts, lengths = [], []
    try:
        for _ in range(rows):
            for reader, width in readers:
                count = 1
                if reader is not None:
                    count = int(reader.unpack_from(data, offset)[0])
                    offset += reader.size
                starts.append(offset)
                lengths.append(count)
                offset += count * width
                if count < 0 or offset > len(data):
                    raise _cut_off(element, file)
    except (struct.error, ValueError, OverflowError) as error:  # a length that is cut off, or no number
        raise _cut_off(element, file) from error
    shape = rows, len(readers)
    return np.array(starts).reshape(shape), np.array(lengths).reshape(shape), offset


def _cut_off(element: _Element, file: Path) -> InputError:
    return InputError(
        f'{file} is cut off or damaged: it holds fewer than {element.count} rows of "{element.name[:40]}", '
        "or their lists are longer than the file; copy or export it anew."
    )


def _together(columns: _Columns, names: tuple[str, ...]) -> NDArray[np.float64] | None:
    """Single numbers side by side [n, len(names)]; None if one is missing."""
    found = [columns.get(name) for name in names]
    arrays = [column for column in found if isinstance(column, np.ndarray)]
    return np.stack(arrays, axis=1) if len(arrays) == len(names) else None


def _uv_of_corners(lengths: NDArray[np.int64], given: _Lists) -> NDArray[np.float64]:
    """uv of each corner, NaN of faces that do not have two numbers a corner."""
    uv = np.full((lengths.sum(), 2), np.nan)
    whole = given.lengths == 2 * lengths
    uv[np.repeat(whole, lengths)] = given.values[np.repeat(whole, given.lengths)].reshape(-1, 2)
    return uv


def _strips(columns: _Columns) -> NDArray[np.int64]:
    """The triangles of "tristrips", in which -1 ends a strip."""
    lists = columns.get("vertex_indices")
    if not isinstance(lists, _Lists):
        return np.zeros((0, 3), np.int64)
    ends = np.cumsum(lists.lengths)[:-1]
    strips = [piece for strip in np.split(lists.values.astype(np.int64), ends) for piece in _unbroken(strip)]
    return np.concatenate([strip_triangles(strip) for strip in strips])


def _unbroken(strip: NDArray[np.int64]) -> list[NDArray[np.int64]]:
    return [piece[piece != -1] for piece in np.split(strip, np.flatnonzero(strip == -1))]
