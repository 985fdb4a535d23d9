"""A fabric from a photograph that came over the network, by a process of limited memory and time.

Each photograph has a process of its own, which is ended when nobody waits for it any more.
"""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from collections.abc import AsyncIterator
from pathlib import Path
from tempfile import TemporaryDirectory

import anyio

from loomlight.core.errors import InputError
from loomlight.viewer.limited_reader import environment, safe_name

# A photograph of 50 megapixels is read in 2 GB; the largest that is worked on takes 1.5 GB more.
MAX_PHOTO = 64 << 20
MEMORY_BYTES = 8 << 30
# It takes one or two minutes; on a busy machine several.
SECONDS = 900.0
LIGHTS = ("flash", "window")


def width_and_light(width_mm: str, light: str) -> tuple[float, str]:
    """What a page says of a photograph.

    Raises:
        InputError: a width that is no number, or an unknown light.
    """
    try:
        width = float(width_mm)
    except ValueError as error:
        raise InputError(f"width_mm = {width_mm[:40]!r} is no number of millimetres.") from error
    if light not in LIGHTS:
        raise InputError(f"light = {light[:40]!r} is unknown: write {' or '.join(LIGHTS)}.")
    return width, light


async def capture_lines(
    content: bytes, name: str, width_mm: float, light: str, seconds: float = SECONDS
) -> AsyncIterator[bytes]:
    """Lines of JSON, `messages.CaptureLine`s: how far the work is, and last the fabric or a sentence.

    Args:
        content: of a picture file; the suffix of `name` says which, and messages name it.
        width_mm: millimetres of cloth that it is wide.
        light: of `LIGHTS`.
        seconds: that it may take.
    """
    shown = safe_name(name)
    with TemporaryDirectory(prefix="loomlight-") as folder:
        file = Path(folder) / shown
        file.write_bytes(content)
        arguments = (str(file), str(MEMORY_BYTES), str(seconds), str(width_mm), light)
        process = subprocess.Popen(
            [sys.executable, "-m", "loomlight.viewer.capture_worker", *arguments],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env=environment(),
        )
        timer = threading.Timer(seconds, process.kill)
        timer.start()
        try:
            assert process.stdout is not None
            last = b""
            while line := await anyio.to_thread.run_sync(process.stdout.readline, abandon_on_cancel=True):
                last = line
                yield line
            if not _is_last(last):
                sentence = (
                    f"{shown} was given up: it took more than {seconds:g} s or {MEMORY_BYTES >> 30} GiB."
                )
                yield json.dumps({"share": 1.0, "error": sentence}).encode() + b"\n"
        finally:
            # Also where the page has gone, and nobody reads on.
            timer.cancel()
            process.kill()
            process.wait()


def _is_last(line: bytes) -> bool:
    return b'"found"' in line or b'"error"' in line
