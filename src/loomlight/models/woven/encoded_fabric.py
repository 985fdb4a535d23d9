"""What the encoder finds of a fabric: latents of both faces, with its fibres."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.models.woven.fibres import Fibres
from loomlight.models.woven.footprint_coding import Level, levels_of


@dataclass(frozen=True, eq=False)
class EncodedFabric:
    """What the decoder needs of a fabric.

    Attributes:
        picks, ends: of the shortest repeat, without its colours.
        faces: latents of front and back [texels, latent_size], in half precision: what they are computed and
            stored with are the same numbers.
        fibres: of both families.
        correction: what is added to the decoder's last layer, to its rows for bundles [2 · `BUNDLES`,
            hidden + 1], biases last; None where it is that of all fabrics. See `fine_tuning.py`.
    """

    picks: int
    ends: int
    faces: tuple[NDArray[np.float16], NDArray[np.float16]]
    fibres: Fibres
    correction: NDArray[np.float32] | None = None

    @property
    def levels(self) -> list[Level]:
        """Where each level of a field begins."""
        return levels_of(self.picks, self.ends)

    @cached_property
    def both(self) -> NDArray[np.float32]:
        """Front above back [2 texels, latent_size], in single precision."""
        return np.concatenate(self.faces).astype(np.float32)

    def mixed(self, other: EncodedFabric, share: float) -> EncodedFabric:
        """Latents and fibres between this fabric (0) and another of the same repeat (1), or beyond them.

        Raises:
            InputError: repeats of different size.
        """
        if (self.picks, self.ends) != (other.picks, other.ends):
            raise InputError(
                f"fabrics of {self.ends} × {self.picks} and {other.ends} × {other.picks} threads cannot be "
                "interpolated: encode both for a common repeat."
            )
        front, back = (
            (mine + share * (yours.astype(np.float32) - mine)).astype(np.float16)
            for mine, yours in zip(self.faces, other.faces, strict=True)
        )
        correction = None
        if self.correction is not None and other.correction is not None:
            correction = self.correction + np.float32(share) * (other.correction - self.correction)
        fibres = self.fibres.mixed(other.fibres, share)
        return EncodedFabric(self.picks, self.ends, (front, back), fibres, correction)
