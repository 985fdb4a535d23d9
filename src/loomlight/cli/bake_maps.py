"""`loomlight bake-maps`: the cloth of one repeat as textures."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.options import FabricArgument
from loomlight.cli.progress import done
from loomlight.cli.values import parse_numbers, parse_size, require_within
from loomlight.core.errors import InputError
from loomlight.core.outputs import check_output, require_not_read

EXAMPLE = 'Example: loomlight bake-maps "twill 3/1" -o maps.exr --resolution 1024'

# Millimetres; farther away single precision does not resolve neighbouring fibres.
MAX_WINDOW = 1e5


def bake_maps(
    fabric: FabricArgument,
    output: Annotated[
        Path,
        typer.Option("--output", "-o", help="An .exr file with all maps, or .png for one picture a map."),
    ],
    resolution: Annotated[
        str | None,
        typer.Option(metavar="WxH", help="Columns and rows of texels, or texels of the longer side; 1024."),
    ] = None,
    pixels_per_mm: Annotated[
        float | None, typer.Option(metavar="NUMBER", help="Texels a millimetre, in place of --resolution.")
    ] = None,
    window: Annotated[
        str | None,
        typer.Option(
            metavar="X,Y,W,H", help="Left, bottom, width, height in millimetres; one repeat if left out."
        ),
    ] = None,
    tile: Annotated[
        float | None, typer.Option(metavar="MM", help="Whole repeats, as many as come nearest to a side.")
    ] = None,
    back: Annotated[bool, typer.Option("--back", help="The back face, as seen from behind.")] = False,
) -> None:
    """Writes a fabric as textures: height, normal, fibres, colour, opacity, roughness, occlusion."""
    check_output(output, (".exr", ".png"), makes_folder=True)
    from loomlight.fabric.maps import (
        bake_maps,
        map_file,
        map_files,
        require_window,
        resolution_of,
        warn_of_oblong_texels,
        write_maps,
    )

    require_not_read(map_files(output), [fabric])
    if pixels_per_mm is not None and resolution is not None:
        raise InputError("--pixels-per-mm and --resolution both say how many texels: give one of them.")
    if tile is not None and window is not None:
        raise InputError("--tile and --window both say what is shown: give one of them.")
    for option, number in (("--pixels-per-mm", pixels_per_mm), ("--tile", tile)):
        if number is not None:
            require_within(option, number, 1e-3, MAX_WINDOW)
    corner = None
    if window is not None:
        left, bottom, width, height = parse_numbers("--window", window, 4, "0,0,5,5")
        for number in (left, bottom, width, height):
            require_within("--window", number, -MAX_WINDOW, MAX_WINDOW)
        corner = (left, bottom, width, height)
    # A wrong size is named before the fabric is read.
    sides = parse_size(resolution or "1024", "--resolution")

    from loomlight.core.llvm import require_llvm
    from loomlight.sources.load import fabric_of_path

    cloth = fabric_of_path(fabric)
    require_llvm()
    from drjit.llvm import Float

    if tile is not None:
        across, up = (max(round(tile / side), 1) * side for side in cloth.repeat_mm)
        corner = (0.0, 0.0, across, up)
    if corner is not None:
        require_window(corner)
    extent = cloth.repeat_mm if corner is None else corner[2:]
    if pixels_per_mm is not None:
        columns_and_rows = resolution_of(extent, pixels_per_mm)
    elif resolution is not None and not resolution.strip().isdigit():
        columns_and_rows = sides
        warn_of_oblong_texels(extent, sides)
    else:
        columns_and_rows = resolution_of(extent, sides[0] / max(extent))
    maps = bake_maps(cloth, columns_and_rows, Float, corner, back)
    low, high = maps.height_range
    for path in write_maps(maps, output):
        is_height = path == map_file(output, "height")
        done(path, f"0 to 65535 are {low:.4g} to {high:.4g} mm" if is_height else "")
