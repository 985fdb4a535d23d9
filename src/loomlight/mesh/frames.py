"""Frames of animations in mesh files, whatever clock a file has."""

from __future__ import annotations

from pathlib import Path

from loomlight.core.errors import InputError

# An hour at 24 a second.
_MAX_FRAMES = 86_400


def times_of_frames(duration: float, per_second: float, file: Path) -> list[float]:
    """Seconds from the start of each frame within `duration` seconds, the first at 0.

    Raises:
        InputError: no duration or rate that makes frames, or too many.
    """
    if not (0 <= duration < 1e9 and 1e-3 <= per_second <= 1e6 and duration * per_second < _MAX_FRAMES):
        raise InputError(
            f"{file} has an animation of {duration:g} s and {per_second:g} frames a second: it should have "
            f"at most {_MAX_FRAMES} frames."
        )
    return [number / per_second for number in range(int(duration * per_second + 1e-3) + 1)]
