"""The process that reads files for the server: it limits itself, and answers until its input ends.

It takes a name and a file's content from its input, and gives the answer of a reader or a sentence.
"""

from __future__ import annotations

import json
import struct
import sys
import warnings
from collections.abc import Callable
from pathlib import Path

from loomlight.core.errors import LoomlightError

# Bytes of the name and of the content that follow.
REQUEST = struct.Struct("<IQ")
# Whether an answer follows, or {"error": …}; and its bytes.
ANSWER = struct.Struct("<?Q")

# From a file to its answer, in which warnings are said as the second argument has them.
Reader = Callable[[Path, Callable[[], list[str]]], bytes]


def serve(read: Reader, what: str) -> None:
    """Serves what is asked for; the arguments of the process are FOLDER BYTES SECONDS.

    Args:
        what: a file is, for sentences: "draft".
    """
    limit_memory(int(sys.argv[2]))
    folder, seconds = Path(sys.argv[1]), float(sys.argv[3])
    given, answers = sys.stdin.buffer, sys.stdout.buffer
    # What libraries print would be taken for answers.
    sys.stdout = sys.stderr
    while len(head := given.read(REQUEST.size)) == REQUEST.size:
        name_size, content_size = REQUEST.unpack(head)
        file = folder / given.read(name_size).decode()
        allow_time(seconds)
        file.write_bytes(given.read(content_size))
        is_read, answer = _answer(read, file, what)
        file.unlink()
        answers.write(ANSWER.pack(is_read, len(answer)) + answer)
        answers.flush()


def _answer(read: Reader, file: Path, what: str) -> tuple[bool, bytes]:
    try:
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            return True, read(file, lambda: [without_folder(str(each.message), file) for each in told])
    except LoomlightError as error:
        sentence = without_folder(str(error), file)
    except MemoryError:
        sentence = f"{file.name} takes more memory than a {what} may."
    except Exception as error:  # a reader's defect must not look like the server's
        sentence = f"{file.name} is no {what} that can be read ({type(error).__name__})."
    return False, json.dumps({"error": sentence}).encode()


def without_folder(sentence: str, file: Path) -> str:
    """A sentence in which the file has no folder: it is of no use to who sent the file."""
    return sentence.replace(str(file), file.name)


def limit_memory(memory_bytes: int) -> None:
    """Limits this process; Windows has no such limits, there the server's time limit alone holds."""
    try:
        import resource
    except ImportError:
        return
    resource.setrlimit(resource.RLIMIT_AS, (memory_bytes, memory_bytes))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def allow_time(seconds: float) -> None:
    """So many seconds of the processor from now on; it ends the process."""
    try:
        import resource
    except ImportError:
        return
    usage = resource.getrusage(resource.RUSAGE_SELF)
    used = int(usage.ru_utime + usage.ru_stime)
    _, most = resource.getrlimit(resource.RLIMIT_CPU)
    resource.setrlimit(resource.RLIMIT_CPU, (used + int(seconds) + 2, most))
