"""`loomlight bake`: a model of a fabric as one file."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.outputs import check_output, done

EXAMPLE = "Example: loomlight bake examples/denim.toml --model woven -o denim.loom"


def bake(
    fabric: Annotated[
        str, typer.Argument(metavar="FABRIC", help="A fabric file, a draft, a .loom, or a weave's name.")
    ],
    model: Annotated[str, typer.Option(help="What to bake: one of the models below.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="The .loom file to write.")],
) -> None:
    """Writes a fabric and all that a model needs of it into one .loom file; see docs/materials.md."""
    check_output(output, (".loom",))

    from loomlight.models.bake import bake as run

    run(fabric, model, output)
    done(output)
