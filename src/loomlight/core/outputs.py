"""Output paths, checked before the work begins."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Sequence
from itertools import chain
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.files import short_path

# Files whose quoted texts may be paths of further files: fabrics, scenes, meshes.
_NAMES_FILES = (".toml", ".xml", ".gltf", ".json")
_QUOTED = re.compile(r"\"([^\"\n]{1,4096})\"|'([^'\n]{1,4096})'")
# Characters of such a file that are looked through.
_MAX = 1 << 22


def check_output(
    path: Path,
    suffixes: Sequence[str],
    reads: Iterable[str | os.PathLike[str] | None] = (),
    *,
    makes_folder: bool = False,
) -> None:
    """Raises InputError unless a file with one of the `suffixes` can be written at `path`.

    Args:
        reads: see `require_not_read`.
        makes_folder: the folder may be missing, where the one that is to hold it is there.
    """
    allowed = " or ".join(suffixes)
    if path.suffix.lower() not in suffixes:
        raise InputError(f"{path} has no suffix that says what to write: it must end in {allowed}.")
    try:
        if path.is_dir():
            raise InputError(f"{path} is a folder; give the name of a file that ends in {allowed}.")
        folder = path.parent
        if makes_folder and not os.path.lexists(folder):
            folder = folder.parent
        if not folder.is_dir():
            raise InputError(f"{path}: the folder {folder} does not exist; make it first.")
    except (OSError, ValueError) as error:
        raise InputError(f"{short_path(path)!r} is no path of a file that can be written.") from error
    if not os.access(folder, os.W_OK):
        raise InputError(f"{path}: the folder {folder} cannot be written to.")
    require_not_read([path], reads)


def require_not_read(outputs: Iterable[Path], reads: Iterable[str | os.PathLike[str] | None]) -> None:
    """Raises InputError if an output is a file that the command reads, or a folder that holds one.

    Args:
        reads: paths, or what may be one, such as the name of a weave. Files that a fabric file, a scene file
            or a glTF file names are read as well.
    """
    written = [path for path in outputs if _exists(path)]
    if not written:
        return
    for read in chain.from_iterable(map(files_of, reads)):
        for path in written:
            if path.is_dir() and path.resolve() in read.resolve().parents:
                raise InputError(f"{path} holds {read}, which is read by this command: give another folder.")
            if not path.is_dir() and os.path.samefile(path, read):
                raise InputError(f"{path} is read by this command: give another name to write to.")


def files_of(argument: str | os.PathLike[str] | None) -> list[Path]:
    """The file that an argument names, if it names one, and those that this file names, and so on."""
    found: list[Path] = []
    left = [] if argument is None else [Path(argument)]
    while left:
        path = left.pop()
        if _is_file(path) and path not in found:
            found.append(path)
            left += [path.parent / name for name in _names_in(path)]
    return found


def _names_in(path: Path) -> list[str]:
    """Quoted texts of a file that may name others."""
    if path.suffix.lower() not in _NAMES_FILES:
        return []
    try:
        with path.open(encoding="utf-8", errors="replace") as stream:
            return [one or other for one, other in _QUOTED.findall(stream.read(_MAX))]
    except OSError:
        return []  # whoever reads it says so


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):
        return False  # too long a name, a NUL


def _is_file(path: Path) -> bool:
    return _exists(path) and path.is_file()


def is_folder(path: Path) -> bool:
    """Whether a folder is there by that name, which may be no possible one."""
    return _exists(path) and path.is_dir()
