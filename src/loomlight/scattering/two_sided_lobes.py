"""Two mixtures of lobes that a sampler network describes: of the view's side, and of the other one, mirrored.

Both cover directions below their own side too, so both count in the density everywhere. Formulas take Dr.Jit,
torch or NumPy arrays, as those of `lobe_mixture.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from loomlight.core.arrays import Float
from loomlight.core.backend import DRJIT
from loomlight.scattering.lobe_mixture import (
    LOBE_OUTPUTS,
    LobeMixture,
    lobe_mixture,
    mixture_density,
    sample_mixture,
)

# Of a network that describes both sides, and of one for sources that transmit no light.
OUTPUTS, OPAQUE_OUTPUTS = 2 * LOBE_OUTPUTS + 1, LOBE_OUTPUTS
# Bound of the log-odds of the sides: neither is left out.
_MAX_LOG_ODDS = 5.0
_TINY = 1e-6


@dataclass
class TwoSidedLobes:
    """The density that the network describes, without its uniform part.

    Attributes:
        near: lobes of lights on the view's side.
        far: lobes of lights on the other side, mirrored to the view's side.
        reflect: probability of `near`.
    """

    near: LobeMixture
    far: LobeMixture
    reflect: Float

    @classmethod
    def of(cls, outputs: Sequence[Float], math: Any = DRJIT) -> TwoSidedLobes:
        """The lobes of a network's `OUTPUTS` numbers, or of the `OPAQUE_OUTPUTS` of the view's side alone."""
        if len(outputs) == OPAQUE_OUTPUTS:
            near = lobe_mixture(outputs, math)
            return cls(near, near, 1 + 0 * outputs[0])
        odds = math.clip(outputs[-1], -_MAX_LOG_ODDS, _MAX_LOG_ODDS)
        near, far = (lobe_mixture(outputs[k : k + LOBE_OUTPUTS], math) for k in (0, LOBE_OUTPUTS))
        return cls(near, far, 1 / (1 + math.exp(-odds)))

    def density(self, light: Sequence[Float], view: Sequence[Float], math: Any = DRJIT) -> Float:
        """Density of lights over the sphere, 1/sr, in the frame of the face that is seen."""
        mirrored = [light[0], light[1], -light[2]]
        return self.reflect * mixture_density(self.near, light, view, math) + (
            1 - self.reflect
        ) * mixture_density(self.far, mirrored, view, math)

    def sample(
        self, view: Sequence[Float], choice: Float, u: Sequence[Float], math: Any = DRJIT
    ) -> list[Float]:
        """A light: x, y and z.

        Args:
            choice: uniform number in [0, 1) that chooses side and lobe.
            u: two uniform numbers in [0, 1).
        """
        reflects = choice < self.reflect
        # Given the side, the number is uniform again.
        behind = (choice - self.reflect) / math.maximum(1 - self.reflect, _TINY)
        rest = math.select(reflects, choice / self.reflect, behind)
        near = sample_mixture(self.near, view, rest, u, math)
        far = sample_mixture(self.far, view, rest, u, math)
        return [math.select(reflects, a, b) for a, b in zip(near, (far[0], far[1], -far[2]), strict=True)]
