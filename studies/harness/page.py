"""The page of a study: what it asks, its tables and pictures, and how they were made, in Markdown."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from studies.harness.record import Record
from studies.harness.study import Study


def page(
    study: Study[Any], record: Record, sheet: str | None = None, pictures: Mapping[str, str] | None = None
) -> str:
    """The Markdown of a study's page.

    Args:
        sheet: the file of the sheet, relative to the page.
        pictures: files of single pictures by title.
    """
    parts = [f"# {study.name}", f"{study.shows[:1].upper()}{study.shows[1:]}.", study.about]
    parts += [table.to_markdown().strip() for table in study.tables(record.figures)]
    if missed := record.figures.get("missed"):
        parts.append("Not met: " + "; ".join(missed) + ".")
    if sheet is not None:
        parts.append(f"![{study.shows}]({sheet})")
    if pictures:
        parts.append("\n".join(f"- [{title}]({file})" for title, file in pictures.items()))
    parts.append(f"    {record.command}")
    seconds = (
        "" if record.processor_seconds is None else f", {record.processor_seconds:.0f} processor seconds"
    )
    parts.append(f"Sources {record.sources}; {record.machine}{seconds}.")
    return "\n\n".join(parts) + "\n"
