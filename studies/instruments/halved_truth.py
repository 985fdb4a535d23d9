"""Errors without the truth's own noise."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class HalvedTruth:
    """A noisy truth in two independent halves, whose own noise no mean squared error contains.

    The mean of (p − a)(p − b) over pixels is the squared error of p against what a and b estimate, if p, a
    and b are independent: the noise of a and b is on average 0 in it.

    Attributes:
        halves: two pictures of linear RGB [height, width, 3].
    """

    halves: tuple[NDArray[np.float32], NDArray[np.float32]]

    @property
    def picture(self) -> NDArray[np.float32]:
        """The mean of both halves."""
        one, other = self.halves
        return ((one + other) * np.float32(0.5)).astype(np.float32)

    def squared_error(
        self, picture: NDArray[np.float32], counted: NDArray[np.bool_] | slice = slice(None)
    ) -> float:
        """Mean squared error of a picture; about 0 it may be negative.

        Args:
            counted: a mask [height, width]; all pixels by default.
        """
        one, other = (picture[counted].astype(np.float64) - half[counted] for half in self.halves)
        return float((one * other).mean())
