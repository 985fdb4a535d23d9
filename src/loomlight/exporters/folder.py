"""The folder of an export: written beside its final name, then renamed; nothing is left half-written."""

from __future__ import annotations

import json
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.files import short_path

MANIFEST = "manifest.json"
_MARK = "loomlight_export"


def check_folder(folder: str | os.PathLike[str]) -> None:
    """Raises InputError unless `folder` can be written and is new, empty, or an earlier export."""
    path = Path(folder)
    try:
        exists = path.exists() or path.is_symlink()
        if exists and not path.is_dir():
            raise InputError(f"{path} is a file; name a folder that is new or holds an earlier export.")
        if exists and any(path.iterdir()) and not _is_export(path):
            raise InputError(
                f"{path} holds other files; name a folder that is new or holds an earlier export."
            )
        parent = path.resolve().parent
        if not parent.is_dir():
            raise InputError(f"{path}: the folder {parent} does not exist; make it first.")
    except (OSError, ValueError) as error:
        raise InputError(f"{short_path(path)!r} is no path of a folder that can be written.") from error
    if not os.access(parent, os.W_OK):
        raise InputError(f"{path}: the folder {parent} cannot be written to.")


def check_file(path: str | os.PathLike[str], suffix: str) -> None:
    """Raises InputError unless a path has the suffix of the one file that an export is."""
    if Path(path).suffix.lower() != suffix:
        raise InputError(f"{path}: this export is one file; give it a name that ends in {suffix}.")


def _is_export(path: Path) -> bool:
    try:
        return _MARK in json.loads((path / MANIFEST).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return False


@contextmanager
def replacing_folder(folder: str | os.PathLike[str]) -> Iterator[Path]:
    """A temporary folder beside `folder` that takes its place when the block ends without an error.

    Raises:
        InputError: as `check_folder`, or the disk is full.
    """
    target = Path(folder)
    check_folder(target)
    parent = target.resolve().parent
    try:
        temporary = Path(tempfile.mkdtemp(dir=parent, prefix=".loomlight-"))
    except OSError as error:
        raise InputError(f"{target} cannot be written: {error.strerror or error}.") from error
    try:
        yield temporary
        umask = os.umask(0)
        os.umask(umask)
        temporary.chmod(0o777 & ~umask)
        earlier = None
        if target.exists():
            earlier = Path(tempfile.mkdtemp(dir=parent, prefix=".loomlight-")) / "earlier"
            target.resolve().rename(earlier)
        temporary.rename(target.resolve())
        if earlier is not None:
            shutil.rmtree(earlier.parent)
    except OSError as error:
        raise InputError(f"{target} cannot be written: {error.strerror or error}.") from error
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def write_manifest(folder: Path, content: dict[str, object]) -> None:
    """Writes manifest.json with the mark of an export."""
    text = json.dumps({_MARK: 1} | content, indent=1, ensure_ascii=False)
    (folder / MANIFEST).write_text(text + "\n", encoding="utf-8")
