"""The commands that make files of a fabric: `bake`, `bake-maps` and `export`."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from loomlight.cli.options import (
    ExecutorName,
    FabricArgument,
    Given,
    SlurmSettings,
    Workers,
    executor_of,
    takes,
)
from loomlight.cli.terminal import done, note_left, progress
from loomlight.core.errors import InputError
from loomlight.core.outputs import check_output, is_folder, require_not_read
from loomlight.core.picture_settings import GarmentSettings, MapSettings, Worn

if TYPE_CHECKING:
    from loomlight.core.fleet import Executor

BAKE_EXAMPLE = "Example: loomlight bake examples/denim.toml --model neural -o denim.loom"


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
    if len(sources) > 1 or (is_folder(output) and not output.suffix):
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
    if folder.suffix or not is_folder(folder.parent) or (os.path.lexists(folder) and not is_folder(folder)):
        raise InputError(f"{folder}: several sources are baked into a folder; give the name of one.")
    from loomlight.models.bake import bake_catalogue
    from loomlight.models.registry import model_class, parse_options

    model_class(model, to_bake=True)
    chosen = parse_options(model, options)
    note_left(f"{folder} keeps what is baked: the same command goes on from there.")
    with progress(f"{len(sources)} sources, {model}") as report:
        paths = bake_catalogue(sources, model, folder, chosen, executor=executor, report=report)
    for path in paths:
        done(path)


# -------------------------------------------------------------------------------------------------- bake-maps

BAKE_MAPS_EXAMPLE = 'Example: loomlight bake-maps "twill 3/1" -o maps.exr --resolution 1024'


@takes(MapSettings)
def bake_maps(
    fabric: FabricArgument,
    output: Annotated[
        Path,
        typer.Option("--output", "-o", help="An .exr file with all maps, or .png for one picture a map."),
    ],
    given: Given,
) -> None:
    """Writes a fabric as textures: height, normal, fibres, colour, opacity, roughness, occlusion."""
    check_output(output, (".exr", ".png"), makes_folder=True)
    settings = MapSettings(**given)
    from loomlight.fabric.maps import map_file, map_files, write_maps
    from loomlight.models.bake import bake_maps

    require_not_read(map_files(output), [fabric])
    maps = bake_maps(fabric, settings)
    low, high = maps.height_range
    for path in write_maps(maps, output):
        is_height = path == map_file(output, "height")
        done(path, f"0 to 65535 are {low:.4g} to {high:.4g} mm" if is_height else "")


# ----------------------------------------------------------------------------------------------------- export

EXPORT_EXAMPLE = "Example: loomlight export examples/denim.toml --to wgsl -o denim-wgsl"


@takes(GarmentSettings)
def export(
    fabric: FabricArgument,
    to: Annotated[
        str,
        typer.Option(
            help=(
                "slang, wgsl, hlsl, glsl, spirv, metal, cuda, onnx, gltf, materialx, usd, usdz, unreal, "
                "unity, godot, threejs, u3m, u3ma, blender or blender-addon."
            )
        ),
    ],
    output: Annotated[
        Path,
        typer.Option(
            "--output",
            "-o",
            help="The folder to write: new, or of an export; of usdz, and of u3ma without --cloth, a file.",
        ),
    ],
    model: Annotated[
        str | None,
        typer.Option(
            help="lobes, point, neural, clustered, neumip or latent; by default as in the .loom, else lobes."
        ),
    ] = None,
    distance: Annotated[
        float | None,
        typer.Option(help="Metres from which textures are seen, but of u3m; by default close."),
    ] = None,
    dpi: Annotated[
        float | None,
        typer.Option(help="Texels an inch of the maps of u3m and u3ma, 30 to 2400; 300 by default."),
    ] = None,
    *,
    given: Given,
) -> None:
    """Writes a fabric for another program: shader code, a network or a textured material; docs/export.md."""
    settings = GarmentSettings(**given)
    worn = [each.fabric if isinstance(each, Worn) else each for each in settings.cloths.values()]
    require_not_read([output], [fabric, settings.mesh, *worn])
    from loomlight.exporters import export as run

    done(run(fabric, to, output, model, distance, dpi, settings))
