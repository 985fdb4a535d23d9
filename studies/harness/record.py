"""The record of a study: figures behind all that is to be known of how they were measured.

A record is a JSON file below a folder, at the name of its study: `records/accuracy/brightness.json` holds

- "study", "settings", "command": what was asked, and the command that asks it again;
- "sources", "machine", "processor_seconds": `git rev-parse COMMIT:src` gives the hash of `src` of any commit;
- "stands_on": outputs of probes (`probes.py`) with these sources, by which `--stale` sees what is old;
- "figures": what was found.
"""

from __future__ import annotations

import json
import os
import shlex
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from loomlight.cli.options import options_of_settings
from loomlight.core.errors import InputError
from loomlight.core.provenance import provenance
from loomlight.core.settings import Settings, declared
from loomlight.evaluation.table import write_json
from studies.harness.parts import as_json
from studies.harness.study import REPOSITORY, Figures, Study

RECORDS = REPOSITORY / "studies" / "records"
# Outputs of a probe, by its name.
Outputs = dict[str, list[float]]


@dataclass(frozen=True, eq=False)
class Record:
    """What is kept of a run.

    Attributes:
        study: its name.
        command, sources, machine: see `loomlight.core.provenance`.
        settings: that were not the defaults, by name.
        processor_seconds: of the run; None where that was not measured.
        stands_on: outputs of probes by name.
        figures: what was found.
    """

    study: str
    command: str
    sources: str
    machine: str
    settings: Mapping[str, Any] = field(default_factory=dict)
    processor_seconds: float | None = None
    stands_on: Outputs = field(default_factory=dict)
    figures: Figures = field(default_factory=dict)

    def write(self, folder: Path) -> Path:
        """Writes the record into its place below a folder, and returns the file.

        Raises:
            InputError: the file cannot be written.
        """
        file = record_file(folder, self.study)
        make_folder(file.parent)
        write_json(file, as_json(vars(self)))
        return file


def record_file(folder: Path, study: str) -> Path:
    """The place of a study's record below a folder."""
    return folder / f"{study}.json"


def make_folder(folder: Path) -> None:
    """Raises InputError if a folder for results cannot be made."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except (OSError, ValueError) as error:
        raise InputError(f"{str(folder)[:80]!r} cannot be made a folder: {error}.") from error


def read_record(file: Path) -> Record:
    """The record of a file.

    Raises:
        InputError: it holds none.
    """
    try:
        content = json.loads(file.read_bytes())
        return Record(**content)
    except (OSError, ValueError, TypeError, RecursionError) as error:
        raise InputError(
            f"{file} holds no record of a study; `python -m studies NAME -o DIR` writes one."
        ) from error


def records(folder: Path) -> dict[str, Record]:
    """All records below a folder by the names of their studies.

    Raises:
        InputError: a JSON file there is none, or lies in the place of another study.
    """
    found = {}
    for file in sorted(folder.rglob("*.json")):
        record = read_record(file)
        if record_file(folder, record.study) != file:
            raise InputError(f"{file} is the record of {record.study}; it must lie at {record.study}.json.")
        found[record.study] = record
    return found


def new_record(
    study: Study[Any], settings: Settings, figures: Figures, seconds: float, outputs: Outputs
) -> Record:
    """The record of a run that was made just now."""
    chosen = changed_settings(settings, study.settings)
    made = provenance(command_of(study, chosen), REPOSITORY)
    return Record(
        study.name,
        made["command"],
        made["sources"],
        made["machine"],
        chosen,
        round(seconds, 1),
        outputs,
        as_json(figures),
    )


def sources_now() -> str:
    """What a record says of the sources of this moment."""
    return provenance("", REPOSITORY)["sources"]


def command_of(study: Study[Any], changed: Mapping[str, Any]) -> str:
    """The command line that runs a study.

    Args:
        changed: the settings that are not the defaults, as a record has them.
    """
    words = []
    for option in options_of_settings(type(study.settings)):
        if option.key in changed:
            words += [option.flag, _text(changed[option.key])]
    return shlex.join(["python", "-m", "studies", study.name, *words])


def changed_settings(settings: Settings, defaults: Settings) -> dict[str, Any]:
    """The settings that are not the defaults, as JSON holds them; of files elsewhere the names alone."""
    found = {}
    for name in declared(type(settings)):
        value = getattr(settings, name)
        if value != getattr(defaults, name):
            found[name] = _without_folder(value) if isinstance(value, os.PathLike) else as_json(value)
    return found


def _text(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        return ("x" if all(isinstance(part, int) for part in value) else ",").join(map(str, value))
    return str(value)


def _without_folder(path: os.PathLike[str]) -> str:
    """A record says nothing of whose machine: of a path outside the repository only the name stays."""
    place = Path(path).resolve()
    return place.relative_to(REPOSITORY).as_posix() if place.is_relative_to(REPOSITORY) else place.name
