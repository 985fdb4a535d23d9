"""The settings of pictures and of maps, each declared once.

What the command line offers (`cli/options.py`), what Python's keywords may be, and the tables of
pages (`python -m tools.generate.settings`) follow from the classes here.
A new setting is a field of one of them, its line in the keywords below it, and the code that uses it.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass
from numbers import Real
from typing import Any, ClassVar, TypedDict

from loomlight.core.camera_settings import CameraKeywords, CameraSettings
from loomlight.core.errors import InputError
from loomlight.core.sentences import shown
from loomlight.core.settings import Settings, documented, same_setting, setting

MAX_SIDE = 16384
# Millimetres; farther away single precision does not resolve neighbouring fibres.
MAX_WINDOW = 1e5
DENOISING = ("auto", "off")
# Layers of a picture.
LAYERS = ("albedo", "normal", "depth", "roughness")


@documented
@dataclass(frozen=True)
class Placement(Settings):
    """Where the weave lies on a mesh, beside what its uv say."""

    title: ClassVar[str] = "setting of a placement"

    turn: float = setting(
        0.0,
        "Turns the weave on the mesh about the middle of its uv, counter-clockwise as the front is seen, "
        "degrees.",
    )
    # Single precision tells a tenth of a millimetre at a kilometre.
    shift: tuple[float, float] = setting(
        (0.0, 0.0),
        "Shifts the weave on the mesh to the right and up, millimetres.",
        low=-1e6,
        high=1e6,
        metavar="X,Y",
        example="5,-2.5",
    )
    scale: float = setting(1.0, "2 shows threads twice as large as life.", low=1e-4, high=1e4)


@dataclass(frozen=True)
class Worn:
    """A further fabric of a picture, as some parts wear it.

    Attributes:
        fabric: a fabric, a model, or the path of a file.
        turn: turns its weave there, counter-clockwise as the front is seen, degrees, beyond `Placement.turn`.
    """

    fabric: Any
    turn: float = 0.0

    def __post_init__(self) -> None:
        """Raises InputError unless the angle is a finite number."""
        if not isinstance(self.turn, Real) or not math.isfinite(self.turn):
            raise InputError(f"turn = {shown(self.turn)} is wrong: give a number of degrees.")


def layer_names(aov: str) -> list[str]:
    """Names of layers in the setting `aov`."""
    return [name.strip() for name in aov.split(",")]


@documented
@dataclass(frozen=True, kw_only=True)
class RenderSettings(Settings):
    """Settings of a picture; `loomlight.render` takes the same names as keywords."""

    title: ClassVar[str] = "setting of a picture"

    model: str | None = setting(
        None,
        "One of the models; a .loom of another one is baked anew, and a line says so.",
        otherwise="what a .loom holds, else lobes",
        metavar="NAME",
    )
    scene: str | os.PathLike[str] = setting(
        "drape",
        "flat (0.1 m), sphere, cylinder, drape (0.6 m), or a Mitsuba scene FILE.xml, whose meshes with the "
        "BSDF fabric are clothed.",
        metavar="NAME|FILE",
    )
    mesh: str | os.PathLike[str] | None = setting(
        None,
        "An .obj, .ply, .gltf, .glb, .usd, .usda, .usdc or .usdz file that is clothed instead of the scene's "
        "cloth; without uv it is cut into pieces.",
        otherwise="none",
    )
    unwrap: bool | None = setting(
        None,
        "Cuts the mesh into pieces that lie flat, at true scale and on straight grain, whether it has uv or "
        "not.",
        flag="--unwrap/--no-unwrap",
        otherwise="where the mesh has no uv",
    )
    save_mesh: str | os.PathLike[str] | None = setting(
        None,
        "An .obj, .gltf or .glb file to which the mesh is written as it is clothed: its parts, their names, "
        "and uv in metres.",
        otherwise="none",
    )
    metres_per_unit: float = setting(
        1.0, "Length of one unit of the mesh or the scene file, metres.", low=1e-6, high=1e6
    )
    environment: str | os.PathLike[str] | None = setting(
        None,
        "A latitude-longitude picture that lights the scene: .exr, .hdr, .png or .jpg.",
        flag="--env",
        otherwise="none",
    )
    environment_turn: float = setting(
        0.0, "Turns the environment about the vertical, degrees.", flag="--env-turn"
    )
    light: str | None = setting(
        None,
        "studio, a neutral key light, back light and dome; sunsky, daylight; point or directional.",
        otherwise="studio; of a scene file its own",
        choices=("studio", "sunsky", "point", "directional"),
        metavar="NAME",
    )
    light_from: tuple[float, float] | None = setting(
        None,
        "Where the light comes from, degrees: 0,0 is the front (+z), 90,0 the right (+x), 0,90 above.",
        otherwise="the upper left",
        metavar="AZIMUTH,ELEVATION",
        example="-40,35",
    )
    # Two halves of 2 × 2: a denoised picture takes as many as fill the grids of both, of 9 twelve.
    spp: int = setting(8, "Samples a pixel.", low=1, high=1_000_000)
    size: tuple[int, int] | None = setting(
        None,
        "Pixels.",
        otherwise="640x480, a scene file's own, or as a camera's",
        low=1,
        high=MAX_SIDE,
        metavar="WxH",
    )
    view: str | tuple[float, float] | None = same_setting(CameraSettings, "view")
    look_at: str | None = same_setting(CameraSettings, "look_at")
    target: tuple[float, float, float] | None = same_setting(CameraSettings, "target")
    distance: float | None = same_setting(CameraSettings, "distance")
    focal_length: float | None = same_setting(CameraSettings, "focal_length")
    roll: float = same_setting(CameraSettings, "roll")
    camera: str | None = same_setting(CameraSettings, "camera")
    zoom: float = setting(
        1.0,
        "1 frames the whole object, 10 is ten times closer to the cloth in the middle.",
        low=0,
        high=1000,
        fits=lambda zoom: zoom > 0,
        expected="a number above 0, at most 1000: 1 frames the object, 10 is ten times closer",
    )
    max_depth: int | None = setting(
        None, "Longest light path, in segments.", otherwise="8, or a scene file's own", low=1, high=1000
    )
    exposure: float = setting(0.0, "Stops; +1 is twice as bright.", low=-30, high=30)
    white_balance: float | None = setting(
        None,
        "Colour temperature of the light that is shown as white, kelvin.",
        otherwise="6500, as it is",
        low=1667,
        high=25000,
        metavar="KELVIN",
    )
    denoise: str = setting(
        "auto",
        "auto takes noise out by Open Image Denoise, where it is installed, and leaves yarns sharp.",
        choices=DENOISING,
    )
    aov: str | None = setting(
        None,
        "Layers of an .exr beside the picture, for denoisers and compositing: some of albedo, normal, "
        "depth and roughness, with commas between.",
        otherwise="none",
        fits=lambda names: set(layer_names(names)) <= set(LAYERS),
        expected=f"names of {', '.join(LAYERS)}, with commas between",
        metavar="NAMES",
        example="albedo,normal",
    )
    inset: bool | None = setting(
        None,
        "A close-up in the upper left corner, in which the weave can be read.",
        flag="--inset/--no-inset",
        otherwise="of a fabric on the whole drape, at 160 pixels and more",
    )
    colors: Mapping[str, Any] = setting(
        dict,
        "Other colours of the yarns; a family that is named twice gets a list, in thread order.",
        flag="--color",
        otherwise="the fabric's",
        expected="a dictionary; {} changes nothing",
        metavar="warp=#…,weft=#…",
    )
    cloths: Mapping[str, Any] = setting(
        dict,
        "Further fabrics, for parts, pieces or materials NAME of the mesh, or BSDFs NAME of a scene file; "
        "turn turns the weave there (`Worn` in Python).",
        flag="--cloth",
        otherwise="none",
        expected="a dictionary; {} changes nothing",
        metavar="NAME=FABRIC[,turn=DEGREES]",
        example="lining=satin",
    )
    maps: Mapping[str, Any] = setting(
        dict,
        "Pictures over the surface, of a colour, a number of the yarns, wear, or which fabric, color=a.png, "
        "or with fields of [maps], wear=knees.png:side=front:width_mm=400.",
        flag="--map",
        otherwise="the fabric's",
        expected="a dictionary; {} changes nothing",
        metavar="NAME=PICTURE",
        example="wear=knees.png",
    )
    placement: Placement = setting(Placement, "Where the weave lies on a mesh.", expected="a Placement")
    edge: str | None = setting(
        None,
        "Edges of the cloth: folded over, cut in teeth, or as the mesh has them; scene files have their own.",
        otherwise="hem of the drape and of meshes, pinked of flat, else raw",
        choices=("hem", "pinked", "raw"),
    )
    seed: int = setting(0, "The same seed gives the same picture, but for rounding.", low=0, high=2**32 - 1)
    variant: str | None = setting(
        None,
        "llvm_ad_rgb, the processor, or cuda_ad_rgb, an NVIDIA card.",
        otherwise="the one that is set, else llvm_ad_rgb",
        choices=("llvm_ad_rgb", "cuda_ad_rgb"),
        metavar="NAME",
    )

    def __post_init__(self) -> None:
        """Raises InputError for a value that cannot be, and for settings of the camera that contradict."""
        super().__post_init__()
        CameraSettings.within(self)

    @property
    def soft_terminator(self) -> bool:
        """Whether flat triangles could show at the edge of shadow: of narrow lights, not of the studio's."""
        return self.light in ("point", "directional", "sunsky")


