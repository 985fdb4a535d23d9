"""Tables of figures: written as JSON for programs and as Markdown for people."""

from __future__ import annotations

import json
import math
import os
from dataclasses import dataclass, field
from typing import Any

from loomlight.core.files import replacing

Cell = float | int | str | None


@dataclass
class Table:
    """A table.

    Attributes:
        title: what it shows.
        columns: headings, without that of the row's name.
        rows: cells by the row's name, as many as there are columns; None where there is nothing to show.
        note: what has to be known to read it.
        digits: significant digits of Markdown's numbers.
    """

    title: str
    columns: list[str]
    rows: dict[str, list[Cell]] = field(default_factory=dict)
    note: str = ""
    digits: int = 3

    def to_dict(self) -> dict[str, Any]:
        """What JSON holds: rows as objects by column; NaN and infinity are null."""
        rows = {
            name: {column: _plain(cell) for column, cell in zip(self.columns, cells, strict=True)}
            for name, cells in self.rows.items()
        }
        return {"title": self.title, "note": self.note, "rows": rows}

    def to_markdown(self) -> str:
        """The table in Markdown, its title as a heading."""
        lines = [f"### {self.title}", ""]
        if self.note:
            lines += [self.note, ""]
        lines.append("| " + " | ".join(["", *self.columns]) + " |")
        lines.append("|" + "---|" + "---:|" * len(self.columns))
        for name, cells in self.rows.items():
            lines.append("| " + " | ".join([name, *(self.shown(cell) for cell in cells)]) + " |")
        return "\n".join(lines) + "\n"

    def shown(self, cell: Cell) -> str:
        """A cell as a person reads it."""
        if cell is None or (isinstance(cell, float) and not math.isfinite(cell)):
            return "–"
        if isinstance(cell, float):
            return _rounded(cell, self.digits)
        return str(cell)


def write_json(path: str | os.PathLike[str], content: dict[str, Any]) -> None:
    """Writes JSON without NaN.

    Raises:
        InputError: the path cannot be written.
    """
    with replacing(path) as temporary:
        temporary.write_text(
            json.dumps(_plain(content), indent=2, ensure_ascii=False) + "\n", encoding="utf-8"
        )


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(part) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(part) for part in value]
    if isinstance(value, float):
        return float(f"{value:.6g}") if math.isfinite(value) else None
    return value


def _rounded(value: float, digits: int) -> str:
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(value)))
    if exponent < -4 or exponent > 6:
        return f"{value:.{digits - 1}e}"
    return f"{value:.{max(digits - 1 - exponent, 0)}f}"
