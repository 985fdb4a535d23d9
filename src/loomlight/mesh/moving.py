"""Moving cloth: the frames of a mesh, in a file each or in one, of one topology.

The triangles, uv and parts of all frames are those of the first one; of the others positions alone are read.
"""

from __future__ import annotations

import glob
import os
import re
import warnings
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mesh.cloth_mesh import BETWEEN, INDEX, MAX_COORDINATE, ClothMesh
from loomlight.mesh.reading import SUFFIXES, frame_times, is_mesh, is_pattern, read_rows, read_triangles

Floats = NDArray[np.float64]

_DIGITS = re.compile(r"\d+")
_RANGE = re.compile(r"\s*(\d*)\s*(?::\s*(\d*)\s*)?(?::\s*(\d*)\s*)?")
# Directions in which the outermost vertices of each frame are kept: others stand out by 1 % of the radius.
_DIRECTIONS = 400
# Numbers that are computed at a time.
_AT_ONCE = 2**22
# Of the triangles of a frame that the first one has too, at least: polygons may be cut in other ways.
_SAME = 0.5


@dataclass(frozen=True)
class Frame:
    """A frame of moving cloth.

    Attributes:
        number: as the names of files have it, or counted from 1 in a file of several.
        path: its file.
        time: seconds from the start of a file of several frames.
    """

    number: int
    path: Path
    time: float | None = None

    def __str__(self) -> str:
        return f"{self.path}" if self.time is None else f"{self.path} at {self.time:.4g} s"


def find_frames(mesh: str | os.PathLike[str]) -> list[Frame]:
    """The frames of a file that moves, or of a pattern such as "frames/*.obj".

    Files are in the order of the number in which their names differ. A warning says so where one is missing.

    Raises:
        InputError: no mesh files, several formats, names without numbers of their own, or a file whose meshes
            do not move; and what `read_parts` raises.
        MissingDependencyError: as `read_parts` raises it.
    """
    if is_pattern(mesh):
        return _frames_of_files(mesh)
    path = Path(mesh)
    times = frame_times(path)
    if not times:
        raise InputError(
            f"{path} does not move: give a file of several frames, or a pattern such as 'frames/*.obj'."
        )
    return [Frame(number, path, time) for number, time in enumerate(times, 1)]


def frames_per_second(frames: Sequence[Frame]) -> float | None:
    """The rate of frames in one file; None where none is known."""
    times = [frame.time for frame in frames[:2] if frame.time is not None]
    return 1 / (times[1] - times[0]) if len(times) > 1 else None


def _frames_of_files(pattern: str | os.PathLike[str]) -> list[Frame]:
    found = sorted(Path(name) for name in glob.glob(os.fspath(pattern), recursive=True))
    paths = [path for path in found if is_mesh(path) and path.is_file()]
    if not paths:
        what = f"{len(found)} files, none of them a mesh" if found else "no file"
        raise InputError(f"{pattern} matches {what}: frames are read from {', '.join(SUFFIXES)} files.")
    for path in paths:
        if path.suffix.lower() != paths[0].suffix.lower():
            raise InputError(
                f"{pattern} matches {paths[0]} and {path}, which are of two formats: write the suffix, "
                f"such as *{paths[0].suffix}."
            )
    frames = [Frame(number, path) for number, path in zip(_numbers(paths, pattern), paths, strict=True)]
    frames.sort(key=lambda frame: frame.number)
    _warn_of_gaps(frames, pattern)
    return frames


def _numbers(paths: Sequence[Path], pattern: str | os.PathLike[str]) -> list[int]:
    """The last number of each path, of those in which the paths differ."""
    if len(paths) == 1:
        digits = _DIGITS.findall(paths[0].stem)
        return [int(digits[-1]) if digits else 1]
    found = [[int(each) for each in _DIGITS.findall(str(path.with_suffix("")))] for path in paths]
    usual = Counter(map(len, found)).most_common(1)[0][0]
    for path, numbers in zip(paths, found, strict=True):
        if len(numbers) != usual or not numbers:
            other = next(each for each, own in zip(paths, found, strict=True) if len(own) == usual)
            raise InputError(
                f"{pattern} matches {path}, whose name has no number of a frame as that of {other} has."
            )
    places = [place for place in range(1, usual + 1) if len({own[-place] for own in found}) > 1]
    last = [own[-places[0] if places else -1] for own in found]
    for place in places:
        column = [own[-place] for own in found]
        if len(set(column)) == len(column):
            return column
    double = next(number for number in last if last.count(number) > 1)
    same = [path for path, number in zip(paths, last, strict=True) if number == double]
    raise InputError(
        f"{pattern} matches {same[0]} and {same[1]}, which are both frame {double}: narrow the pattern."
    )


def _warn_of_gaps(frames: Sequence[Frame], pattern: str | os.PathLike[str]) -> None:
    steps = np.diff([frame.number for frame in frames])
    if len(steps) == 0 or (steps == steps.min()).all():
        return
    at = int(np.argmax(steps > steps.min()))
    missing = frames[at].number + int(steps.min())
    warnings.warn(
        f"{pattern} has no frame {missing} between {frames[at].number} and {frames[at + 1].number}.",
        LoomlightWarning,
        stacklevel=4,
    )


