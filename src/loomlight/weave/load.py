"""Drafts in the formats of single programs, and which reader a file is for.

Fiberworks (.dtx), WeavePoint (.wpo), TempoWeave (.twa): the library dtx_to_wif knows the first two; the
third is a weaving information file in a zip archive. All pass through the reader of such files, so that every
draft is validated in one place.
"""

from __future__ import annotations

import io
import os
import warnings
import zipfile
import zlib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import require_file
from loomlight.core.images import PICTURE_SUFFIXES
from loomlight.weave.draft import Draft
from loomlight.weave.picture import drawdown_from_picture
from loomlight.weave.wif_reader import draft_of, read_wif
from loomlight.weave.wif_text import MAXIMUM_BYTES, decode_wif, parse_wif_text

OTHER_SUFFIXES = (".dtx", ".wpo", ".twa")


def read_other_program(path: str | os.PathLike[str]) -> Draft:
    """The draft in a .dtx, .wpo or .twa file.

    Raises:
        InputError: the file cannot be read, or holds no draft that can be used; places in such a message
            are those of the weaving information file that it amounts to.
    """
    file = Path(path)
    _check_readable(file)
    text = _unzipped(file) if file.suffix.lower() == ".twa" else _converted(file)
    return draft_of(parse_wif_text(text, str(path)))


_FILE_IN_TWA = "twamain.waf"


def _unzipped(path: Path) -> str:
    try:
        with zipfile.ZipFile(path) as archive, archive.open(_FILE_IN_TWA) as file:
            # Read with a bound, since a small archive can hold more than any memory.
            content = file.read(MAXIMUM_BYTES + 1)
    except (
        zipfile.BadZipFile,
        KeyError,
        OSError,
        EOFError,
        NotImplementedError,
        RuntimeError,
        zlib.error,
    ) as error:
        raise _unreadable(path, error) from error
    if len(content) > MAXIMUM_BYTES:
        raise InputError(f"{path} holds more than {MAXIMUM_BYTES >> 20} MiB; no draft that can be used does.")
    return decode_wif(content)


def _converted(path: Path) -> str:
    from dtx_to_wif import read_pattern_file, write_wif

    converted = io.StringIO()
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            write_wif(converted, read_pattern_file(path))
    except Exception as error:
        # The library raises whatever its parsing runs into: KeyError, IndexError, struct.error and more.
        raise _unreadable(path, error) from error
    for warning in caught:
        warnings.warn(f"{path}: {' '.join(str(warning.message).split())}.", LoomlightWarning, stacklevel=4)
    return converted.getvalue()


def _unreadable(path: Path, error: Exception) -> InputError:
    detail = " ".join(str(error).split())[:120] or type(error).__name__
    return InputError(
        f"{path} is no {path.suffix.lower()} draft that can be read ({detail}); "
        "export it as .wif from the program that made it."
    )


def _check_readable(path: Path) -> None:
    try:
        with path.open("rb") as file:
            size = file.seek(0, os.SEEK_END)
    except FileNotFoundError as error:
        raise InputError(f"{path} does not exist.") from error
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.") from error
    if size > MAXIMUM_BYTES:
        raise InputError(f"{path} is larger than {MAXIMUM_BYTES >> 20} MiB; no draft that can be used is.")


# --------------------------------------------------------------------------------- which reader a file is for


_PICTURES = (*PICTURE_SUFFIXES, ".webp")
DRAFT_SUFFIXES = (".wif", *OTHER_SUFFIXES, *_PICTURES)
_READERS: dict[str, Callable[[str | os.PathLike[str]], Draft]] = {
    ".wif": read_wif,
    **dict.fromkeys(OTHER_SUFFIXES, read_other_program),
    **dict.fromkeys(_PICTURES, drawdown_from_picture),
}


def load_draft(path: str | os.PathLike[str]) -> Draft:
    """The draft in a file: .wif, .dtx, .wpo, .twa, or a picture of a drawdown; untitled ones get its name.

    Raises:
        InputError: another kind of file, or one that cannot be read or used.
    """
    suffix = Path(path).suffix.lower()
    if suffix in DRAFT_SUFFIXES:
        require_file(path)
    read = _READERS.get(suffix)
    if read is not None:
        draft = read(path)
        return draft if draft.title.strip() else replace(draft, title=Path(path).stem)
    given = f'"{suffix}"' if suffix else "no suffix"
    raise InputError(f"{path}: a draft is a file or picture in {', '.join(DRAFT_SUFFIXES)}, not {given}.")
