# SPDX-License-Identifier: GPL-3.0-or-later
"""The fabrics and weaves that come with the add-on, with their pictures, as items of enumerations."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path

import bpy
import bpy.utils.previews

FOLDER = Path(__file__).resolve().parent
READY = FOLDER / "ready"
Item = tuple[str, str, str, int, int]
_FIRST = "denim"
_pictures: list[bpy.utils.previews.ImagePreviewCollection] = []


@cache
def fabrics() -> list[Item]:
    """The fabrics of the gallery, by the names of their files."""
    files = sorted((FOLDER / "gallery").glob("*.toml"), key=lambda file: (file.stem != _FIRST, file.stem))
    items = []
    for number, file in enumerate(files):
        fields = tomllib.loads(file.read_text(encoding="utf-8"))
        name, about = fields.get("name", file.stem), fields.get("description", "")
        items.append((file.stem, name, about, _icon(file.with_suffix(".webp")), number))
    return items or [("NONE", "None", "This copy of the add-on has no gallery", 0, 0)]


@cache
def weaves() -> list[Item]:
    """The weaves that have names, each in the form in which its name is written."""
    names = FOLDER / "weaves" / "names.txt"
    lines = names.read_text(encoding="utf-8").splitlines() if names.is_file() else ["plain"]
    pictures = (names.parent / f"{number}.png" for number in range(len(lines)))
    return [
        (name, name, f"The weave {name}", _icon(picture), number)
        for number, (name, picture) in enumerate(zip(lines, pictures, strict=True))
    ]


def gallery_file(name: str) -> Path:
    """The fabric file of an item of the gallery."""
    return FOLDER / "gallery" / f"{name}.toml"


def _icon(file: Path) -> int:
    """The number of a picture; 0, no icon, where there is none."""
    if not file.is_file():
        return 0
    if not _pictures:
        _pictures.append(bpy.utils.previews.new())
    return int(_pictures[0].load(str(file), str(file), "IMAGE").icon_id)


def forget() -> None:
    """Frees the pictures."""
    for found in (fabrics, weaves):
        found.cache_clear()
    while _pictures:
        bpy.utils.previews.remove(_pictures.pop())
