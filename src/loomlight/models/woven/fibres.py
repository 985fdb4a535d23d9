"""How the fibres of a fabric lie and how rough they are: what the decoder needs beside latents."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric

# Roughness that mixing may lead to.
_ROUGHNESS = 0.01, 1.0


@dataclass(frozen=True)
class Fibres:
    """Both families, the warp first.

    Attributes:
        twist: ψ, radians.
        roughness: α.
    """

    twist: tuple[float, float]
    roughness: tuple[float, float]

    @classmethod
    def of(cls, fabric: Fabric) -> Self:
        """The fibres of a fabric, in single precision, as materials keep them."""
        layout, appearance = fabric.layout(), fabric.appearance()
        twist = layout.warp.twist, layout.weft.twist
        roughness = appearance.warp.roughness, appearance.weft.roughness
        return cls.from_array(np.array([twist, roughness], np.float32))

    @classmethod
    def from_array(cls, numbers: NDArray[np.float32]) -> Self:
        """What `array` gave."""
        (warp, weft), (warp_roughness, weft_roughness) = numbers.tolist()
        return cls((warp, weft), (warp_roughness, weft_roughness))

    def array(self) -> NDArray[np.float32]:
        """Twists and roughnesses [2, 2 families]."""
        return np.array([self.twist, self.roughness], np.float32)

    def face(self, back: bool) -> NDArray[np.float32]:
        """Their direction on a yarn's crown, x and y, and α [2 families, 3], in the frame of one face.

        A twist keeps its sign seen from behind, but the frame of that face is mirrored.
        """
        turn = -1 if back else 1
        warp, weft = (turn * angle for angle in self.twist)
        return np.array(
            [
                [-np.sin(warp), np.cos(warp), self.roughness[0]],
                [-np.cos(weft), -np.sin(weft), self.roughness[1]],
            ],
            np.float32,
        )

    def mixed(self, other: Fibres, share: float) -> Fibres:
        """Between these (0) and others (1), or beyond: twists evenly, roughnesses by shares."""
        low, high = _ROUGHNESS
        mine, theirs = self.array(), other.array()
        twist = (1 - share) * mine[0] + share * theirs[0]
        roughness = np.exp((1 - share) * np.log(mine[1]) + share * np.log(theirs[1]))
        return Fibres.from_array(np.stack([twist, np.clip(roughness, low, high)]).astype(np.float32))
