"""The options of `loomlight render`, in the order in which its help lists them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

FabricsArgument = Annotated[
    list[str],
    typer.Argument(metavar="FABRIC...", help="Fabric files, drafts, .loom files, or weaves' names."),
]
FabricArgument = Annotated[
    str, typer.Argument(metavar="FABRIC", help="A fabric file, a draft, a .loom, or a weave's name.")
]
RealtimeModelOption = Annotated[
    str | None,
    typer.Option(
        help="lobes, point, neural, clustered, neumip or latent; by default as in the .loom, else lobes."
    ),
]
OutputOption = Annotated[
    str,
    typer.Option(
        "--output",
        "-o",
        metavar="PATH",
        help="A picture: .png or .jpg (sRGB), or .exr (linear); of several fabrics with {name} in it.",
    ),
]
ModelOption = Annotated[
    str | None, typer.Option(help="One of the models below; by default what a .loom holds, else lobes.")
]
SceneOption = Annotated[
    str | None, typer.Option(help="flat, sphere, cylinder, drape (default), or a Mitsuba scene FILE.xml.")
]
MeshOption = Annotated[
    Path | None,
    typer.Option(help="An .obj, .ply, .gltf or .glb file to clothe instead of --scene; it needs uv."),
]
MetresPerUnitOption = Annotated[
    float, typer.Option(help="Length of one unit of the mesh or the scene file, metres.")
]
EnvironmentOption = Annotated[
    Path | None,
    typer.Option("--env", help="A latitude-longitude picture that lights the scene; none by default."),
]
EnvironmentTurnOption = Annotated[
    float, typer.Option("--env-turn", help="Turns it about the vertical, degrees.")
]
LightOption = Annotated[
    str | None, typer.Option(help="studio (default), sunsky, point or directional; of a scene file its own.")
]
LightFromOption = Annotated[
    str | None,
    typer.Option(
        metavar="AZIMUTH,ELEVATION",
        help="Where it comes from, degrees: 0,0 is the front, 90,0 the right, 0,90 above; "
        "by default from the upper left.",
    ),
]
SamplesOption = Annotated[int, typer.Option("--spp", help="Samples a pixel.")]
SizeOption = Annotated[
    str | None, typer.Option(metavar="WxH", help="Pixels; by default 640x480, or a scene file's own.")
]
ZoomOption = Annotated[float, typer.Option(help="1 frames the whole object, 10 is ten times closer.")]
DepthOption = Annotated[
    int | None,
    typer.Option("--max-depth", help="Longest light path, in segments; by default 8, or a scene file's own."),
]
ExposureOption = Annotated[float, typer.Option(help="Stops; +1 is twice as bright.")]
WhiteBalanceOption = Annotated[
    float | None,
    typer.Option(
        metavar="KELVIN",
        help="Colour temperature of the light that is shown as white; by default 6500, as it is.",
    ),
]
DenoiseOption = Annotated[
    str, typer.Option(metavar="auto|off", help="auto takes noise out of pictures, and leaves yarns sharp.")
]
InsetOption = Annotated[
    bool | None,
    typer.Option(
        "--inset/--no-inset",
        help="A close-up in the corner; by default where a weave or draft is on the whole drape.",
    ),
]
ColorOption = Annotated[
    list[str] | None,
    typer.Option(metavar="warp=#…,weft=#…", help="Colours of the yarns; by default the fabric's."),
]
ClothOption = Annotated[
    list[str] | None,
    typer.Option(
        metavar="NAME=FABRIC",
        help="A further fabric for parts or materials NAME of the mesh, or BSDFs NAME of a scene; "
        "none by default.",
    ),
]
TurnOption = Annotated[float, typer.Option(help="Turns the weave on the mesh, degrees.")]
ShiftOption = Annotated[str, typer.Option(metavar="X,Y", help="Shifts the weave on the mesh, millimetres.")]
ScaleOption = Annotated[float, typer.Option(help="2 shows threads twice as large as life.")]
EdgeOption = Annotated[
    str | None,
    typer.Option(
        metavar="hem|pinked|raw",
        help="Edges of the cloth: hem by default of the drape and meshes, pinked of flat, else raw.",
    ),
]
TurntableOption = Annotated[
    int | None,
    typer.Option(
        metavar="N",
        help="N pictures of one turn: .png, .jpg, .exr, numbered, or one .webp or .gif; off by default.",
    ),
]
SeedOption = Annotated[int, typer.Option(help="The same seed gives the same picture, but for rounding.")]
VariantOption = Annotated[
    str | None, typer.Option(help="llvm_ad_rgb (default: the processor) or cuda_ad_rgb (an NVIDIA card).")
]
