"""What a study is: a question with settings, a function that answers it, and tables of the answer.

    STUDY = Study("accuracy/brightness", "brightness of `lobes` over distance", Brightness(), run, tables)

A module below `studies/` declares one or more, each under a name of its own; its docstring is what the page
of the study explains. Names and what they show are literals: `catalogue.py` reads them without importing.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import InputError
from loomlight.core.sentences import closest
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from studies.harness.parts import Parts

REPOSITORY = Path(__file__).resolve().parents[2]
EXAMPLES = REPOSITORY / "examples"

# Numbers, texts, lists and mappings of them: what JSON holds.
Figures = dict[str, Any]
Pixels = NDArray[np.uint8]
Chosen = TypeVar("Chosen", bound=Settings)
Made = TypeVar("Made")


@dataclass(frozen=True)
class NoSettings(Settings):
    """Of studies that have none."""


@dataclass(frozen=True, eq=False)
class Found:
    """What a study finds.

    Attributes:
        figures: all that was measured; with the key "missed", the bars that were not met.
        sheet: everything on one page, sRGB [height, width, 3].
        pictures: single ones by title, sRGB [height, width, 3].
    """

    figures: Figures
    sheet: Pixels | None = None
    pictures: Mapping[str, Pixels] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Run:
    """What a study is handed beside its settings.

    Attributes:
        parts: what an interrupted run of the same settings has made already.
        runs: the folder of trainings, which later runs and other studies use again.
        report: called with (steps done, steps in all).
        folder: of records; None if none is written.
    """

    parts: Parts = field(default_factory=Parts)
    runs: Path = Path("runs")
    report: Callable[[int, int], None] = lambda done, total: None
    folder: Path | None = None

    def each(self, cases: Mapping[str, Callable[[], Made]]) -> dict[str, Made]:
        """What each function returns, by name: values of JSON, kept as soon as they are there."""
        found = {}
        for number, (name, make) in enumerate(cases.items()):
            found[name] = self.parts.kept(name, make)
            self.report(number + 1, len(cases))
        return found


def stored_tables(figures: Figures) -> list[Table]:
    """Tables of figures that hold them as `with_tables` puts them there."""
    return [Table.from_dict(content) for content in figures.get("tables", [])]


def with_tables(*tables: Table, **figures: Any) -> Figures:
    """Figures that are tables, beside others."""
    return {**figures, "tables": [table.to_dict() for table in tables]}


@dataclass(frozen=True, eq=False)
class Study(Generic[Chosen]):
    """A study.

    Attributes:
        name: such as "accuracy/brightness": the folder, and what is asked.
        shows: a line for people.
        settings: those that it has unless others are given.
        run: measures.
        tables: of figures, as a record holds them: numbers, texts, lists and objects.
        stands_on: names of `probes.py:PROBES`, whose outputs are kept with the figures.
        small: settings by name with which a run takes seconds.
    """

    name: str
    shows: str
    settings: Chosen
    run: Callable[[Chosen, Run], Found]
    tables: Callable[[Figures], Sequence[Table]] = stored_tables
    stands_on: tuple[str, ...] = ()
    small: Mapping[str, Any] = field(default_factory=dict)

    @property
    def about(self) -> str:
        """What its module explains."""
        return (sys.modules[self.run.__module__].__doc__ or "").strip()


# ----------------------------------------------------------------------------------------- declared settings


def names(default: str, help: str, among: Sequence[str] = ()) -> Any:
    """A setting that is a list of names with commas between them; `listed` takes it apart.

    Args:
        among: those that there are; empty if any will do.
    """

    def exist(text: str) -> bool:
        return all(name in among for name in listed(text) or [""])

    expected = f"names with commas, of {', '.join(among)}" if among else "names with commas"
    return setting(default, help, fits=exist if among else None, expected=expected, metavar="NAME,…")


def listed(text: str) -> list[str]:
    """The names of a list with commas."""
    return [name.strip() for name in text.split(",") if name.strip()]


def listed_numbers(option: str, text: str) -> list[float]:
    """The numbers of a list with commas.

    Raises:
        InputError: a part is none.
    """
    try:
        return [float(part) for part in listed(text)]
    except ValueError as error:
        raise InputError(f'{option} = "{text}" is wrong: write numbers with commas.') from error


def listed_counts(option: str, text: str, low: int, high: int) -> list[int]:
    """The whole numbers of a list with commas.

    Raises:
        InputError: a part is none, or out of bounds, or there is none at all.
    """
    parts = listed(text)
    if not parts or not all(part.isdigit() and low <= int(part) <= high for part in parts):
        raise InputError(
            f'{option} = "{text}" is wrong: write whole numbers from {low} to {high} with commas.'
        )
    return [int(part) for part in parts]


# --------------------------------------------------------------------------------------------- data, pictures


def outside_data(*parts: str) -> Path:
    """A path in the folder of data from outside, which the environment variable LOOMLIGHT_DATA names.

    Raises:
        InputError: the variable is not set.
    """
    folder = os.environ.get("LOOMLIGHT_DATA")
    if folder is None:
        raise InputError("LOOMLIGHT_DATA does not name the folder of data from outside.")
    return Path(folder, *parts)


def example(name: str) -> Path:
    """The file of one of the example fabrics.

    Raises:
        InputError: there is none of that name.
    """
    file = EXAMPLES / f"{name}.toml"
    if not file.is_file():
        known = sorted(path.stem for path in EXAMPLES.glob("*.toml"))
        raise InputError(f'"{name}" is no example: {closest(name, known)}')
    return file


def on_display(linear: NDArray[np.float32]) -> Pixels:
    """Linear RGB [height, width, 3] as 8-bit sRGB, exposure 0."""
    return np.rint(255 * linear_to_srgb(np.clip(np.nan_to_num(linear), 0, 1))).astype(np.uint8)
