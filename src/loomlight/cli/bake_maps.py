"""`loomlight bake-maps`: the cloth of one repeat as textures."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.options import FabricArgument, Given, takes
from loomlight.cli.progress import done
from loomlight.core.outputs import check_output, require_not_read
from loomlight.picture_settings import MapSettings

EXAMPLE = 'Example: loomlight bake-maps "twill 3/1" -o maps.exr --resolution 1024'


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
