"""`loomlight export`: a fabric for engines and other programs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.options import FabricArgument
from loomlight.cli.progress import done
from loomlight.core.outputs import require_not_read

EXAMPLE = "Example: loomlight export examples/denim.toml --to wgsl -o denim-wgsl"


def export(
    fabric: FabricArgument,
    to: Annotated[
        str,
        typer.Option(help="slang, wgsl, hlsl, glsl, spirv, metal, cuda, onnx, gltf or materialx."),
    ],
    output: Annotated[
        Path, typer.Option("--output", "-o", help="The folder to write: new, or of an export.")
    ],
    model: Annotated[
        str | None,
        typer.Option(
            help="lobes, point, neural, clustered, neumip or latent; by default as in the .loom, else lobes."
        ),
    ] = None,
    distance: Annotated[
        float | None,
        typer.Option(help="Metres from which textures of gltf and materialx are seen; by default close."),
    ] = None,
) -> None:
    """Writes a fabric for another program: shader code, a network or a textured material; docs/export.md."""
    require_not_read([output], [fabric])
    from loomlight.exporters import export as run

    done(run(fabric, to, output, model, distance))