@documented
@dataclass(frozen=True, kw_only=True)
class SwatchSettings(Settings):
    """Settings of a contact sheet; `loomlight.swatches` takes the same names as keywords."""

    title: ClassVar[str] = "setting of a contact sheet"

    model: str = setting("lobes", "One of the models.", metavar="NAME")
    size: int = setting(240, "Side of each picture, pixels.", low=32, high=2048, metavar="PIXELS")
    spp: int = same_setting(RenderSettings, "spp")
    view: str | tuple[float, float] | None = same_setting(
        CameraSettings, "view", help="Where the camera of the drape stands, as that of a picture."
    )
    heading: str = setting("Fabrics", "Heading of a page.", flag="--title")
    white_balance: float | None = same_setting(RenderSettings, "white_balance")
    denoise: str = same_setting(RenderSettings, "denoise")
    variant: str | None = same_setting(RenderSettings, "variant")


@documented
@dataclass(frozen=True, kw_only=True)
class PlaySettings(Settings):
    """Settings of the window in real time; `loomlight.play` takes the same names as keywords."""

    title: ClassVar[str] = "setting of the window"

    scene: str = setting("drape", "flat, sphere, cylinder or drape.", metavar="NAME")
    mesh: str | os.PathLike[str] | None = same_setting(RenderSettings, "mesh")
    unwrap: bool | None = same_setting(RenderSettings, "unwrap")
    metres_per_unit: float = same_setting(
        RenderSettings, "metres_per_unit", help="Length of one unit of the mesh, metres."
    )
    model: str | None = setting(
        None,
        "lobes, point, neural, clustered, neumip or latent.",
        otherwise="as in the .loom, else lobes",
        metavar="NAME",
    )
    environment: str | os.PathLike[str] | None = same_setting(RenderSettings, "environment")
    environment_turn: float = same_setting(RenderSettings, "environment_turn")
    size: tuple[int, int] = same_setting(
        RenderSettings, "size", help="Pixels of the window.", default=(960, 720), otherwise=""
    )
    view: str | tuple[float, float] | None = same_setting(CameraSettings, "view")
    look_at: str | None = same_setting(CameraSettings, "look_at")
    target: tuple[float, float, float] | None = same_setting(CameraSettings, "target")
    distance: float | None = same_setting(CameraSettings, "distance")
    focal_length: float | None = same_setting(CameraSettings, "focal_length", otherwise="52")
    roll: float = same_setting(CameraSettings, "roll")
    camera: str | None = same_setting(CameraSettings, "camera")
    zoom: float = same_setting(RenderSettings, "zoom", low=1e-3, fits=None, expected="")
    exposure: float = same_setting(
        RenderSettings, "exposure", help="Stops; the keys + and - of the window change it."
    )
    white_balance: float | None = same_setting(RenderSettings, "white_balance")
    passes: int | None = setting(
        None,
        "Passes of a frame that is written.",
        otherwise="16, or 4 where a software adapter computes",
        low=1,
        high=100_000,
    )

    def __post_init__(self) -> None:
        """Raises InputError for a value that cannot be, and for settings of the camera that contradict."""
        super().__post_init__()
        CameraSettings.within(self)


