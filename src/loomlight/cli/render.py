"""`loomlight render`: a picture of a fabric."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from loomlight.cli import render_options as option
from loomlight.cli.interruption import note_left, was_interrupted
from loomlight.cli.outputs import check_output, done, require_not_read
from loomlight.cli.progress import progress
from loomlight.cli.turntable import ANIMATION_SUFFIXES, turn_paths, write_turn
from loomlight.cli.values import parse_named, parse_numbers, parse_size, require_within
from loomlight.core.errors import InputError
from loomlight.core.files import WRITTEN_SUFFIXES, replacing

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from loomlight.mitsuba import RenderSettings

EXAMPLE = "Example: loomlight render examples/denim.toml -o denim.png --scene drape --size 960x720 --spp 64"
DEFAULT_SCENE = "drape"
# Seconds between refined pictures: writing one takes a tenth of a second.
_WRITE_EVERY = 2.0


def render(
    fabrics: option.FabricsArgument,
    output: option.OutputOption,
    model: option.ModelOption = None,
    scene: option.SceneOption = None,
    mesh: option.MeshOption = None,
    metres_per_unit: option.MetresPerUnitOption = 1.0,
    environment: option.EnvironmentOption = None,
    environment_turn: option.EnvironmentTurnOption = 0.0,
    light: option.LightOption = None,
    light_from: option.LightFromOption = None,
    samples: option.SamplesOption = 8,
    size: option.SizeOption = None,
    zoom: option.ZoomOption = 1.0,
    depth: option.DepthOption = None,
    exposure: option.ExposureOption = 0.0,
    white_balance: option.WhiteBalanceOption = None,
    denoise: option.DenoiseOption = "auto",
    inset: option.InsetOption = None,
    color: option.ColorOption = None,
    cloth: option.ClothOption = None,
    turn: option.TurnOption = 0.0,
    shift: option.ShiftOption = "0,0",
    scale: option.ScaleOption = 1.0,
    edge: option.EdgeOption = None,
    turntable: option.TurntableOption = None,
    seed: option.SeedOption = 0,
    variant: option.VariantOption = None,
) -> None:
    """Renders fabrics, each on a piece of cloth, a mesh, or the marked shapes of a scene file."""
    _require_model(model)
    if turntable is not None:
        require_within("--turntable", turntable, 2, 1000)
    outputs = _outputs(fabrics, output, turntable)
    pixels = None if size is None else parse_size(size)
    require_within("--spp", samples, 1, 1_000_000)
    shown = _shown(scene, mesh)
    towards_light = None if light_from is None else _direction(light_from)
    require_within("--exposure", exposure, -30, 30)
    require_within("--white-balance", 6500 if white_balance is None else white_balance, 1667, 25000)
    require_within("--seed", seed, 0, 2**32 - 1)
    require_within("--max-depth", 8 if depth is None else depth, 1, 1000)
    require_within("--env-turn", environment_turn, -360, 360)
    require_within("--metres-per-unit", metres_per_unit, 1e-6, 1e6)
    require_within("--turn", turn, -360, 360)
    require_within("--scale", scale, 1e-4, 1e4)
    across, up = parse_numbers("--shift", shift, 2, "5,-2.5")
    colors = _colors(color)
    cloths = parse_named("--cloth", cloth or [], "lining=satin")
    further = [name for names in cloths.values() for name in names]
    require_not_read(_written(outputs, turntable), [*fabrics, scene, mesh, environment, *further])
    from loomlight.mitsuba import RenderSettings
    from loomlight.mitsuba.meshes import Placement

    settings = RenderSettings(
        model=model,
        size=pixels,
        spp=samples,
        zoom=zoom,
        mesh=mesh,
        metres_per_unit=metres_per_unit,
        environment=environment,
        environment_turn=environment_turn,
        light=light,
        light_from=towards_light,
        max_depth=depth,
        placement=Placement(turn, (across, up), scale),
        edge=edge,
        exposure=exposure,
        white_balance=white_balance,
        denoise=denoise,
        inset=inset if turntable is None else None,
        colors=colors,
        cloths={name: values[-1] for name, values in cloths.items()},
        seed=seed,
        variant=variant,
    )
    for fabric, path in zip(fabrics, outputs, strict=True):
        what = f"{fabric}, {shown if mesh is None else mesh.name}"
        if turntable is None:
            _write_picture(what, fabric, shown, path, settings)
        else:
            write_turn(what, fabric, shown, path, turntable, settings)


def _write_picture(what: str, fabric: str, shown: str, path: Path, settings: RenderSettings) -> None:
    from loomlight.core.images import write_image
    from loomlight.mitsuba import material_picture

    written = _Written(path)
    with progress(what, milliseconds=True) as report, written.restored_on_faults():
        picture = material_picture.render(fabric, shown, settings, progress=report, partial=written.refine)
        write_image(path, picture)
    done(path)


def _outputs(fabrics: list[str], output: str, turntable: int | None) -> list[Path]:
    """Where the picture of each fabric goes: `{name}` stands for the file's name without its suffix."""
    if "\0" in output:
        raise InputError(f"--output {output!r} is no path of a file that can be written.")
    if len(fabrics) > 1 and "{name}" not in output:
        raise InputError(
            f"{output} is one file for {len(fabrics)} pictures: write {{name}} where the fabric's name goes, "
            'such as "{name}.png".'
        )
    if other := next((word for word in re.findall(r"{\w*}", output) if word != "{name}"), None):
        raise InputError(f"--output {output}: {other} stands for nothing; {{name}} is the fabric's name.")
    suffixes = WRITTEN_SUFFIXES if turntable is None else (*WRITTEN_SUFFIXES, *ANIMATION_SUFFIXES)
    paths = [Path(output.replace("{name}", _file_name(fabric))) for fabric in fabrics]
    for path, fabric in zip(paths, fabrics, strict=True):
        check_output(path, suffixes)
        if paths.count(path) > 1:
            raise InputError(f"{path} would be the picture of {fabric} and of another fabric: rename one.")
    for path in _written(paths, turntable):
        check_output(path, suffixes)
    return paths


def _written(outputs: list[Path], turntable: int | None) -> list[Path]:
    """The files of all pictures: numbered ones of each output if it is a turn."""
    if turntable is None:
        return outputs
    return [picture for path in outputs for picture in turn_paths(path, turntable)]


def _file_name(fabric: str) -> str:
    """A file's name without its suffix, or a weave's name without what paths are made of."""
    return Path(fabric).stem if Path(fabric).suffix else re.sub(r"[^\w ,.'-]", "-", fabric)


def _colors(texts: list[str] | None) -> dict[str, Any]:
    # A comma before a part without a name goes on with the order of threads before it.
    parts = [part for text in texts or [] for part in re.split(r",(?=[^,=]*=)", text)]
    found: dict[str, list[str]] = {}
    for part in parts:
        family, _, colours = part.partition("=")
        if not family.strip() or not colours.strip():
            raise InputError(
                f'--color "{part}" is not understood: write NAME=VALUE, such as warp=#223355, or an order '
                'of threads, such as "warp=20 #223355, 4 #eeeeee".'
            )
        found.setdefault(family.strip(), []).append(colours.strip())
    return {family: values[0] if len(values) == 1 else values for family, values in found.items()}


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
