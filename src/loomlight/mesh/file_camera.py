"""Cameras that mesh files hold, of whichever format."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class FileCamera:
    """A camera as a file has it.

    Attributes:
        name: "" where the file gives none.
        to_world: rigid [4, 4], of a camera that looks along -z with y up; lengths as `read_parts` gives them.
        vertical: degrees that its picture's height shows.
        aspect: width over height of its picture; None where the file leaves it open.
        orthographic: its lines of sight are parallel, so that `vertical` says nothing.
    """

    name: str
    to_world: NDArray[np.float64]
    vertical: float
    aspect: float | None = None
    orthographic: bool = False


def rigid(matrix: NDArray[np.float64]) -> NDArray[np.float64]:
    """The turn and the place [4, 4] of a matrix that may scale, shear or mirror too."""
    left, _, right = np.linalg.svd(matrix[:3, :3])
    found = np.eye(4)
    found[:3, :3] = left @ np.diag([1, 1, np.sign(np.linalg.det(left @ right))]) @ right
    found[:3, 3] = matrix[:3, 3]
    return found
