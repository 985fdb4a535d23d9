"""The process that reads drafts for the server: `python -m loomlight.viewer.wif_worker FOLDER BYTES SECONDS`.

It limits itself, takes a name and a file's content from its input, answers with JSON, and so on until its
input ends, as it does with the server.
"""

from __future__ import annotations

import json
import struct
import sys
import warnings
from pathlib import Path
from typing import Any

from loomlight.core.errors import InputError

# Bytes of the name and of the content that follow.
REQUEST = struct.Struct("<IQ")
# Whether JSON of a draft follows, or {"error": …}; and its bytes.
ANSWER = struct.Struct("<?Q")


def _limit_memory(memory_bytes: int) -> None:
    """Limits this process; Windows has no such limits, there the server's time limit alone holds."""
    try:
        import resource
    except ImportError:
        return
    resource.setrlimit(resource.RLIMIT_AS, (memory_bytes, memory_bytes))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def _allow_time(seconds: float) -> None:
    """So many seconds of the processor from now on; it ends the process."""
    try:
        import resource
    except ImportError:
        return
    usage = resource.getrusage(resource.RUSAGE_SELF)
    used = int(usage.ru_utime + usage.ru_stime)
    _, most = resource.getrlimit(resource.RLIMIT_CPU)
    resource.setrlimit(resource.RLIMIT_CPU, (used + int(seconds) + 2, most))


def _read(file: Path) -> dict[str, Any]:
    from loomlight.viewer.messages import draft_json
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


def _serve(folder: Path, seconds: float) -> None:
    given, answers = sys.stdin.buffer, sys.stdout.buffer
    while len(head := given.read(REQUEST.size)) == REQUEST.size:
        name_size, content_size = REQUEST.unpack(head)
        file = folder / given.read(name_size).decode()
        _allow_time(seconds)
        file.write_bytes(given.read(content_size))
        answer = _read(file)
        file.unlink()
        printed = json.dumps(answer).encode()
        answers.write(ANSWER.pack("error" not in answer, len(printed)) + printed)
        answers.flush()


if __name__ == "__main__":
    _limit_memory(int(sys.argv[2]))
    _serve(Path(sys.argv[1]), float(sys.argv[3]))
