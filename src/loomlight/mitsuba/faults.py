"""What other libraries say when they fail, as the end of a sentence for a person."""

from __future__ import annotations

import re

# "[parser.cpp:1718] At dictionary node …: [OBJMesh] what went wrong": only the last part is about the file.
_ORIGIN = re.compile(r".*\[[\w.:]+\] ")
# What Mitsuba's mesh readers stumble over when a file has no faces.
_NO_FACES = "Storing new normals in a Mesh"


def reason_of(error: Exception) -> str:
    """The last line of the message of `error`, without where in the library it was raised."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    text = _ORIGIN.sub("", lines[-1]) if lines else ""
    if text.startswith(_NO_FACES):
        return "it holds no triangles."
    return text if " " in text else f"{type(error).__name__} {text}".strip()
