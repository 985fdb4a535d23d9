"""The point model as a multi-scale model: the yarn at the footprint's centre, whatever the size."""

from __future__ import annotations

from typing import Self, final

from loomlight.assets.loom_file import LoomFile
from loomlight.fabric.fabric import Fabric
from loomlight.models.sampled import SampledModel


@final
class PointFootprint(SampledModel):
    """One sample of the footprint, at its centre: exact there, aliased where threads are small."""

    name = "point"
    filters = False
    conserves_energy = True

    @classmethod
    def for_fabric(cls, fabric: Fabric) -> Self:
        """The model of a fabric; nothing is baked."""
        return cls(fabric)

    @property
    def points(self) -> int:
        """The centre alone."""
        return 1

    def to_loom(self) -> LoomFile:
        """The fabric."""
        return LoomFile(model=self.name, fabric=self.fabric)

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of the fabric.

        Raises:
            InputError: another model's file.
        """
        loom.require_model(cls.name)
        return cls(loom.fabric)
