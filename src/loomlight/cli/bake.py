"""`loomlight bake`: a model of a fabric as one file."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.interruption import note_left
from loomlight.cli.outputs import check_output, done
from loomlight.cli.progress import progress

EXAMPLE = "Example: loomlight bake examples/denim.toml --model woven -o denim.loom"


def bake(
    fabric: Annotated[
        str,
        typer.Argument(
            metavar="SOURCE",
            help="A fabric file, a draft, a .loom, or a weave's name; for neumip height fields, tiles, BTFs.",
        ),
    ],
    model: Annotated[str, typer.Option(help="What to bake: one of the models below.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="The .loom file to write.")],
    options: Annotated[
        list[str] | None,
        typer.Option(
            "--set", metavar="NAME=VALUE", help="An option of the model, such as quality=full of neumip."
        ),
    ] = None,
) -> None:
    """Writes a source and all that a model needs of it into one .loom file; see docs/materials.md."""
    check_output(output, (".loom",))

    from loomlight.models.bake import bake as run
    from loomlight.models.option_values import parse_options
    from loomlight.models.registry import model_class

    chosen = parse_options(model, options or [])
    if not model_class(model).trains:
        run(fabric, model, output, **chosen)
    else:
        note_left("The training is kept: the same command goes on from there.")
        with progress(f"{fabric}, {model}") as report:
            run(fabric, model, output, report=report, **chosen)
    done(output)
