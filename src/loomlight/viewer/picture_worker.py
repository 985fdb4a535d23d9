"""Pictures of stages by a process of its own: `python -m loomlight.viewer.picture_worker`.

Dr.Jit holds Python's lock while it compiles, and a picture that nobody waits for any more can be ended with
its process alone. It stays for further pictures, and is ended by the next that comes before it is done.
"""

from __future__ import annotations

import hashlib
import json
import os
import struct
import subprocess
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.files import cache_folder, replacing

# Of a request; whether it is a picture, and the length of an answer.
REQUEST, ANSWER = struct.Struct("<Q"), struct.Struct("<?Q")
# Pictures that are kept for the next visit, newest first.
MAX_KEPT = 64
_VERSION = b"1"


class PictureMaker:
    """Makes one picture at a time, in a process that starts with the first."""

    def __init__(self, folder: Path | None = None) -> None:
        """
        Args:
            folder: where pictures are kept; in the user's cache by default.
        """
        self._given_folder = folder
        self._process: subprocess.Popen[bytes] | None = None
        self._turn = threading.Lock()
        self._asked: object = None

    def picture(self, content: bytes, asked: object = None) -> bytes:
        """The PNG of a stage, `picture.stage_png` of what a page sent; it ends a picture that is being made.

        Args:
            content: what the page sent.
            asked: the request, for `stop`.

        Raises:
            InputError: content that is no stage, or a picture that another one ended.
        """
        kept = self._folder() / f"{hashlib.sha256(_VERSION + content).hexdigest()}.png"
        with suppress(OSError):
            found = kept.read_bytes()
            os.utime(kept, ns=(now := time.time_ns(), now))
            return found
        if not self._turn.acquire(blocking=False):
            self.stop(self._asked)
            self._turn.acquire()
        try:
            self._asked = asked
            png = self._made(content)
        finally:
            self._asked = None
            self._turn.release()
        self._keep(kept, png)
        return png

    def stop(self, asked: object) -> None:
        """Ends the process if it makes the picture of this request."""
        if self._process is not None and asked is self._asked:
            self._process.kill()

    def close(self) -> None:
        """Ends the process."""
        self.stop(self._asked)

    def _made(self, content: bytes) -> bytes:
        process = self._started()
        assert process.stdin is not None
        assert process.stdout is not None
        with suppress(OSError):  # it was ended
            process.stdin.write(REQUEST.pack(len(content)) + content)
            process.stdin.flush()
        head = process.stdout.read(ANSWER.size)
        if len(head) == ANSWER.size:
            is_picture, size = ANSWER.unpack(head)
            answer = process.stdout.read(size)
            if len(answer) == size:
                if is_picture:
                    return answer
                raise InputError(json.loads(answer)["error"])
        process.wait()
        raise InputError("The picture was given up.")

    def _started(self) -> subprocess.Popen[bytes]:
        if self._process is None or self._process.poll() is not None:
            places = os.pathsep.join(place for place in sys.path if place)
            self._process = subprocess.Popen(
                [sys.executable, "-m", "loomlight.viewer.picture_worker"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                env={**os.environ, "PYTHONPATH": places},
            )
        return self._process

    def _folder(self) -> Path:
        return self._given_folder or cache_folder("stages")

    def _keep(self, file: Path, png: bytes) -> None:
        with suppress(OSError):  # a cache that cannot be written is none
            self._folder().mkdir(parents=True, exist_ok=True)
            with replacing(file) as temporary:
                temporary.write_bytes(png)
            kept = sorted(self._folder().glob("*.png"), key=lambda each: each.stat().st_mtime, reverse=True)
            for old in kept[MAX_KEPT:]:
                old.unlink(missing_ok=True)


def _serve() -> None:
    from loomlight.core.errors import LoomlightError
    from loomlight.viewer.picture import stage_png

    given, answers = sys.stdin.buffer, sys.stdout.buffer
    # What libraries print would be taken for answers.
    sys.stdout = sys.stderr
    while len(head := given.read(REQUEST.size)) == REQUEST.size:
        content = given.read(REQUEST.unpack(head)[0])
        try:
            is_picture, answer = True, stage_png(content)
        except LoomlightError as error:
            is_picture, answer = False, json.dumps({"error": str(error)}).encode()
        except Exception as error:  # a defect must not look like the server's
            sentence = f"The picture cannot be made ({type(error).__name__}); this is a defect of loomlight."
            is_picture, answer = False, json.dumps({"error": sentence}).encode()
        answers.write(ANSWER.pack(is_picture, len(answer)) + answer)
        answers.flush()


if __name__ == "__main__":
    _serve()
