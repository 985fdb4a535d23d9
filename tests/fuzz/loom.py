"""Feeds mutilated records of `.loom` files, as under right checksums, to the readers of tiles and materials.

    python -m tests.fuzz.loom [--seconds 60] [--seed 0] [--faults FOLDER]

See `tests.fuzz.fuzzing`. Text that is read must name nothing outside, and must come back from a `.loom`.
"""

from __future__ import annotations

import json
import random
import re
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
from pydantic import ValidationError

from loomlight.core.errors import InputError
from loomlight.core.images import write_pixels
from loomlight.sources.kinds import SOURCE_KINDS
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom
from loomlight.sources.material import Material, material_record
from loomlight.sources.tile import TileScene, tile_record
from tests.fuzz.fuzzing import TEXT, Target, change_json, main

_BITMAP = '<texture type="bitmap" name="reflectance"><string name="filename" value="a.png"/></texture>'
_BSDF = (
    f'<bsdf version="3.0.0" type="twosided"><bsdf type="diffuse">{_BITMAP}</bsdf>'
    '<bsdf type="roughconductor"><string name="material" value="Au"/><float name="alpha" value="0.2"/></bsdf>'
    "</bsdf>"
)
_SCENE = (
    '<scene version="3.0.0"><default name="p" value="0.5"/><shape type="rectangle">'
    f'<transform name="to_world"><scale value="$p"/></transform>{_BSDF}</shape></scene>'
)
_PARTS = (
    "/etc/hostname", "../a.png", "$p", "file:///a", "C:\\a", 'filename="/a"', "woven_lobes", "&#47;", "&#0;",
    '<default name="p" value="/a"/>', '<spectrum name="x" filename="/a"/>', '<include filename="/a"/>',
    '<string name="filename" value="/a"/>', '<path value="/a"/>', "<!--", "<![CDATA[", "\ud800", "filename",
    "<?xml encoding='utf-7'?>",
)  # fmt: skip
# What no attribute of a text that was read may hold, but for names.
_OUTSIDE = re.compile(r"[/\\$]|\.\.|woven")


def _insert_way(chance: random.Random, content: bytes) -> bytes:
    """A way to name a file put into the text, between elements or in place of a value."""
    record = json.loads(content)
    for key in ("xml", "scene"):
        text = record.get(key) if isinstance(record, dict) else None
        if isinstance(text, str):
            spots = [found.span() for found in re.finditer(r'(?<=>)(?=<)|(?<==")[^"]*(?=")', text)]
            first, last = chance.choice(spots or [(0, 0)])
            record[key] = text[:first] + chance.choice(_PARTS) + text[last:]
    return json.dumps(record).encode()


def _change(chance: random.Random, content: bytes) -> bytes:
    try:
        return chance.choice((_insert_way, _insert_way, change_json))(chance, content)
    except (ValueError, RecursionError):  # another mutation left no JSON
        return content


def _reader(kind: str, tensors: dict[str, np.ndarray[Any, Any]], field: str) -> Callable[[bytes], None]:
    def read(content: bytes) -> None:
        try:
            record = json.loads(content)
        except (ValueError, RecursionError) as error:  # `read_loom` answers these itself
            raise InputError("no JSON") from error
        try:
            source = SOURCE_KINDS[kind].from_record(record, tensors, "")
        except ValidationError as error:
            raise InputError("another record") from error
        for element in ElementTree.fromstring(getattr(source, field)).iter():
            assert "filename" not in element.attrib, element.attrib
            for key, value in element.attrib.items():
                assert key in ("id", "name", "as") or not _OUTSIDE.search(value), element.attrib
        with tempfile.TemporaryDirectory() as name:
            write_loom(Path(name) / "a.loom", LoomFile("neumip", source))
            assert getattr(read_loom(Path(name) / "a.loom").source, field) == getattr(source, field)

    return read


def targets() -> Sequence[Target]:
    """A material and a tile."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_pixels(folder / "a.png", np.zeros((4, 4, 3), np.uint8))
        (folder / "m.xml").write_text(_BSDF)
        (folder / "t.xml").write_text(_SCENE)
        (folder / "t.toml").write_text('tile = "t.xml"\nsize_mm = [1.0, 1.0]\n')
        material, tile = load_source(folder / "m.xml"), load_source(folder / "t.toml")
    assert isinstance(material, Material)
    assert isinstance(tile, TileScene)
    found = []
    for kind, field, (record, tensors) in (
        ("material", "xml", material_record(material)),
        ("tile", "scene", tile_record(tile)),
    ):
        originals = [json.dumps(record).encode()]
        if kind == "tile":
            originals.append(json.dumps({**record, "scene": _SCENE}).encode())
        mutations = (*[_change] * 12, *TEXT)
        found.append(Target(kind, originals, mutations, _reader(kind, tensors, field)))
    return found


if __name__ == "__main__":
    sys.exit(main("loom", targets))
