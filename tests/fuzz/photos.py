"""Feeds mutilated photographs to what `loomlight capture` reads them by, and looks for threads in them.

    python -m tests.fuzz.photos [--seconds 60] [--faults FOLDER]

See `tests.fuzz.fuzzing`.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

from loomlight.capturing.crossings import find_crossings
from loomlight.capturing.photo import read_photo
from loomlight.capturing.thread_grid import find_grid
from loomlight.weave.named import named_weave
from tests.capturing.pictures import save, woven
from tests.fuzz.fuzzing import BYTES, Target, main


def targets() -> list[Target]:
    """A small photograph as JPEG, and as PNG."""
    folder = Path(tempfile.mkdtemp())

    def subject(content: bytes) -> None:
        (folder / "a.jpg").write_bytes(content)
        encoded = read_photo(folder / "a.jpg", 10.0, side=200).encoded
        crossings = find_crossings(encoded, find_grid(encoded))
        assert min(crossings.shape) > 0

    picture = woven(named_weave("twill 2/1").drawdown, px=(9.0, 10.0), size=(120, 110))
    originals = [save(folder / f"original.{suffix}", picture).read_bytes() for suffix in ("jpg", "png")]
    return [Target("photo", originals, BYTES, subject)]


if __name__ == "__main__":
    sys.exit(main("photos", targets))