@documented
@dataclass(frozen=True, kw_only=True)
class MapSettings(Settings):
    """Settings of baked maps; `loomlight.bake_maps` takes the same names as keywords."""

    title: ClassVar[str] = "setting of maps"

    resolution: tuple[int, int] | int | None = setting(
        None,
        "Columns and rows of texels; one number is the longer side of square ones. Some 16 a thread show its "
        "round shape and its plies, 64 its fibres.",
        otherwise="1024",
        low=1,
        high=MAX_SIDE,
        single=True,
        metavar="WxH",
    )
    pixels_per_mm: float | None = setting(
        None,
        "Square texels a millimetre, in place of a resolution.",
        low=1e-3,
        high=MAX_WINDOW,
        metavar="NUMBER",
    )
    window: tuple[float, float, float, float] | None = setting(
        None,
        "Left, bottom, width, height in millimetres, anywhere: the draft repeats.",
        otherwise="one repeat",
        low=-MAX_WINDOW,
        high=MAX_WINDOW,
        metavar="X,Y,W,H",
        example="0,0,5,5",
    )
    tile: float | None = setting(
        None,
        "Whole repeats, as many as come nearest to a side of so many millimetres, in place of a window.",
        low=1e-3,
        high=MAX_WINDOW,
        metavar="MM",
    )
    back: bool = setting(False, "The back face, as seen from behind.")

    def __post_init__(self) -> None:
        """Raises InputError for a value that cannot be, and for two that say the same."""
        super().__post_init__()
        for one, other, what in (
            ("pixels_per_mm", "resolution", "how many texels"),
            ("tile", "window", "what is shown"),
        ):
            if getattr(self, one) is not None and getattr(self, other) is not None:
                raise InputError(f"{one} and {other} both say {what}: give one of them.")


