"""The command `python -m studies`: lists studies, runs those that are named, and names old records."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NoReturn

from loomlight.cli.options import SettingOption, options_of_settings
from loomlight.cli.terminal import done, note_left, progress, report_interruption
from loomlight.core.errors import InputError, LoomlightError
from loomlight.core.outputs import require_not_read
from loomlight.core.settings import Settings, default_text, range_text
from studies.harness.catalogue import catalogue, find_study
from studies.harness.changes import changes_text
from studies.harness.record import RECORDS, Record, changed_settings, read_record, record_file, records
from studies.harness.run import run_study
from studies.harness.stale import stale
from studies.harness.study import Study

BAD_INPUT, MISSED = 2, 1
_USAGE = "python -m studies [NAME ...] [-o DIR] [--against DIR] [--small] [--stale] [settings of the studies]"


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise InputError(f"{message}; `python -m studies --help` shows how it is used.")


def main(arguments: Sequence[str]) -> int:
    """Runs the command line; the exit code is 2 where something is wrong, which one sentence says.

    It is 1 where a study says that a bar was missed, after its record is written.
    """
    try:
        return _run(arguments)
    except LoomlightError as error:
        print(f"studies: {error}", file=sys.stderr)
        return BAD_INPUT
    except ModuleNotFoundError as error:
        brings = "`pip install -e '.[dev]'` brings all that studies need."
        print(f"studies: {error.name} is needed and not installed; {brings}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        return report_interruption()
    except BrokenPipeError:  # the reader of the list has enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0


def _run(arguments: Sequence[str]) -> int:
    # Names come first: of the studies that they name follow the options.
    count = next((number for number, word in enumerate(arguments) if word.startswith("-")), len(arguments))
    names = arguments[:count]
    studies = [find_study(name) for name in names]
    options = _parser(studies).parse_args(arguments[count:])
    if options.stale:
        return _print_stale(options.output or RECORDS)
    if not studies:
        for each in catalogue().values():
            print(f"{each.name:36}{each.shows}")
        return 0
    chosen = [(study, _settings(study, options, studies)) for study in studies]
    missed: list[str] = []
    for study, settings in chosen:
        earlier = None if options.against is None else _earlier(study, settings, options.against)
        record = _run_one(study, settings, options.output, options.runs)
        missed += [f"{study.name}: {bar}" for bar in record.figures.get("missed", [])]
        if earlier is not None:
            print(changes_text(earlier.figures, record.figures))
    if missed:
        print(f"missed: {', '.join(missed)}", file=sys.stderr)
        return MISSED
    return 0


def _run_one(study: Study[Any], settings: Settings, folder: Path | None, runs: Path) -> Record:
    """Runs a study and prints its tables."""
    if folder is not None:
        file = record_file(folder, study.name)
        read = [getattr(settings, option.key, None) for option in _options(study)]
        paths = [value for value in read if isinstance(value, os.PathLike)]
        require_not_read([file, file.with_suffix(".png"), file.with_suffix(".md")], paths)
        note_left(f"{file.with_suffix('.parts')} holds what was made; the same command goes on from there.")
    with progress(study.name) as report:
        record = run_study(study, settings, folder, runs, report)
    for table in study.tables(record.figures):
        print(table.to_markdown())
    if folder is not None:
        done(record_file(folder, study.name))
        note_left(f"{folder} holds all up to {study.name}.")
    return record


def _earlier(study: Study[Any], settings: Settings, folder: Path) -> Record:
    """The record below a folder that a run is compared with.

    Raises:
        InputError: there is none, or of other settings.
    """
    file = record_file(folder, study.name)
    record = read_record(file)
    if record.settings != changed_settings(settings, study.settings):
        raise InputError(f"{file} was made with other settings, by {record.command}; give the same.")
    return record


def _print_stale(folder: Path) -> int:
    reasons = stale(folder)
    for name, reason in reasons.items():
        print(f"{name:36}{reason}")
    print(f"{len(reasons)} of {len(records(folder))} records are older than what they stand on.")
    return 0


# ---------------------------------------------------------------------------------------------------- options


def _parser(studies: Sequence[Study[Any]]) -> argparse.ArgumentParser:
    about = (
        studies[0].about if len(studies) == 1 else "Figures and tables, measured. Without names, lists them."
    )
    parser = _Parser(
        prog="python -m studies",
        usage=_USAGE,
        description=about,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("-o", "--output", type=Path, metavar="DIR", help="a folder for records and pictures")
    parser.add_argument(
        "--runs", type=Path, default=Path("runs"), metavar="DIR", help="trainings that are kept"
    )
    parser.add_argument(
        "--against", type=Path, metavar="DIR", help="says what differs from the records below a folder"
    )
    parser.add_argument("--small", action="store_true", help="so small that it takes seconds")
    parser.add_argument(
        "--stale", action="store_true", help="lists the records that are old, of -o DIR or all"
    )
    known: dict[str, SettingOption] = {}
    for study in studies:
        for option in _options(study):
            known.setdefault(option.flag, option)
    for flag, option in known.items():
        kind = option.setting.kind
        words = f"{option.setting.help}{default_text(option.setting, '  [{}]')}".replace("%", "%%")
        name = option.setting.metavar or range_text(option.setting).replace(" ", "") or option.key.upper()
        action = parser.add_argument(flag, dest=f"set_{option.key}", metavar=name, help=words)
        if kind is bool:
            action.nargs, action.const = "?", "true"
    return parser


def _options(study: Study[Any]) -> list[SettingOption]:
    return list(options_of_settings(type(study.settings)))


def _settings(study: Study[Any], options: argparse.Namespace, studies: Sequence[Study[Any]]) -> Settings:
    """The settings of a study, as the command line changes them.

    Raises:
        InputError: a value that cannot be, or a setting of another of the studies alone.
    """
    known = {option.key: option for option in _options(study)}
    changes = dict(study.small) if options.small else {}
    for key, text in vars(options).items():
        name = key.removeprefix("set_")
        if name == key or text is None:
            continue
        if name not in known:
            raise InputError(f"{study.name} has no setting --{name.replace('_', '-')}; run it by itself.")
        option = known[name]
        kind = option.setting.kind
        if kind is tuple:
            changes[name] = option.value(text)
        elif issubclass(kind, os.PathLike):
            changes[name] = Path(text)
        else:
            changes[name] = option.setting.value_of(text)
    settings: Settings = study.settings.changed(**changes)
    return settings
