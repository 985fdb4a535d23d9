"""Pictures that are broken on purpose."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path


def png_head(path: Path, width: int, height: int) -> Path:
    """A PNG of so many pixels that holds none of them: what is too large is refused by its head."""

    def chunk(kind: bytes, body: bytes) -> bytes:
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    head = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + head + chunk(b"IDAT", zlib.compress(b"")) + chunk(b"IEND", b""))
    return path
