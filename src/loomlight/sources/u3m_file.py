"""U3M files: a material's document and the files that it names, in a folder (`.u3m`) or an archive (`.u3ma`).

Source: U3M 1.1 (Vizoo), u3m_additional_spec*.txt. An archive is a zip without extras: names in UTF-8, times
in UTC, stored or deflated, no attributes, comments, encryption or zip64. Older archives may be any zip and
are read; nothing but the strict form is written. What a document holds beyond what this program knows, and
files that nothing names, stay as they are when a material is written again.
"""

from __future__ import annotations

import json
import math
import os
import re
import struct
import time
import zipfile
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from loomlight.core.errors import InputError
from loomlight.core.files import MAX_TEXT, read_text, replacing, require_file
from loomlight.core.sentences import shown, speaking_of

SUFFIX, ARCHIVE_SUFFIX = ".u3m", ".u3ma"
# Bytes of a file and of all files of a material, and their number.
MAX_FILE, MAX_TOTAL, MAX_FILES = 1 << 28, 1 << 30, 4096
_LONGEST_PATH = 1024
# JSON's lists and objects inside one another.
_DEEPEST = 64
# Of a name in a path: characters that no system or shell takes for something else, and no name of a device.
_NO_NAME = re.compile(r'[\x00-\x1f<>:"/\\|]|[. ]$')
_DEVICE = re.compile(r"(con|prn|aux|nul|clock\$|com[1-9]|lpt[1-9])(\..*)?", re.IGNORECASE)


@dataclass(frozen=True, eq=False)
class U3mFile:
    """A material's document, and the files beside it.

    Attributes:
        name: of the document, without its suffix.
        document: JSON as it was read.
        files: contents by their path relative to the document.
    """

    name: str
    document: dict[str, Any]
    files: Mapping[str, bytes]


def is_u3m_file(path: str | os.PathLike[str]) -> bool:
    """Whether a path is that of a `.u3m` or a `.u3ma`."""
    return Path(path).suffix.lower() in (SUFFIX, ARCHIVE_SUFFIX)


def is_relative_path(path: str) -> bool:
    """Whether U3M allows the path of a file: relative, below its document, valid on every system."""
    *folders, file = path.split("/")
    plain = all(_is_name(name) for name in (*folders, file))
    # Of folders, nothing that a shell would put in.
    return plain and len(path) <= _LONGEST_PATH and not any(set(name) & set("$%") for name in folders)


def _is_name(name: str) -> bool:
    return (
        0 < len(name) <= 255
        and name not in (".", "..", "~")
        and not _NO_NAME.search(name)
        and not _DEVICE.fullmatch(name)
    )


# ------------------------------------------------------------------------------------------------------- read


def read_u3m(path: str | os.PathLike[str]) -> U3mFile:
    """The material of a `.u3m` or `.u3ma`, with all files that belong to it.

    Of a `.u3m`, these are what any text of its document names, and what lies in folders of such files.

    Raises:
        InputError: no such file, no JSON object, an archive that is damaged, unsafe or too large, or a file
            that the document names and that is missing.
    """
    require_file(path)
    with speaking_of(str(path)):
        if Path(path).suffix.lower() == ARCHIVE_SUFFIX:
            found = _read_archive(Path(path))
        else:
            document = _parsed(read_text(path))
            found = U3mFile(Path(path).stem, document, dict(_files_beside(Path(path).parent, document)))
        for name in named_files(found.document):
            if name not in found.files:
                raise InputError(f"the file {shown(name)}, which it names, is missing.")
        return found


def named_files(document: Mapping[str, Any]) -> list[str]:
    """Paths of the files that the common section of a document names, each once.

    Raises:
        InputError: a path that leaves the folder or is no path.
    """
    found: dict[str, None] = {}
    for field, value in _items(document.get("material")):
        if field in ("path", "fab") and isinstance(value, str) and value != "null":
            if not is_relative_path(value):
                raise InputError(f"it names the file {shown(value)}: files lie beside a U3M or below it.")
            found[value] = None
    return list(found)


