"""`loomlight render`: a picture of a fabric."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from loomlight.cli.interruption import note_left, was_interrupted
from loomlight.cli.outputs import check_output, done
from loomlight.cli.progress import progress
from loomlight.cli.values import parse_numbers, parse_size, require_within
from loomlight.core.errors import InputError
from loomlight.core.files import replacing

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

EXAMPLE = "Example: loomlight render examples/denim.toml -o denim.png --scene drape --size 960x720 --spp 64"
DEFAULT_SCENE = "drape"
# Seconds between refined pictures: writing one takes a tenth of a second.
_WRITE_EVERY = 2.0


def render(
    fabric: Annotated[
        str, typer.Argument(metavar="FABRIC", help="A fabric file, a draft, a .loom, or a weave's name.")
    ],
    output: Annotated[
        Path, typer.Option("--output", "-o", help="The picture to write: .png (sRGB) or .exr (linear).")
    ],
    model: Annotated[
        str | None,
        typer.Option(help="One of the models below; by default what a .loom holds, else lobes."),
    ] = None,
    scene: Annotated[
        str | None,
        typer.Option(help="flat, sphere, cylinder, drape (default), or a Mitsuba scene FILE.xml."),
    ] = None,
    mesh: Annotated[
        Path | None, typer.Option(help="An .obj, .ply, .gltf or .glb file to clothe instead; it needs uv.")
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
    samples: Annotated[int, typer.Option("--spp", help="Samples a pixel.")] = 9,
    size: Annotated[
        str | None, typer.Option(metavar="WxH", help="Pixels; 640x480, or a scene file's own.")
    ] = None,
    zoom: Annotated[float, typer.Option(help="1 frames the whole object, 10 is ten times closer.")] = 1.0,
    depth: Annotated[
        int | None,
        typer.Option("--max-depth", help="Longest light path, in segments; 8, or a scene file's own."),
    ] = None,
    exposure: Annotated[float, typer.Option(help="Stops; +1 is twice as bright.")] = 0.0,
    inset: Annotated[
        bool | None,
        typer.Option(
            "--inset/--no-inset",
            help="A close-up in the corner; by default of a weave or draft on the whole drape.",
        ),
    ] = None,
    seed: Annotated[int, typer.Option(help="The same seed gives the same picture, but for rounding.")] = 0,
    variant: Annotated[str | None, typer.Option(help="llvm_ad_rgb (default) or cuda_ad_rgb.")] = None,
) -> None:
    """Renders a fabric on a piece of cloth, a mesh, or the marked shapes of a scene file."""
    _require_model(model)
    check_output(output, (".png", ".exr"))
    pixels = None if size is None else parse_size(size)
    require_within("--spp", samples, 1, 1_000_000)
    shown = _shown(scene, mesh)
    towards_light = None if light_from is None else _direction(light_from)
    require_within("--exposure", exposure, -30, 30)
    require_within("--seed", seed, 0, 2**32 - 1)
    require_within("--max-depth", 8 if depth is None else depth, 1, 1000)
    require_within("--env-turn", environment_turn, -360, 360)
    require_within("--metres-per-unit", metres_per_unit, 1e-6, 1e6)
    from loomlight.core.images import write_image
    from loomlight.mitsuba import render_fabric

    what = f"{fabric}, {shown if mesh is None else mesh.name}"
    written = _Written(output)
    with progress(what, milliseconds=True) as report, written.restored_on_faults():
        picture = render_fabric(
            fabric,
            shown,
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
            inset=inset,
            variant=variant,
            progress=report,
            partial=written.refine,
        )
        write_image(output, picture)
    done(output)


def _require_model(name: str | None) -> None:
    if name is not None:
        from loomlight.models.registry import require_model_name

        require_model_name(name)


def _shown(scene: str | None, mesh: Path | None) -> str:
    if scene is not None and mesh is not None:
        raise InputError(f"--scene {scene} and --mesh {mesh} both say what to clothe: leave one of them out.")
    return DEFAULT_SCENE if scene is None else scene


def _direction(text: str) -> tuple[float, float]:
    azimuth, elevation = parse_numbers("--light-from", text, 2, "-40,35")
    return azimuth, elevation


class _Written:
    """The output file while it is refined: a whole picture at any time."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._before: bytes | None = None
        self._last: float | None = None

    def refine(self, picture: NDArray[np.float32]) -> None:
        """Replaces the file by a better picture, unless the last one is too recent."""
        from loomlight.core.images import write_image

        now = time.monotonic()
        if self._last is None:
            self._before = self._path.read_bytes() if self._path.is_file() else None
        elif now - self._last < _WRITE_EVERY:
            return
        write_image(self._path, picture)
        note_left(f"{self._path} holds the picture as far as it came.")
        self._last = now

    @contextmanager
    def restored_on_faults(self) -> Iterator[None]:
        """Leaves what was there before if the picture cannot be finished; an interruption keeps it."""
        try:
            yield
        except Exception as error:  # Whatever went wrong; it goes on.
            if was_interrupted(error):
                raise
            if self._last is not None and self._before is None:
                self._path.unlink(missing_ok=True)
            elif self._before is not None:
                with replacing(self._path) as temporary:
                    temporary.write_bytes(self._before)
            raise
