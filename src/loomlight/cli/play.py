"""`loomlight play`: a window in which a fabric is seen in real time."""

from __future__ import annotations

import os
import sys
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from loomlight.cli import render_options as option
from loomlight.cli.outputs import check_output, done
from loomlight.cli.progress import progress
from loomlight.cli.values import parse_size, require_within
from loomlight.core.errors import LoomlightWarning, MissingDependencyError
from loomlight.core.files import WRITTEN_SUFFIXES

if TYPE_CHECKING:
    from loomlight.realtime.renderer import Picture
    from loomlight.realtime.viewer import Viewer

EXAMPLE = "Example: loomlight play examples/denim.toml --scene drape"
_SIZE = (960, 720)
# Passes of a frame that is written.
PASSES, SOFTWARE_PASSES = 16, 4
_NO_WINDOW = (
    "loomlight play opens a window, and {reason}: {remedy}, or write a frame with -o frame.png, or use "
    "loomlight render."
)


def play(
    fabric: option.FabricArgument,
    scene: Annotated[str, typer.Option(help="flat, sphere, cylinder or drape.")] = "drape",
    mesh: option.MeshOption = None,
    metres_per_unit: Annotated[float, typer.Option(help="Length of one unit of the mesh, metres.")] = 1.0,
    model: option.RealtimeModelOption = None,
    environment: Annotated[
        Path | None, typer.Option("--env", help="A latitude-longitude picture: .exr, .hdr, .png or .jpg.")
    ] = None,
    environment_turn: option.EnvironmentTurnOption = 0.0,
    size: Annotated[str | None, typer.Option(metavar="WxH", help="Pixels of the window; 960x720.")] = None,
    zoom: option.ZoomOption = 1.0,
    exposure: Annotated[float, typer.Option(help="Stops; the keys + and - change it.")] = 0.0,
    white_balance: option.WhiteBalanceOption = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Write a frame, .png, .jpg or .exr, off screen; open no window."),
    ] = None,
    passes: Annotated[
        int | None, typer.Option(help="Passes of that frame; 16, or 4 where a software adapter computes.")
    ] = None,
) -> None:
    """Opens a window of a fabric in real time: drag to orbit, turn the wheel from garment to yarn.

    Further keys: m the model, l the light, + and - the exposure, r back to the start; Shift or the right
    button moves.
    """
    require_within("--zoom", zoom, 1e-3, 1e3)
    require_within("--exposure", exposure, -30, 30)
    require_within("--white-balance", 6500 if white_balance is None else white_balance, 1667, 25000)
    require_within("--env-turn", environment_turn, -360, 360)
    require_within("--metres-per-unit", metres_per_unit, 1e-6, 1e6)
    require_within("--passes", 1 if passes is None else passes, 1, 100_000)
    pixels = _SIZE if size is None else parse_size(size)
    if output is not None:
        check_output(output, WRITTEN_SUFFIXES, [fabric, mesh, environment])
    canvas = None if output is not None else _window(pixels)
    lighting = environment, environment_turn, white_balance, exposure
    viewer = _viewer(fabric, model, (scene, mesh, metres_per_unit), lighting, pixels, zoom)
    if output is not None:
        _write(viewer, output, passes, exposure)
    elif canvas is not None:
        viewer.attach(canvas)
        from rendercanvas.auto import loop

        loop.run()


