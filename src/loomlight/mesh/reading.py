"""Mesh files, read in parts, at rest or at a time: OBJ, PLY, glTF, GLB and USD.

uv follow Mitsuba's bitmaps, v running down the image: OBJ's and USD's v is turned over, glTF's is kept, PLY's
is taken as it is written, as Mitsuba's `obj` and `ply` plugins do.
"""

from __future__ import annotations

import hashlib
import os
import re
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError, LoomlightError, LoomlightWarning
from loomlight.core.files import require_file
from loomlight.mesh.cloth_mesh import INDEX, MAX_COORDINATE, ClothMesh, MeshPart, cleaned, collapses, joined
from loomlight.mesh.file_camera import FileCamera
from loomlight.mesh.gltf import gltf_cameras, gltf_frames, read_gltf
from loomlight.mesh.obj import read_obj, read_obj_rows
from loomlight.mesh.picture_places import FILE_UV
from loomlight.mesh.ply import read_ply
from loomlight.mesh.usd import SUFFIXES as USD_SUFFIXES
from loomlight.mesh.usd_worker import read_usd, usd_cameras, usd_frames


@dataclass(frozen=True)
class _Format:
    """The readers of a file: its parts and cameras at a time or at rest (None), and times of its frames."""

    parts: Callable[[Path, float | None], list[MeshPart]]
    cameras: Callable[[Path, float | None], list[FileCamera]] = lambda file, time: []
    frames: Callable[[Path], list[float]] = lambda file: []


_GLTF = _Format(read_gltf, gltf_cameras, gltf_frames)
_USD = _Format(read_usd, usd_cameras, usd_frames)
_FORMATS = {
    ".obj": _Format(lambda file, time: read_obj(file)),
    ".ply": _Format(lambda file, time: read_ply(file)),
    ".gltf": _GLTF,
    ".glb": _GLTF,
    **dict.fromkeys(USD_SUFFIXES, _USD),
}
SUFFIXES = tuple(_FORMATS)
T = TypeVar("T")
_WILD = re.compile(r"[*?\[]")


def is_mesh(path: str | os.PathLike[str]) -> bool:
    """Whether a path ends as meshes do that can be read."""
    return Path(path).suffix.lower() in SUFFIXES


def is_pattern(mesh: str | os.PathLike[str]) -> bool:
    """Whether a path stands for many files, as "frames/*.obj" does, and is no file itself."""
    return bool(_WILD.search(os.fspath(mesh))) and not os.path.lexists(mesh)


def read_parts(path: str | os.PathLike[str], time: float | None = None) -> list[MeshPart]:
    """The parts of a mesh file, in its order.

    Their attribute "index" says which row of the file a vertex has its position of. Triangles without an area
    are left out. Those of a part that have no uv become a part of their own, of the same name, which follows
    it. A warning says how many triangles have no uv, if others have.

    Args:
        time: seconds from the start of the file's animation, held beyond its ends; None for what the file
            has at rest, as it does for files that do not move.

    Raises:
        InputError: no such file, another suffix, a damaged file, or no triangles.
        MissingDependencyError: the file is compressed or USD, and what decodes it is not installed.
    """
    file = Path(path)
    with np.errstate(all="ignore"):  # of numbers that are then refused
        parts = [made for part in _raw_parts(file, time) for made in _pieces(part)]
    if not parts:
        raise InputError(f"{file} holds no triangles that have an area.")
    bare = [part for part in parts if len(part.mesh.uv) == 0]
    if bare and len(bare) < len(parts):
        warnings.warn(_uncovered(file, bare, parts), LoomlightWarning, stacklevel=2)
    return parts


def frame_times(path: str | os.PathLike[str]) -> list[float]:
    """The times of a file's frames, for `read_parts`: seconds from the start; [] where nothing moves.

    Raises:
        InputError, MissingDependencyError: what `read_parts` raises.
    """
    file = Path(path)
    return _read(file, lambda of: of.frames(file))


def read_cameras(path: str | os.PathLike[str], time: float | None = None) -> list[FileCamera]:
    """The cameras of a file, in its order; those of OBJ and PLY are none.

    Raises:
        InputError, MissingDependencyError: what `read_parts` raises.
    """
    file = Path(path)
    with np.errstate(all="ignore"):
        return _read(file, lambda of: of.cameras(file, time))


def read_mesh(path: str | os.PathLike[str]) -> ClothMesh:
    """Every triangle with uv of a mesh file as one mesh; missing normals are computed.

    Raises:
        InputError: what `read_parts` raises, or no usable uv.
    """
    covered = [part.mesh for part in read_parts(path) if len(part.mesh.uv)]
    if not covered:
        raise InputError(
            f"{path} has no uv coordinates, or they collapse to lines or points; unwrap it first."
        )
    return joined(covered)


