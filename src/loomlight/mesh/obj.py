"""Wavefront OBJ files: polygons in objects, groups and materials.

Lines of one kind are parsed together by numpy, so that a million faces take seconds. trimesh's reader was no
choice: it loses which faces have no uv, relative indices and concave shapes.
"""

from __future__ import annotations

import codecs
import hashlib
import re
import warnings
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.mesh.cloth_mesh import (
    INDEX,
    MAX_PARTS,
    ClothMesh,
    MeshPart,
    distinct_rows,
    triangulate,
    vertex_normals,
)

_CONTINUED = re.compile(r"\\[ \t]*\n")
# A slash with nothing behind it: "7//2" and "7/" name no uv.
_EMPTY = re.compile(rb"/(?=[/ \n])")
_FACE = re.compile(r"(\s*-?\d+(/(-?\d+)?){0,2}(?=\s|$))*\s*(#.*)?")
# What the three numbers of a face's corner count.
_VALUES = {"v": ("vertex", 3), "vt": ("texture vertex", 2), "vn": ("normal", 3)}


@dataclass(eq=False)
class _Lines:
    """The lines of a file by their keyword, which is left out.

    Attributes:
        values: of "v", "vt" and "vn".
        faces: of "f".
        defined: the number of a face, and how many lines of each of `values` stand before it and those after.
        parts: the number of a face, and the name and material from there on.
    """

    values: dict[str, list[str]] = field(default_factory=lambda: {kind: [] for kind in _VALUES})
    faces: list[str] = field(default_factory=list)
    defined: list[tuple[int, ...]] = field(default_factory=list)
    parts: list[tuple[int, str, str]] = field(default_factory=lambda: [(0, "", "")])


def read_obj(file: Path) -> list[MeshPart]:
    """A part for each pair of a name (of the last object or group) and a material.

    uv are NaN where faces have none; the attribute "index" counts lines "v".

    Raises:
        InputError: a line that cannot be read, or an index out of range.
    """
    lines = _lines_of(file)
    values = {kind: _numbers(found, kind, file) for kind, found in lines.values.items()}
    counts, corners = _corners(lines, [len(rows) for rows in values.values()], file)
    # v runs upwards in the file. The last row is that of corners that name none.
    uv = np.concatenate([values["vt"] * [1, -1] + [0, 1], [[np.nan, np.nan]]])
    normals = np.concatenate([values["vn"], [[0, 0, 0]]])
    triangles = triangulate(values["v"], corners[:, 0], counts)
    smooth = vertex_normals(values["v"], corners[triangles, 0]) if (corners[:, 2] < 0).any() else None
    keys = {key: number for number, key in enumerate(dict.fromkeys(part[1:] for part in lines.parts))}
    starts, key_of_part = (
        np.array(column) for column in zip(*((p[0], keys[p[1:]]) for p in lines.parts), strict=True)
    )
    face = np.repeat(np.arange(len(counts)), counts)[triangles[:, 0]]
    key = key_of_part[np.searchsorted(starts, face, side="right") - 1]
    parts = []
    order = np.argsort(key, kind="stable")
    pieces = np.split(order, np.searchsorted(key[order], np.arange(1, len(keys))))
    if sum(len(piece) > 0 for piece in pieces) > MAX_PARTS:
        raise InputError(f"{file} has more than {MAX_PARTS} parts (o, g, usemtl): join some.")
    for (name, material), piece in zip(keys, pieces, strict=True):
        if len(piece) == 0:
            continue
        found = corners[triangles[piece].ravel()]
        at, inverse = distinct_rows(found)
        rows = found[at]
        own = normals[rows[:, 2]]
        if smooth is not None:
            own = np.where(rows[:, 2:] < 0, smooth[rows[:, 0]], own)
        mesh = ClothMesh(values["v"][rows[:, 0]], own, uv[rows[:, 1]], inverse.reshape(-1, 3), str(file))
        mesh = replace(mesh, attributes={INDEX: rows[:, :1].astype(np.float64)})
        parts.append(MeshPart(name, material, mesh))
    return parts


def read_obj_rows(file: Path) -> tuple[NDArray[np.float64], bytes]:
    """The positions of all lines "v" [n, 3], and a hash of the faces; quicker than the parts.

    Raises:
        InputError: a line "v" that cannot be read.
    """
    lines = _lines_of(file)
    return _numbers(lines.values["v"], "v", file), hashlib.sha256("\n".join(lines.faces).encode()).digest()


