"""The mean of the point model over many points of the footprint: slow, and right in the limit."""

from __future__ import annotations

from typing import Self, final

from loomlight.assets.loom_file import LoomFile
from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.models.sampled import SampledModel

DEFAULT_POINTS = 32
MAXIMUM_POINTS = 1 << 16


@final
class FootprintSamples(SampledModel):
    """So many points, spread evenly over the footprint in a pattern that is the same for all."""

    name = "samples"
    filters = True
    conserves_energy = True

    def __init__(self, fabric: Fabric, points: int = DEFAULT_POINTS) -> None:
        """A model of `points` points, 1 to 65536.

        Raises:
            InputError: fewer or more points.
        """
        super().__init__(fabric)
        if not 1 <= points <= MAXIMUM_POINTS:
            raise InputError(f"points = {points} is out of range: use 1 to {MAXIMUM_POINTS}.")
        self._points = points

    @classmethod
    def for_fabric(cls, fabric: Fabric) -> Self:
        """The model of a fabric with 32 points; nothing is baked."""
        return cls(fabric)

    @property
    def points(self) -> int:
        """How many points of a footprint are looked at."""
        return self._points

    def to_loom(self) -> LoomFile:
        """The fabric and the number of points."""
        return LoomFile(model=self.name, fabric=self.fabric, settings={"points": self._points})

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of the fabric with as many points as the file says.

        Raises:
            InputError: another model's file, or a number of points that cannot be.
        """
        loom.require_model(cls.name)
        return cls(loom.fabric, loom.setting("points", int))
