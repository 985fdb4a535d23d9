"""Feeds mutilated measured BRDFs to their readers: MERL's `.binary`, and RGL's `.bsdf`.

    python -m tests.fuzz.merl [--seconds 60] [--faults FOLDER]

See `tests.fuzz.fuzzing`.
"""

from __future__ import annotations

import math
import random
import struct
import sys
import tempfile
from pathlib import Path

import numpy as np

from loomlight.mitsuba.material_btf import MaterialBtf
from loomlight.sources.material import load_material
from loomlight.sources.merl import BINS, read_merl
from tests.fuzz.fuzzing import BYTES, Target, main

_DIRECTIONS = np.array([[0, 0, 1], [0.6, 0, 0.8], [0, -0.995, 0.1]], np.float32)


def merl_file() -> bytes:
    """A file of constant reflectance."""
    return struct.pack("<3i", *BINS) + np.full(3 * math.prod(BINS), 0.5).tobytes()


def rgl_file() -> bytes:
    """A small isotropic file of RGL's, of constant reflectance."""
    theta = np.linspace(0, np.pi / 2, 4, dtype=np.float32)
    grid, square = (1, 4, 4, 4), (4, 4)
    fields: dict[str, np.ndarray] = {
        "description": np.frombuffer(b"constant", np.uint8),
        "theta_i": theta,
        "phi_i": np.zeros(1, np.float32),
        "ndf": np.ones(square, np.float32),
        "sigma": np.ones(square, np.float32),
        "vndf": np.ones(grid, np.float32),
        "luminance": np.ones(grid, np.float32),
        "rgb": np.full((1, 4, 3, 4, 4), 0.3, np.float32),
        "jacobian": np.zeros(1, np.uint8),
    }
    codes = {np.dtype(np.uint8): 1, np.dtype(np.float32): 10}
    start = 18 + sum(13 + len(name) + 8 * array.ndim for name, array in fields.items())
    head = b"tensor_file\0" + struct.pack("<BBI", 1, 0, len(fields))
    body = b""
    for name, array in fields.items():
        head += struct.pack("<H", len(name)) + name.encode()
        head += struct.pack("<HBQ", array.ndim, codes[array.dtype], start + len(body))
        head += struct.pack(f"<{array.ndim}Q", *array.shape)
        body += array.tobytes()
    return head + body


def _at_head(chance: random.Random, content: bytes) -> bytes:
    """A mutation of the first bytes, which say what follows."""
    return chance.choice(BYTES)(chance, content[:400]) + content[400:]


def _nasty_double(chance: random.Random, content: bytes) -> bytes:
    value = struct.pack(
        "<d", chance.choice((math.nan, math.inf, -math.inf, 1e300, -1e300, 1e9, -1.0, 5e-324))
    )
    at = 12 + 8 * chance.randrange(max((len(content) - 12) // 8, 1))
    return content[:at] + value + content[at + 8 :]


def targets() -> list[Target]:
    """What is fed."""
    folder = Path(tempfile.mkdtemp())

    def merl(content: bytes) -> None:
        (folder / "a.binary").write_bytes(content)
        read_merl(folder / "a.binary")

    def rgl(content: bytes) -> None:
        (folder / "a.bsdf").write_bytes(content)
        material = load_material(folder / "a.bsdf")
        values = MaterialBtf(material).values(np.zeros((3, 2), np.float32), _DIRECTIONS, _DIRECTIONS, (0,))
        assert np.isfinite(values).all()

    return [
        Target("merl", [merl_file()], (*BYTES, _at_head, _nasty_double, _nasty_double), merl),
        Target("rgl", [rgl_file()], (*BYTES, _at_head, _at_head), rgl),
    ]


if __name__ == "__main__":
    sys.exit(main("merl", targets))