def _viewer(
    fabric: str,
    model: str | None,
    worn: tuple[str, Path | None, float],
    lighting: tuple[Path | None, float, float | None, float],
    size: tuple[int, int],
    zoom: float,
) -> Viewer:
    import numpy as np

    from loomlight.core.colour import white_balance as white_balance_gains
    from loomlight.mesh.cloth_mesh import uv_size, warn_of_extent, warn_of_scale
    from loomlight.mitsuba.camera import framing
    from loomlight.mitsuba.lights import studio_radiance
    from loomlight.mitsuba.scenes import built_in_cloth
    from loomlight.mitsuba.variants import choose_variant
    from loomlight.realtime import Cloth, DirectionalLight, Environment, Mesh, Renderer
    from loomlight.realtime.models import material_of, models_of
    from loomlight.realtime.orbit import Orbit
    from loomlight.realtime.viewer import Lighting, Viewer

    scene, mesh, metres_per_unit = worn
    environment, environment_turn, white_balance, exposure = lighting
    choose_variant(None)
    material = material_of(fabric)
    cloth, towards_camera, towards_light = built_in_cloth(scene, mesh)
    cloth = cloth.scaled(metres_per_unit if mesh is not None else 1.0)
    if mesh is not None:
        warn_of_extent(cloth, metres_per_unit)
        warn_of_scale(cloth)
    piece = Cloth(
        Mesh(cloth.positions, cloth.normals, cloth.uv, cloth.triangles.astype("uint32")),
        material,
        uv_size(cloth),
    )
    # Light and colours multiply channel by channel: balanced light is a balanced picture.
    gains = np.ones(3) if white_balance is None else white_balance_gains(white_balance)
    towards = towards_light / (towards_light @ towards_light) ** 0.5
    places = {"studio": Environment(studio_radiance(towards) * gains)}
    if environment is not None:
        read = Environment.read(environment, environment_turn)
        places[environment.name] = Environment(read.radiance * gains, read.turn)
    around = [
        Lighting(
            name, (), {"environment": place, "background": tuple(0.18 * gains) if name == "studio" else None}
        )
        for name, place in places.items()
    ]
    # What the user named comes first.
    sun = Lighting("directional", [DirectionalLight(towards_light, tuple(np.pi * gains))])
    renderer = Renderer([piece], size, model)
    view = framing(cloth.positions, towards_camera, size)
    orbit = Orbit.between(view.origin, view.target)
    return Viewer(renderer, orbit.closer_by(zoom), [*around[::-1], sun], models_of(material), exposure)


def _write(viewer: Viewer, output: Path, passes: int | None, exposure: float) -> None:
    """Writes the frame after its first pass, and again after its last."""
    if viewer.adapter.is_software:
        warnings.warn(
            f"{viewer.adapter.name} computes on the CPU, which takes many seconds a pass: loomlight render "
            "is faster here.",
            LoomlightWarning,
            stacklevel=2,
        )
    whole = passes or (SOFTWARE_PASSES if viewer.adapter.is_software else PASSES)
    with progress(f"{output.name}") as report:
        for number in range(1, whole + 1):
            picture = viewer.frame()
            report(number, whole)
            if number in (1, whole):
                _write_frame(picture, output, exposure)
    done(output)


def _write_frame(picture: Picture, output: Path, exposure: float) -> None:
    from loomlight.core.images import write_image, write_pixels

    if output.suffix.lower() == ".exr":
        write_image(output, picture.linear[..., :3] * 2.0**exposure)
    else:
        write_pixels(output, picture.srgb[..., :3])


def _window(size: tuple[int, int]) -> Any:
    """A window of rendercanvas.

    Raises:
        MissingDependencyError: rendercanvas is not installed, or there is no display or no window library.
    """
    from loomlight.core.extras import import_extra

    import_extra("rendercanvas", "realtime", "A window")
    if sys.platform.startswith("linux") and not (
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY") or _is_offscreen()
    ):
        reason = "this machine has no display (neither DISPLAY nor WAYLAND_DISPLAY is set)"
        raise MissingDependencyError(_NO_WINDOW.format(reason=reason, remedy="run it where there is one"))
    try:
        from rendercanvas.auto import RenderCanvas

        return RenderCanvas(size=size, title="loomlight", update_mode="ondemand", max_fps=60)
    except (ImportError, RuntimeError) as error:
        reason = "no window library can open one here"
        raise MissingDependencyError(
            _NO_WINDOW.format(reason=reason, remedy="install one (pip install glfw)")
        ) from error


def _is_offscreen() -> bool:
    """Whether rendercanvas is told to draw off screen, as its own tests do."""
    return os.environ.get("RENDERCANVAS_FORCE_OFFSCREEN", "") in ("1", "true", "yes")
