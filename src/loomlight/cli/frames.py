"""`render` of moving cloth: numbered pictures or one animation, which go on where they stopped."""

from __future__ import annotations

import dataclasses
import hashlib
import json
import os
import shutil
import sys
import time
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from loomlight import __version__
from loomlight.cli.terminal import done, note_left, progress
from loomlight.core.errors import InputError, LoomlightError, LoomlightWarning
from loomlight.core.files import ANIMATION_SUFFIXES
from loomlight.core.outputs import files_of
from loomlight.core.picture_record import PictureRecord
from loomlight.core.picture_settings import RenderSettings

if TYPE_CHECKING:
    from loomlight.mesh.moving import Frame


@dataclass(frozen=True)
class Frames:
    """Frames of a mesh that moves: all, and those that are to be rendered."""

    frames: Sequence[Frame]
    chosen: Sequence[Frame]

    def numbers(self) -> list[str]:
        """Numbers of those that are to be rendered, of as many digits each."""
        digits = max(4, len(str(self.frames[-1].number)))
        return [f"{frame.number:0{digits}}" for frame in self.chosen]

    def paths(self, output: Path) -> list[Path]:
        """The files of an output: a picture numbered as each frame is, or an animation."""
        if is_animation(output):
            return [output]
        return [output.with_stem(f"{output.stem}-{number}") for number in self.numbers()]


def frames_of(
    mesh: str | os.PathLike[str] | None,
    chosen: str | None,
    turns: int | None,
    fabrics: Sequence[str],
    output: str,
) -> Frames | None:
    """The frames that a command line names; None where nothing moves.

    Args:
        mesh, chosen, turns, output: of `--mesh`, `--frames`, `--turntable` and `--output`.
        fabrics: of the command line, among which shells put the meshes of a pattern.

    Raises:
        InputError: no such frames, or options that do not go together.
    """
    if mesh is None:
        if chosen is not None:
            raise InputError(f"--frames {chosen} needs a mesh that moves, such as --mesh 'frames/*.obj'.")
        return None  # what follows takes numpy, for which help must not wait
    from loomlight.mesh.moving import chosen_frames, find_frames
    from loomlight.mesh.reading import is_mesh, is_pattern

    if other := next(filter(is_mesh, fabrics), None):
        raise InputError(
            f"{other} is a mesh and no fabric: put a pattern of meshes in quotes, as in --mesh "
            f"'{Path(other).with_name('*')}{Path(other).suffix}', so that the shell hands it on."
        )
    if chosen is None and not is_pattern(mesh):
        count = 0 if turns is not None else _count_in_file(mesh)
        if count == 0:
            return None
        if not is_animation(Path(output)):
            _say(f"{mesh} is shown as it rests: --frames : renders its {count} frames.")
            return None
    if turns is not None:
        raise InputError(
            f"--turntable {turns} turns a cloth that stands still, and that of {mesh} moves: leave one of "
            "the two out."
        )
    frames = find_frames(mesh)
    return Frames(frames, chosen_frames(frames, chosen, mesh, "--frames"))


def _count_in_file(mesh: str | os.PathLike[str]) -> int:
    """Frames of a file of several, 0 of another one or of one that cannot be read, which is said later."""
    from loomlight.mesh.reading import frame_times, is_mesh

    try:
        return len(frame_times(mesh)) if is_mesh(mesh) else 0
    except LoomlightError:
        return 0


def is_animation(output: Path) -> bool:
    """Whether an output is one file of several pictures."""
    return output.suffix.lower() in ANIMATION_SUFFIXES


def _parts(animation: Path) -> Path:
    """Where frames of an animation are kept until it is whole."""
    return animation.with_name(f".loomlight-{animation.name}.parts")