@documented
@dataclass(frozen=True, kw_only=True)
class GarmentSettings(Settings):
    """Settings of a mesh that is exported in its cloths; `loomlight.export` takes the same keywords."""

    title: ClassVar[str] = "setting of an export"

    mesh: str | os.PathLike[str] | None = setting(
        None,
        "An .obj, .ply, .gltf, .glb, .usd, .usda, .usdc or .usdz file that is written in the fabric; without "
        "uv it is cut into pieces.",
        otherwise="a sheet of 10 cm",
    )
    cloths: Mapping[str, Any] = same_setting(
        RenderSettings,
        "cloths",
        help="Further fabrics, for parts, pieces or materials NAME of the mesh; turn turns the weave there "
        "(`Worn` in Python). U3M takes them without a mesh.",
    )
    unwrap: bool | None = same_setting(RenderSettings, "unwrap")
    metres_per_unit: float = same_setting(
        RenderSettings, "metres_per_unit", help="Length of one unit of the mesh, metres."
    )
    placement: Placement = same_setting(RenderSettings, "placement")


class _Keywords(TypedDict, total=False):
    """Keywords of all pictures that Mitsuba renders, for editors and type checkers."""

    spp: int
    white_balance: float | None
    denoise: str
    variant: str | None


class RenderKeywords(_Keywords, CameraKeywords, total=False):
    """Keywords of `loomlight.render`: fields of `RenderSettings`, but for the scene."""

    model: str | None
    mesh: str | os.PathLike[str] | None
    unwrap: bool | None
    save_mesh: str | os.PathLike[str] | None
    metres_per_unit: float
    environment: str | os.PathLike[str] | None
    environment_turn: float
    light: str | None
    light_from: tuple[float, float] | None
    size: tuple[int, int] | None
    zoom: float
    max_depth: int | None
    exposure: float
    aov: str | None
    inset: bool | None
    colors: Mapping[str, Any]
    cloths: Mapping[str, Any]
    maps: Mapping[str, Any]
    placement: Placement
    edge: str | None
    seed: int


class SwatchKeywords(_Keywords, total=False):
    """Keywords of `loomlight.swatches`: fields of `SwatchSettings`."""

    model: str
    size: int
    view: str | tuple[float, float] | None
    heading: str


class PlayKeywords(CameraKeywords, total=False):
    """Keywords of `loomlight.play`: fields of `PlaySettings`."""

    scene: str
    mesh: str | os.PathLike[str] | None
    unwrap: bool | None
    metres_per_unit: float
    model: str | None
    environment: str | os.PathLike[str] | None
    environment_turn: float
    size: tuple[int, int]
    zoom: float
    exposure: float
    white_balance: float | None
    passes: int | None


class MapKeywords(TypedDict, total=False):
    """Keywords of `loomlight.bake_maps`: fields of `MapSettings`."""

    resolution: tuple[int, int] | int | None
    pixels_per_mm: float | None
    window: tuple[float, float, float, float] | None
    tile: float | None
    back: bool


class GarmentKeywords(TypedDict, total=False):
    """Keywords of `loomlight.export`: fields of `GarmentSettings`."""

    mesh: str | os.PathLike[str] | None
    cloths: Mapping[str, Any]
    unwrap: bool | None
    metres_per_unit: float
    placement: Placement
