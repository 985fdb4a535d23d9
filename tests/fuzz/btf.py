"""Feeds mutilated measured BTFs to their reader, of both formats; a pixel of each channel is read too.

    python -m tests.fuzz.btf [--seconds 60] [--faults FOLDER]

See `tests.fuzz.fuzzing`.
"""

from __future__ import annotations

import random
import struct
import sys
import tempfile
from pathlib import Path

import numpy as np

from loomlight.sources.btf import read_btf
from tests.fuzz.fuzzing import BYTES, Target, main
from tests.sources.test_btf_files import write_2003, write_2014


def _at_head(chance: random.Random, content: bytes) -> bytes:
    return chance.choice(BYTES)(chance, content[:400]) + content[400:]


def _at_end(chance: random.Random, content: bytes) -> bytes:
    """A mutation of a ZIP's directory."""
    return content[:-1500] + chance.choice(BYTES)(chance, content[-1500:])


def _nasty_float(chance: random.Random, content: bytes) -> bytes:
    value = chance.choice((struct.pack("<f", 3e38), struct.pack("<f", float("nan")), b"\xff\x7b"))
    at = chance.randrange(len(content) // 2, len(content)) if content else 0
    return content[:at] + value + content[at + len(value) :]


def targets() -> list[Target]:
    """What is fed."""
    folder = Path(tempfile.mkdtemp())

    def subject(content: bytes) -> None:
        (folder / "a.btf").write_bytes(content)
        pictures = read_btf(folder / "a.btf")
        rng = np.random.default_rng(0)
        sides = (len(pictures.lights), len(pictures.views), pictures.width, pictures.height)
        values = pictures.pixels(*(rng.integers(side, size=500) for side in sides))
        assert np.isfinite(values).all()

    def originals(write: object, *options: dict[str, object]) -> list[bytes]:
        found = []
        for option in options:
            write(folder / "original", **option)  # type: ignore[operator]
            found.append((folder / "original").read_bytes())
        return found

    return [
        Target("ubo2003", originals(write_2003, {}, {"deflated": True}), (*BYTES, _at_end, _at_end), subject),
        Target(
            "ubo2014",
            originals(write_2014, {}, {"yuv": True}, {"scalar": "<f2"}, {"scalar": "<f8", "version": 1}),
            (*BYTES, _at_head, _nasty_float),
            subject,
        ),
    ]


if __name__ == "__main__":
    sys.exit(main("btf", targets))
