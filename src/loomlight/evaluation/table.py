"""Tables of figures: written as JSON for programs and as Markdown for people."""

from __future__ import annotations

import json
import math
import os
import re
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from loomlight.core.files import replacing

Cell = float | int | str | None

_DIGITS = 6  # significant, of numbers in JSON
# A list of numbers alone, which is read more easily on one line.
_NUMBERS = re.compile(r"\[\s*[-+\d.eE,\s]*?\s*\]")


@dataclass
class Table:
    """A table.

    Attributes:
        title: of the table.
        columns: headings, without that of the row's name.
        rows: cells by the row's name, one a column; None is an empty cell.
        note: explanation.
        digits: significant digits of Markdown's numbers.
    """

    title: str
    columns: list[str]
    rows: dict[str, list[Cell]] = field(default_factory=dict)
    note: str = ""
    digits: int = 3

    def to_dict(self) -> dict[str, Any]:
        """The table for JSON: rows as objects by column; NaN and infinity are null."""
        rows = {
            name: {column: _plain(cell) for column, cell in zip(self.columns, cells, strict=True)}
            for name, cells in self.rows.items()
        }
        return {"title": self.title, "note": self.note, "rows": rows}

    @classmethod
    def from_dict(cls, content: dict[str, Any]) -> Table:
        """The table that `to_dict` made JSON of."""
        rows = {name: list(cells.values()) for name, cells in content["rows"].items()}
        columns = next((list(cells) for cells in content["rows"].values()), [])
        return cls(content["title"], columns, rows, content["note"])

    def to_markdown(self) -> str:
        """The table in Markdown, its title as a heading."""
        note = f"{self.note}\n\n" if self.note else ""
        return f"### {self.title}\n\n{note}{self.grid()}"

    def grid(self) -> str:
        """The rows in Markdown, with their headings alone."""
        lines = ["| " + " | ".join(["", *self.columns]) + " |", "|" + "---|" + "---:|" * len(self.columns)]
        for name, cells in self.rows.items():
            lines.append("| " + " | ".join([name, *(self.shown(cell) for cell in cells)]) + " |")
        return "\n".join(lines) + "\n"

    def shown(self, cell: Cell) -> str:
        """A cell as text."""
        if cell is None or (isinstance(cell, float) and not math.isfinite(cell)):
            return "–"
        if isinstance(cell, float):
            return _rounded(cell, self.digits)
        return str(cell)


def write_json(
    path: str | os.PathLike[str], content: dict[str, Any], *, digits: int | None = _DIGITS
) -> None:
    """Writes JSON without NaN; the last folder of the path is created if it does not exist.

    Args:
        digits: significant digits of numbers; None for all of them.

    Raises:
        InputError: the path cannot be written.
    """
    # If the folder cannot be created, `replacing` raises.
    with suppress(OSError, ValueError):
        Path(path).parent.mkdir(exist_ok=True)
    with replacing(path) as temporary:
        text = _NUMBERS.sub(_on_one_line, json.dumps(_plain(content, digits), indent=2, ensure_ascii=False))
        temporary.write_text(text + "\n", encoding="utf-8")


def _on_one_line(numbers: re.Match[str]) -> str:
    return f"[{' '.join(numbers[0][1:-1].split())}]"


def _plain(value: Any, digits: int | None = _DIGITS) -> Any:
    if isinstance(value, dict):
        return {key: _plain(part, digits) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(part, digits) for part in value]
    if isinstance(value, float):
        if not math.isfinite(value):
            return None
        return value if digits is None else float(f"{value:.{digits}g}")
    return value


def _rounded(value: float, digits: int) -> str:
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(value)))
    if exponent < -4 or exponent > 6:
        return f"{value:.{digits - 1}e}"
    return f"{value:.{max(digits - 1 - exponent, 0)}f}"
