"""Runs a study and writes what it finds: the record, a page, the sheet and single pictures."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

from loomlight.core.files import discarding_empty, replacing
from loomlight.core.images import write_pixels
from loomlight.core.provenance import provenance
from loomlight.core.settings import Settings
from studies.harness.page import page
from studies.harness.parts import Parts, as_json
from studies.harness.probes import probed
from studies.harness.record import (
    REPOSITORY,
    Record,
    _described,
    make_folder,
    new_record,
    record_file,
)
from studies.harness.study import Run, Study


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
    outputs = probed(study.stands_on)
    if folder is None:
        parts = Parts()
        found = study.run(chosen, Run(parts, runs, report))
        return new_record(study, chosen, found.figures, parts.processor_seconds, outputs)
    file = record_file(folder, study.name)
    with discarding_empty(folder):
        make_folder(file.parent)
        sources = provenance("", REPOSITORY)["sources"]
        of = as_json({"settings": _described(chosen, study.settings), "sources": sources, "probes": outputs})
        parts = Parts(file.with_suffix(".parts"), of)
        found = study.run(chosen, Run(parts, runs, report))
        record = new_record(study, chosen, found.figures, parts.processor_seconds, outputs)
        pictures = {title: file.with_suffix("") / f"{_file_name(title)}.png" for title in found.pictures}
        for title, picture in pictures.items():
            make_folder(picture.parent)
            write_pixels(picture, found.pictures[title])
        if found.sheet is not None:
            write_pixels(file.with_suffix(".png"), found.sheet)
        record.write(folder)
        with replacing(file.with_suffix(".md")) as temporary:
            shown = {
                title: picture.relative_to(file.parent).as_posix() for title, picture in pictures.items()
            }
            sheet = None if found.sheet is None else file.with_suffix(".png").name
            temporary.write_text(page(study, record, sheet, shown), encoding="utf-8")
        parts.forget()
        return record


def _file_name(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", text.lower().replace("×", "x").replace("/", "-")).strip("-")
