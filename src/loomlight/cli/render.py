"""`loomlight render`: a picture of a fabric."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.outputs import check_output, done
from loomlight.cli.progress import progress
from loomlight.cli.values import parse_numbers, parse_size, require_within

EXAMPLE = "Example: loomlight render examples/denim.toml -o denim.png --scene drape --size 960x720 --spp 64"


def render(
    fabric: Annotated[
        str, typer.Argument(metavar="FABRIC", help="A fabric file, a draft, a .loom, or a weave's name.")
    ],
    output: Annotated[
        Path, typer.Option("--output", "-o", help="The picture to write: .png (sRGB) or .exr (linear).")
    ],
    model: Annotated[
        str | None,
        typer.Option(help="How the cloth is computed; by default what a .loom holds, else lobes."),
    ] = None,
    scene: Annotated[
        str, typer.Option(help="flat, sphere, cylinder, drape, or a Mitsuba scene FILE.xml.")
    ] = "drape",
    mesh: Annotated[
        Path | None, typer.Option(help="An .obj, .ply, .gltf or .glb file to clothe; it needs uv.")
    ] = None,
    metres_per_unit: Annotated[
        float, typer.Option(help="Length of one unit of the mesh or the scene file, metres.")
    ] = 1.0,
    environment: Annotated[
        Path | None, typer.Option("--env", help="A latitude-longitude picture that lights the scene.")
    ] = None,
    environment_turn: Annotated[
        float, typer.Option("--env-turn", help="Turns it about the vertical, degrees.")
    ] = 0.0,
    light: Annotated[
        str | None,
        typer.Option(help="studio, sunsky, point or directional; by default what suits the scene."),
    ] = None,
    light_from: Annotated[
        str | None,
        typer.Option(
            metavar="AZIMUTH,ELEVATION",
            help="Where it comes from, degrees: 0,0 is the front, 90,0 the right, 0,90 above.",
        ),
    ] = None,
    samples: Annotated[int, typer.Option("--spp", help="Samples a pixel.")] = 64,
    size: Annotated[
        str | None, typer.Option(metavar="WxH", help="Pixels; 512x512, or a scene file's own.")
    ] = None,
    zoom: Annotated[float, typer.Option(help="1 frames the whole object, 10 is ten times closer.")] = 1.0,
    depth: Annotated[
        int | None,
        typer.Option("--max-depth", help="Longest light path, in segments; 8, or a scene file's own."),
    ] = None,
    exposure: Annotated[float, typer.Option(help="Stops; +1 is twice as bright.")] = 0.0,
    seed: Annotated[int, typer.Option(help="The same seed gives the same picture, but for rounding.")] = 0,
    variant: Annotated[str | None, typer.Option(help="llvm_ad_rgb (default) or cuda_ad_rgb.")] = None,
) -> None:
    """Renders a fabric on a piece of cloth, a mesh, or the marked shapes of a scene file."""
    if model is not None:
        from loomlight.models.registry import require_model_name

        require_model_name(model)
    check_output(output, (".png", ".exr"))
    pixels = None if size is None else parse_size(size)
    require_within("--spp", samples, 1, 1_000_000)
    require_within("--exposure", exposure, -30, 30)
    require_within("--seed", seed, 0, 2**32 - 1)
    require_within("--max-depth", 8 if depth is None else depth, 1, 1000)
    require_within("--env-turn", environment_turn, -360, 360)
    require_within("--metres-per-unit", metres_per_unit, 1e-6, 1e6)
    towards_light = None
    if light_from is not None:
        azimuth, elevation = parse_numbers("--light-from", light_from, 2, "-40,35")
        towards_light = (azimuth, elevation)

    from loomlight.core.images import write_image
    from loomlight.mitsuba import render_fabric

    with progress(f"{fabric}, {scene if mesh is None else mesh.name}") as report:
        picture = render_fabric(
            fabric,
            scene,
            model=model,
            mesh=mesh,
            metres_per_unit=metres_per_unit,
            environment=environment,
            environment_turn=environment_turn,
            light=light,
            light_from=towards_light,
            zoom=zoom,
            size=pixels,
            max_depth=depth,
            spp=samples,
            seed=seed,
            exposure=exposure,
            variant=variant,
            progress=report,
        )
    write_image(output, picture)
    done(output)