def write_frames(
    what: str,
    fabric: str,
    output: Path,
    moving: Frames,
    settings: RenderSettings,
    frames_per_second: float | None,
) -> None:
    """Writes the pictures of frames, but for those that this command has made before.

    Args:
        what: is rendered, for the terminal.
        output: see `Frames.paths`.
        frames_per_second: of an animation; by default as its file has it, else 24.
    """
    import numpy as np

    from loomlight.core.images import read_picture, write_animation, write_picture
    from loomlight.mesh.moving import frames_per_second as own_rate
    from loomlight.mitsuba.moving import MovingCloth

    animated, frames, chosen = is_animation(output), moving.frames, moving.chosen
    paths = moving.paths(output)
    if animated:
        paths = [_parts(output) / f"{number}.png" for number in moving.numbers()]
    rate = frames_per_second or own_rate(frames) or 24.0
    # 1. All that pictures are made of, and which of them are there.
    with progress(f"{what}: reading {len(frames)} frames") as report:
        cloth = MovingCloth(fabric, frames, settings, report)
    values = {**dataclasses.asdict(settings), "fabric": fabric, "mesh": None, "save_mesh": None}
    common = _hash([__version__, *_facts(values)])
    made_of = [_hash([common, cloth.hash_of(frame)]) for frame in chosen]
    record = PictureRecord(output.with_name(f".loomlight-{output.name}.frames"))
    whole_hash = _hash([*made_of, rate])
    if animated and record.holds(output, whole_hash):
        _say(f"{output} is whole and made by this command: nothing is rendered.")
        return
    left = [
        (frame, path, of)
        for frame, path, of in zip(chosen, paths, made_of, strict=True)
        if not record.holds(path, of)
    ]
    if animated:
        _parts(output).mkdir(exist_ok=True)
    _say_what_is_there(output, paths, [path for _, path, _ in left])
    # 2. What is left, one after the other.
    begun = time.monotonic()
    with progress(what, unit="frame") as report:
        for count, (frame, path, of) in enumerate(left):
            note_left(_left(output, len(chosen) - len(left) + count, len(chosen)))
            write_picture(path, cloth.picture(frame))
            record.add(path, of)
            if not animated:
                done(path)
            report(count + 1, len(left))
    if animated:
        pictures = [np.rint(255 * read_picture(path)).astype(np.uint8) for path in paths]
        write_animation(output, pictures, len(pictures) / rate)
        record.add(output, whole_hash)
        done(output)
        shutil.rmtree(_parts(output), ignore_errors=True)
    if left:
        _say(f"{len(left)} frames, {(time.monotonic() - begun) / len(left):.2g} s each.")


def _say_what_is_there(output: Path, paths: Sequence[Path], left: Sequence[Path]) -> None:
    """Says which pictures stay, and warns of others that are there."""
    if len(left) < len(paths):
        _say(f"{len(paths) - len(left)} of {len(paths)} frames of {output} are made already and stay.")
    other = [path for path in left if path.exists()]
    if other:
        and_others = f", as are {len(other) - 1} others" if len(other) > 1 else ""
        warnings.warn(
            f"{other[0]} is there, but was not made by this command of this cloth: it is rendered anew"
            f"{and_others}.",
            LoomlightWarning,
            stacklevel=3,
        )


def _left(output: Path, count: int, total: int) -> str:
    return f"{count} of {total} frames of {output} are whole: the same command goes on from there."


def _say(sentence: str) -> None:
    print(f"loomlight: {sentence}", file=sys.stderr)


def _facts(values: Mapping[str, object]) -> Iterator[object]:
    """Settings, and hashes of what the files that they name hold."""
    yield values
    for word in _words(values):
        for file in files_of(word):
            yield hashlib.sha256(file.read_bytes()).hexdigest()


def _words(value: object) -> Iterator[str]:
    if isinstance(value, str | os.PathLike):
        yield os.fspath(value)
    elif isinstance(value, Mapping):
        for part in value.values():
            yield from _words(part)
    elif isinstance(value, Iterable):
        for part in value:
            yield from _words(part)


def _hash(facts: object) -> str:
    return hashlib.sha256(json.dumps(facts, sort_keys=True, default=str).encode()).hexdigest()
