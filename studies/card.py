"""A kit for the minutes of a graphics card: jobs in order of worth, of which those run that fit.

    python -m studies card                                   the plan
    python -m studies card --carry kit                       with a network: gathers what a bare machine needs
    python -m studies card --minutes 28 -o out               on the card; again, it goes on
    python -m studies card --minutes 20 -o out --small       a rehearsal on whatever driver there is

Records of the studies that run lie in `-o`, as those of any study; trainings, logs and `state.json`, how far
each job has come, in `card` of `--runs`. A job that is done is not done again; one that failed is tried
again, and ends no other.
"""

from __future__ import annotations

import os
import re
from dataclasses import asdict, dataclass
from functools import cache, partial
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Cell, Table
from studies.card_kit.carry import carry
from studies.card_kit.jobs import JOBS, Job, Places
from studies.card_kit.machine import NEEDS, look_for
from studies.card_kit.plan import Plan, Standing, run_words
from studies.harness.record import make_folder
from studies.harness.study import Figures, Found, Run, Study, listed, names

_NAMES = tuple(job.name for job in JOBS)


# Columns of the table of what ran, and keys of a job's standing.
_SHOWN = ("state", "minutes", "says")


@dataclass(frozen=True)
class CardSettings(Settings):
    """Of the kit."""

    minutes: float = setting(0.0, "Minutes of the card; with 0 the plan is shown.", low=0, high=1e5)
    jobs: str = names(",".join(_NAMES), "Jobs that are run, in the order of the plan.", _NAMES)
    rehearse: bool = setting(False, "Jobs at tiny sizes, on whatever driver there is.")
    carry: os.PathLike[str] | None = setting(
        None, "Gathers there what a machine without a network needs.", otherwise="none", metavar="DIR"
    )
    python: str = setting(
        "3.11",
        "Version of Python on that machine.",
        fits=lambda text: re.fullmatch(r"3\.\d\d", text) is not None,
        expected="a version such as 3.11",
    )


def spend(settings: CardSettings, run: Run) -> Found:
    """Runs what fits into the minutes, or gathers what is carried.

    Raises:
        InputError: minutes without a folder of records, or something that cannot be gathered.
    """
    jobs = [job for job in JOBS if job.name in listed(settings.jobs)]
    if settings.carry is not None:
        return Found(
            {
                "plan": [_facts(job) for job in jobs],
                "carried": carry(Path(settings.carry), run.runs, settings.python, run.report),
            }
        )
    if not settings.minutes:
        return Found({"plan": [_facts(job) for job in jobs]})
    if run.folder is None:
        raise InputError(f"--minutes {settings.minutes:g} needs -o DIR, a folder for records.")
    places = _places(run.folder, run.runs, settings.rehearse)
    make_folder(places.work)
    plan = Plan(jobs, places, settings.rehearse)
    has = cache(partial(look_for, rehearses=settings.rehearse))
    plan.run(settings.minutes, has, partial(run_words, work=places.work), report=run.report)
    return Found(
        {
            "plan": [_facts(job) for job in jobs],
            "rehearsal": settings.rehearse,
            "machine": {need: asdict(has(need)) for need in NEEDS},
            "jobs": {job.name: _shown(plan.standings[job.name], places) for job in jobs},
        }
    )


def _shown(standing: Standing, places: Places) -> Figures:
    """A standing as records have it, which name no folder of the machine."""
    says = standing.says
    for folder in (places.records.parent, places.runs.parent):
        says = says.replace(f"{folder}{os.sep}", "")
    return {"state": standing.state, "minutes": round(standing.minutes, 2), "says": says}


def _places(folder: Path, runs: Path, rehearses: bool) -> Places:
    """Records of a rehearsal are no results: they lie beside its trainings."""
    if rehearses:
        small = runs.resolve() / "small"
        return Places(small / "records", small, small / "card")
    return Places(folder.resolve(), runs.resolve(), runs.resolve() / "card")


def _facts(job: Job) -> Figures:
    return {
        "name": job.name,
        "answers": job.answers,
        "minutes": job.minutes,
        "estimated": job.estimated,
        "needs": list(job.needs),
        "resumes": job.resumes,
    }


def tables(figures: Figures) -> list[Table]:
    """The plan, and what ran."""
    columns = ["minutes", "from", "needs", "when stopped", "answers"]
    rows: dict[str, list[Cell]] = {
        job["name"]: [
            job["minutes"],
            job["estimated"],
            ", ".join(job["needs"]) or "–",
            "goes on" if job["resumes"] else "begins anew",
            job["answers"],
        ]
        for job in figures["plan"]
    }
    plan = Table("The plan of a card", columns, rows, "In order of worth; minutes are estimates.")
    if "carried" in figures:
        carried: dict[str, Cell] = {
            name: ", ".join(value) or "none" if isinstance(value, list) else value
            for name, value in figures["carried"].items()
        }
        return [plan, Table("What is carried", [""], {name: [cell] for name, cell in carried.items()})]
    if "jobs" not in figures:
        return [plan]
    on = ", ".join(f"{need}: {found['name'] or 'none'}" for need, found in figures["machine"].items())
    title = "A rehearsal at tiny sizes" if figures["rehearsal"] else "What ran on a card"
    ran: dict[str, list[Cell]] = {
        name: [standing[key] for key in _SHOWN] for name, standing in figures["jobs"].items()
    }
    return [plan, Table(title, list(_SHOWN), ran, f"{on}.")]


STUDY = Study(
    "card",
    "a kit for the minutes of a graphics card: jobs in order of worth, of which those run that fit",
    CardSettings(),
    spend,
    tables,
    small={"rehearse": True},
)
