"""USD read in a process of its own, which stays for further files: `python -m loomlight.mesh.usd_worker`.

usd-core ends its process at some damage, and says things on the terminal that nobody can silence from Python.
"""

from __future__ import annotations

import gc
import os
import pickle
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import warnings
import weakref
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.extras import import_extra
from loomlight.mesh.cloth_mesh import MeshPart
from loomlight.mesh.file_camera import FileCamera

# Ten million triangles take a minute.
_MAX_SECONDS = 600.0
# After the last file it gives its memory back: it starts in less than a second.
_IDLE_SECONDS = 10.0
# Of address space, beside so many times the file: a damaged one may ask for any amount, and ten million
# triangles that a small one shows again and again take 6 GiB.
_MAX_BYTES, _BYTES_OF_FILE = 8 << 30, 32


def read_usd(file: Path, time: float | None = None) -> list[MeshPart]:
    """As `usd.read_usd`, in the other process."""
    parts: list[MeshPart] = _worker().answer("read_usd", file, time)
    return parts


def usd_frames(file: Path) -> list[float]:
    """As `usd.usd_frames`, in the other process."""
    times: list[float] = _worker().answer("usd_frames", file)
    return times


def usd_cameras(file: Path, time: float | None = None) -> list[FileCamera]:
    """As `usd.usd_cameras`, in the other process."""
    cameras: list[FileCamera] = _worker().answer("usd_cameras", file, time)
    return cameras


@dataclass(eq=False)
class _Worker:
    """The process, which starts with the first question; it belongs to the process that it started in."""

    owner: int = field(default_factory=os.getpid)
    _process: subprocess.Popen[bytes] | None = None
    _end: Callable[[], object] = lambda: None
    _idle: threading.Timer | None = None
    _lock: threading.Lock = field(default_factory=threading.Lock)

    def answer(self, what: str, file: Path, *more: object) -> Any:
        """What a function of `loomlight.mesh.usd` returns, its warnings and errors included.

        Raises:
            InputError: what it raises, or the process ended or took too long.
            MissingDependencyError: usd-core is not installed.
        """
        import_extra("pxr", "usd", f"{file}: a mesh in USD")
        with self._lock:
            process = self._started()
            is_late = threading.Event()

            def give_up() -> None:
                is_late.set()
                process.kill()

            timer = threading.Timer(_MAX_SECONDS, give_up)
            timer.daemon = True
            timer.start()
            try:
                kind, result, told = _asked(process, (_current_folder(), what, file, *more))
            except (OSError, EOFError, pickle.UnpicklingError) as error:
                self._stop()
                if is_late.is_set():
                    raise InputError(f"{file} was given up after {_MAX_SECONDS:g} s.") from error
                raise InputError(
                    f"{file} is damaged or takes too much memory: usd-core ended as it read it."
                ) from error
            except BaseException:  # an interruption: the answer would be that to another question
                self._stop()
                raise
            finally:
                timer.cancel()
            self._rest()
        for sentence in told:
            warnings.warn(sentence, LoomlightWarning, stacklevel=5)
        if kind == "fault":
            raise RuntimeError(result)
        if kind == "refused":
            raise result
        return result

    def close(self) -> None:
        """Ends the process; another question starts one anew."""
        with self._lock:
            self._stop()

    def _stop(self) -> None:
        self._end()
        self._process = None

    def _rest(self) -> None:
        if self._idle is not None:
            self._idle.cancel()
        self._idle = threading.Timer(_IDLE_SECONDS, self.close)
        self._idle.daemon = True
        self._idle.start()

    def _started(self) -> subprocess.Popen[bytes]:
        if self._process is None or self._process.poll() is not None:
            self._end()
            folder = tempfile.mkdtemp(prefix="loomlight-")  # for reports of crashes, which nobody asked for
            places = os.pathsep.join(place for place in sys.path if place)
            self._process = subprocess.Popen(
                [sys.executable, "-P", "-m", "loomlight.mesh.usd_worker"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                env={**os.environ, "PYTHONPATH": places, "TMPDIR": folder},
            )
            self._end = weakref.finalize(self, _ended, self._process, folder, self.owner)
        return self._process


_current = _Worker()


def _worker() -> _Worker:
    """The worker of this process: a forked one must not share the pipes of its parent."""
    global _current
    if _current.owner != os.getpid():
        _current = _Worker()
    return _current


def _current_folder() -> str | None:
    """The folder that relative names start from, which may have changed since the other process began."""
    try:
        return os.getcwd()
    except OSError:  # it is gone
        return None


def _asked(process: subprocess.Popen[bytes], question: tuple[object, ...]) -> tuple[str, Any, list[str]]:
    assert process.stdin is not None
    assert process.stdout is not None
    pickle.dump(question, process.stdin)
    process.stdin.flush()
    answer: tuple[str, Any, list[str]] = pickle.load(process.stdout)
    return answer


def _ended(process: subprocess.Popen[bytes], folder: str, owner: int) -> None:
    if owner != os.getpid():
        return
    process.kill()
    process.wait()
    for pipe in (process.stdin, process.stdout):
        if pipe is not None:
            with suppress(OSError):  # what was not yet sent to a process that is gone
                pipe.close()
    shutil.rmtree(folder, ignore_errors=True)


# ------------------------------------------------------------------------------------------ the other process


def _limit_memory(file: Path) -> None:
    """Limits this process while it reads a file; Windows has no such limits."""
    try:
        import resource
    except ImportError:
        return
    limit = _MAX_BYTES + _BYTES_OF_FILE * file.stat().st_size
    _, most = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(
        resource.RLIMIT_AS, (limit if most == resource.RLIM_INFINITY else min(limit, most), most)
    )
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def _answer(folder: str | None, what: str, *arguments: Any) -> tuple[str, Any, list[str]]:
    from loomlight.core.errors import LoomlightError
    from loomlight.mesh import usd

    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        try:
            if folder is not None:
                os.chdir(folder)
            _limit_memory(arguments[0])
            kind, result = "done", getattr(usd, what)(*arguments)
        except LoomlightError as error:
            kind, result = "refused", error
        except MemoryError:
            kind, result = "refused", InputError(f"{arguments[0]} takes more memory than there is.")
        except Exception as error:  # whatever damage the reader did not foresee
            kind, result = "fault", f"{type(error).__name__}: {error!r}"
    if isinstance(result, Exception):
        # Its frames hold the stage, of which the next question would be told, should the file have changed.
        result.__traceback__ = result.__cause__ = result.__context__ = None
    if kind != "done":
        gc.collect()
    return kind, result, [str(each.message) for each in told if issubclass(each.category, LoomlightWarning)]


def _serve(questions: BinaryIO, answers: BinaryIO) -> None:
    while True:
        try:
            question = pickle.load(questions)
        except EOFError:  # the other process has ended
            return
        pickle.dump(_answer(*question), answers)
        answers.flush()


if __name__ == "__main__":
    # An interruption is the other process's to handle.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # whatever is printed is no answer
    _serve(sys.stdin.buffer, answers)
