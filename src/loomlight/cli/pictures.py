"""The commands that render pictures by Mitsuba: `render`, with `--turntable`, `swatches` and `demo`."""

from __future__ import annotations

import os
import re
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from loomlight.cli.frames import frames_of, is_animation, write_frames
from loomlight.cli.options import (
    ExecutorName,
    FabricsArgument,
    Given,
    SlurmSettings,
    Workers,
    executor_of,
    require_within,
    takes,
)
from loomlight.cli.terminal import done, note_left, progress, was_interrupted
from loomlight.core.errors import InputError
from loomlight.core.files import ANIMATION_SUFFIXES, WRITTEN_SUFFIXES, replacing
from loomlight.core.outputs import check_output, require_not_read
from loomlight.core.picture_settings import RenderSettings, SwatchSettings, Worn

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

RENDER_EXAMPLE = (
    "Example: loomlight render examples/denim.toml -o denim.png --scene drape --size 960x720 --spp 64"
)
# Of one turn of an animation, seconds.
_TURN_SECONDS = 6.0
# Seconds between refined pictures: writing one takes a tenth of a second.
_WRITE_EVERY = 2.0


@takes(RenderSettings)
def render(
    fabrics: FabricsArgument,
    output: Annotated[
        str,
        typer.Option(
            "--output",
            "-o",
            metavar="PATH",
            help="A picture: .png or .jpg (sRGB), or .exr (linear); of several fabrics with {name} in it.",
        ),
    ],
    given: Given,
    turns: Annotated[
        int | None,
        typer.Option(
            "--turntable",
            metavar="N",
            help="N pictures of one turn: .png, .jpg, .exr, numbered, or one .webp or .gif; off by default.",
        ),
    ] = None,
    frames: Annotated[
        str | None,
        typer.Option(
            "--frames",
            metavar="A:B",
            help="Frames of a mesh that moves: from A to B, A:B:STEP, one number, or : for all, as of files "
            "--mesh 'frames/*.obj'. Pictures are numbered as frames are, or one .webp or .gif.",
        ),
    ] = None,
    frames_per_second: Annotated[
        float | None,
        typer.Option(
            "--fps",
            metavar="N",
            help="Frames a second of one .webp or .gif; by default the mesh file's, or 24.",
        ),
    ] = None,
) -> None:
    """Renders fabrics, each on a piece of cloth, a mesh, or the marked shapes of a scene file."""
    if turns is not None:
        require_within("--turntable", turns, 2, 1000)
    if frames_per_second is not None:
        require_within("--fps", frames_per_second, 1, 240)
    moving = frames_of(given.get("mesh"), frames, turns, fabrics, output)
    numbered: Callable[[Path], list[Path]] | None = None
    if moving is not None:
        numbered = moving.paths
    elif turns is not None:
        numbered = partial(turn_paths, count=turns)
    outputs = _outputs(fabrics, output, numbered)
    if "scene" in given and "mesh" in given:
        raise InputError(
            f"--scene {given['scene']} and --mesh {given['mesh']} both say what to clothe: leave one of them "
            "out."
        )
    settings = RenderSettings(**given)
    if settings.aov is not None:
        _require_layers_fit(settings.aov, outputs)
    cloths = [cloth.fabric if isinstance(cloth, Worn) else cloth for cloth in settings.cloths.values()]
    read = [*fabrics, settings.scene, settings.mesh, settings.environment, *cloths]
    read += [] if moving is None else {frame.path for frame in moving.frames}
    require_not_read(_written(outputs, numbered), read)
    if settings.save_mesh is not None:
        _check_save_mesh(settings, read)
    for fabric, path in zip(fabrics, outputs, strict=True):
        what = f"{fabric}, {settings.scene if settings.mesh is None else Path(settings.mesh).name}"
        if moving is not None:
            write_frames(what, fabric, path, moving, settings, frames_per_second)
        elif turns is not None:
            write_turn(what, fabric, path, turns, settings.changed(inset=None))
        else:
            _write_picture(what, fabric, path, settings)


def _require_layers_fit(aov: str, outputs: list[Path]) -> None:
    """Raises InputError unless outputs are files that hold layers."""
    for path in outputs:
        if path.suffix.lower() != ".exr":
            raise InputError(f"--aov {aov} are layers of an .exr, and {path} is none: name the output .exr.")


def _check_save_mesh(settings: RenderSettings, read: list[str | os.PathLike[str] | None]) -> None:
    from loomlight.mesh.writing import WRITTEN_MESHES

    assert settings.save_mesh is not None
    if settings.mesh is None:
        raise InputError(f"--save-mesh {settings.save_mesh} writes the mesh of --mesh, and none is given.")
    check_output(Path(settings.save_mesh), WRITTEN_MESHES, read)


def _write_picture(what: str, fabric: str, path: Path, settings: RenderSettings) -> None:
    from loomlight.core.images import write_picture
    from loomlight.mitsuba import pictures

    written = _Written(path)
    with progress(what, milliseconds=True) as report, written.restored_on_faults():
        picture = pictures.render(fabric, settings=settings, progress=report, partial=written.refine)
        write_picture(path, picture)
    done(path)


