"""The process that makes a fabric of a photograph for the server: it limits itself, and says how far it is.

Its arguments are FILE BYTES SECONDS WIDTH_MM LIGHT. It prints `messages.CaptureLine`s, a line each as JSON:
how far it is, and last the fabric or a sentence.
"""

from __future__ import annotations

import json
import sys
import warnings
from pathlib import Path
from typing import Any, TextIO

from loomlight.core.errors import LoomlightError
from loomlight.viewer.limited_worker import allow_time, limit_memory, without_folder


def main() -> None:
    """Makes the fabric of the file that the arguments name."""
    file, memory, seconds, width_mm, light = sys.argv[1:]
    limit_memory(int(memory))
    allow_time(float(seconds))
    lines = sys.stdout
    # What libraries print would be taken for lines.
    sys.stdout = sys.stderr
    _say(lines, _last_line(lines, Path(file), float(width_mm), light))


def _last_line(lines: TextIO, file: Path, width_mm: float, light: str) -> dict[str, Any]:
    """The fabric, or why there is none."""
    try:
        from loomlight.capturing.capture import capture

        with warnings.catch_warnings():
            # They are the doubts of the result.
            warnings.simplefilter("ignore")
            found = capture(
                file,
                width_mm=width_mm,
                light=light,
                report=lambda done, total: _say(lines, {"share": done / total}),
            )
            return {"share": 1.0, "found": _found(found)}
    except LoomlightError as error:
        sentence = without_folder(str(error), file)
    except MemoryError:
        sentence = f"{file.name} takes more memory than a photograph may: make it smaller."
    except Exception as error:  # a defect must not look like the server's
        sentence = f"{file.name} cannot be captured ({type(error).__name__}); this is a defect of loomlight."
    return {"share": 1.0, "error": sentence}


def _found(found: Any) -> dict[str, Any]:
    from loomlight.viewer.messages import draft_json, fabric_json

    fabric = fabric_json(found.fabric())
    if not found.weave:
        # No name stands for its draft, which the page keeps beside the fields.
        fields = {**fabric["fields"], "draft": f"{Path(found.photo).stem}.wif"}
        fields.pop("weave", None)
        fabric |= {"fields": fields, "draft": draft_json(found.draft)}
    return {"fabric": fabric, "summary": found.summary, "doubts": found.doubts, "unfixed": found.unfixed}


def _say(lines: TextIO, line: dict[str, Any]) -> None:
    lines.write(json.dumps(line) + "\n")
    lines.flush()


if __name__ == "__main__":
    main()
