"""The window of `loomlight play`, in which a fabric is seen in real time, and its frames as files."""

from __future__ import annotations

import os
import sys
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any, Unpack

import numpy as np

from loomlight.core.camera_settings import CameraSettings
from loomlight.core.colour import white_balance
from loomlight.core.errors import LoomlightWarning, MissingDependencyError
from loomlight.core.extras import import_extra
from loomlight.core.files import WRITTEN_SUFFIXES
from loomlight.core.fleet import Report
from loomlight.core.images import write_image, write_pixels
from loomlight.core.outputs import check_output
from loomlight.core.picture_settings import PlayKeywords, PlaySettings
from loomlight.core.studio import studio_radiance
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.surface_maps import print_on_uv, without_maps
from loomlight.mesh.cloth_mesh import uv_size, warn_of_extent, warn_of_scale
from loomlight.mitsuba.scenes import built_in_cloth, built_in_view
from loomlight.mitsuba.variants import choose_variant
from loomlight.realtime import Cloth, DirectionalLight, Environment, Mesh, Renderer
from loomlight.realtime.materials import Material, material_of, models_of
from loomlight.realtime.renderer import Picture
from loomlight.realtime.viewer import Lighting, Orbit, Viewer

# Passes of a frame that is written.
PASSES, SOFTWARE_PASSES = 16, 4
_NO_WINDOW = (
    "loomlight play opens a window, and {reason}: {remedy}, or write a frame with -o frame.png, or use "
    "loomlight render."
)


def play(
    fabric: Material | str | os.PathLike[str],
    settings: PlaySettings | None = None,
    *,
    output: str | os.PathLike[str] | None = None,
    report: Report = lambda done, total: None,
    **changes: Unpack[PlayKeywords],
) -> None:
    """Opens a window of a fabric in real time, and returns when it is closed; or writes a frame of it.

    Drag to orbit, turn the wheel from garment to yarn, Shift or the right button moves; m is the model, l the
    light, + and - the exposure, c prints the camera as options of commands, r back to the start.

    Args:
        fabric: a fabric or a model; or the path of a fabric file, a draft or a `.loom`, or a weave's name.
        settings: by default those of `PlaySettings`.
        output: a .png, .jpg or .exr: a frame is written there off screen, and no window is opened.
        report: called with (passes done, passes in all) of that frame.
        changes: settings by name, such as `scene="flat", zoom=4`.

    Raises:
        InputError: an unknown setting, or a fabric, file or value that cannot be used.
        MissingDependencyError: no adapter, or for a window no display or no window library.
    """
    chosen = (settings or PlaySettings()).changed(**changes)
    if output is not None:
        own = fabric if isinstance(fabric, str | os.PathLike) else None
        check_output(Path(output), WRITTEN_SUFFIXES, [own, chosen.mesh, chosen.environment])
        _write(_viewer(fabric, chosen), Path(output), chosen, report)
        return
    canvas = _window(chosen.size)
    _viewer(fabric, chosen).attach(canvas)
    from rendercanvas.auto import loop

    loop.run()


def _viewer(fabric: Material | str | os.PathLike[str], settings: PlaySettings) -> Viewer:
    """Cloth as the settings have it, in real time."""
    choose_variant(None)
    material = material_of(fabric)
    cloth, _, _, on_paper = built_in_cloth(
        settings.scene, settings.mesh, settings.metres_per_unit, settings.unwrap
    )
    picture = None
    if isinstance(material, Fabric) and material.fields.maps:
        picture = print_on_uv(material)
        material = without_maps(material, "A window", [] if picture is None else ["color"])
        if picture is not None and settings.mesh is None:
            picture = picture[::-1]  # uv of built-in pieces run upwards
    if settings.mesh is not None:
        warn_of_extent(cloth, settings.metres_per_unit)
        warn_of_scale(cloth)
    seen = CameraSettings.within(settings)
    view, towards_light = built_in_view(
        seen,
        settings.scene,
        settings.mesh,
        cloth,
        settings.size,
        settings.metres_per_unit,
        settings.unwrap,
    )
    piece = Cloth(
        Mesh(cloth.positions, cloth.normals, cloth.uv, cloth.triangles.astype("uint32")),
        material,
        uv_size(cloth),
        picture,
    )
    # Light and colours multiply channel by channel: balanced light is a balanced picture.
    balance, environment = settings.white_balance, settings.environment
    gains = np.ones(3) if balance is None else white_balance(balance)
    places = {"studio": Environment(studio_radiance(towards_light, paper=on_paper) * gains)}
    if environment is not None:
        read = Environment.read(environment, settings.environment_turn)
        places[Path(environment).name] = Environment(read.radiance * gains, read.turn)
    around = [
        Lighting(
            name, (), {"environment": place, "background": tuple(0.18 * gains) if name == "studio" else None}
        )
        for name, place in places.items()
    ]
    # What the user named comes first.
    sun = Lighting("directional", [DirectionalLight(towards_light, tuple(np.pi * gains))])
    renderer = Renderer([piece], settings.size, settings.model)
    orbit = replace(
        Orbit.between(view.origin, view.target),
        azimuth=view.azimuth,
        field_of_view=view.field_of_view,
        roll=view.roll,
    )
    lights = [*around[::-1], sun]
    return Viewer(renderer, orbit.closer_by(settings.zoom), lights, models_of(material), settings.exposure)


def _write(viewer: Viewer, output: Path, settings: PlaySettings, report: Report) -> None:
    """Writes the frame after its first pass, and again after its last."""
    if viewer.adapter.is_software:
        warnings.warn(
            f"{viewer.adapter.name} computes on the CPU, which takes many seconds a pass: loomlight render "
            "is faster here.",
            LoomlightWarning,
            stacklevel=2,
        )
    whole = settings.passes or (SOFTWARE_PASSES if viewer.adapter.is_software else PASSES)
    for number in range(1, whole + 1):
        picture = viewer.frame()
        report(number, whole)
        if number in (1, whole):
            _write_frame(picture, output, settings.exposure)


def _write_frame(picture: Picture, output: Path, exposure: float) -> None:
    if output.suffix.lower() == ".exr":
        write_image(output, picture.linear[..., :3] * 2.0**exposure)
    else:
        write_pixels(output, picture.srgb[..., :3])


def _window(size: tuple[int, int]) -> Any:
    """A window of rendercanvas.

    Raises:
        MissingDependencyError: rendercanvas is not installed, or there is no display or no window library.
    """
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
