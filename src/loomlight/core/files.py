"""Atomic writes: a file is written beside its final name, then renamed.

Temporary names say whose they are, so that what a killed process leaves is recognised, and removed when the
next one writes into that folder.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.process_identity import has_ended, process_identity

# Of pictures that are written: of 8-bit pixels, and of linear values. Commands check them before they load
# what writes.
PIXEL_SUFFIXES = (".png", ".jpg", ".jpeg")
WRITTEN_SUFFIXES = (*PIXEL_SUFFIXES, ".exr")

_TEMPORARY = ".loomlight-"
# Folders that this process has looked through.
_cleaned: set[Path] = set()


def cache_folder(kind: str) -> Path:
    """The folder of a cache: loomlight/`kind` in $XDG_CACHE_HOME, or in ~/.cache."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "loomlight" / kind


def require_file(path: str | os.PathLike[str]) -> None:
    """Raises InputError unless `path` is an ordinary file or a link to one.

    Pipes and devices are refused, as reading them might never end.
    """
    file = Path(path)
    try:
        if file.is_file():
            return
        if file.is_dir():
            raise InputError(f"{file} is a folder; give the name of a file.")
        if file.exists():
            raise InputError(f"{file} is no ordinary file; give the name of one.")
    except (OSError, ValueError) as error:  # too long a name, a NUL, no permission
        raise InputError(f"{str(file)[:80]!r} is no path of a file that can be read.") from error
    raise InputError(f"{file} does not exist.")


@contextmanager
def replacing(path: str | os.PathLike[str]) -> Iterator[Path]:
    """A temporary path beside `path` that becomes `path` when the block ends without an error.

    The temporary name keeps the suffix, by which writers choose a format.

    Raises:
        InputError: the folder does not exist or cannot be written, or the disk is full.
    """
    target = Path(path)
    if not target.parent.is_dir():
        raise InputError(f"{target}: the folder {target.parent} does not exist; make it first.")
    if target.is_dir():
        raise InputError(f"{target} is a folder; give the name of a file.")
    if target.parent not in _cleaned:
        _cleaned.add(target.parent)
        remove_leftovers(target.parent)
    prefix = f"{_TEMPORARY}{process_identity()}-"
    try:
        handle, name = tempfile.mkstemp(dir=target.parent, prefix=prefix, suffix=target.suffix)
    except OSError as error:
        raise InputError(f"{target} cannot be written: {error.strerror}.") from error
    os.close(handle)
    temporary = Path(name)
    try:
        yield temporary
        # mkstemp makes private files; a picture that is shared should follow the user's umask.
        umask = os.umask(0)
        os.umask(umask)
        temporary.chmod(0o666 & ~umask)
        temporary.replace(target)
    except OSError as error:
        raise InputError(f"{target} cannot be written: {error.strerror or error}.") from error
    finally:
        temporary.unlink(missing_ok=True)


def remove_leftovers(folder: Path) -> None:
    """Removes temporary files in a folder whose processes have ended; those of other machines stay."""
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if entry.name.startswith(_TEMPORARY):
                identity = entry.name.removeprefix(_TEMPORARY).rpartition("-")[0]
                if has_ended(identity):
                    Path(entry.path).unlink(missing_ok=True)


@contextmanager
def replacing_all(paths: Sequence[str | os.PathLike[str]]) -> Iterator[list[Path]]:
    """Temporary paths beside several files that belong together: all become those files, or none does.

    Raises:
        InputError: as `replacing`.
    """
    with ExitStack() as stack:
        yield [stack.enter_context(replacing(path)) for path in paths]


@contextmanager
def discarding_empty(folder: str | os.PathLike[str]) -> Iterator[None]:
    """Removes a folder that the block makes if the block ends in an error and leaves no file in it."""
    top = Path(folder)
    existed = os.path.lexists(top)
    try:
        yield
    except BaseException:
        if not existed:
            # Folders that hold something refuse.
            for parent, _, _ in os.walk(top, topdown=False):
                with suppress(OSError):
                    Path(parent).rmdir()
        raise
