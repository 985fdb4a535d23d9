"""`loomlight compare`: models against the reference, or a fabric beside a measured BRDF."""

from __future__ import annotations

import shlex
import warnings
from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.options import FabricArgument, parse_size, require_within
from loomlight.cli.terminal import done, progress
from loomlight.core.errors import LoomlightWarning
from loomlight.core.outputs import require_not_read

EXAMPLE = "Example: loomlight compare examples/denim.toml --models lobes,point -o report"


def compare(
    fabric: FabricArgument,
    output: Annotated[
        Path, typer.Option("--output", "-o", metavar="DIR", help="The folder for index.html and table.json.")
    ],
    models: Annotated[str, typer.Option(help="Models, with commas between them.")] = "lobes,point,neural",
    scenes: Annotated[
        str | None, typer.Option(help="Some of the eight scenes, with commas between them.")
    ] = None,
    size: Annotated[str, typer.Option(metavar="WxH", help="Pixels of each picture.")] = "320x180",
    samples: Annotated[int, typer.Option("--spp", help="Samples a pixel of the reference.")] = 49,
    measured: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="In their place a measured BRDF beside the fabric: of MERL (.binary) or RGL (.bsdf).",
        ),
    ] = None,
) -> None:
    """Compares models with the reference: pictures, difference maps, FLIP, MSE and time."""
    if measured is not None:
        _beside(fabric, measured, output)
        return
    pixels = parse_size(size)
    require_within("--spp", samples, 1, 1_000_000)
    names = _listed(models)
    require_not_read([output / name for name in ("index.html", "table.json", "pictures")], [fabric])

    from loomlight.sources.load import fabric_of_path
    from loomlight.sources.loom_file import is_loom, read_loom

    cloth = fabric_of_path(fabric)
    if is_loom(fabric):
        held = read_loom(fabric).model
        warnings.warn(
            f"{fabric} holds the model {held}; compare bakes each model from its fabric.",
            LoomlightWarning,
            stacklevel=2,
        )

    from loomlight.evaluation.compare import compare as run
    from loomlight.mitsuba.measured_scenes import MEASURED_SCENES

    shown = list(MEASURED_SCENES) if scenes is None else _listed(scenes)
    with progress(cloth.name) as report:
        found = run(
            cloth,
            names,
            output,
            scenes=shown,
            size=pixels,
            reference_samples=samples,
            command=_command(fabric, names, output, shown, pixels, samples),
            progress=lambda _what, steps, total: report(steps, total),
            row=lambda line: print(line, flush=True),
        )
    print(found.tables[0].to_markdown())
    for name, why in found.refused.items():
        print(f"{name} does not take this fabric: {why}")
    done(output / "index.html")


def _beside(fabric: str, measured: Path, output: Path) -> None:
    """A measured BRDF beside the fabric: its error, curves and their plots."""
    names = ("index.html", "table.json", "pictures")
    require_not_read([output / name for name in names], [fabric, measured])

    from loomlight.evaluation.measured import compare_measured
    from loomlight.sources.load import fabric_of_path

    cloth = fabric_of_path(fabric)
    options = ["--measured", str(measured), "--output", str(output)]
    command = shlex.join(["loomlight", "compare", fabric, *options])
    found = compare_measured(cloth, measured, output, command=command)
    print(found.table.to_markdown())
    done(output / "index.html")


def _command(
    fabric: str, models: list[str], output: Path, scenes: list[str], size: tuple[int, int], samples: int
) -> str:
    """The command that makes the same comparison again, as a shell takes it."""
    width, height = size
    options = ["--models", ",".join(models), "--scenes", ",".join(scenes), "--size", f"{width}x{height}"]
    return shlex.join(
        ["loomlight", "compare", fabric, *options, "--spp", str(samples), "--output", str(output)]
    )


def _listed(text: str) -> list[str]:
    return [part.strip() for part in text.split(",") if part.strip()]
