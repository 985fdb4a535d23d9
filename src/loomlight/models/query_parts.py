"""Queries of a source in parts, each of which depends on a seed and its number alone and is kept on disk."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import Any, ClassVar, Generic, Self, TypeVar

import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError
from safetensors.numpy import load_file, save_file

from loomlight.core.files import replacing

# Queries of a part; a part is drawn, stored and counted as a whole.
PART = 1 << 16
# More grazing directions see crests alone.
MIN_COSINE = 0.02

# Called with (done, in all) of a whole training, in thousandths.
Progress = Callable[[int, int], None]


class QueryArrays:
    """A dataclass of arrays with a row a query, the size of its footprint among them."""

    __dataclass_fields__: ClassVar[dict[str, Any]]
    levels: NDArray[Any]

    def __len__(self) -> int:
        return len(self.levels)

    def __getitem__(self, chosen: NDArray[np.intp] | slice) -> Self:
        return type(self)(*(getattr(self, part.name)[chosen] for part in fields(self)))

    @classmethod
    def joined(cls, parts: list[Self]) -> Self:
        """All queries of some parts."""
        return cls(*(np.concatenate([getattr(p, field.name) for p in parts]) for field in fields(cls)))


QueriesT = TypeVar("QueriesT", bound=QueryArrays)


class FileStore(Generic[QueriesT]):
    """A safetensors file a part, which is renamed into place."""

    def __init__(self, kind: type[QueriesT], folder: Path, identity: str) -> None:
        """
        Args:
            identity: of what queries depend on.
        """
        self._kind, self._folder, self._name = kind, folder, f"queries-{identity[:12]}"

    def _file(self, number: int) -> Path:
        return self._folder / f"{self._name}-{number:05d}.safetensors"

    def read(self, number: int, size: int) -> QueriesT | None:
        """The part of a number and so many queries; None if it is not there or damaged."""
        try:
            part = self._kind(**load_file(self._file(number)))
        except (OSError, SafetensorError, TypeError):
            return None
        return part if len(part) == size else None

    def write(self, number: int, part: QueriesT) -> None:
        """Keeps a part.

        Raises:
            InputError: it cannot be written.
        """
        with replacing(self._file(number)) as temporary:
            save_file({field.name: getattr(part, field.name) for field in fields(part)}, temporary)


def stored_queries(
    draw: Callable[[int, int], QueriesT],
    store: FileStore[QueriesT],
    total: int,
    report: Callable[[int, int], None],
) -> QueriesT:
    """All queries of a training; parts that the store holds are read.

    Args:
        draw: the part of a number, and of a size.
        report: called with (parts done, parts in all).
    """
    sizes = [min(PART, total - first) for first in range(0, total, PART)]
    parts: list[QueriesT] = []
    for number, size in enumerate(sizes):
        part = store.read(number, size)
        if part is None:
            part = draw(number, size)
            store.write(number, part)
        parts.append(part)
        report(number + 1, len(sizes))
    return type(parts[0]).joined(parts)


def draw_directions(rng: np.random.Generator, count: int) -> NDArray[np.float32]:
    """Unit vectors [count, 3] with z > 0, half uniform in solid angle, half on the projected disk."""
    u, azimuth = rng.random(count), 2 * math.pi * rng.random(count)
    cosine = np.where(rng.random(count) < 0.5, u, np.sqrt(u))
    return from_cosine(MIN_COSINE + (1 - MIN_COSINE) * cosine, azimuth)


def from_cosine(cosine: NDArray[np.float64], azimuth: NDArray[np.float64]) -> NDArray[np.float32]:
    """Unit vectors [n, 3] of cosines with z and azimuths about it, radians."""
    sine = np.sqrt(np.maximum(1 - cosine**2, 0))
    return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=1).astype(np.float32)
