"""Placement of cloth on a mesh: turn, shift and scale."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.mesh.cloth_mesh import ClothMesh, uv_size

_MAX_SCALE = 1e4
# Single precision tells a tenth of a millimetre there.
_MAX_SHIFT_MM = 1e6


@dataclass(frozen=True)
class Placement:
    """Where the weave lies on a mesh, beside what its uv say.

    Attributes:
        turn: degrees, counter-clockwise as the front is seen, about the middle of the uv.
        shift: millimetres to the right and up, as the uv run.
        scale: 2 shows threads twice as large; above 0.
    """

    turn: float = 0.0
    shift: tuple[float, float] = (0.0, 0.0)
    scale: float = 1.0

    def __post_init__(self) -> None:
        """Raises InputError unless `turn` is finite, `shift` within a kilometre, `scale` 1/10000 to 10000."""
        if not np.isfinite([self.turn, *self.shift]).all():
            raise InputError(f"turn = {self.turn:g} and shift = {self.shift} have to be finite numbers.")
        if max(map(abs, self.shift)) > _MAX_SHIFT_MM:
            raise InputError(f"shift = {self.shift} is out of range: at most {_MAX_SHIFT_MM:g} mm each way.")
        if not 1 / _MAX_SCALE <= self.scale <= _MAX_SCALE:
            raise InputError(f"scale = {self.scale:g} is out of range: 1 is life-size, 2 twice as large.")


def placed(mesh: ClothMesh, placement: Placement) -> tuple[ClothMesh, tuple[float, float]]:
    """A mesh with uv for cloth so placed, and its millimetres per unit of u and of v.

    Where they are as life has them nothing changes; otherwise uv become millimetres.
    """
    size = uv_size(mesh)
    if placement == Placement():
        return mesh, size
    upright = ~_mirrored(mesh)
    # Draft coordinates, as cloth_uv.draft_position has them: v is counted from its other end where mirrored.
    x, y = mesh.uv[:, 0] * size[0], np.where(upright, mesh.uv[:, 1], 1 - mesh.uv[:, 1]) * size[1]
    middle = np.array([(values.min() + values.max()) / 2 for values in (x, y)])
    angle = np.radians(placement.turn)
    # The weave turns with the angle, so the place where a point of the surface finds it turns against it.
    against = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    moved = (np.stack([x, y], axis=1) - middle - placement.shift) @ against.T / placement.scale + middle
    v = np.where(upright, moved[:, 1], 1 - moved[:, 1])
    return replace(mesh, uv=np.stack([moved[:, 0], v], axis=1)), (1.0, 1.0)


def _mirrored(mesh: ClothMesh) -> NDArray[np.bool_]:
    """Vertices of triangles whose uv run clockwise, as seen from the front."""
    a, b, c = (mesh.uv[mesh.triangles[:, corner]] for corner in range(3))
    (u1, v1), (u2, v2) = (b - a).T, (c - a).T
    turning = np.zeros(len(mesh.uv))
    for corner in range(3):
        np.add.at(turning, mesh.triangles[:, corner], u1 * v2 - u2 * v1)
    return turning < 0
