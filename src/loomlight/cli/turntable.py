"""`loomlight render --turntable`: pictures of one turn, numbered or as an animation."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from loomlight.cli.outputs import check_output, done
from loomlight.cli.progress import progress

ANIMATION_SUFFIXES = (".webp", ".gif")
# Of one turn of an animation.
_SECONDS = 6.0


def write_turn(what: str, fabric: str, scene: str, path: Path, count: int, **options: Any) -> None:
    """Writes `count` pictures of one turn: `path` itself if it is an animation, else numbered from 000.

    Args:
        options: of `turn_of_fabric`.
    """
    animated = path.suffix.lower() in ANIMATION_SUFFIXES
    paths = [path] if animated else [path.with_stem(f"{path.stem}-{number:03}") for number in range(count)]
    for each in paths:
        check_output(each, (path.suffix.lower(),))
    from loomlight.core.images import encoded, write_animation, write_image
    from loomlight.mitsuba.turntable import turn_of_fabric

    frames = []
    with progress(what) as report:
        for number, picture in enumerate(turn_of_fabric(fabric, scene, count, **options)):
            if animated:
                frames.append(encoded(picture))
            else:
                write_image(paths[number], picture)
                done(paths[number])
            report(number + 1, count)
    if animated:
        write_animation(path, frames, _SECONDS)
        done(path)
