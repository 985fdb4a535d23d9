"""Messages of other libraries, as the end of a sentence for a person."""

from __future__ import annotations

import re

# "[parser.cpp:1718] At dictionary node …: [OBJMesh] what went wrong": only the last part is about the file.
_ORIGIN = re.compile(r".*\[[\w.:]+\] ")
# A sentence of ours, as the last line of a plugin's traceback.
_OURS = re.compile(r"^(?:\w+\.)*InputError: ")
# Mitsuba lists what it does not know below its sentence, an entry a line.
_ENTRY = "- "
# What Mitsuba's mesh readers stumble over when a file has no faces.
_NO_FACES = "Storing new normals in a Mesh"


def reason_of(error: Exception) -> str:
    """The last sentence of the message of `error`, without where in the library it was raised."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    entries: list[str] = []
    while len(lines) > 1 and lines[-1].startswith(_ENTRY):
        entries.insert(0, lines.pop().removeprefix(_ENTRY))
    text = _OURS.sub("", _ORIGIN.sub("", lines[-1])) if lines else ""
    if entries:
        return f"{text} {', '.join(entries)}"
    if text.startswith(_NO_FACES):
        return "it holds no triangles."
    return text if " " in text else f"{type(error).__name__} {text}".strip()
