"""Feeds mutilated drafts to their readers: WIF, Fiberworks, drawdowns, bitmaps of looms, artwork.

    python -m tests.fuzz.wif [--seconds 60] [--count 2000] [--faults FOLDER]

A file is there twice: as it is, and without the line [WIF], as some programs write it. A draft that is read
must survive being written and read again. Files of LOOMLIGHT_DATA/wif join those of the tests. See
`tests.fuzz.fuzzing`.
"""

from __future__ import annotations

import os
import random
import re
import sys
import tempfile
from io import BytesIO
from pathlib import Path

import numpy as np
from PIL import Image

from loomlight.weave import Draft, load_draft, read_bitmap
from loomlight.weave.artwork import BACK, Artwork, weave_artwork
from loomlight.weave.dtx import dtx_text_of
from loomlight.weave.structures import plain, satin
from loomlight.weave.wif_reader import draft_of
from loomlight.weave.wif_text import decode_wif, parse_wif_text
from loomlight.weave.wif_writer import wif_text_of
from tests.fuzz.fuzzing import BYTES, NASTY_TEXTS, TEXT, Target, drop, main, on_pieces, repeat, swap

FIXTURES = Path(__file__).resolve().parents[1] / "cases" / "drafts"
# Larger files would only repeat in more time what smaller ones show.
MAX_BYTES = 30_000

_SECTIONS = (
    "WIF", "CONTENTS", "TEXT", "NOTES", "WEAVING", "WARP", "WEFT", "THREADING", "TIEUP", "TREADLING",
    "LIFTPLAN", "COLOR TABLE", "COLOR PALETTE", "WARP COLORS", "WEFT SPACING", "PRIVATE X", "", "NO SUCH",
)  # fmt: skip
_HEADER = re.compile(r"\[wif\]", re.IGNORECASE)


def _change_line(chance: random.Random, lines: list[bytes]) -> None:
    """The key or the value of a line replaced."""
    at = chance.randrange(len(lines))
    key, equals, value = lines[at].partition(b"=")
    nasty = chance.choice(NASTY_TEXTS).encode()
    if equals:
        lines[at] = key + b"=" + nasty if chance.random() < 0.67 else nasty + b"=" + value


def _rename_section(chance: random.Random, lines: list[bytes]) -> None:
    headers = [at for at, line in enumerate(lines) if line.startswith(b"[")]
    if headers:
        lines[chance.choice(headers)] = b"[" + chance.choice(_SECTIONS).encode() + b"]"


MUTATIONS = (
    *TEXT,
    *map(on_pieces, (_change_line, _change_line, _rename_section)),
    *(on_pieces(change, b"\n[") for change in (drop, repeat, swap)),
)


def _read(content: bytes) -> Draft:
    return draft_of(parse_wif_text(decode_wif(content), "file.wif"))


def read_twice(content: bytes) -> None:
    """Reads a file; what is written of it must be the same draft."""
    draft = _read(content)
    again = _read(wif_text_of(draft).encode("utf-8", errors="replace"))
    assert np.array_equal(draft.drawdown, again.drawdown)
    assert (draft.title, draft.notes) == (again.title, again.notes)
    for one, other in ((draft.warp, again.warp), (draft.weft, again.weft)):
        for name in ("colors", "spacing_mm", "thickness_mm"):
            a, b = getattr(one, name), getattr(other, name)
            assert (a is None) == (b is None)
            assert a is None or np.allclose(a, b, rtol=1e-12, atol=1e-9)


def originals_in(*folders: Path) -> list[bytes]:
    """All weaving information files below the folders that are small enough, each also without [WIF]."""
    files = sorted(file for folder in folders for file in folder.rglob("*.wif"))
    whole = [content for content in (file.read_bytes() for file in files) if len(content) <= MAX_BYTES]
    return [*whole, *(_HEADER.sub("", decode_wif(content), count=1).encode() for content in whole)]


def pictures() -> list[tuple[str, bytes]]:
    """Small drawdowns of each format, with its suffix."""
    up = np.random.default_rng(0).random((12, 16, 1)) < 0.5
    found = []
    for suffix, colours in (
        ("png", (0, 255)), ("bmp", (40, 90)), ("gif", (0, 255)), ("tiff", (0, 255)), ("webp", (170, 250)),
        ("jpeg", (0, 255)),
    ):  # fmt: skip
        held = BytesIO()
        pixels = np.where(up, *colours).astype(np.uint8).repeat(3, axis=2)
        Image.fromarray(pixels).save(held, suffix, **({"lossless": True} if suffix == "webp" else {}))
        found.append((suffix, held.getvalue()))
    return found


def fiberworks() -> list[bytes]:
    """Files of ours: a treadling, a liftplan, a sinking shed, thread colours and spacings, notes."""
    found = [file.read_bytes() for file in sorted(FIXTURES.glob("*.dtx"))]
    return [*found, *(dtx_text_of(load_draft(file))[0].encode() for file in sorted(FIXTURES.glob("*.wif")))]


def bitmaps() -> list[bytes]:
    """Bitmaps of 1 bit of each format that looms take."""
    up = np.random.default_rng(1).random((9, 21)) < 0.5
    found = []
    for suffix in ("png", "bmp", "tiff"):
        held = BytesIO()
        Image.fromarray(np.where(up, 0, 255).astype(np.uint8)).convert("1").save(held, suffix)
        found.append(held.getvalue())
    return found


def targets() -> list[Target]:
    """Weaving information files, Fiberworks files, and pictures and bitmaps by their format."""
    data = os.environ.get("LOOMLIGHT_DATA")
    folders = [FIXTURES, *([Path(data, "wif")] if data else [])]
    folder = Path(tempfile.mkdtemp())

    def subject(content: bytes) -> None:
        # The first bytes tell Pillow the format, whatever the suffix.
        file = folder / "drawdown.png"
        file.write_bytes(content)
        load_draft(file)

    def read_dtx_twice(content: bytes) -> None:
        file = folder / "draft.dtx"
        file.write_bytes(content)
        draft = load_draft(file)
        file.write_text(dtx_text_of(draft)[0], encoding="utf-8", errors="replace", newline="")
        assert np.array_equal(draft.drawdown, load_draft(file).drawdown)

    def bitmap(content: bytes) -> None:
        file = folder / "bitmap.bmp"
        file.write_bytes(content)
        read_bitmap(file)

    def artwork(content: bytes) -> None:
        file = folder / "artwork.png"
        file.write_bytes(content)
        weaves = {"#000000": [satin(5, 2), BACK], "#ffffff": [plain(), plain()]}
        names = {"#000000": ["satin", "back"], "#ffffff": ["plain", "plain"]}
        weave_artwork(file, Artwork(weaves, names, extra_from=2, nearest=True))

    held = [content for _, content in pictures()]
    return [
        Target("wif", originals_in(*folders), MUTATIONS, read_twice),
        Target("dtx", fiberworks(), TEXT, read_dtx_twice),
        Target("pictures", held, BYTES, subject, max_seconds=20),
        Target("bitmaps", bitmaps(), BYTES, bitmap, max_seconds=20),
        Target("artworks", held, BYTES, artwork, max_seconds=20),
    ]


if __name__ == "__main__":
    sys.exit(main("wif", targets))
