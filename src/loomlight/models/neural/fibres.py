"""Directions and roughness of the fibres of a fabric: inputs of the decoder beside latents."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric
from loomlight.fabric.fields import yarn_range
from loomlight.models.neural.architecture import BUNDLE_POSITIONS, BUNDLE_SLOPES

# Valid ranges of parameters, to which mixtures are clipped; angles in radians.
_LIMITS = {
    "roughness": yarn_range("roughness"),
    "inclination": (0.0, math.radians(yarn_range("inclination_deg")[1])),
    "height_scale": yarn_range("height_scale"),
}
_ROUNDING = 1e-6
# Slopes of bundles in units of the slope at the ends of floats, as yarns dive steeper between floats; and the
# smallest largest slope.
_SLOPE_MARGIN, _MIN_SLOPE = 1.15, 0.03
# The sine of the angle at a yarn's edges, seen along it.
_EDGE = 0.98
# α² of a lobe is that of the fibres plus this fraction of the squared distance to the next lobe: less leaves
# gaps between lobes, more blurs highlights.
_SPREAD = 0.3
# Added to α for each unit of the standard deviation of fibre directions in one direction.
_SPREAD_WIDTH = 1.7


@dataclass(frozen=True)
class Fibres:
    """Both families, the warp first.

    Attributes:
        twist: ψ, radians.
        roughness: α.
        inclination: U, radians.
        height_scale: β.
    """

    twist: tuple[float, float]
    roughness: tuple[float, float]
    inclination: tuple[float, float]
    height_scale: tuple[float, float]

    @classmethod
    def of(cls, fabric: Fabric) -> Self:
        """The fibres of a fabric, in single precision, as materials keep them."""
        layout, appearance = fabric.layout(), fabric.appearance()
        families = layout.warp, layout.weft
        numbers = [
            [family.twist for family in families],
            [appearance.warp.roughness, appearance.weft.roughness],
            [family.inclination for family in families],
            [family.height_scale for family in families],
        ]
        return cls.from_array(np.array(numbers, np.float32))

    @classmethod
    def from_array(cls, numbers: NDArray[np.float32]) -> Self:
        """The fibres of `array`'s numbers."""
        twist, roughness, inclination, height_scale = ((warp, weft) for warp, weft in numbers.tolist())
        return cls(twist, roughness, inclination, height_scale)

    def array(self) -> NDArray[np.float32]:
        """Twists, roughnesses, inclinations and height scales [4, 2 families]."""
        return np.array([self.twist, self.roughness, self.inclination, self.height_scale], np.float32)

    def face(self, back: bool) -> NDArray[np.float32]:
        """Fibre direction on the crown of a yarn, x and y, and α [2 families, 3], in the frame of one face.

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

    def bundles(self, back: bool) -> NDArray[np.float32]:
        """The lobe basis: bundles of parallel fibres, in the frame of one face [2 families, `BUNDLES`, 4].

        The four numbers are b [3] and a: the density of a bundle's normals towards the half vector h is
        1/(a + (b·h)²)², 1/sr. Bundles have `BUNDLE_SLOPES` slopes along the yarn, times `BUNDLE_POSITIONS`
        positions across it, which differ where fibres are twisted; the last one's density is 1 everywhere. On
        the back, bundles are mirrored across the yarn: both faces have the same ones in different order.
        """
        slopes, positions = np.indices((BUNDLE_SLOPES, BUNDLE_POSITIONS)).reshape(2, -1).astype(float)
        numbers = []
        for family in (0, 1):
            axis = self._axis(family, back, slopes, positions)
            square = np.full(len(axis), self.roughness[family] ** 2)
            for along, across in ((0.5, 0.0), (0.0, 0.5)):
                step = self._axis(family, back, slopes + along, positions + across) - self._axis(
                    family, back, slopes - along, positions - across
                )
                square += _SPREAD * np.square(step).sum(1)
            square = np.minimum(square, 1)
            # SGGX of fibres (appearance.md 3), α³/(π (α² + (t·h)²(1 − α²))²), as one square.
            scale = np.sqrt(math.pi / square**1.5)
            axis *= np.sqrt(scale * (1 - square))[:, None]
            bundles = np.concatenate([axis, (scale * square)[:, None]], axis=1)
            numbers.append(np.concatenate([bundles, [[0, 0, 0, 1]]]))
        return np.array(numbers, np.float32)

    def lobe_roughness(self) -> tuple[float, float]:
        """α of one lobe about the crown's fibres that covers those of the whole yarn, for both families.

        α grows with the standard deviation of fibre directions, as that of groups of `lobes` does.
        """
        slopes, positions = np.indices((BUNDLE_SLOPES, BUNDLE_POSITIONS)).reshape(2, -1).astype(float)
        widened = []
        for family in (0, 1):
            axis = self._axis(family, False, slopes, positions)
            crown = np.append(self.face(False)[family, :2], 0)
            variance = np.square(axis - crown).sum(1).mean()
            widened.append(min(self.roughness[family] + _SPREAD_WIDTH * math.sqrt(0.5 * variance), 1.0))
        return widened[0], widened[1]

    def _axis(
        self, family: int, back: bool, slopes: NDArray[np.float64], positions: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Unit vectors along the fibres [n, 3] for indices of slopes and positions [n], in bundles."""
        twist = -self.twist[family] if back else self.twist[family]
        steepest = _SLOPE_MARGIN * math.tan(self.inclination[family]) + _MIN_SLOPE
        along = steepest * ((2 * slopes + 1) / BUNDLE_SLOPES - 1)
        # Evenly over the yarn's width; the outermost half of a position has the slope of its centre.
        sine = np.clip(_EDGE * ((2 * positions + 1) / BUNDLE_POSITIONS - 1), -_EDGE, _EDGE)
        across = -sine / np.sqrt(1 - sine * sine)
        # t = cos ψ e_u − sin ψ e_v of a surface with these slopes; heights are scaled afterwards.
        lengthwise = 1 + along * along
        crosswise = math.sin(twist) / np.sqrt(lengthwise * (lengthwise + across * across))
        x, y = -crosswise * lengthwise, crosswise * across * along + math.cos(twist) / np.sqrt(lengthwise)
        z = self.height_scale[family] * (across * x + along * y)
        axis = np.stack([x, y, z] if family == 0 else [-y, x, z], axis=1)
        return axis / np.linalg.norm(axis, axis=1, keepdims=True)

    def mixed(self, other: Fibres, weight: float) -> Fibres:
        """Interpolates to others: weight 0 is these, 1 the others; linear, roughness in its logarithm."""
        mine, theirs = self.array(), other.array()
        twist, roughness, inclination, height_scale = (1 - weight) * mine + weight * theirs
        roughness = np.exp((1 - weight) * np.log(mine[1]) + weight * np.log(theirs[1]))
        others = zip((roughness, inclination, height_scale), _LIMITS.values(), strict=True)
        values = [twist, *(np.clip(values, *limits) for values, limits in others)]
        return Fibres.from_array(np.stack(values).astype(np.float32))

    def validation_error(self) -> str | None:
        """A sentence that names a value out of its valid range; None if all are valid."""
        for name, (low, high) in _LIMITS.items():
            warp, weft = getattr(self, name)
            if not all(low - _ROUNDING <= value <= high + _ROUNDING for value in (warp, weft)):
                return f"{name} is {warp:g} and {weft:g}: both should be {low:g} to {high:g}"
        return None
