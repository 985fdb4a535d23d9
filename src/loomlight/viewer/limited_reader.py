"""Files that came over the network, drafts and meshes, read by a process of limited memory and time.

The process stays for further files. It is ended when its time for a file is over, so no file can take the
server down; the next one starts another process.
"""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import threading
import weakref
from collections.abc import Callable
from contextlib import suppress
from tempfile import TemporaryDirectory

from loomlight.core.errors import InputError
from loomlight.viewer.limited_worker import ANSWER, REQUEST

# A WIF of 16384 threads with a colour and a spacing each has some 2 MB.
MAX_UPLOAD = 16 << 20
# The interpreter and NumPy map 0.4 GiB; the largest draft, of 16384² crossings, takes 1.2 GiB meanwhile.
MEMORY_BYTES = 2 << 30
SECONDS = 20.0
# A page reads meshes as large; a million triangles without uv take 1.5 GiB to cut, and a minute.
MAX_MESH = 64 << 20
_MESH_BYTES, _MESH_SECONDS = 6 << 30, 180.0
# Files after which a process is replaced, so that what readers leave behind does not grow.
_MAX_SERVED = 200
_UNSAFE = re.compile(r"[^\w .()+-]+")
_MAX_NAME = 120


class LimitedReader:
    """Reads one file at a time, in a process that starts with the first.

    Attributes:
        worker: the module of the process.
        usual: how long a file takes, the end of a sentence.
        less: how much memory, too.
    """

    worker = ""
    usual = ""
    less = ""

    def __init__(self, seconds: float, memory_bytes: int) -> None:
        """
        Args:
            seconds: that a file may take.
            memory_bytes: of address space that the process may take.
        """
        self._seconds = seconds
        self._memory_bytes = memory_bytes
        self._process: subprocess.Popen[bytes] | None = None
        self._served = 0
        self._end: Callable[[], object] = lambda: None

    def read(self, content: bytes, name: str) -> bytes:
        """The worker's answer to a file's content.

        Args:
            name: of the file; its suffix says what it is, and messages name it.

        Raises:
            InputError: no such file, or one that takes too much time or memory.
        """
        shown = safe_name(name)
        process = self._started()
        is_late = threading.Event()

        def give_up() -> None:
            is_late.set()
            process.kill()

        timer = threading.Timer(self._seconds, give_up)
        timer.start()
        try:
            answer = _asked(process, content, shown)
        finally:
            timer.cancel()
        self._served += 1
        if answer is None or self._served >= _MAX_SERVED:
            self.close()
        if answer is None:
            if is_late.is_set() or process.returncode == -getattr(signal, "SIGXCPU", 999):
                raise InputError(f"{shown} was given up after {self._seconds:g} s; {self.usual}.")
            raise InputError(
                f"{shown} could not be read within {self._memory_bytes >> 20} MiB of memory{self.less}."
            )
        is_read, printed = answer
        if not is_read:
            raise InputError(json.loads(printed)["error"])
        return printed

    def close(self) -> None:
        """Ends the process; another file starts one anew."""
        self._end()
        self._process, self._served = None, 0

    def _started(self) -> subprocess.Popen[bytes]:
        if self._process is None or self._process.poll() is not None:
            self.close()
            folder = TemporaryDirectory(prefix="loomlight-")
            limits = (folder.name, str(self._memory_bytes), str(self._seconds))
            self._process = subprocess.Popen(
                [sys.executable, "-m", self.worker, *limits],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                env=environment(),
            )
            self._end = weakref.finalize(self, _ended, self._process, folder)
        return self._process


class DraftReader(LimitedReader):
    """Reads drafts: JSON of `draft_json` with its reader's warnings in "warnings"."""

    worker = "loomlight.viewer.wif_worker"
    usual, less = "a draft takes less than one", "; drafts take far less"

    def __init__(self, seconds: float = SECONDS, memory_bytes: int = MEMORY_BYTES) -> None:
        super().__init__(seconds, memory_bytes)


class MeshReader(LimitedReader):
    """Reads meshes, cut where they have no uv: the bytes of `mesh_message`."""

    worker = "loomlight.viewer.mesh_worker"
    usual, less = "loomlight render --mesh takes its time with it", "; simplify it"

    def __init__(self, seconds: float = _MESH_SECONDS, memory_bytes: int = _MESH_BYTES) -> None:
        super().__init__(seconds, memory_bytes)


def safe_name(name: str) -> str:
    """The last part of a path as a file name that no system and no terminal misreads."""
    last = re.split(r"[/\\]", name)[-1]
    cleaned = _UNSAFE.sub("_", last).strip(" .")
    stem, dot, suffix = cleaned.rpartition(".")
    if not dot:
        return (cleaned or "draft")[:_MAX_NAME]
    return f"{stem[:_MAX_NAME] or 'draft'}.{suffix[:8]}"


def _asked(process: subprocess.Popen[bytes], content: bytes, name: str) -> tuple[bool, bytes] | None:
    """Whether a process read a file, and its answer; None if it ended."""
    assert process.stdin is not None
    assert process.stdout is not None
    named = name.encode()
    try:
        process.stdin.write(REQUEST.pack(len(named), len(content)) + named + content)
        process.stdin.flush()
    except OSError:  # it ended, and its pipe is gone
        process.wait()
        return None
    head = process.stdout.read(ANSWER.size)
    if len(head) == ANSWER.size:
        is_read, size = ANSWER.unpack(head)
        printed = process.stdout.read(size)
        if len(printed) == size:
            return is_read, printed
    process.wait()
    return None


def _ended(process: subprocess.Popen[bytes], folder: TemporaryDirectory[str]) -> None:
    process.kill()
    process.wait()
    for pipe in (process.stdin, process.stdout):
        if pipe is not None:
            with suppress(OSError):  # what was not yet sent to a process that is gone
                pipe.close()
    folder.cleanup()


def environment() -> dict[str, str]:
    """This process's, with the places that it imports from; pools of threads would take address space."""
    places = os.pathsep.join(place for place in sys.path if place)
    return {**os.environ, "PYTHONPATH": places, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
