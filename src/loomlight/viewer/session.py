"""The first state of the editor: the fabric that it was opened for, and the gallery."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import load_fabric
from loomlight.sources.load import fabric_of_path
from loomlight.viewer.limited_reader import MAX_UPLOAD
from loomlight.viewer.messages import Session, artwork_json, fabric_json

VERSION = 1
# The fabric of the gallery that the editor shows when it is opened without one.
_FIRST = "wool-houndstooth"
_PACKAGE = Path(str(files("loomlight.viewer")))
# A wheel holds the examples in the first folder; in a source checkout they lie in the second.
_FOLDERS = (_PACKAGE / "gallery", _PACKAGE.parents[2] / "examples")


def session(fabric: Fabric | str | None, *, has_python: bool, token: str | None = None) -> dict[str, Any]:
    """The session of a page, as JSON: see `messages.Session`.

    Args:
        fabric: a fabric, an argument of `fabric_of_path`, or None for the gallery's first.
        has_python: whether a server answers the page.
        token: that the page must send to that server.

    Raises:
        InputError: no such file, or no fabric.
    """
    if fabric is None:
        shown = first_fabric()
    else:
        shown = fabric if isinstance(fabric, Fabric) else fabric_of_path(fabric)
    return Session.model_validate(
        {
            "version": VERSION,
            "has_python": has_python,
            "token": token,
            "fabric": fabric_json(shown),
            "artwork": artwork_json(shown),
            "gallery": gallery(),
            "largest_upload": MAX_UPLOAD,
        }
    ).model_dump()


def first_fabric() -> Fabric:
    """The fabric of a page that is opened without one."""
    return load_fabric(gallery_files()[_FIRST])


@cache
def gallery() -> list[dict[str, Any]]:
    """The fabrics that come with the editor, by name: "id", "description", "picture", and a fabric as JSON.

    A picture is a place relative to the page; it is null where there is none.
    """
    entries = []
    for name, file in sorted(gallery_files().items()):
        fabric = load_fabric(file)
        picture = f"gallery/{name}.webp"
        facts = {
            "id": name,
            "description": fabric.fields.description or "",
            "picture": picture if (_PACKAGE / picture).is_file() else None,
        }
        entries.append(facts | fabric_json(fabric))
    return entries


def gallery_pictures() -> Path:
    """The folder of the gallery's pictures, which a page finds as "gallery"."""
    return _PACKAGE / "gallery"


def gallery_files() -> dict[str, Path]:
    """The files of the gallery by their names."""
    return {file.stem: file for folder in _FOLDERS for file in folder.glob("*.toml")}