def read_rows(path: str | os.PathLike[str], time: float | None = None) -> tuple[NDArray[np.float64], bytes]:
    """The positions of a file's rows [n, 3], which "index" counts, and a hash that equal faces share.

    Args:
        time: as `read_parts` takes it.

    Raises:
        InputError, MissingDependencyError: what `read_parts` raises.
    """
    file = Path(path)
    if file.suffix.lower() == ".obj":
        return _read(file, lambda of: read_obj_rows(file))
    parts = _raw_parts(file, time)
    faces = hashlib.sha256(_triangles(parts).tobytes()).digest()
    return np.concatenate([part.mesh.positions for part in parts]), faces


def read_triangles(path: str | os.PathLike[str], time: float | None = None) -> NDArray[np.int64]:
    """All triangles [m, 3] of a file, as rows that "index" counts.

    Args:
        time: as `read_parts` takes it.

    Raises:
        InputError, MissingDependencyError: what `read_parts` raises.
    """
    return _triangles(_raw_parts(Path(path), time))


def _triangles(parts: list[MeshPart]) -> NDArray[np.int64]:
    rows = [part.mesh.attributes[INDEX][part.mesh.triangles, 0] for part in parts]
    return np.concatenate(rows).astype(np.int64)


def _raw_parts(file: Path, time: float | None) -> list[MeshPart]:
    """The parts as their reader has them, with "index"."""
    parts, first = [], 0
    with np.errstate(all="ignore"):  # of numbers that are then refused
        raw = _read(file, lambda of: of.parts(file, time))
    for part in raw:
        mesh, count = part.mesh, len(part.mesh.positions)
        if INDEX not in mesh.attributes:
            rows = np.arange(first, first + count, dtype=np.float64)[:, None]
            mesh = replace(mesh, attributes={**mesh.attributes, INDEX: rows})
        first += count
        parts.append(replace(part, mesh=mesh))
    return parts


def _read(file: Path, what: Callable[[_Format], T]) -> T:
    suffix = file.suffix.lower()
    if is_pattern(file):
        raise InputError(
            f"{file} stands for several meshes, frames of one that moves; one alone is shown here."
        )
    if suffix not in _FORMATS:
        raise InputError(f"{file}: meshes are read from {', '.join(SUFFIXES)} files.")
    require_file(file)
    if file.stat().st_size == 0:
        raise InputError(f"{file} is empty: it holds no mesh.")
    try:
        return what(_FORMATS[suffix])
    except LoomlightError:
        raise
    except OSError as error:
        raise InputError(f"{file} cannot be read: {error.strerror or error}.") from error
    except Exception as error:  # whatever damage the readers did not foresee
        reason = " ".join(f"{type(error).__name__}: {error}".split())[:120]
        raise InputError(f"{file} is damaged or no {suffix[1:]} mesh ({reason}).") from error


def _uncovered(file: Path, bare: list[MeshPart], parts: list[MeshPart]) -> str:
    missing, total = (sum(len(part.mesh.triangles) for part in group) for group in (bare, parts))
    names = list(dict.fromkeys(name[:40] for part in bare if (name := part.name or part.material)))
    more = " and others" if len(names) > 4 else ""
    whose = f", of {', '.join(names[:4])}{more}," if names else ""
    return f"{file}: {missing} of {total} triangles{whose} have no usable uv coordinates and stay uncovered."


def _pieces(part: MeshPart) -> list[MeshPart]:
    """The part cleaned: with uv, without, or one of each."""
    mesh = cleaned(part.mesh)
    has_uv: NDArray[np.bool_] = np.zeros(len(mesh.triangles), bool)
    if len(mesh.uv):
        has_uv = np.all((np.abs(mesh.uv) < MAX_COORDINATE)[mesh.triangles], axis=(1, 2))
    covered, bare = (mesh if chosen.all() else _some(mesh, chosen) for chosen in (has_uv, ~has_uv))
    if len(covered.triangles) and collapses(covered):
        covered = _without_uv(covered)
    if len(covered.uv):
        # Pictures lie on these, whatever becomes of those of the weave.
        covered = replace(covered, attributes={**covered.attributes, FILE_UV: covered.uv})
    pieces = covered, _without_uv(bare)
    return [MeshPart(part.name, part.material, piece) for piece in pieces if len(piece.triangles)]


def _some(mesh: ClothMesh, chosen: NDArray[np.bool_]) -> ClothMesh:
    return cleaned(replace(mesh, triangles=mesh.triangles[chosen]))


def _without_uv(mesh: ClothMesh) -> ClothMesh:
    return replace(mesh, uv=np.zeros((0, 2)))
