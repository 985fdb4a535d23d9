"""Output paths, checked before the work begins."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path

from loomlight.core.errors import InputError


def check_output(path: Path, suffixes: Sequence[str]) -> None:
    """Raises InputError unless a file with one of the `suffixes` can be written at `path`."""
    allowed = " or ".join(suffixes)
    if path.suffix.lower() not in suffixes:
        raise InputError(f"{path} has no suffix that says what to write: it must end in {allowed}.")
    try:
        if path.is_dir():
            raise InputError(f"{path} is a folder; give the name of a file that ends in {allowed}.")
        if not path.parent.is_dir():
            raise InputError(f"{path}: the folder {path.parent} does not exist; make it first.")
    except (OSError, ValueError) as error:
        raise InputError(f"{str(path)[:80]!r} is no path of a file that can be written: {error}.") from error
    if not os.access(path.parent, os.W_OK):
        raise InputError(f"{path}: the folder {path.parent} cannot be written to.")


def require_not_read(path: Path, reads: Iterable[str | Path | None]) -> None:
    """Raises InputError if `path` is one of the files that the command reads.

    Args:
        reads: paths, or what may be one, such as the name of a weave.
    """
    for read in reads:
        try:
            same = read is not None and path.exists() and os.path.samefile(path, read)
        except (OSError, ValueError):
            continue  # a name, or a file that is not there
        if same:
            raise InputError(f"{path} is read by this command: give another name to write to.")


def done(path: Path) -> None:
    """Prints the path of a written file to stdout."""
    print(path)