def _lines_of(file: Path) -> _Lines:
    content = file.read_bytes()
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        raise InputError(f"{file} is UTF-16 text: save it as UTF-8.")
    lines = _lines(content.decode("utf-8-sig", errors="replace"))
    if not lines.faces:
        raise InputError(f"{file} holds no triangles: it has no faces.")
    return lines


def _lines(text: str) -> _Lines:
    text = _CONTINUED.sub(" ", text.replace("\r\n", "\n").replace("\r", "\n")).replace("\t", " ")
    found = _Lines()
    values, faces = found.values, found.faces
    name, material, fresh = "", "", True
    for line in text.split("\n"):
        kind, _, rest = line.partition(" ")
        if not kind:
            kind, _, rest = line.strip().partition(" ")
        if kind == "f":
            if fresh:
                found.defined.append((len(faces), *(len(rows) for rows in values.values())))
                fresh = False
            faces.append(rest)
        elif kind in values:
            values[kind].append(rest)
            fresh = True
        elif kind in ("o", "g", "usemtl"):
            if kind == "usemtl":
                material = rest.strip()
            else:
                name = rest.strip()
            found.parts.append((len(faces), name, material))
    return found


def _numbers(lines: list[str], kind: str, file: Path) -> NDArray[np.float64]:
    _, width = _VALUES[kind]
    if not lines:
        return np.zeros((0, width))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # of lines without any number
            rows = np.loadtxt(lines, usecols=range(width), ndmin=2)
        if len(rows) == len(lines):  # lines without any number are skipped
            return rows
    except (UserWarning, ValueError):
        pass
    for number, line in enumerate(lines, 1):
        try:
            complete = len([float(word) for word in line.partition("#")[0].split()[:width]]) == width
        except ValueError:
            complete = False
        if not complete:
            raise InputError(
                f'{file} is damaged: line {number} of those that begin with "{kind}" goes on with '
                f'"{line[:60]}", which is no {width} numbers.'
            )
    raise InputError(f'{file} is damaged: its lines that begin with "{kind}" hold more than numbers.')


def _corners(lines: _Lines, sizes: list[int], file: Path) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Corners of each face, and the rows of v, vt and vn that each corner names [n, 3], -1 for none."""
    text = ("\n".join(lines.faces) + "\n").encode("ascii", "replace")
    text = _EMPTY.sub(b"/0", re.sub(rb"#[^\n]*", b"", text) if b"#" in text else text)
    code = np.frombuffer(text, np.uint8)
    blank = code <= 32
    begins = np.flatnonzero(~blank & np.concatenate([[True], blank[:-1]]))
    slashes = np.searchsorted(begins, np.flatnonzero(code == ord("/")), side="right") - 1
    widths = 1 + np.bincount(slashes, minlength=len(begins))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # of NumPy before 2.4
            numbers = np.fromstring(text.replace(b"/", b" "), dtype=np.int64, sep=" ")
    except (DeprecationWarning, ValueError):
        numbers = np.zeros(0, np.int64)
    if len(numbers) != widths.sum() or widths.max(initial=1) > 3:
        number, line = next(
            ((n, line) for n, line in enumerate(lines.faces, 1) if not _FACE.fullmatch(line)),
            (1, lines.faces[0]),
        )
        raise InputError(
            f'{file} is damaged: face {number} is "{line[:60]}", which is no list of corners such as 1/1/1.'
        )
    face = np.searchsorted(np.flatnonzero(code == ord("\n")), begins)
    firsts, befores = (
        np.array([mark[0] for mark in lines.defined]),
        np.array(lines.defined).reshape(-1, 4)[:, 1:],
    )
    corners = np.full((len(begins), 3), -1)
    for column, ((kind, _), size) in enumerate(zip(_VALUES.values(), sizes, strict=True)):
        has = np.flatnonzero(widths > column)
        index = numbers[(np.cumsum(widths) - widths)[has] + column]
        relative = index < 0
        index[~relative] -= 1
        index[relative] += befores[np.searchsorted(firsts, face[has[relative]], side="right") - 1, column]
        # 0 stands for none, except for the vertex itself.
        wrong = (index >= size) | (index < (0 if column == 0 else -1)) | relative & (index < 0)
        if wrong.any():
            at = np.flatnonzero(wrong)[0]
            raise InputError(
                f'{file} is damaged: face {face[has[at]] + 1}, "{lines.faces[face[has[at]]][:60]}", '
                f"names a {kind} that is not there; there are {size}."
            )
        corners[has, column] = index
    return np.bincount(face, minlength=len(lines.faces)), corners
