"""The encoded fabric: latents of both faces, with its fibres."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.models.neural.fibres import Fibres
from loomlight.models.neural.footprint_coding import Level, levels_of


@dataclass(frozen=True, eq=False)
class EncodedFabric:
    """The inputs of the decoder that belong to a fabric.

    Attributes:
        picks, ends: of the shortest repeat, without its colours.
        faces: latents of front and back [texels, latent_size], in half precision, in memory as in files.
        fibres: of both families.
        correction: added to the decoder's last layer, to its rows for the lobe basis [2 · `BUNDLES`,
            hidden + 1], biases last; None without fine-tuning. See `fine_tuning.py`.
    """

    picks: int
    ends: int
    faces: tuple[NDArray[np.float16], NDArray[np.float16]]
    fibres: Fibres
    correction: NDArray[np.float32] | None = None

    @property
    def levels(self) -> list[Level]:
        """The levels of the latent field."""
        return levels_of(self.picks, self.ends)

    @cached_property
    def stacked(self) -> NDArray[np.float32]:
        """Front above back [2 texels, latent_size], in single precision."""
        return np.concatenate(self.faces).astype(np.float32)

    def mixed(self, other: EncodedFabric, weight: float) -> EncodedFabric:
        """Interpolates latents and fibres to another fabric of the same repeat.

        Args:
            weight: 0 is this fabric, 1 the other; other values extrapolate.

        Raises:
            InputError: repeats of different size.
        """
        if (self.picks, self.ends) != (other.picks, other.ends):
            raise InputError(
                f"fabrics of {self.ends} × {self.picks} and {other.ends} × {other.picks} threads cannot be "
                "interpolated: encode both for a common repeat."
            )
        front, back = (
            (mine + weight * (yours.astype(np.float32) - mine)).astype(np.float16)
            for mine, yours in zip(self.faces, other.faces, strict=True)
        )
        correction = None
        if self.correction is not None and other.correction is not None:
            correction = self.correction + np.float32(weight) * (other.correction - self.correction)
        fibres = self.fibres.mixed(other.fibres, weight)
        return EncodedFabric(self.picks, self.ends, (front, back), fibres, correction)
