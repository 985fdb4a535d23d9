"""The reference page of the Python interface, from signatures and docstrings."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from typing import Any

import loomlight
import loomlight.mitsuba
import loomlight.realtime

TITLE = "Python reference"
_MODULES = (loomlight, loomlight.mitsuba, loomlight.realtime)
_SECTIONS = ("Args", "Attributes", "Returns", "Raises", "Warns", "Source")


def api_text() -> str:
    """Markdown of all public names of the package, of its Mitsuba half and of its real-time half."""
    parts = [
        f"# {TITLE}",
        "Generated from the docstrings. Names are imported from the module that heads them.",
    ]
    for module in _MODULES:
        parts += [f"## {module.__name__}", *_entries(module)]
    return "\n\n".join(parts) + "\n"


def _entries(module: Any) -> Iterator[str]:
    for name in module.__all__:
        value = getattr(module, name)
        yield f"### {name}"
        if callable(value):
            yield f"```python\n{_signature(name, value)}\n```"
            yield _as_markdown(inspect.getdoc(value) or "")
            yield from _methods(value)
        else:
            yield f"`{value!r}`"


def _methods(value: Any) -> Iterator[str]:
    """Public methods of a class, with the first sentence of each."""
    if inspect.isclass(value):
        lines = []
        for name, member in vars(value).items():
            text = inspect.getdoc(member)
            if (
                not name.startswith("_")
                and text
                and (inspect.isroutine(member) or isinstance(member, property))
            ):
                lines.append(f"- `{name}`: {' '.join(text.split(chr(10) * 2)[0].split())}")
        if lines:
            yield "\n".join(lines)


def _signature(name: str, value: Any) -> str:
    try:
        parameters = inspect.signature(value)
    except (TypeError, ValueError):  # a class that is made by C code
        return name
    text = f"{name}{parameters}"
    if len(text) > 100:
        text = f"{name}(\n" + "".join(f"    {each},\n" for each in parameters.parameters.values()) + ")"
    return re.sub(r"(: |-> )'([^']*)'", r"\1\2", text)  # annotations are texts


def _as_markdown(text: str) -> str:
    """A docstring with its sections as lists: "Args:", then "name: meaning" and lines that go on."""
    lines: list[str] = []
    in_section = False
    for line in text.splitlines():
        heading = re.fullmatch(rf"({'|'.join(_SECTIONS)}):(.*)", line)
        entry = re.fullmatch(r"    ([\w, *]+): (.*)", line)
        if heading:
            in_section = not heading[2]
            lines += ["", f"**{heading[1]}**{heading[2]}", ""]
        elif in_section and entry:
            lines.append(f"- `{entry[1]}`: {entry[2]}")
        elif in_section and line.startswith("    "):
            lines.append("  " + line.strip())
        else:
            lines.append(line)
    return "\n".join(lines)
