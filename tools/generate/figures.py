"""Writes tables of figures into the pages, from the records of studies.

`python -m tools.generate.figures` writes them; a test fails where that is due. In a page, what stands between

    <!-- study accuracy/brightness -->
    <!-- end -->

is all tables of that study's record, and the command and machine that they come from; a comment
`<!-- study accuracy/brightness: Title -->` asks for one of them. Within a line, what stands between

    <!-- cell accuracy/brightness: Title / row / column --><!-- end -->

is one cell; a table of one column needs no name of it.
"""

from __future__ import annotations

import re
from pathlib import Path

from studies.harness.catalogue import find_study
from studies.harness.record import RECORDS, command_of, read_record, record_file

ROOT = Path(__file__).resolve().parents[2]
_PLACE = re.compile(r"^(<!-- study ([\w/.-]+)(?:: (.+?))? -->\n).*?(<!-- end -->)", re.DOTALL | re.MULTILINE)

# Not in code, which explains it.
_CELL = re.compile(r"(?<!`)(<!-- cell ([\w/.-]+): (.+?) -->).*?(<!-- end -->)")


def pages() -> list[Path]:
    """The Markdown files that have places for figures."""
    found = [file for folder in ("docs", "studies/papers") for file in sorted((ROOT / folder).rglob("*.md"))]
    return [file for file in found if _has_places(file.read_text(encoding="utf-8"))]


def _has_places(text: str) -> bool:
    return bool(_PLACE.search(text) or _CELL.search(text))


def with_figures(text: str) -> str:
    """The text of a page with its tables as records have them.

    Raises:
        InputError: a study or a record that does not exist.
        ValueError: a table, row or column that the study does not have.
    """
    text = _CELL.sub(lambda place: f"{place[1]}{_cell(place[2], place[3])}{place[4]}", text)
    return _PLACE.sub(lambda place: f"{place[1]}{_figures(place[2], place[3])}{place[4]}", text)


def _cell(name: str, path: str) -> str:
    title, *where = path.split(" / ")
    study, record = find_study(name), read_record(record_file(RECORDS, name))
    for table in study.tables(record.figures):
        if table.title == title and where and where[0] in table.rows:
            column = where[1] if len(where) == 2 else table.columns[0]
            if column in table.columns and (len(where) == 2 or len(table.columns) == 1):
                return table.shown(table.rows[where[0]][table.columns.index(column)])
    raise ValueError(f"{name} has no cell {path}")


def _figures(name: str, title: str | None) -> str:
    study, file = find_study(name), record_file(RECORDS, name)
    record = read_record(file)
    tables = list(study.tables(record.figures))
    if title is not None:
        tables = [table for table in tables if table.title == title]
        if not tables:
            raise ValueError(f"{name} has no table of the title {title}")
    parts = []
    for table in tables:
        said = [] if title is not None else [f"**{table.title}.**"]
        said += [table.note] if table.note else []
        parts += [" ".join(said), table.grid().rstrip()] if said else [table.grid().rstrip()]
    # Of a record that an earlier command made, the command that there is now.
    made = f"`{command_of(study, record.settings)}`; {record.machine.split(', ', 1)[-1]}"
    parts.append(f"{made}, sources `{record.sources}`; `{file.relative_to(ROOT).as_posix()}`.")
    return "\n" + "\n\n".join(parts) + "\n\n"


def main() -> None:
    for page in pages():
        text = page.read_text(encoding="utf-8")
        page.write_text(with_figures(text), encoding="utf-8")


if __name__ == "__main__":
    main()
