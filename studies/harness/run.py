"""Runs a study and writes what it finds: the record, a page, the sheet and single pictures."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

from loomlight.core.files import discarding_empty, replacing
from loomlight.core.images import write_pixels
from loomlight.core.settings import Settings
from studies.harness.page import page
from studies.harness.parts import Parts
from studies.harness.probes import probed
from studies.harness.record import (
    Outputs,
    Record,
    changed_settings,
    make_folder,
    new_record,
    record_file,
    sources_now,
)
from studies.harness.study import Found, Run, Study


def run_study(
    study: Study[Any],
    settings: Settings | None = None,
    folder: Path | None = None,
    runs: Path = Path("runs"),
    report: Callable[[int, int], None] = lambda done, total: None,
) -> Record:
    """Runs a study, and writes its record and pictures below a folder, if one is given.

    `folder`/NAME.json is the record, NAME.md its page, NAME.png the sheet; single pictures lie in the folder
    NAME. A run that is interrupted leaves NAME.parts, from which the next one of the same settings and
    sources goes on.

    Args:
        settings: by default the study's.
        runs: the folder of trainings.
        report: called with (steps done, steps in all).

    Raises:
        InputError: settings that cannot be, or a folder that cannot be written.
    """
    chosen = study.settings if settings is None else settings
    if folder is None:
        return _measured(study, chosen, {}, Run(Parts(), runs, report))[0]
    outputs = probed(study.stands_on)
    file = record_file(folder, study.name)
    asked = {
        "settings": changed_settings(chosen, study.settings),
        "sources": sources_now(),
        "probes": outputs,
    }
    with discarding_empty(folder):
        make_folder(file.parent)
        parts = Parts(file.with_suffix(".parts"), asked)
        record, found = _measured(study, chosen, outputs, Run(parts, runs, report, folder))
        _write(study, record, found, folder)
        parts.forget()
    return record


def _measured(study: Study[Any], settings: Settings, outputs: Outputs, run: Run) -> tuple[Record, Found]:
    found = study.run(settings, run)
    seconds = run.parts.processor_seconds
    return new_record(study, settings, found.figures, seconds, outputs), found


def _write(study: Study[Any], record: Record, found: Found, folder: Path) -> None:
    """Pictures first, then the record and the page that shows both."""
    file = record_file(folder, study.name)
    pictures = {}
    for title, pixels in found.pictures.items():
        picture = file.with_suffix("") / f"{_file_name(title)}.png"
        make_folder(picture.parent)
        write_pixels(picture, pixels)
        pictures[title] = picture.relative_to(file.parent).as_posix()
    sheet = None if found.sheet is None else file.with_suffix(".png")
    if sheet is not None and found.sheet is not None:
        write_pixels(sheet, found.sheet)
    record.write(folder)
    with replacing(file.with_suffix(".md")) as temporary:
        shown = page(study, record, None if sheet is None else sheet.name, pictures)
        temporary.write_text(shown, encoding="utf-8")


def _file_name(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", text.lower().replace("×", "x").replace("/", "-")).strip("-")
