"""Options of commands that run over many items: who works on them."""

from __future__ import annotations

from typing import Annotated

import typer

from loomlight.cli.values import parse_named
from loomlight.core.fleet import Executor, parse_executor

Workers = Annotated[int, typer.Option("--workers", metavar="N", help="Processes, or jobs of Slurm.")]
ExecutorName = Annotated[
    str,
    typer.Option(
        "--executor",
        metavar="NAME",
        help="local: processes of this machine; slurm: jobs through submitit; joblib:BACKEND, such as "
        "joblib:dask or joblib:ray. See docs/fleet.md.",
    ),
]
SlurmSettings = Annotated[
    list[str] | None,
    typer.Option(
        "--slurm", metavar="NAME=VALUE", help="A parameter of submitit, such as slurm_partition=cpu."
    ),
]


def executor_of(name: str, workers: int, slurm: list[str] | None) -> Executor:
    """The executor of the options.

    Raises:
        InputError: no such executor, or a value out of range.
    """
    settings = parse_named("--slurm", slurm or [], "slurm_partition=cpu,timeout_min=60")
    return parse_executor(name, workers, {name: values[-1] for name, values in settings.items()})
