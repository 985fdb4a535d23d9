"""One family's scattering parameters on one backend."""

from __future__ import annotations

import drjit as dr
import numpy as np

from loomlight.core.arrays import Color3, UInt
from loomlight.core.backend import ArrayTypes, opaque
from loomlight.scattering.appearance import FamilyAppearance

ALBEDO_NAMES = ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit")


class FamilyParameters:
    """One family's scattering parameters on one backend: scalars where threads are alike, else a table."""

    def __init__(self, family: FamilyAppearance, types: ArrayTypes) -> None:
        rows = np.stack([np.asarray(getattr(family, name), np.float64) for name in ALBEDO_NAMES], axis=1)
        self.roughness = dr.opaque(types.Float, float(family.roughness))
        self.threads = rows.shape[0]
        self._mean = [types.Color3(*row) for row in opaque(types.Float, rows.mean(axis=0))]
        self.alike = bool(np.allclose(rows, rows[:1], rtol=0, atol=1e-12))
        self.shared = [types.Color3(*row) for row in opaque(types.Float, rows[0])]
        padded = np.zeros((self.threads, 4, 4))
        padded[:, :, :3] = rows
        self.table = None if self.alike else types.Float(padded.ravel())
        self._types = types

    def albedo(self, number: int, thread: UInt) -> Color3:
        """Albedo `number` (in the order of `ALBEDO_NAMES`) of a thread, Color3."""
        if self.table is None:
            return self.shared[number]
        row = dr.gather(self._types.Vector4, self.table, thread * 4 + number)
        return self._types.Color3(row.x, row.y, row.z)

    def follow_table(self) -> None:
        """Takes the means of the table anew, after an edit of it."""
        if self.table is not None:
            rows = self.table.numpy().reshape(self.threads, 4, 4)[:, :, :3].astype(np.float64).mean(axis=0)
            self._mean = [self._types.Color3(*row) for row in opaque(self._types.Float, rows)]

    def mean(self) -> list[Color3]:
        """Mean albedos over the threads, in the order of `ALBEDO_NAMES`."""
        return self.shared if self.table is None else self._mean
