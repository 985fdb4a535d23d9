"""Samples of the cloth's surface for baking tables, at low-discrepancy positions over the repeat."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types
from loomlight.core.frozen import FrozenArg, FrozenFunction
from loomlight.yarn.geometry import SurfacePoint, YarnGeometry
from loomlight.yarn.rays import upload_extent

# Top-down samples of each face.
TOP_DOWN_SAMPLES = 1 << 13
# The additive recurrence of Roberts (2018, "The Unreasonable Effectiveness of Quasirandom Sequences") in four
# dimensions: powers of 1/φ₄, the root of x⁵ = x + 1, in units of 2⁻³², where products wrap around as
# fractions.
RECURRENCE = [round(2**32 * 1.1673039782614187**-power) for power in range(1, 5)]

# 2³²/φ: fractions of multiples of the golden ratio fill the unit interval evenly.
GOLDEN_FRACTION = 0x9E3779B9
# Shifts x, y from lattice to lattice: 1/ρ and −1/ρ² − 1/φ in units of 2⁻³², ρ the root of x³ = x + 1. Points
# of successive numbers and lattices, which shadow rays start from, are then nearly an additive recurrence.
LATTICE_SHIFT = 0xC13FA9A9, 2**33 - 0x91E10DA6 - GOLDEN_FRACTION


@dataclass
class SurfaceHits:
    """Yarn points in the frame of their face.

    Attributes:
        is_warp: the warp is hit, else the weft.
        hole: no yarn is hit.
        normal, tangent: unit normal and unit fibre direction.
        shown_share: see `SurfacePoint`.
    """

    is_warp: Mask
    hole: Mask
    normal: Vec3
    tangent: Vec3
    shown_share: Float

    @classmethod
    def of(cls, point: SurfacePoint, hole: Mask) -> Self:
        """The point as a hit; `hole` where nothing was hit."""
        return cls(point.is_warp, hole, point.normal, point.tangent, point.shown_share)

    def features(self) -> list[Float]:
        """What points are told apart by: normal, fibre direction, shown share."""
        return [*self.normal, *self.tangent, self.shown_share]


@dataclass(frozen=True, eq=False)
class FaceSamples:
    """Samples of both faces, in the frame of the face that shows them.

    Attributes:
        back, is_warp, hole: which face, which family, and whether neither family is there [n].
        features: see `SurfaceHits.features` [n, 7].
    """

    back: NDArray[np.bool_]
    is_warp: NDArray[np.bool_]
    hole: NDArray[np.bool_]
    features: NDArray[np.float32]

    def by_family(self) -> list[NDArray[np.intp]]:
        """Indices of samples by family, without holes: the front's warp and weft, then the back's."""
        family_of = 2 * self.back + ~self.is_warp
        return [np.flatnonzero((family_of == family) & ~self.hole) for family in range(4)]


@dataclass(frozen=True, eq=False)
class TopDownSamples(FaceSamples):
    """Samples of the surface as seen along the normal, evenly over the repeat; the front's come first.

    Attributes:
        gaps: positions of the holes among them [m, 2], millimetres.
    """

    gaps: NDArray[np.float32]

    @property
    def hole_fraction(self) -> float:
        """Fraction of the repeat without yarn, 0 to 1: the same for both faces."""
        return len(self.gaps) / TOP_DOWN_SAMPLES


class SamplePositions:
    """Low-discrepancy point sets over the repeat, the same every time."""

    def __init__(self, geometry: YarnGeometry, types: ArrayTypes) -> None:
        self._types = types
        picks, ends = geometry.layout.warp_on_top.shape
        # Of either axis: how many threads there are, and millimetres a thread.
        self._axes = [
            (dr.opaque(types.Float, threads), dr.opaque(types.Float, side / threads))
            for threads, side in zip((ends, picks), geometry.size, strict=True)
        ]

    def at(self, index: UInt, sequence: UInt) -> tuple[Float, Float]:
        """Positions x, y, millimetres.

        Two dimensions choose the crossing and two the position within it: points that are even over the
        repeat alone may hit a gap of a few per cent too often, as threads repeat.

        Args:
            index: of the point in its sequence, from 0.
            sequence: which one of many shifted sequences.
        """
        unit = [
            self._types.Float((index * factor + factor // 2 + sequence * shift) >> 8) * 2**-24
            for factor, shift in zip(RECURRENCE, RECURRENCE[::-1], strict=True)
        ]
        x, y = (
            (dr.floor(crossing * threads) + within) * spacing
            for within, crossing, (threads, spacing) in zip(unit[:2], unit[2:], self._axes, strict=True)
        )
        return x, y

    def in_lattice(self, index: UInt, count: int, lattice: UInt) -> tuple[Float, Float]:
        """Positions x, y, millimetres, of a golden lattice over the repeat.

        With 512 points the area that a family shows has half the noise of `at`, but gaps of a few per cent
        between evenly spaced threads may have more of it.

        Args:
            index: of the point, from 0.
            count: of points in a lattice.
            lattice: which one of many shifted lattices.
        """
        step = dr.opaque(self._types.UInt32, (2**32 - 1) // count)
        x, y = (
            self._types.Float((index * factor + lattice * shift) >> 8) * 2**-24 * (threads * spacing)
            for factor, shift, (threads, spacing) in zip(
                (step, GOLDEN_FRACTION), LATTICE_SHIFT, self._axes, strict=True
            )
        )
        return x, y


class UploadedCloth:
    """The yarns of one fabric on one backend.

    Attributes:
        geometry: the yarns, uploaded.
        positions: point sets over their repeat.
        types: of the backend.
    """

    def __init__(self, geometry: YarnGeometry, types: ArrayTypes) -> None:
        geometry.upload(types)
        upload_extent(geometry, types)
        self.geometry = geometry
        self.positions = SamplePositions(geometry, types)
        self.types = types


def upload_cloth(geometry: YarnGeometry, float_type: FloatType) -> FrozenArg[UploadedCloth]:
    """The yarns on the backend of a Dr.Jit Float type, as an argument of frozen functions."""
    return FrozenArg(UploadedCloth(geometry, array_types(float_type)))


def top_down_samples(cloth: FrozenArg[UploadedCloth]) -> TopDownSamples:
    """Samples both faces along the normal."""
    x, y, hits = _sample_top_down(cloth)
    hole = hits.hole.numpy()
    back = np.arange(2 * TOP_DOWN_SAMPLES) >= TOP_DOWN_SAMPLES
    gaps = np.stack([part.numpy()[hole & ~back] for part in (x, y)], axis=1)
    features = np.stack([part.numpy() for part in hits.features()], axis=1)
    return TopDownSamples(back, hits.is_warp.numpy(), hole, features, gaps)


@FrozenFunction
def _sample_top_down(cloth: UploadedCloth) -> tuple[Float, Float, SurfaceHits]:
    """Positions x, y of all samples, and what is there."""
    lane = dr.arange(cloth.types.UInt32, 2 * TOP_DOWN_SAMPLES)
    back = lane >= TOP_DOWN_SAMPLES
    x, y = cloth.positions.at(lane & (TOP_DOWN_SAMPLES - 1), cloth.types.UInt32(0))
    point = cloth.geometry.surface(x, y, back)
    return x, y, SurfaceHits.of(point, point.hole)
