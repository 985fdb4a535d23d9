"""Feeds mutilated U3M materials to their reader: documents, archives and pictures.

    python -m tests.fuzz.u3m [--seconds 60] [--faults FOLDER]

What is read must be shown by finite values, come back from an archive, and write nothing outside. See
`tests.fuzz.fuzzing`.
"""

from __future__ import annotations

import io
import json
import random
import sys
import tempfile
import time
import warnings
import zipfile
import zlib
from pathlib import Path

import numpy as np

from loomlight.models.standard.maps import FaceMaps
from loomlight.sources.u3m import load_u3m
from loomlight.sources.u3m_file import archive_bytes, is_relative_path, read_u3m, write_u3ma
from tests.fuzz.fuzzing import BYTES, TEXT, Target, change_json, main
from tests.helpers.u3m import image, material, png, visual

_NAMES = (
    "../a.png",
    "/a.png",
    "C:\\a.png",
    "a.u3m",
    "con",
    "A.PNG",
    "a.png",
    "x" * 300,
    "",
    "a/../b",
    "a\x00b",
    "ä",
)


def document() -> bytes:
    """A document of two faces and two pictures."""
    white = {"r": 1, "g": 1, "b": 1}
    colour = {"constant": white, "texture": {"mode": "multiply", "factor": white, "image": image("a.png")}}
    rough = {"constant": 0.5, "texture": {"factor": 1, "offset": 0, "image": image("b.png", mode="mirror_y")}}
    normal = {"constant": {"x": 0, "y": 0, "z": 1}, "texture": {"scale": 1, "image": image("b.png")}}
    front = visual(basecolor=colour, roughness=rough, normal=normal, anisotropy_value=0.5, alpha=0.9)
    made = material(front, visual(roughness=0.3), a=png(_PIXELS), b=png(_PIXELS[:2]))
    return json.dumps(made.file.document).encode()


_PIXELS = np.arange(72, dtype=np.uint8).reshape(4, 6, 3)


def archive(text: bytes) -> bytes:
    """A strict archive of a document and its pictures."""
    files = {"x.u3m": text, "a.png": png(_PIXELS), "b.png": png(_PIXELS[:2]), "other/data.bin": bytes(50)}
    return archive_bytes(files, time.gmtime(1e9))


def _loose(chance: random.Random, content: bytes) -> bytes:
    """The same files as another program's zip, one under a nasty name, or a document that is changed."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as found:
            files = [(name, found.read(name)) for name in found.namelist()]
    except Exception:  # another mutation left no archive
        return content
    at = chance.randrange(len(files)) if files else 0
    stream = io.BytesIO()
    # It warns of names that are there twice, which is what is wanted.
    with (
        warnings.catch_warnings(action="ignore"),
        zipfile.ZipFile(stream, "w", chance.choice((0, 8, 14))) as made,
    ):
        for number, (name, each) in enumerate(files):
            if number == at and chance.random() < 0.3:
                name = chance.choice(_NAMES)
            elif number == at:
                each = (
                    change_json(chance, each) if name.endswith(".u3m") else chance.choice(BYTES)(chance, each)
                )
            made.writestr(name or "x", each)
    return stream.getvalue()


def _picture(chance: random.Random, content: bytes) -> bytes:
    """A changed head of a PNG under a right checksum."""
    at = content.find(b"IHDR")
    if at < 0 or at + 21 > len(content):
        return content
    head = bytearray(content[at : at + 17])
    head[chance.randrange(4, 17)] = chance.randrange(256)
    return content[:at] + bytes(head) + zlib.crc32(bytes(head)).to_bytes(4, "big") + content[at + 21 :]


def targets() -> list[Target]:
    """Documents beside their pictures, archives, and pictures."""
    folder = Path(tempfile.mkdtemp())
    (folder / "a.png").write_bytes(png(_PIXELS))
    (folder / "b.png").write_bytes(png(_PIXELS[:2]))

    def read(path: Path) -> None:
        found = load_u3m(path)
        assert all(map(is_relative_path, found.file.files)), list(found.file.files)
        for face in found.faces:
            assert all(np.isfinite(level).all() for level in FaceMaps.of(face).levels)
        write_u3ma(folder / "again.u3ma", found.file)
        again = read_u3m(folder / "again.u3ma")
        assert (again.document, dict(again.files)) == (found.file.document, dict(found.file.files))

    def loose(content: bytes) -> None:
        (folder / "x.u3m").write_bytes(content)
        read(folder / "x.u3m")

    def packed(content: bytes) -> None:
        (folder / "x.u3ma").write_bytes(content)
        read(folder / "x.u3ma")

    def picture(content: bytes) -> None:
        files = {"x.u3m": document(), "a.png": content, "b.png": content}
        (folder / "p.u3ma").write_bytes(archive_bytes(files, time.gmtime(1e9)))
        read(folder / "p.u3ma")

    return [
        Target("u3m", [document()], (*TEXT, *[change_json] * 12), loose),
        Target("u3ma", [archive(document())], (*BYTES, *[_loose] * 8), packed),
        Target("u3m-picture", [png(_PIXELS)], (*BYTES, _picture, _picture), picture),
    ]


if __name__ == "__main__":
    sys.exit(main("u3m", targets))