def chosen_frames(
    frames: Sequence[Frame], chosen: int | str | Iterable[int] | None, of: object, option: str = "frames"
) -> list[Frame]:
    """Some of the frames, in their order.

    Args:
        chosen: a number; "A:B" or "A:B:STEP", from A to B, both included, of which either may be left out;
            or numbers; None for all.
        of: whose frames they are, for messages.
        option: the name of `chosen`, for messages.

    Raises:
        InputError: no such frame, or a text that says no range.
    """
    numbers = [frame.number for frame in frames]
    there = f"{of} has frames {numbers[0]} to {numbers[-1]}" if len(numbers) > 1 else f"{of} has one frame"
    wanted = numbers if chosen is None else _wanted(chosen, numbers, there, option)
    known = set(numbers)
    for number in wanted:
        if number not in known:
            raise InputError(f"{option} {_text(chosen)}: {there}, and {number} is none of them.")
    kept = set(wanted)
    return [frame for frame in frames if frame.number in kept]


def _wanted(
    chosen: int | str | Iterable[int], numbers: Sequence[int], there: str, option: str
) -> Sequence[int]:
    if not isinstance(chosen, str):
        return [chosen] if isinstance(chosen, int) else [int(number) for number in chosen]
    match = _RANGE.fullmatch(chosen)
    if match is None or not chosen.strip():
        raise InputError(f'{option} "{chosen[:40]}" says no frames: write A:B, A:B:STEP or a number.')
    if ":" not in chosen:
        return [int(match[1])]
    first, last, step = (int(word) if word else None for word in match.groups())
    first, last = numbers[0] if first is None else first, numbers[-1] if last is None else last
    if first < numbers[0] or last > numbers[-1] or first > last or step == 0:
        raise InputError(f"{option} {chosen} is out of range: {there}; write A:B or A:B:STEP, from A on.")
    wanted = [number for number in numbers if first <= number <= last]
    return wanted if step is None else [number for number in wanted if (number - first) % step == 0]


def _text(chosen: object) -> str:
    return f"{chosen}"[:40]


class MovingMesh:
    """The positions of a mesh's vertices in all of its frames.

    Attributes:
        frames: all of them.
        first: the one that has the triangles, uv and parts of all.
    """

    def __init__(self, frames: Sequence[Frame], metres_per_unit: float = 1.0) -> None:
        """Reads the first frame.

        Args:
            frames: in their order.
            metres_per_unit: the length of one unit of the files' positions.

        Raises:
            InputError: what `read_parts` raises.
        """
        self.frames = list(frames)
        self.first = self.frames[0]
        self._metres_per_unit = metres_per_unit
        rows, self._faces = read_rows(self.first.path, self.first.time)
        self._count = len(rows)
        self._triangles = read_triangles(self.first.path, self.first.time)
        self._used = np.unique(self._triangles)

    def rows(self, frame: Frame) -> Floats:
        """Positions of all rows of a frame's file [n, 3], metres.

        Raises:
            InputError: a damaged file, or other vertices or triangles than the first frame's.
        """
        rows, faces = read_rows(frame.path, frame.time)
        if len(rows) != self._count or faces != self._faces:
            self._require_same(frame, len(rows))
        if not (np.abs(rows[self._used]) < MAX_COORDINATE).all():
            raise InputError(f"{frame} is damaged: a vertex position is not finite, or beyond ±1e15.")
        return rows * self._metres_per_unit

    def _require_same(self, frame: Frame, count: int) -> None:
        triangles = read_triangles(frame.path, frame.time)
        own, first = (
            f"{vertices} vertices and {len(faces)} triangles"
            for vertices, faces in ((count, triangles), (self._count, self._triangles))
        )
        advice = "frames are one mesh that moves, with the same vertices and faces in the same order."
        if own != first:
            raise InputError(f"{frame} has {own}, and the first frame, {self.first}, {first}: {advice}")
        if np.isin(_keys(triangles, count), _keys(self._triangles, count)).mean() < _SAME:
            raise InputError(
                f"{frame} has as many vertices and triangles as the first frame, {self.first} "
                f"({first}), but other ones: {advice}"
            )


def moved(cloth: ClothMesh, rows: Floats) -> ClothMesh:
    """A cloth of the first frame where the rows of another one have its vertices; normals stay."""
    positions = rows[cloth.attributes[INDEX][:, 0].astype(np.int64)]
    between = cloth.attributes.get(BETWEEN)
    if between is not None:
        new = np.isfinite(between[:, 0])
        three, shares = between[new, :3].astype(np.int64), between[new, 3:]
        positions[new] = np.einsum("nk,nkj->nj", shares, rows[three])
    return replace(cloth, positions=positions)


def _keys(triangles: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    """A number for each triangle, whichever corner it begins with."""
    low, middle, high = np.sort(triangles, axis=1).T
    return (low * count + middle) * count + high


def extremes(points: Floats) -> Floats:
    """The outermost of points [n, 3], in directions all around, the axes among them."""
    number = np.arange(_DIRECTIONS) + 0.5
    height, angle = 1 - 2 * number / _DIRECTIONS, np.pi * (1 + 5**0.5) * number
    ring = np.sqrt(1 - height**2)
    around = np.stack([ring * np.cos(angle), ring * np.sin(angle), height], axis=1)
    directions = np.concatenate([around, np.eye(3), -np.eye(3)])
    found = []
    # Of single precision and along memory: a hundred thousand points take a tenth of a second.
    rows = points.T.astype(np.float32)
    for part in np.array_split(directions, -(-len(directions) * len(points) // _AT_ONCE)):
        found.append((part.astype(np.float32) @ rows).argmax(axis=1))
    return points[np.unique(np.concatenate(found))]
