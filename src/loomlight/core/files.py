"""Atomic writes: a file is written beside its final name, then renamed.

Temporary names say whose they are, so that what a killed process leaves is recognised, and removed when the
next one writes into that folder.
"""

from __future__ import annotations

import hashlib
import os
import socket
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from functools import cache
from pathlib import Path

from loomlight.core.errors import InputError

# Of pictures that are written: of 8-bit pixels, and of linear values. Commands check them before they load
# what writes.
PIXEL_SUFFIXES = (".png", ".jpg", ".jpeg")
WRITTEN_SUFFIXES = (*PIXEL_SUFFIXES, ".exr")
# Of several pictures in one file.
ANIMATION_SUFFIXES = (".webp", ".gif")

# Thread colours of the longest draft take some 100 kB; what is larger is not a fabric file.
MAX_TEXT = 4 * 2**20
_TEMPORARY = ".loomlight-"
# Folders that this process has looked through.
_cleaned: set[Path] = set()


def cache_folder(kind: str) -> Path:
    """The folder of a cache: loomlight/`kind` in $XDG_CACHE_HOME, or in ~/.cache."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "loomlight" / kind


def require_file(path: str | os.PathLike[str]) -> None:
    """Raises InputError unless `path` is an ordinary file or a link to one, and may be read.

    Pipes and devices are refused, as reading them might never end.
    """
    file = Path(path)
    try:
        if file.is_file():
            file.open("rb").close()
            return
        if file.is_dir():
            raise InputError(f"{file} is a folder; give the name of a file.")
        if file.exists():
            raise InputError(f"{file} is no ordinary file; give the name of one.")
    except PermissionError as error:
        raise InputError(f"{file} cannot be read: {error.strerror}.") from error
    except (OSError, ValueError) as error:  # too long a name, a NUL
        raise InputError(f"{short_path(file)!r} is no path of a file that can be read.") from error
    raise InputError(f"{file} does not exist.")


def short_path(path: Path) -> str:
    """The beginning of a path, and its end, by which a user knows it."""
    text = str(path)
    return text if len(text) <= 160 else f"{text[:60]}…{text[-99:]}"


def read_text(path: str | os.PathLike[str]) -> str:
    """Text of a UTF-8 file.

    Raises:
        InputError: no such file, no file but a folder or device, unreadable, too large, not UTF-8.
    """
    file = Path(path)
    require_file(file)
    try:
        if file.stat().st_size > MAX_TEXT:
            raise InputError(f"{file} is larger than {MAX_TEXT >> 20} MiB: no text of that size is read.")
        return file.read_bytes().decode("utf-8-sig")
    except OSError as error:
        raise InputError(f"{file} cannot be read: {error.strerror or error}.") from error
    except UnicodeDecodeError as error:
        raise InputError(f"{file} is not UTF-8 text: save it as UTF-8.") from error


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


# ----------------------------------------------------------------------------------------- names of processes
# Names of processes that no other process ever has: machine, process number, and when it began.


def process_identity() -> str:
    """The name of this process: letters, digits and dots, without "-"."""
    process = os.getpid()
    return f"{_machine()}.{process}.{_begun(process)}"


def has_ended(identity: str) -> bool:
    """Whether a process of this machine has ended; False of other machines' and of what is no name."""
    machine, _, rest = identity.partition(".")
    number, _, begun = rest.partition(".")
    if machine != _machine() or not (number.isdecimal() and begun.isdecimal()):
        return False
    try:
        os.kill(int(number), 0)
    except ProcessLookupError:
        return True
    except (PermissionError, OverflowError):
        pass  # another user's
    # The number may have been given to another process since.
    return _begun(int(number)) != int(begun)


@cache
def _machine() -> str:
    """A hash of the host and of the numbering of its processes, which containers have of their own."""
    try:
        numbering = os.readlink("/proc/self/ns/pid")
    except OSError:
        numbering = ""
    return hashlib.sha256(f"{socket.gethostname()} {numbering}".encode()).hexdigest()[:12]


def _begun(process: int) -> int:
    """Clock ticks from the machine's start to the process's; 0 where the system does not say."""
    try:
        # The name before it may hold spaces and brackets.
        fields = (
            Path(f"/proc/{process}/stat").read_text(encoding="utf-8", errors="replace").rpartition(")")[2]
        )
        return int(fields.split()[19])
    except (OSError, IndexError, ValueError):
        return 0