def _outputs(fabrics: list[str], output: str, numbered: Callable[[Path], list[Path]] | None) -> list[Path]:
    """Where the picture of each fabric goes: `{name}` stands for the file's name without its suffix.

    Args:
        numbered: gives the files of an output that is several pictures.
    """
    if "\0" in output:
        raise InputError(f"--output {output!r} is no path of a file that can be written.")
    if len(fabrics) > 1 and "{name}" not in output:
        raise InputError(
            f"{output} is one file for {len(fabrics)} pictures: write {{name}} where the fabric's name goes, "
            'such as "{name}.png".'
        )
    if other := next((word for word in re.findall(r"{\w*}", output) if word != "{name}"), None):
        raise InputError(f"--output {output}: {other} stands for nothing; {{name}} is the fabric's name.")
    suffixes = WRITTEN_SUFFIXES if numbered is None else (*WRITTEN_SUFFIXES, *ANIMATION_SUFFIXES)
    paths = [Path(output.replace("{name}", _file_name(fabric))) for fabric in fabrics]
    for path, fabric in zip(paths, fabrics, strict=True):
        check_output(path, suffixes)
        if paths.count(path) > 1:
            raise InputError(f"{path} would be the picture of {fabric} and of another fabric: rename one.")
    for path in _written(paths, numbered):
        check_output(path, suffixes)
    return paths


def _written(outputs: list[Path], numbered: Callable[[Path], list[Path]] | None) -> list[Path]:
    """The files of all pictures."""
    return outputs if numbered is None else [picture for path in outputs for picture in numbered(path)]


def _file_name(fabric: str) -> str:
    """A file's name without its suffix, or a weave's name without what paths are made of."""
    return Path(fabric).stem if Path(fabric).suffix else re.sub(r"[^\w ,.'-]", "-", fabric)


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


# -------------------------------------------------------------------------------------------------- turntable


def turn_paths(path: Path, count: int) -> list[Path]:
    """The files of `count` pictures of one turn: `path` if it is an animation, else numbered from 000."""
    if is_animation(path):
        return [path]
    return [path.with_stem(f"{path.stem}-{number:03}") for number in range(count)]


def write_turn(what: str, fabric: str, path: Path, count: int, settings: RenderSettings) -> None:
    """Writes `count` pictures of one turn to `turn_paths`."""
    animated = is_animation(path)
    paths = turn_paths(path, count)
    from loomlight.core.images import encoded, write_animation, write_picture
    from loomlight.mitsuba.pictures import turntable

    frames = []
    with progress(what) as report:
        for number, picture in enumerate(turntable(fabric, count, settings=settings)):
            if animated:
                frames.append(encoded(picture))
            else:
                write_picture(paths[number], picture)
                done(paths[number])
            report(number + 1, count)
    if animated:
        write_animation(path, frames, _TURN_SECONDS)
        done(path)


# --------------------------------------------------------------------------------------------------- swatches

SWATCHES_EXAMPLE = "Example: loomlight swatches examples/*.toml -o sheet.png"


@takes(SwatchSettings)
def swatches(
    fabrics: FabricsArgument,
    output: Annotated[
        Path,
        typer.Option("--output", "-o", help="The sheet: a .png or .jpg picture, or an .html page."),
    ],
    given: Given,
    workers: Workers = 1,
    executor: ExecutorName = "local",
    slurm: SlurmSettings = None,
) -> None:
    """Renders a labelled contact sheet: of each fabric its drawdown, a swatch, a drape and facts.

    The sheet grows as fabrics are rendered. A file that cannot be used is left out with a warning.
    """
    settings, chosen = SwatchSettings(**given), executor_of(executor, workers, slurm)
    from loomlight.mitsuba.swatches import swatches, work_folder_of

    note_left(
        f"{work_folder_of(output)} keeps the fabrics that are rendered: the same command goes on from there."
    )
    with progress("swatches") as report:
        done(swatches(fabrics, output, settings, executor=chosen, report=report))


# ------------------------------------------------------------------------------------------------------- demo

DEMO_EXAMPLE = "Example: loomlight demo -o demo.png"


def demo(
    output: Annotated[Path, typer.Option("--output", "-o", help="The picture: .png, .jpg or .exr.")] = Path(
        "demo.png"
    ),
    samples: Annotated[int, typer.Option("--spp", min=1, max=4096, help="Samples a pixel.")] = 10,
) -> None:
    """Renders draped cloth in daylight, with a close-up in which its yarns can be counted."""
    check_output(output, WRITTEN_SUFFIXES)

    from loomlight.core.images import write_image
    from loomlight.fabric.read import load_fabric
    from loomlight.mitsuba.pictures import render

    cloth = load_fabric(Path(__file__).with_name("demo.toml"))
    with progress(f"{cloth.name}, draped", milliseconds=True) as report:
        # The point model shows how the dye varies, a high sun a shadow that stays in the picture.
        picture = render(
            cloth,
            model="point",
            light="sunsky",
            light_from=(-45, 41),
            size=(1080, 810),
            spp=samples,
            exposure=0.5,
            inset=True,
            progress=report,
        )
    write_image(output, picture)
    done(output)
