"""The common part of all measuring scripts: options, provenance of figures, and JSON output.

A script holds a function that takes its options and returns its figures, and ends with `run(measure)`:

    python -m studies.speed.point [--output FILE.json]

Figures with bars name those that they miss in the list "missed"; the script then exits with 1.
"""

from __future__ import annotations

import argparse
import json
import os
import shlex
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from loomlight.core.provenance import provenance
from loomlight.evaluation.table import write_json

REPOSITORY = Path(__file__).resolve().parents[2]

Figures = dict[str, Any]


def run(
    measure: Callable[[argparse.Namespace], Figures],
    add_options: Callable[[argparse.ArgumentParser], None] | None = None,
    *,
    prints: bool = True,
    digits: int | None = 6,
) -> None:
    """Parses the command line, measures, prints the record and writes it to `--output`.

    Args:
        measure: takes the options, returns the figures.
        add_options: adds the script's own options.
        prints: print the record as JSON; False for scripts that print tables.
        digits: significant digits of numbers in the file; None for all.

    Raises:
        SystemExit: with status 1 if the figures' list "missed" holds a bar.
    """
    script = sys.modules["__main__"]
    parser = argparse.ArgumentParser(
        prog=f"python -m {_module()}",
        description=script.__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--output", type=Path, default=None, help="a JSON file for the record")
    if add_options is not None:
        add_options(parser)
    options = parser.parse_args()
    figures = record(measure(options))
    if prints:
        print(json.dumps(figures, indent=2, ensure_ascii=False))
    if options.output is not None:
        write_json(options.output, figures, digits=digits)
    missed = figures.get("missed", [])
    if missed:
        sys.exit(f"missed: {', '.join(missed)}")


def record(figures: Figures) -> Figures:
    """The figures behind the command, sources and machine that they come from."""
    return {**provenance(command(_module(), sys.argv[1:]), REPOSITORY), **figures}


def command(module: str, arguments: Sequence[str]) -> str:
    """The command line for these figures, without `--output`; files outside the repository by name alone."""
    words, rest = [], iter(arguments)
    for word in rest:
        if word == "--output":
            next(rest, None)
        elif not word.startswith("--output="):
            words.append(_without_folder(word))
    return shlex.join(["python", "-m", module, *words])


def outside_data(*parts: str) -> Path:
    """A path in the folder of data from outside, which the environment variable LOOMLIGHT_DATA names.

    Raises:
        SystemExit: the variable is not set.
    """
    folder = os.environ.get("LOOMLIGHT_DATA")
    if folder is None:
        sys.exit("LOOMLIGHT_DATA does not name the folder of data from outside.")
    return Path(folder, *parts)


def _module() -> str:
    """The name by which Python runs the script."""
    specification = sys.modules["__main__"].__spec__
    return "" if specification is None else specification.name


def _without_folder(word: str) -> str:
    """A record says nothing of whose machine: of a path outside the repository only the name stays."""
    if not Path(word).exists():
        return word
    path = Path(word).resolve()
    return os.fspath(path.relative_to(REPOSITORY) if path.is_relative_to(REPOSITORY) else path.name)