def _items(value: Any) -> Iterator[tuple[str, Any]]:
    """Names and values of all fields, however deep; elements of lists have the name of the list."""
    stack = [("", value)]
    while stack:
        name, value = stack.pop()
        yield name, value
        if isinstance(value, dict):
            stack += [(str(key), each) for key, each in value.items()]
        elif isinstance(value, list):
            stack += [(name, each) for each in value]


def _parsed(text: str) -> dict[str, Any]:
    try:
        found = json.loads(text, parse_constant=_refuse_constant, parse_float=_finite)
    except (ValueError, RecursionError) as error:
        raise InputError(f"it is no U3M, which is JSON: {_first_line(error)}.") from error
    if not isinstance(found, dict) or not isinstance(found.get("material"), dict):
        raise InputError('it is no U3M: one is an object with the field "material".')
    return found


def _refuse_constant(name: str) -> float:
    raise ValueError(f"{name} is no number")


def _finite(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(f"{text[:20]} is too large a number")
    return value


def _first_line(error: BaseException) -> str:
    if isinstance(error, RecursionError):
        return "it lies too deep"
    return (str(error).splitlines() or [type(error).__name__])[0][:120]


def _files_beside(folder: Path, document: dict[str, Any]) -> Iterator[tuple[str, bytes]]:
    """Names and contents of the files of a `.u3m` in a folder."""
    texts = {value for _, value in _items(document) if isinstance(value, str) and is_relative_path(value)}
    names = sorted(name for name in texts if (folder / name).is_file())
    for inner in sorted({name.rpartition("/")[0] for name in names} - {""}):
        names += [f"{inner}/{file.name}" for file in sorted((folder / inner).iterdir()) if file.is_file()]
    total = 0
    for number, name in enumerate(dict.fromkeys(names)):
        file = folder / name
        if not file.resolve().is_relative_to(folder.resolve()):
            raise InputError(f"the file {shown(name)} is a link to another folder: copy it there.")
        total += file.stat().st_size
        _require_small(name, file.stat().st_size, total, number + 1)
        yield name, file.read_bytes()


def _require_small(name: str, size: int, total: int, count: int) -> None:
    if size > MAX_FILE:
        raise InputError(f"the file {shown(name)} is larger than {MAX_FILE >> 20} MiB.")
    if total > MAX_TOTAL:
        raise InputError(f"its files are larger than {MAX_TOTAL >> 20} MiB together.")
    if count > MAX_FILES:
        raise InputError(f"it has more than {MAX_FILES} files.")


def _read_archive(path: Path) -> U3mFile:
    try:
        with zipfile.ZipFile(path) as archive:
            contents = dict(_entries(archive))
    except InputError:
        raise
    # A damaged archive makes `zipfile` raise all of these.
    except (
        zipfile.BadZipFile, zlib.error, struct.error, OSError, EOFError, ValueError, RuntimeError,
        LookupError, OverflowError, MemoryError,
    ) as error:  # fmt: skip
        raise InputError(f"it is no U3M archive that can be read: {_first_line(error)}.") from error
    documents = [name for name in contents if name.lower().endswith(SUFFIX)]
    if len(documents) != 1:
        raise InputError(f"it holds {len(documents)} files {SUFFIX}: an archive has one.")
    (name,) = documents
    try:
        text = contents.pop(name).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(f"{shown(name)} in it is not UTF-8 text.") from error
    if len(text) > MAX_TEXT:
        raise InputError(f"{shown(name)} in it is larger than {MAX_TEXT >> 20} MiB.")
    # Paths are relative to the document, wherever an archive has it.
    folder = name.rpartition("/")[0]
    prefix = f"{folder}/" if folder else ""
    outside = next((other for other in contents if not other.startswith(prefix)), None)
    if outside is not None:
        raise InputError(f"{shown(outside)} in it lies outside the folder of {shown(name)}.")
    files = {other[len(prefix) :]: content for other, content in contents.items()}
    return U3mFile(name[len(prefix) : -len(SUFFIX)], _parsed(text), files)


def _entries(archive: zipfile.ZipFile) -> Iterator[tuple[str, bytes]]:
    """Names and contents of an archive's files; sizes that it declares are not believed."""
    names: set[str] = set()
    total = 0
    for entry in archive.infolist():
        if entry.is_dir():
            continue
        name = entry.filename
        if not is_relative_path(name):
            raise InputError(f"it holds the file {shown(name)}, whose name no U3M archive may have.")
        if name.casefold() in names:
            raise InputError(f"it holds the file {shown(name)} twice.")
        if entry.compress_type not in (_STORED, _DEFLATED):
            raise InputError(f"it holds the file {shown(name)}, which is neither stored nor deflated.")
        names.add(name.casefold())
        _require_small(name, entry.file_size, total + entry.file_size, len(names))
        with archive.open(entry) as stream:
            content = stream.read(entry.file_size + 1)
        total += len(content)
        _require_small(name, len(content), total, len(names))
        yield name, content


# ------------------------------------------------------------------------------------------------------ write


def document_text(file: U3mFile) -> str:
    """The document as its file holds it."""
    return json.dumps(file.document, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def write_u3m_folder(folder: Path, file: U3mFile) -> list[str]:
    """Writes NAME.u3m and its files into a folder that is there, and returns their names.

    Raises:
        InputError: a name that U3M does not allow.
    """
    contents = _contents(file)
    for name, content in contents.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    return list(contents)


def write_u3ma(path: str | os.PathLike[str], file: U3mFile) -> None:
    """Writes an archive, under a temporary name first.

    Raises:
        InputError: a path that cannot be written, or a name that U3M does not allow.
    """
    content = archive_bytes(_contents(file), time.gmtime())
    with replacing(path) as temporary:
        temporary.write_bytes(content)


def _contents(file: U3mFile) -> dict[str, bytes]:
    contents = {f"{file.name}{SUFFIX}": document_text(file).encode(), **file.files}
    for name in contents:
        if not is_relative_path(name):
            raise InputError(f"A U3M cannot hold a file of the name {shown(name)}.")
    return contents


_LOCAL, _CENTRAL, _END = 0x04034B50, 0x02014B50, 0x06054B50
# Made by FAT and zip 6.3; needs 2.0; names are UTF-8.
_MADE_BY, _NEEDS, _UTF8 = 0x003F, 0x14, 1 << 11
_STORED, _DEFLATED = 0, 8


def archive_bytes(contents: Mapping[str, bytes], written: time.struct_time) -> bytes:
    """A U3M archive of files by name, in the form of u3m_additional_spec_u3ma.txt.

    Args:
        written: the time of all files, UTC.

    Raises:
        InputError: more than 65535 files or 4 GiB, which the format cannot hold.
    """
    stamp = (
        written.tm_hour << 11 | written.tm_min << 5 | written.tm_sec // 2,
        max(written.tm_year - 1980, 0) << 9 | written.tm_mon << 5 | written.tm_mday,
    )
    body, directory = bytearray(), bytearray()
    for name, content in contents.items():
        encoded = name.encode()
        packer = zlib.compressobj(9, zlib.DEFLATED, -15)
        packed = packer.compress(content) + packer.flush()
        method = _DEFLATED if len(packed) < len(content) else _STORED
        packed = packed if method == _DEFLATED else content
        shared = struct.pack(
            "<HHHHHIIIHH",
            _NEEDS, _UTF8, method, *stamp, zlib.crc32(content), len(packed), len(content), len(encoded), 0,
        )  # fmt: skip
        directory += struct.pack("<IH", _CENTRAL, _MADE_BY) + shared
        directory += struct.pack("<HHHII", 0, 0, 0, 0, len(body)) + encoded
        body += struct.pack("<I", _LOCAL) + shared + encoded + packed
    if len(contents) > 0xFFFF or len(body) + len(directory) >= 1 << 32:
        raise InputError("A U3M archive holds at most 65535 files and 4 GiB: export to u3m, a folder.")
    end = struct.pack("<IHHHHIIH", _END, 0, 0, len(contents), len(contents), len(directory), len(body), 0)
    return bytes(body + directory + end)
