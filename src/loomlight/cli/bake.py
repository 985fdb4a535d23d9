"""`loomlight bake`: a model of a fabric as one file."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.fleet import ExecutorName, SlurmSettings, Workers, executor_of
from loomlight.cli.interruption import note_left
from loomlight.cli.progress import done, progress
from loomlight.core.errors import InputError
from loomlight.core.fleet import Executor
from loomlight.core.outputs import check_output

EXAMPLE = "Example: loomlight bake examples/denim.toml --model neural -o denim.loom"


def bake(
    sources: Annotated[
        list[str],
        typer.Argument(
            metavar="SOURCE...",
            help="Fabric files, drafts, .loom, or weaves' names; for neumip height fields, tiles, BTFs.",
        ),
    ],
    model: Annotated[str, typer.Option(help="What to bake: one of the models below.")],
    output: Annotated[
        Path, typer.Option("--output", "-o", help="The .loom file to write; of several sources, a folder.")
    ],
    options: Annotated[
        list[str] | None,
        typer.Option(
            "--set", metavar="NAME=VALUE", help="An option of the model, such as quality=full of neumip."
        ),
    ] = None,
    workers: Workers = 1,
    executor: ExecutorName = "local",
    slurm: SlurmSettings = None,
) -> None:
    """Writes a source and all that a model needs of it into one .loom file; see docs/materials.md.

    Several sources go into a folder. Run again, the same command bakes what is missing or has changed.
    """
    chosen_executor = executor_of(executor, workers, slurm)
    if len(sources) > 1 or output.is_dir():
        _bake_into_folder(sources, model, output, options or [], chosen_executor)
        return
    fabric = sources[0]
    check_output(output, (".loom",), sources)

    from loomlight.models.bake import bake as run
    from loomlight.models.bake import save
    from loomlight.models.registry import model_class, parse_options

    kind = model_class(model, to_bake=True)
    chosen = parse_options(model, options or [])
    if not kind.trains:
        save(run(fabric, model, options=chosen), output)
    else:
        note_left("The training is kept: the same command goes on from there.")
        with progress(f"{fabric}, {model}") as report:
            save(run(fabric, model, options=chosen, report=report), output)
    done(output)


def _bake_into_folder(
    sources: list[str], model: str, folder: Path, options: list[str], executor: Executor
) -> None:
    if folder.suffix or not folder.parent.is_dir() or (folder.exists() and not folder.is_dir()):
        raise InputError(f"{folder}: several sources are baked into a folder; give the name of one.")
    from loomlight.cli.bake_catalogue import bake_catalogue
    from loomlight.models.registry import model_class, parse_options

    model_class(model, to_bake=True)
    chosen = parse_options(model, options)
    note_left(f"{folder} keeps what is baked: the same command goes on from there.")
    with progress(f"{len(sources)} sources, {model}") as report:
        paths = bake_catalogue(sources, model, folder, chosen, executor=executor, report=report)
    for path in paths:
        done(path)
