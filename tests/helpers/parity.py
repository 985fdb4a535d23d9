"""The bar of parity of shaders with Python, and places and appearances that they are compared at."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from drjit.llvm.ad import Bool, Float
from numpy.typing import ArrayLike, NDArray

from loomlight.scattering.appearance import Appearance, FamilyAppearance, Irregularity, Sheen, Variation
from loomlight.yarn.layout import ClothLayout

ABSOLUTE, RELATIVE = 1e-5, 1e-3
# Slang: the footprint of the arguments x, y, dx, dy.
FOOTPRINT = "Footprint p; p.centre = float2(x, y); p.dx = dx; p.dy = dy; let back = view.z < 0.0;"


def share_beyond(found: ArrayLike, expected: ArrayLike) -> float:
    """Share of the numbers with |a − b| > 1e-5 + 1e-3·|b|; NaN counts."""
    a, b = np.asarray(found, np.float64), np.asarray(expected, np.float64)
    return float(np.mean(~(np.abs(a - b) <= ABSOLUTE + RELATIVE * np.abs(b))))


@dataclass
class Places:
    """Places on the cloth, some repeats away from the origin, on either face."""

    x: NDArray[np.float32]
    y: NDArray[np.float32]
    back: NDArray[np.bool_]

    def arguments(self) -> dict[str, NDArray[np.generic]]:
        return {"x": self.x, "y": self.y, "back": self.back}

    def arrays(self) -> tuple[Float, Float, Bool]:
        return Float(self.x), Float(self.y), Bool(self.back)


def places(rng: np.random.Generator, layout: ClothLayout, count: int) -> Places:
    width, height = layout.size
    return Places(
        np.float32(rng.uniform(-3 * width, 3 * width, count)),
        np.float32(rng.uniform(-3 * height, 3 * height, count)),
        rng.random(count) < 0.5,
    )


def appearance(rng: np.random.Generator, layout: ClothLayout, sheen: bool, varies: bool) -> Appearance:
    """Random albedos inside the energy bound; with `varies` they differ by thread and by noise."""

    def family(count: int) -> FamilyAppearance:
        rows = [rng.uniform(0, most, (count if varies else 1, 3)) for most in (0.4, 0.2, 0.3, 0.2)]
        return FamilyAppearance(*(np.broadcast_to(row, (count, 3)) for row in rows), rng.uniform(0.1, 0.6))

    return Appearance(
        family(layout.warp.spacing.size),
        family(layout.weft.spacing.size),
        Sheen(0.5, 0.3) if sheen else Sheen(),
        Variation(0.5, 0.5, 7) if varies else Variation(),
    )


# Slubs, neps, and shades along the yarn and from thread to thread.
IRREGULAR_WARP = Irregularity(0.25, 60, 4, 30, 1.2, 0.3, 0.1, 6, 4, (0.6, 0.1, 0.05))
IRREGULAR_WEFT = Irregularity(0.15, 28, melange=0.3, neps=3)


def irregular(looks: Appearance, alike: bool = False) -> Appearance:
    """An appearance whose yarns vary along themselves: of each family by other numbers, or alike."""
    weft = IRREGULAR_WARP if alike else IRREGULAR_WEFT
    return replace(
        looks,
        warp=replace(looks.warp, irregularity=IRREGULAR_WARP),
        weft=replace(looks.weft, irregularity=weft),
    )
