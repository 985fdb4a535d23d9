"""`loomlight bake-maps`: the yarns of one repeat as textures."""

from __future__ import annotations

import glob
from pathlib import Path
from typing import Annotated

import typer

from loomlight.cli.outputs import check_output, done, require_not_read
from loomlight.cli.values import parse_numbers, parse_size, require_within

EXAMPLE = 'Example: loomlight bake-maps "twill 3/1" -o maps.exr --resolution 1024'

# Millimetres; farther away single precision does not resolve neighbouring fibres.
MAX_WINDOW = 1e5


def bake_maps(
    fabric: Annotated[
        str, typer.Argument(metavar="FABRIC", help="A fabric file, a draft, a .loom, or a weave's name.")
    ],
    output: Annotated[
        Path,
        typer.Option("--output", "-o", help="An .exr file with all maps, or .png for one picture a map."),
    ],
    resolution: Annotated[
        str, typer.Option(metavar="WxH", help="Columns and rows of texels; one number for both.")
    ] = "1024",
    window: Annotated[
        str | None,
        typer.Option(
            metavar="X,Y,W,H", help="Left, bottom, width, height in millimetres; one repeat if left out."
        ),
    ] = None,
    back: Annotated[bool, typer.Option("--back", help="The back face, as seen from behind.")] = False,
) -> None:
    """Writes height, normal, fibres, family, holes, colour, opacity and roughness of a fabric as textures."""
    check_output(output, (".exr", ".png"))
    # One picture a map, or one file of all.
    pictures = output.parent.glob(f"{glob.escape(output.stem)}_*.png")
    require_not_read([output] if output.suffix.lower() == ".exr" else pictures, [fabric])
    columns_and_rows = parse_size(resolution, "--resolution")
    corner = None
    if window is not None:
        left, bottom, width, height = parse_numbers("--window", window, 4, "0,0,5,5")
        for number in (left, bottom, width, height):
            require_within("--window", number, -MAX_WINDOW, MAX_WINDOW)
        corner = (left, bottom, width, height)

    from loomlight.assets.load import fabric_of_path
    from loomlight.core.llvm import require_llvm

    cloth = fabric_of_path(fabric)
    require_llvm()
    from drjit.llvm import Float

    from loomlight.fabric.material_maps import material_maps
    from loomlight.yarn.geometry import YarnGeometry
    from loomlight.yarn.maps import bake_maps, write_maps

    maps = bake_maps(YarnGeometry(cloth.layout()), columns_and_rows, Float, corner, back)
    for path in write_maps(maps, output, material_maps(cloth, maps)):
        done(path)
