"""Files of drafts that came over the network, read by a process of limited memory and time.

The process is `python -m loomlight.viewer.wif_worker FILE`: it limits itself, reads the file and prints JSON.
The server waits for it and ends it when its time is over, so no file can take the server down.
"""

from __future__ import annotations

import asyncio
import json
import os
import re
import sys
import tempfile
import warnings
from pathlib import Path
from typing import Any

from loomlight.core.errors import InputError

# A WIF of 16384 threads with a colour and a spacing each has some 2 MB.
MAX_UPLOAD = 16 << 20
# The interpreter and NumPy map 0.4 GiB; the largest draft, of 16384² crossings, takes 1.2 GiB meanwhile.
MEMORY_BYTES = 2 << 30
SECONDS = 20.0
_UNSAFE = re.compile(r"[^\w .()+-]+")
_MAX_NAME = 120


async def read_uploaded_draft(
    content: bytes, name: str, *, seconds: float = SECONDS, memory_bytes: int = MEMORY_BYTES
) -> dict[str, Any]:
    """The draft in a file's content, as `draft_json`, with the warnings of its reader in "warnings".

    Args:
        name: of the file; its suffix says what it is, and messages name it.
        seconds: after which the process is ended.
        memory_bytes: of address space that it may take.

    Raises:
        InputError: no draft, or one that takes too much time or memory.
    """
    shown = safe_name(name)
    with tempfile.TemporaryDirectory(prefix="loomlight-") as folder:
        file = Path(folder) / shown
        file.write_bytes(content)
        process = await asyncio.create_subprocess_exec(
            *(
                sys.executable,
                "-m",
                "loomlight.viewer.wif_worker",
                str(file),
                str(memory_bytes),
                str(seconds),
            ),
            stdin=asyncio.subprocess.DEVNULL,
            stdout=asyncio.subprocess.PIPE,
            stderr=asyncio.subprocess.DEVNULL,
            env=_environment(),
        )
        try:
            async with asyncio.timeout(seconds):
                printed, _ = await process.communicate()
        except TimeoutError as error:
            raise InputError(
                f"{shown} was given up after {seconds:g} s; a draft takes less than one."
            ) from error
        finally:
            if process.returncode is None:
                process.kill()
                await process.wait()
    return _answer(printed, shown, memory_bytes)


def safe_name(name: str) -> str:
    """The last part of a path as a file name that no system and no terminal misreads."""
    last = re.split(r"[/\\]", name)[-1]
    cleaned = _UNSAFE.sub("_", last).strip(" .")
    stem, dot, suffix = cleaned.rpartition(".")
    if not dot:
        return (cleaned or "draft")[:_MAX_NAME]
    return f"{stem[:_MAX_NAME] or 'draft'}.{suffix[:8]}"


def _environment() -> dict[str, str]:
    """This process's, with the places that it imports from; pools of threads would take address space."""
    places = os.pathsep.join(place for place in sys.path if place)
    return {**os.environ, "PYTHONPATH": places, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def _answer(printed: bytes, name: str, memory_bytes: int) -> dict[str, Any]:
    try:
        answer = json.loads(printed)
    except ValueError as error:
        raise InputError(
            f"{name} could not be read within {memory_bytes >> 20} MiB of memory; drafts take far less."
        ) from error
    if "error" in answer:
        raise InputError(answer["error"])
    return dict(answer)


def _limit(memory_bytes: int, seconds: float) -> None:
    """Limits this process; Windows has no such limits, there the server's time limit alone holds."""
    try:
        import resource
    except ImportError:
        return
    resource.setrlimit(resource.RLIMIT_AS, (memory_bytes, memory_bytes))
    # Of the processor, not of the clock; a process that handles SIGXCPU is killed a second later.
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def _read(file: Path) -> dict[str, Any]:
    from loomlight.viewer.draft_json import draft_json
    from loomlight.weave.load import load_draft

    try:
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            draft = draft_json(load_draft(file))
    except InputError as error:
        return {"error": _without_folder(str(error), file)}
    except MemoryError:
        return {"error": f"{file.name} takes more memory than a draft may."}
    except Exception as error:  # a reader's defect must not look like the server's
        return {"error": f"{file.name} is no draft that can be read ({type(error).__name__})."}
    return {**draft, "warnings": [_without_folder(str(each.message), file) for each in told]}


def _without_folder(sentence: str, file: Path) -> str:
    return sentence.replace(str(file), file.name)


if __name__ == "__main__":
    _limit(int(sys.argv[2]), float(sys.argv[3]))
    json.dump(_read(Path(sys.argv[1])), sys.stdout)
