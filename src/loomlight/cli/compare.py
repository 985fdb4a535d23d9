"""`loomlight compare`: models against the reference, as pictures and as figures."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.outputs import done, require_not_read
from loomlight.cli.progress import progress
from loomlight.cli.values import parse_size, require_within
from loomlight.core.errors import LoomlightWarning

EXAMPLE = "Example: loomlight compare examples/denim.toml --models lobes,point -o report"


def compare(
    fabric: Annotated[
        str, typer.Argument(metavar="FABRIC", help="A fabric file, a draft, a .loom, or a weave's name.")
    ],
    output: Annotated[
        Path, typer.Option("--output", "-o", metavar="DIR", help="The folder for index.html and table.json.")
    ],
    models: Annotated[str, typer.Option(help="Models, with commas between them.")] = "lobes,point,neural",
    full: Annotated[
        bool, typer.Option("--full", help="The whole protocol of the evaluation page: hours on a CPU.")
    ] = False,
    scenes: Annotated[
        str | None, typer.Option(help="Some of the eight scenes, with commas between them.")
    ] = None,
    size: Annotated[
        str | None, typer.Option(metavar="WxH", help="Pixels; 400x225, or 960x540 with --full.")
    ] = None,
    samples: Annotated[
        int | None, typer.Option("--spp", help="Samples a pixel of the reference; 64, or 1024 with --full.")
    ] = None,
) -> None:
    """Compares models with the reference: pictures, difference maps, FLIP, MSE and time."""
    pixels = None if size is None else parse_size(size)
    require_within("--spp", 1 if samples is None else samples, 1, 1_000_000)
    names = _listed(models)
    require_not_read([output / name for name in ("index.html", "table.json", "pictures")], [fabric])

    from loomlight.assets.load import fabric_of_path
    from loomlight.assets.loom_file import is_loom, read_loom

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

    with progress(cloth.name) as report:
        found = run(
            cloth,
            names,
            output,
            full=full,
            scenes=MEASURED_SCENES if scenes is None else _listed(scenes),
            size=pixels,
            reference_samples=samples,
            command=f"loomlight compare --models {','.join(names)}{' --full' if full else ''}",
            progress=lambda _what, steps, total: report(steps, total),
        )
    print(found.tables[0].to_markdown())
    for name, why in found.refused.items():
        print(f"{name} does not take this fabric: {why}")
    done(output / "index.html")


def _listed(text: str) -> list[str]:
    return [part.strip() for part in text.split(",") if part.strip()]
