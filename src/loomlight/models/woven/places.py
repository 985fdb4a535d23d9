"""Where a footprint lies in the repeat, as the decoder takes it; one function for numpy and for Dr.Jit."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.footprint import ANISOTROPIC_TAPS
from loomlight.models.woven.config import NetworkTable
from loomlight.models.woven.pyramid import size_share

# Smallest and largest footprint of "field", in threads; of "vector", in repeats, the smallest of at most
# `_LONGEST` threads. They are those of the query test.
_FIELD_SIZES = 1 / 64, 80.0
_REPEATS = 1 / 128, 5.0
# A fabric's own correction counts from the first size on, in threads, and wholly from the second.
_CORRECTED = 1.0, 4.0
_LONGEST = 8.0


@dataclass
class AnisotropicTaps:
    """Anisotropic taps of a footprint, in threads; see `Footprint.anisotropic_taps`.

    Attributes:
        x, y: the middle of the row.
        side: of a square.
        step_x, step_y: from one square to the next; 0 and 0 where the footprint is one square.
    """

    x: Any
    y: Any
    side: Any
    step_x: Any
    step_y: Any

    def numbers(self) -> tuple[Any, ...]:
        """All five."""
        return self.x, self.y, self.side, self.step_x, self.step_y

    def size(self, arrays: Any) -> Any:
        """The side of a square of the row's area, which the decoder is told.

        Args:
            arrays: the module of the arrays' functions, drjit or code that is being written.
        """
        step = arrays.fma(self.step_x, self.step_x, arrays.square(self.step_y))
        length = arrays.sqrt(arrays.fma(step, ANISOTROPIC_TAPS**2 - 1.0, arrays.square(self.side)))
        return arrays.sqrt(self.side * length)


def place_of(
    table: NetworkTable, picks: int, ends: int, x: Any, y: Any, size: Any, arrays: Any = np
) -> tuple[Any, Any, Any]:
    """Position x, y and size of footprints for the decoder, each 0 to 1.

    "field" counts positions within a thread, as the latent knows which one it is, "vector" within the repeat.

    Args:
        picks, ends: of the repeat.
        x, y, size: centre and side of footprints, in threads.
        arrays: the module of the arrays' functions, numpy or drjit.
    """
    size = arrays.maximum(size, 1e-6)
    if table.latent == "field":
        return x - arrays.floor(x), y - arrays.floor(y), size_share(size, *_FIELD_SIZES, arrays)
    repeat = math.sqrt(picks * ends)
    smallest, largest = min(repeat, _LONGEST) * _REPEATS[0], repeat * _REPEATS[1]
    u, v = x / ends, y / picks
    return u - arrays.floor(u), v - arrays.floor(v), size_share(size, smallest, largest, arrays)


def own_share(size: Any, arrays: Any = np) -> Any:
    """How much a fabric's own correction of the last layer counts, 0 to 1, for coded sizes of "field".

    Args:
        size: the last of what `place_of` gives.
    """
    first, full = (float(size_share(threads, *_FIELD_SIZES)) for threads in _CORRECTED)
    return arrays.clip((size - first) * (1 / (full - first)), 0, 1)


def network_places(
    table: NetworkTable, picks: int, ends: int, footprints: NDArray[np.float32]
) -> NDArray[np.float32]:
    """`place_of` of footprints [n, 3], position x and y and side, in threads."""
    return np.stack(place_of(table, picks, ends, *footprints.T), -1).astype(np.float32)
