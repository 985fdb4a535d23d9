"""`loomlight reproduce`: the figures and tables of the papers, made again."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from loomlight.cli.interruption import note_left
from loomlight.cli.outputs import done, require_not_read
from loomlight.cli.progress import progress
from loomlight.cli.values import parse_size, require_within
from loomlight.core.errors import InputError

if TYPE_CHECKING:
    from loomlight.evaluation.reproduce import Setting

EXAMPLE = "Example: loomlight reproduce chen2024/fig4 zhu2024/table1 -o out"


def reproduce(
    names: Annotated[
        list[str] | None, typer.Argument(metavar="[FIGURE]...", help="Such as chen2024/fig4; see --list.")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", metavar="DIR", help="The folder for pictures and table.json."),
    ] = None,
    listed: Annotated[bool, typer.Option("--list", help="Print every figure and what it shows.")] = False,
    size: Annotated[
        str | None,
        typer.Option(metavar="WxH", help="Pixels of each picture; 384x216, the paper's 1920x1080."),
    ] = None,
    samples: Annotated[
        int | None,
        typer.Option("--spp", help="Samples a pixel of references; 256, of zhu2024/table1 and fig5 1024."),
    ] = None,
    weights: Annotated[
        Path | None, typer.Option(help="A weights file of neural; by default the one that comes along.")
    ] = None,
    runs: Annotated[Path, typer.Option(metavar="DIR", help="Trainings that ablations are read from.")] = Path(
        "runs"
    ),
    model: Annotated[
        str | None, typer.Option(metavar="NAME", help="The model of zhu2024's figures; clustered.")
    ] = None,
    environment: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="A latitude-longitude picture for zhu2024's blouse; the studio."),
    ] = None,
    quality: Annotated[
        str, typer.Option(metavar="NAME", help="Of zeltner2024's trainings: preview, full or published.")
    ] = "preview",
    steps: Annotated[
        int | None, typer.Option(metavar="N", help="Of each of these trainings; as the quality says.")
    ] = None,
) -> None:
    """Makes figures and tables of the papers again, with every number behind them."""
    if listed:
        from loomlight.evaluation.reproduce import CATALOGUE

        for item in CATALOGUE.values():
            print(f"{item.name:24}{item.shows}")
        return
    if not names:
        raise InputError("No figure is named: `loomlight reproduce --list` prints them all.")
    if output is None:
        raise InputError("No folder is given: write -o DIR for pictures and table.json.")
    if steps is not None:
        require_within("--steps", steps, 1, 10_000_000)
    if samples is not None:
        require_within("--spp", samples, 1, 1_000_000)
    pixels = None if size is None else parse_size(size)

    from loomlight.evaluation.reproduce import Setting, find_item, reproduce
    from loomlight.evaluation.reproduce.setting import NEURAL, SIZE

    chosen = [find_item(name) for name in names]
    pictures = [output / f"{item.stem}.png" for item in chosen]
    require_not_read([*pictures, output / "table.json", output / "pictures"], [weights, environment])
    for item in chosen:
        with progress(item.name) as report:
            setting = Setting(
                pixels or SIZE,
                samples or item.samples,
                weights,
                runs,
                report,
                NEURAL if item.model is None else model or item.model,
                environment,
                quality,
                steps,
            )
            found = reproduce(item.name, output, setting, _command(item.name, setting))
        for table in found.tables:
            print(table.to_markdown())
        done(output / f"{item.stem}.png")
        note_left(f"{output} holds the figures up to {item.name}.")


def _command(name: str, setting: Setting) -> str:
    """What makes the same figure again, without folders."""
    from loomlight.evaluation.reproduce import find_item

    width, height = setting.size
    command = f"loomlight reproduce {name} --size {width}x{height} --spp {setting.samples}"
    options = {"weights": setting.weights, "environment": setting.environment}
    named = "".join(f" --{option} {file.name}" for option, file in options.items() if file is not None)
    model = "" if find_item(name).model is None else f" --model {setting.model}"
    if name.startswith("zeltner2024"):
        named += f" --quality {setting.quality}"
        named += "" if setting.steps is None else f" --steps {setting.steps}"
    return f"{command}{model}{named}"
