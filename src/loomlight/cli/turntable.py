"""`loomlight render --turntable`: pictures of one turn, numbered or as an animation."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from loomlight.cli.progress import done, progress

if TYPE_CHECKING:
    from loomlight.picture_settings import RenderSettings

ANIMATION_SUFFIXES = (".webp", ".gif")
# Of one turn of an animation.
_SECONDS = 6.0


def turn_paths(path: Path, count: int) -> list[Path]:
    """The files of `count` pictures of one turn: `path` if it is an animation, else numbered from 000."""
    if _is_animated(path):
        return [path]
    return [path.with_stem(f"{path.stem}-{number:03}") for number in range(count)]


def _is_animated(path: Path) -> bool:
    return path.suffix.lower() in ANIMATION_SUFFIXES


def write_turn(what: str, fabric: str, path: Path, count: int, settings: RenderSettings) -> None:
    """Writes `count` pictures of one turn to `turn_paths`."""
    animated = _is_animated(path)
    paths = turn_paths(path, count)
    from loomlight.core.images import encoded, write_animation, write_image
    from loomlight.mitsuba.turntable import turntable

    frames = []
    with progress(what) as report:
        for number, picture in enumerate(turntable(fabric, count, settings=settings)):
            if animated:
                frames.append(encoded(picture))
            else:
                write_image(paths[number], picture)
                done(paths[number])
            report(number + 1, count)
    if animated:
        write_animation(path, frames, _SECONDS)
        done(path)
