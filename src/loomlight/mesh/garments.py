"""The parts of a mesh file as cloth, in metres: those without uv are cut, once for each mesh."""

from __future__ import annotations

import hashlib
import json
import os
import warnings
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import groupby
from pathlib import Path

import numpy as np
from safetensors import SafetensorError, safe_open
from safetensors.numpy import save_file

from loomlight.core.errors import InputError, LoomlightError, LoomlightWarning
from loomlight.core.files import cache_folder, replacing
from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart, joined
from loomlight.mesh.reading import read_parts
from loomlight.mesh.unwrap import CutPieces, cut_pieces, with_uv

# Changed with whatever changes how cloth is cut.
_VERSION = 2
# Cuts that are kept on disk, the newest, and in memory: a command reads a mesh for each of its pictures.
_MAX_KEPT, _MAX_HELD = 32, 2
_held: dict[str, CutPieces] = {}


def garment_parts(
    path: str | os.PathLike[str],
    metres_per_unit: float = 1.0,
    unwrap: bool | None = None,
    named: Iterable[str] = (),
    time: float | None = None,
) -> list[MeshPart]:
    """The parts of a mesh file, in metres; cloth that is cut has a part for each of its pieces.

    A warning says how it was cut.

    Args:
        metres_per_unit: the length of one unit of the file's positions.
        unwrap: cuts all parts, those that have uv too; None cuts where no part has any, and those without
            that are `named`; False cuts none.
        named: names of parts or materials that have to be cloth.
        time: see `read_parts`.

    Raises:
        InputError: what `read_parts` raises, or no uv where nothing may be cut.
    """
    with warnings.catch_warnings():
        if unwrap:
            warnings.simplefilter("ignore", LoomlightWarning)  # of parts without uv, which are cut
        parts = read_parts(path, time)
    parts = [replace(part, mesh=part.mesh.scaled(metres_per_unit)) for part in parts]
    if unwrap:
        return _cut(_whole(parts), path)
    covered = any(len(part.mesh.uv) for part in parts)
    if not covered and unwrap is None:
        return _cut(parts, path)
    if not covered:
        raise InputError(
            f"{path} has no uv coordinates, or they collapse to lines or points: let it be unwrapped, or "
            "unwrap it first."
        )
    wanted = set(named)
    bare = [
        part
        for part in parts
        if not len(part.mesh.uv) and unwrap is None and {part.name, part.material} & wanted
    ]
    if not bare:
        return parts
    return [*(part for part in parts if part not in bare), *_cut(bare, path)]


def _whole(parts: Sequence[MeshPart]) -> list[MeshPart]:
    """Parts without uv, of which triangles that had some and those that had none are one part again."""
    made = []
    for _, group in groupby(parts, lambda part: (part.name, part.material)):
        same = list(group)
        meshes = [replace(part.mesh, uv=part.mesh.uv[:0]) for part in same]
        made.append(replace(same[0], mesh=joined(meshes)))
    return made


def _cut(parts: Sequence[MeshPart], path: str | os.PathLike[str]) -> list[MeshPart]:
    found = _kept(parts)
    warnings.warn(found.sentence(path), LoomlightWarning, stacklevel=4)
    return with_uv(parts, found)


def _kept(parts: Sequence[MeshPart]) -> CutPieces:
    """The cut of parts: of this process, of the cache, or a new one, which is put there."""
    key = _digest([part.mesh for part in parts])
    file = cache_folder("cuts") / f"{key}.safetensors"
    found = _held.get(key) or _read(file, sum(len(part.mesh.triangles) for part in parts))
    if found is None:
        found = cut_pieces(parts)
        _write(file, found)
    _held[key] = found
    while len(_held) > _MAX_HELD:
        del _held[next(iter(_held))]
    return found


def _digest(meshes: Sequence[ClothMesh]) -> str:
    digest = hashlib.sha256(f"{_VERSION}".encode())
    for mesh in meshes:
        digest.update(f"{mesh.positions.shape} {mesh.triangles.shape}".encode())
        # Of single precision, so that a mesh is the same in metres and in centimetres.
        digest.update(mesh.positions.astype(np.float32).tobytes())
        digest.update(mesh.triangles.astype(np.int64).tobytes())
    return digest.hexdigest()[:32]


def _read(file: Path, triangles: int) -> CutPieces | None:
    """A cut on disk; None if there is none, or no usable one."""
    try:
        with safe_open(file, "numpy") as opened:
            said = json.loads(opened.metadata()["cut"])
            corners, piece = opened.get_tensor("corners"), opened.get_tensor("piece")
            uv = opened.get_tensor("uv")
        found = CutPieces(corners.astype(np.int64), uv, piece.astype(np.int64), **said)
        is_right = corners.shape == (triangles, 3) and piece.shape == (triangles,) and uv.shape[1:] == (2,)
        if is_right and corners.min() >= 0 and corners.max() < len(uv) and piece.max() < len(found.names):
            return found
    except (SafetensorError, OSError, ValueError, KeyError, TypeError):
        pass
    return None


def _write(file: Path, found: CutPieces) -> None:
    """Writes a cut to disk; ignores errors, which cost cutting next time."""
    said = {name: getattr(found, name) for name in ("names", "count", "stretch", "worst", "angle")}
    arrays = {
        "corners": found.corners.astype(np.int32),
        "piece": found.piece.astype(np.int32),
        "uv": found.uv,
    }
    with suppress(OSError, LoomlightError, SafetensorError):
        file.parent.mkdir(parents=True, exist_ok=True)
        with replacing(file) as temporary:
            save_file(arrays, temporary, {"cut": json.dumps(said)})
        kept = sorted(file.parent.glob("*.safetensors"), key=lambda each: each.stat().st_mtime, reverse=True)
        for old in kept[_MAX_KEPT:]:
            old.unlink(missing_ok=True)
