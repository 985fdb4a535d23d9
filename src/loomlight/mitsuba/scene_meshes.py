"""Mesh files that a Mitsuba scene names, checked before Mitsuba reads them: it trusts their indices."""

from __future__ import annotations

import re
import warnings
from pathlib import Path
from xml.etree import ElementTree

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mesh.reading import read_parts

_CHECKED = ("obj", "ply")
_VARIABLE = re.compile(r"\$(\w+)")


def check_scene_meshes(file: Path) -> None:
    """Reads each OBJ and PLY mesh that a scene file, or one that it includes, names.

    Warns of those that are not found beside the scene and therefore not checked.

    Raises:
        InputError: a damaged mesh, or one of which some triangles alone have uv.
    """
    waiting, seen = [file], set[Path]()
    defaults: dict[str, str] = {}
    while waiting:
        scene = waiting.pop()
        if scene in seen:
            continue
        seen.add(scene)
        try:
            root = ElementTree.parse(scene).getroot()
        except (ElementTree.ParseError, ValueError, OSError):
            continue  # which Mitsuba says better
        for node in root.iter("default"):
            defaults.setdefault(node.get("name", ""), node.get("value", ""))
        for node in root.iter("include"):
            waiting.append(file.parent / _filled(node.get("filename", ""), defaults))
        for shape in root.iter("shape"):
            for node in shape.iterfind("string[@name='filename']"):
                if shape.get("type") in _CHECKED:
                    _check(file, _filled(node.get("value", ""), defaults), str(shape.get("type")))


def _filled(text: str, defaults: dict[str, str]) -> str:
    return _VARIABLE.sub(lambda found: defaults.get(found[1], found[0]), text)


def _check(scene: Path, name: str, kind: str) -> None:
    mesh = scene.parent / name
    if not mesh.is_file() or mesh.suffix.lower() != f".{kind}":
        warnings.warn(
            f'{scene}: the mesh "{name[:80]}" is not checked before Mitsuba reads it: it is no .{kind} file '
            "beside the scene.",
            LoomlightWarning,
            stacklevel=4,
        )
        return
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", LoomlightWarning)  # the sentence below takes its place
        parts = read_parts(mesh)
    bare = sum(len(part.mesh.triangles) for part in parts if len(part.mesh.uv) == 0)
    total = sum(len(part.mesh.triangles) for part in parts)
    if 0 < bare < total:
        raise InputError(
            f"{mesh}: {bare} of {total} triangles have no usable uv coordinates, and Mitsuba takes any "
            "numbers for them: unwrap the mesh, or make two meshes of it."
        )
