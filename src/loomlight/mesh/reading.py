"""Mesh files, read in parts: OBJ, PLY, glTF and GLB.

uv follow Mitsuba's bitmaps, v running down the image: OBJ's v is turned over, glTF's is kept, PLY's is taken
as it is written, as Mitsuba's `obj` and `ply` plugins do.
"""

from __future__ import annotations

import os
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError, LoomlightError, LoomlightWarning
from loomlight.core.files import require_file
from loomlight.mesh.cloth_mesh import MAX_COORDINATE, ClothMesh, MeshPart, cleaned, collapses, joined
from loomlight.mesh.gltf import read_gltf
from loomlight.mesh.obj import read_obj
from loomlight.mesh.ply import read_ply

_READERS = {".obj": read_obj, ".ply": read_ply, ".gltf": read_gltf, ".glb": read_gltf}
SUFFIXES = tuple(_READERS)


def read_parts(path: str | os.PathLike[str]) -> list[MeshPart]:
    """The parts of an OBJ, PLY, glTF or GLB file, in its order.

    Triangles without an area are left out. Those of a part that have no uv become a part of their own, of the
    same name, which follows it. A warning says how many triangles have no uv, if others have.

    Raises:
        InputError: no such file, another suffix, a damaged file, or no triangles.
        MissingDependencyError: the file is compressed, and what decodes it is not installed.
    """
    file = Path(path)
    with np.errstate(all="ignore"):  # of numbers that are then refused
        parts = [made for part in _raw_parts(file) for made in _pieces(part)]
    if not parts:
        raise InputError(f"{file} holds no triangles that have an area.")
    bare = [part for part in parts if len(part.mesh.uv) == 0]
    if bare and len(bare) < len(parts):
        warnings.warn(_uncovered(file, bare, parts), LoomlightWarning, stacklevel=2)
    return parts


def read_mesh(path: str | os.PathLike[str]) -> ClothMesh:
    """Every triangle with uv of an OBJ, PLY, glTF or GLB file as one mesh; missing normals are computed.

    Raises:
        InputError: what `read_parts` raises, or no usable uv.
    """
    covered = [part.mesh for part in read_parts(path) if len(part.mesh.uv)]
    if not covered:
        raise InputError(
            f"{path} has no uv coordinates, or they collapse to lines or points; unwrap it first."
        )
    return joined(covered)


def _raw_parts(file: Path) -> list[MeshPart]:
    suffix = file.suffix.lower()
    if suffix not in _READERS:
        raise InputError(f"{file}: meshes are read from {', '.join(SUFFIXES)} files.")
    require_file(file)
    if file.stat().st_size == 0:
        raise InputError(f"{file} is empty: it holds no mesh.")
    try:
        return _READERS[suffix](file)
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
    pieces = covered, _without_uv(bare)
    return [MeshPart(part.name, part.material, piece) for piece in pieces if len(piece.triangles)]


def _some(mesh: ClothMesh, chosen: NDArray[np.bool_]) -> ClothMesh:
    return cleaned(replace(mesh, triangles=mesh.triangles[chosen]))


def _without_uv(mesh: ClothMesh) -> ClothMesh:
    return replace(mesh, uv=np.zeros((0, 2)))
