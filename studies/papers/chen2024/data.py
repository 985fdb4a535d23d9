"""The materials and queries of chen2024 on disk: `python -m studies.papers.chen2024.data -o queries.zarr`."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.main import run
from loomlight.cli.options import ExecutorName, SlurmSettings, Workers, executor_of, require_within
from loomlight.cli.terminal import done, note_left, progress, supervised
from loomlight.core.errors import InputError

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

EXAMPLE = "Example: python -m studies.papers.chen2024.data -o queries.zarr --materials 0:100"

MATERIALS = 465
DEFAULT_QUERIES = 200_000


@app.command(epilog=EXAMPLE)
def data(
    output: Annotated[
        Path,
        typer.Option("--output", "-o", help="The Zarr store to write, or to go on with: a folder .zarr."),
    ],
    materials: Annotated[
        str, typer.Option(metavar="FIRST:END", help="Which of the 465 materials, END not included; or one.")
    ] = f"0:{MATERIALS}",
    queries: Annotated[
        str,
        typer.Option(
            metavar="N",
            help="Queries a material, about: 200000 makes 0.6 GB in all; full is 6.4 million, 17 GB.",
        ),
    ] = str(DEFAULT_QUERIES),
    seed: Annotated[int, typer.Option(help="The same seed gives the same materials and queries.")] = 0,
    workers: Workers = 1,
    executor: ExecutorName = "local",
    slurm: SlurmSettings = None,
) -> None:
    """Writes the materials and queries of chen2024 with their answers. Run again, it goes on where it ended.

    Several runs with different materials may write into one store at the same time.
    """
    first, end = _range_of(materials)
    chosen = executor_of(executor, workers, slurm)
    require_within("--seed", seed, 0, 2**32 - 1)
    wanted = _queries_of(queries)
    if output.suffix != ".zarr":
        raise InputError(f"{output} must end in .zarr: what is written is a Zarr store.")
    if not output.parent.is_dir():
        raise InputError(f"{output}: the folder {output.parent} does not exist; make it first.")

    from loomlight.core.llvm import require_llvm

    require_llvm()
    from drjit.llvm.ad import Float

    from studies.papers.chen2024.dataset_store import StoreSettings, make_store

    settings = StoreSettings(seed, wanted)
    command = f"python -m studies.papers.chen2024.data --queries {wanted} --seed {seed}"
    note_left(f"{output} keeps the materials that are finished: the same command goes on from there.")
    with progress(f"materials {materials}") as report:
        make_store(output, range(first, end), settings, Float, command, report, chosen)
    done(output)


def _range_of(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"\s*(\d{1,4})(?:\s*:\s*(\d{1,4}))?\s*", text)
    first = int(match[1]) if match else 0
    end = (int(match[2]) if match[2] else first + 1) if match else 0
    if not 0 <= first < end <= MATERIALS:
        raise InputError(
            f'--materials "{text}" is not understood: write FIRST:END with 0 to {MATERIALS}, such as 0:100, '
            "or one number."
        )
    return first, end


def _queries_of(text: str) -> int:
    from studies.papers.chen2024.queries import FULL_QUERIES, MIN_QUERIES

    if text.strip() == "full":
        return FULL_QUERIES
    if not re.fullmatch(r"\s*\d{1,9}\s*", text):
        raise InputError(f'--queries "{text}" is no number: write {MIN_QUERIES} to {FULL_QUERIES}, or full.')
    require_within("--queries", int(text), MIN_QUERIES, FULL_QUERIES)
    return int(text)


def main() -> None:
    """Runs the command line in a forked process, which must load Dr.Jit itself; exits with its code."""
    sys.exit(supervised(lambda: run(sys.argv[1:], app, "python -m studies.papers.chen2024.data")))


if __name__ == "__main__":
    main()
