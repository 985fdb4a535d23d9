"""Yarns that vary over millimetres to metres: a random process a thread, and its means over footprints.

Along every thread four numbers vary, each with the mean 0:

- *thickness*, relative mass: fibres that lie at random (Martindale 1945: their spectrum is white above the
  length of a fibre), drafting waves of 2.5 to 3 lengths of a fibre, slow drift, and thick places;
- *cover*, the relative width of the yarn: the root of its mass, as wide as its cell at most;
- *tone*, the logarithm of the depth of shade: waves of all lengths for a dye, short ones for a mélange, and
  ones as long as the table for threads of another lot;
- *nep*, the share of the yarn that knots of other fibres cover.

A table holds the process of `ROWS` threads over `SAMPLES` steps, which closes to a ring. A block of `BLOCK`
threads of the cloth reads it from a row and a place that a hash of its number chooses, so cloth repeats
nowhere though the table is small. Its entries are integrals over all threads and steps before: a mean over
any footprint takes four rows of four entries in the block of its first and its last thread each, exactly.

What follows from the numbers is linear in each of them, so that its mean over a footprint is that of the
footprint's mean, and cloth keeps the mean colour, families and holes of even cloth at every distance:

- the diffuse albedo R of a depth of shade (Kubelka and Munk 1931): dR/R = −(1 − R)/(1 + R) · d ln(K/S);
- shares of families and holes by the cover of both (`Yarns.shares`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Color3, Float, Mask, UInt, Vec2
from loomlight.core.backend import (
    ArrayTypes,
    array_types,
    clip,
    masked_branch,
    maximum,
    minimum,
    opaque,
    upload,
)
from loomlight.core.footprint import Box, Footprint
from loomlight.scattering.appearance import Appearance, FamilyAppearance, Irregularity
from loomlight.scattering.detail import fade
from loomlight.scattering.variation import FourColours, hash_bits, hash_key
from loomlight.yarn.cells import Cell, upload_family
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.threads import FamilyTables

# Threads and steps of a table, threads of a block, length of a step in millimetres.
ROWS, SAMPLES, BLOCK = 128, 1024, 64
SAMPLES_BITS = 10
STEP = 2.0
# Quantities of an entry: thickness, cover, tone, nep.
QUANTITIES = 4
# Uster's tests weigh lengths of so many millimetres.
CUT_LENGTH = 8.0
# Of the variance of mass by fibres at random, drafting waves and drift; of cotton's spectrograms, by eye.
RANDOM_SHARE, DRAFTING_SHARE, DRIFT_SHARE = 0.6, 0.25, 0.15
# Length of drafting waves in lengths of a fibre, and deviation of its logarithm.
DRAFTING_LENGTH, DRAFTING_SPREAD = 2.75, 0.2
# Waves of drift are longer than so many lengths of a fibre.
DRIFT_LENGTH = 6.0
# A mélange varies within so many millimetres; threads of another lot over this many.
MELANGE_LENGTH, LOT_LENGTH = 30.0, 700.0
# Least mass of a yarn, relative, and largest change of tone: a linear gain stays above 0.
LEAST_THICKNESS, LARGEST_TONE = -0.75, 0.9
# Thick yarn stands above its neighbours, which lie in its shade: how much lighter it is, over how much wider;
# by eye.
RELIEF = 0.5
# The largest integral of a table, as an integer.
LARGEST_INTEGRAL = float(2**29)
# Least width of a box in threads: float32 tells narrower ones apart no longer.
LEAST_WIDTH = 1 / 16
# Of the hash of blocks, and of the random numbers of a table.
STREAM = 0x6C8E9CF5
THICKNESS_STREAM, SHADE_STREAM, MELANGE_STREAM, LOT_STREAM, THICK_STREAM, NEP_STREAM = range(1, 7)


# ------------------------------------------------------------------------------------------- the process


def _scrambled(value: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """The permutation of `variation.py`, of NumPy's numbers."""
    state = value * np.uint32(747796405) + np.uint32(2891336453)
    word = ((state >> ((state >> np.uint32(28)) + np.uint32(4))) ^ state) * np.uint32(277803737)
    return np.asarray((word >> np.uint32(22)) ^ word)


def random_numbers(stream: int, count: int) -> NDArray[np.float64]:
    """Numbers in (0, 1) of each row [ROWS, count], which depend on the stream, row and column alone."""
    row, column = np.arange(ROWS, dtype=np.uint32)[:, None], np.arange(count, dtype=np.uint32)
    key = _scrambled(row + _scrambled(np.array([stream], np.uint32)))
    return (_scrambled(column + key).astype(np.float64) + 0.5) * 2.0**-32


def frequencies() -> NDArray[np.float64]:
    """Waves of a table per millimetre [SAMPLES / 2]: the longest is as long as the table."""
    return np.arange(1, SAMPLES // 2 + 1) / (SAMPLES * STEP)


def mass_spectrum(yarn: Irregularity) -> NDArray[np.float64]:
    """Variance of the mass by wave [SAMPLES / 2], without thick places; see `frequencies`."""
    f, length = frequencies(), yarn.fibre_length
    of_fibres = np.sinc(f * length) ** 2
    of_drafting = np.exp(-0.5 * (np.log(f * DRAFTING_LENGTH * length) / DRAFTING_SPREAD) ** 2) / f
    of_drift = 1 / (f * (1 + (f * DRIFT_LENGTH * length) ** 2))
    total = np.zeros_like(f)
    for share, part in (
        (RANDOM_SHARE, of_fibres),
        (DRAFTING_SHARE, of_drafting),
        (DRIFT_SHARE, of_drift),
    ):
        # Drafting waves of filaments are longer than the table.
        total += share * part / max(float(part.sum()), 1e-12)
    of_cuts = float((total * np.sinc(f * CUT_LENGTH) ** 2).sum())
    return np.asarray(total * (yarn.mass_cv**2 / of_cuts))


def tone_spectra(yarn: Irregularity, of_lots: float) -> dict[int, NDArray[np.float64]]:
    """Variance of the depth of shade by wave [SAMPLES / 2] of dye, mélange and lots, by their streams.

    Args:
        of_lots: deviation from thread to thread.
    """
    f = frequencies()
    parts = {
        SHADE_STREAM: (yarn.shade, 1 / f),
        MELANGE_STREAM: (yarn.melange, (f > 1 / MELANGE_LENGTH).astype(np.float64)),
        LOT_STREAM: (of_lots, (f < 1 / LOT_LENGTH).astype(np.float64)),
    }
    return {stream: amount**2 * part / part.sum() for stream, (amount, part) in parts.items()}


def waves(spectrum: NDArray[np.float64], stream: int) -> NDArray[np.float64]:
    """A process [ROWS, SAMPLES] of a variance by wave [SAMPLES / 2], waves with phases by chance."""
    turns = 2 * math.pi * random_numbers(stream, len(spectrum))
    amplitudes = np.sqrt(2 * spectrum) * (SAMPLES / 2) * np.exp(1j * turns)
    amplitudes[:, -1] = math.sqrt(spectrum[-1]) * SAMPLES * np.cos(turns[:, -1])
    return np.asarray(np.fft.irfft(np.concatenate([np.zeros((ROWS, 1)), amplitudes], axis=1), SAMPLES))


def places(per_metre: float, length: float, stream: int) -> NDArray[np.float64]:
    """Bumps [ROWS, SAMPLES] of heights from 0.5 to 1.5 and half to one and a half times a length, by chance.

    Args:
        per_metre: of them, on average.
        length: millimetres.
    """
    found = np.zeros((ROWS, SAMPLES))
    chance = per_metre * STEP / 1000
    if chance <= 0:
        return found
    begins = random_numbers(stream, SAMPLES) < chance
    longer, higher = (0.5 + random_numbers(stream + 8 * more, SAMPLES) for more in (1, 2))
    for row, column in np.argwhere(begins):
        half = 0.5 * max(length * longer[row, column] / STEP, 1.0)
        reach = math.ceil(half)
        steps = np.arange(-reach, reach + 1)
        bump = np.where(np.abs(steps) < half, 0.5 + 0.5 * np.cos(math.pi * steps / half), 0)
        np.add.at(found[row], (column + steps) % SAMPLES, higher[row, column] * bump)
    return found


def thickness_of(yarn: Irregularity) -> NDArray[np.float64]:
    """Relative mass less 1 [ROWS, SAMPLES], of mean 0."""
    mass = waves(mass_spectrum(yarn), THICKNESS_STREAM)
    thick = yarn.thick_size * places(yarn.thick_places, yarn.thick_length, THICK_STREAM)
    found = np.maximum(mass + thick - thick.mean(), LEAST_THICKNESS)
    return np.asarray(found - found.mean(axis=1, keepdims=True))


def cover_of(thickness: NDArray[np.float64], cover: float) -> NDArray[np.float64]:
    """Relative width of the yarn less 1 [ROWS, SAMPLES], of mean 0.

    Args:
        cover: mean share of a cell that the yarn covers; where it covers all, it cannot be wider.
    """
    root = np.sqrt(1 + np.maximum(thickness, LEAST_THICKNESS))
    low, high = 0.5, 2.0
    for _ in range(40):
        middle = 0.5 * (low + high)
        is_thin = np.minimum(middle * cover * root, 1).mean() < cover
        low, high = (middle, high) if is_thin else (low, middle)
    found = np.minimum(high * cover * root, 1) / cover - 1
    return np.asarray(found - found.mean(axis=1, keepdims=True))


def tone_of(
    yarn: Irregularity, thickness: NDArray[np.float64], per_gain: float, colour_noise: float
) -> NDArray[np.float64]:
    """Depth of shade [ROWS, SAMPLES], of mean 0; positive is darker.

    Args:
        thickness: see `thickness_of`.
        per_gain: see `depth_per_gain`.
        colour_noise: relative spread of the albedo from thread to thread.
    """
    # A spread of ±1 has the deviation 1/√3.
    parts = tone_spectra(yarn, colour_noise / math.sqrt(3) * per_gain)
    total = sum(waves(spectrum, stream) for stream, spectrum in parts.items())
    wider = np.sqrt(1 + np.maximum(thickness, LEAST_THICKNESS)) - 1
    found = np.tanh((np.asarray(total) - RELIEF * per_gain * wider) / LARGEST_TONE)
    found -= found.mean(axis=1, keepdims=True)
    # Its mean may have lain on either side.
    return np.asarray(LARGEST_TONE * found / max(1.0, float(np.abs(found).max())))


def nep_of(yarn: Irregularity) -> NDArray[np.float64]:
    """Share of the yarn that neps cover less its mean [ROWS, SAMPLES]."""
    found = np.minimum(places(yarn.neps, yarn.nep_length, NEP_STREAM), 1)
    return np.asarray(found - found.mean(axis=1, keepdims=True))


@dataclass(frozen=True, eq=False)
class IrregularTable:
    """The process of one family as integrals.

    Attributes:
        integrals: over threads and steps before [ROWS + BLOCK + 1, SAMPLES, QUANTITIES], signed integers.
        units: what the integer 1 stands for [QUANTITIES], times a thread and a step.
    """

    integrals: NDArray[np.int32]
    units: NDArray[np.float64]


def irregular_table(
    yarn: Irregularity, cover: float, per_gain: float = 1.0, colour_noise: float = 0.0
) -> IrregularTable:
    """The table of a family.

    Args:
        cover: see `cover_of`.
        per_gain, colour_noise: see `tone_of`.
    """
    thickness = thickness_of(yarn)
    tone = tone_of(yarn, thickness, per_gain, colour_noise)
    process = np.stack([thickness, cover_of(thickness, cover), tone, nep_of(yarn)], axis=-1)
    # Blocks that begin in the last rows go on with the first.
    rows = np.concatenate([process, process[:BLOCK]])
    integrals = np.zeros((ROWS + BLOCK + 1, SAMPLES, QUANTITIES))
    # Each row is 0 in all, so the integral at the ring's end is that at its beginning.
    integrals[1:, 1:] = np.cumsum(np.cumsum(rows, axis=0), axis=1)[:, :-1]
    units = np.maximum(np.abs(integrals).max(axis=(0, 1)), 1e-12) / LARGEST_INTEGRAL
    return IrregularTable(np.rint(integrals / units).astype(np.int32), units)


# ------------------------------------------------------------------------------------ means over footprints


@dataclass
class Yarn:
    """What the yarns of a family are over a footprint, less what they are in even cloth: means, of mean 0."""

    thickness: Float
    cover: Float
    tone: Float
    nep: Float


@dataclass
class _OfFamily:
    """Where the process of one family, or of the family of each lane, is read.

    Attributes:
        first: row of the table at which it begins, UInt32.
        key: of the hash of its blocks, UInt32.
        units: see `IrregularTable` [QUANTITIES].
    """

    integrals: UInt
    first: UInt
    key: UInt
    units: list[Float]

    def over(self, place: Float, width: Float, along: Float, length: Float) -> Yarn:
        """Means over threads: `place` is the number of a thread and how far across its cell, 0 to 1.

        Args:
            width: of the box, in threads. Of a wider one than a block, a block's width in the middle counts,
                and varies as much less as the threads are more.
            along, length: millimetres.
        """
        types = array_types(place)
        width = maximum(width, LEAST_WIDTH)
        shown = minimum(width, BLOCK)
        steps = maximum(length * (1 / STEP), 1)
        begin = dr.fma(-0.5, steps, along * (1 / STEP))
        low, high = (self._bound(place + side * shown, begin, steps) for side in (-0.5, 0.5))
        sums = [b - a for a, b in zip(low.integral(), high.integral(), strict=True)]
        # The rest of the first block, and the part of the table before the second one.
        sums = masked_branch(
            high.block != low.block,
            sums,
            lambda totals: [
                total + (a - b) for total, a, b in zip(totals, low.up_to(BLOCK), high.up_to(0), strict=True)
            ],
            "irregularity: two blocks",
        )
        scale = dr.sqrt(shown / width) * dr.rcp(shown * steps)
        return Yarn(
            *(total * unit * types.Float(scale) for total, unit in zip(sums, self.units, strict=True))
        )

    def at(self, number: Float, along: Float) -> Yarn:
        """What a thread is at a place along it, millimetres."""
        bound = self._bound(number + 0.5, dr.fma(along, 1 / STEP, -0.5), array_types(along).Float(1))
        # A thread lies in one block.
        whole = dr.floor(bound.inside)
        low, high = bound.up_to(whole), bound.up_to(whole + 1)
        return Yarn(*((b - a) * unit for a, b, unit in zip(low, high, self.units, strict=True)))

    def _bound(self, thread: Float, begin: Float, steps: Float) -> _Bound:
        types = array_types(thread)
        block = dr.floor(thread * (1 / BLOCK))
        # A ring is as likely to be entered in any row and at any step.
        bits = hash_bits(self.key, types.UInt32(types.Int32(block)))
        row = self.first + (bits & (ROWS - 1))
        begin = begin + types.Float(bits >> (32 - SAMPLES_BITS))
        return _Bound(self.integrals, block, dr.fma(-BLOCK, block, thread), row, begin, steps)


class _Bound:
    """One side of a box across the threads.

    Attributes:
        block: number of the block that it lies in.
        inside: threads of the block before it, 0 to `BLOCK`.
    """

    def __init__(
        self, integrals: UInt, block: Float, inside: Float, row: UInt, begin: Float, steps: Float
    ) -> None:
        """
        Args:
            row: of the table, where the block begins.
            begin, steps: along the threads, steps of the table.
        """
        self.block = block
        self._types = types = array_types(inside)
        self._integrals, self.inside, self._row = integrals, inside, row
        places = [begin, begin + steps]
        whole = [dr.floor(place) for place in places]
        self._columns = [types.UInt32(types.Int32(column)) for column in whole]
        self._shares = [place - column for place, column in zip(places, whole, strict=True)]

    def integral(self) -> list[Float]:
        """Integrals of the quantities over the threads of the table before it, the last one in part."""
        whole = clip(dr.floor(self.inside), 0, BLOCK - 1)
        low, high = self.up_to(whole), self.up_to(whole + 1)
        return [dr.lerp(a, b, self.inside - whole) for a, b in zip(low, high, strict=True)]

    def up_to(self, threads: Float, active: Mask = True) -> list[Float]:
        """Integrals over so many whole threads of the block, and those of the table before it."""
        types = self._types
        start = (self._row + types.UInt32(threads)) * SAMPLES
        ends = []
        for column, share in zip(self._columns, self._shares, strict=True):
            here, next_one = (
                dr.gather(types.Index4, self._integrals, start + ((column + step) & (SAMPLES - 1)), active)
                for step in (0, 1)
            )
            ends.append(
                [(a, types.Float(types.Int32(b - a)) * share) for a, b in zip(here, next_one, strict=True)]
            )
        # Differences of integers are exact; only they are converted.
        return [
            types.Float(types.Int32(b - a)) + (of_b - of_a)
            for (a, of_a), (b, of_b) in zip(*ends, strict=True)
        ]


@dataclass
class Yarns:
    """The yarns of both families over a footprint.

    Attributes:
        warp, weft: see `Yarn`.
        covers: mean share of a cell that warp and weft cover.
        warp_on_top: share of the crossings, on the face that is seen.
    """

    warp: Yarn
    weft: Yarn
    covers: tuple[Float, Float]
    warp_on_top: Float

    @cached_property
    def shares(self) -> tuple[Float, Float, Float]:
        """How many times as much shows of warp, weft and holes as in even cloth, ≥ 0.

        Seen along the normal, the warp shows where it covers and the weft does not lie on top, and so on: all
        are linear in the cover of either family.
        """
        even = self._shown(*self.covers)
        warp, weft = (
            clip(dr.fma(cover, yarn.cover, cover), 0, 1)
            for cover, yarn in zip(self.covers, (self.warp, self.weft), strict=True)
        )
        warp_shown, weft_shown, hole = (
            part * dr.rcp(maximum(usual, LEAST_SHOWN))
            for part, usual in zip(self._shown(warp, weft), even, strict=True)
        )
        # Cloth without holes has none here either.
        return warp_shown, weft_shown, dr.select(even[2] > LEAST_SHOWN, hole, 1)

    def _shown(self, warp: Float, weft: Float) -> tuple[Float, Float, Float]:
        on_top = self.warp_on_top
        return (
            warp * (1 - weft * (1 - on_top)),
            weft * (1 - warp * on_top),
            (1 - warp) * (1 - weft),
        )


# Where less than this shows of a family or of holes, it is rounding.
LEAST_SHOWN = 1e-4


def depth_per_gain(family: FamilyAppearance) -> float:
    """Change of the depth of shade over the relative change of the albedo that it makes, 1 to 19."""
    albedo = np.clip(np.mean(family.diffuse_reflect + family.diffuse_transmit), 0, 0.9)
    return float((1 + albedo) / (1 - albedo))


@lru_cache(maxsize=16)
def _table(yarn: Irregularity, cover: float, per_gain: float, colour_noise: float) -> IrregularTable:
    return irregular_table(yarn, cover, per_gain, colour_noise)


class IrregularYarns:
    """The irregularity of both families of a fabric, for any backend."""

    def __init__(self, geometry: YarnGeometry, appearance: Appearance) -> None:
        self._families = geometry.families
        self._yarns = appearance.warp, appearance.weft
        self._appearance = appearance
        self._warp_on_top = float(geometry.layout.warp_on_top.mean())
        self._is_layered = bool(geometry.layout.layers)
        self._uploaded: dict[type, Process] = {}

    @property
    def is_on(self) -> bool:
        """Whether yarns vary at all."""
        return self._appearance.is_irregular

    @cached_property
    def covers(self) -> tuple[float, float]:
        """Mean share of a cell that warp and weft cover."""
        warp, weft = (float((2 * family.half_width).sum()) / family.period for family in self._families)
        return warp, weft

    @cached_property
    def tables(self) -> tuple[IrregularTable, IrregularTable]:
        """Of warp and weft; the same one where their yarns are alike."""
        noise = self._appearance.variation.colour_noise
        warp, weft = (
            # Families that differ little, and in the colour of neps, share a table.
            _table(
                replace(family.irregularity, nep_albedo=(0.0, 0.0, 0.0)),
                float(np.rint(1000 * cover) / 1000),
                float(np.rint(10 * depth_per_gain(family)) / 10),
                noise,
            )
            for family, cover in zip(self._yarns, self.covers, strict=True)
        )
        return warp, weft

    def upload(self, types: ArrayTypes) -> None:
        """Puts the tables on a backend, which otherwise happens at first use."""
        if self.is_on and types.Float not in self._uploaded:
            self._uploaded[types.Float] = Process(
                self.tables, self._families, self._appearance, self.covers, self._warp_on_top, types
            )

    def on(self, types: ArrayTypes) -> Process:
        """The process on a backend; only where `is_on`."""
        self.upload(types)
        return self._uploaded[types.Float]

    def over(self, footprint: Footprint, back: Mask) -> Yarns:
        """The yarns over footprints in draft coordinates, as their axis-aligned boxes.

        Cover is that of what `place` does not move.
        """
        process = self.on(array_types(footprint.centre.x))
        return process.over(footprint.box(), footprint.spread_side, back)

    def place(self, centre: Vec2, size: Float | None = None) -> Vec2:
        """Where in the draft of even yarns the cloth at a place [2] is, millimetres.

        Thick yarns are wide: they take room of the gaps beside them and of thinner neighbours.

        Args:
            size: side of the footprint, millimetres. From a quarter of a thread on it moves less, as
                footprints show shares (`Yarns.shares`) in its place; None is a point.

        In layered cloth places stay: one move cannot suit the threads of all layers.
        """
        if not self.is_on or self._is_layered:
            return centre
        return self.on(array_types(centre.x)).place(centre, size)


class Process:
    """The irregularity of both families on one backend."""

    def __init__(
        self,
        tables: tuple[IrregularTable, IrregularTable],
        families: tuple[FamilyTables, FamilyTables],
        appearance: Appearance,
        covers: tuple[float, float],
        warp_on_top: float,
        types: ArrayTypes,
    ) -> None:
        kept = tables[:1] if tables[0] is tables[1] else tables
        integrals = upload(types.UInt32, np.concatenate([table.integrals for table in kept]).view(np.uint32))
        second = 0 if len(kept) == 1 else len(tables[0].integrals)
        seed = types.UInt32(appearance.variation.seed)
        self._families = [
            _OfFamily(
                integrals,
                opaque(types.UInt32, first),
                hash_key(types.UInt32(number), seed ^ STREAM),
                opaque(types.Float, table.units),
            )
            for number, (first, table) in enumerate(zip((0, second), tables, strict=True))
        ]
        # Literals would be compiled into kernels.
        dr.make_opaque([family.key for family in self._families])
        self._cells = [upload_family(family, types) for family in families]
        self._periods = [opaque(types.Float, family.period) for family in families]
        self._threads = [opaque(types.Float, family.lower.size) for family in families]
        self._covers = opaque(types.Float, covers)
        self._warp_on_top = opaque(types.Float, warp_on_top)
        yarns = appearance.warp.irregularity, appearance.weft.irregularity
        self._layer_bound = opaque(types.Float, appearance.layer_bound)
        has_neps = any(yarn.neps > 0 for yarn in yarns)
        self._nep_albedos = [
            types.Color3(*opaque(types.Float, yarn.nep_albedo)) if has_neps else None for yarn in yarns
        ]

    def _cell(self, family: int, across: Float) -> tuple[Cell, Float]:
        """The cell of a place across the threads, millimetres, and its thread's number over the cloth."""
        cell = self._cells[family].locate(across)
        repeat = dr.floor((across - cell.across) / self._periods[family])
        return cell, dr.fma(repeat, self._threads[family], cell.number)

    def over(self, box: Box, size: Float, back: Mask) -> Yarns:
        """See `IrregularYarns.over`."""
        types = array_types(box.centre)
        found = []
        for family, (across, along, width, length) in enumerate(
            (
                (box.centre.x, box.centre.y, box.size.x, box.size.y),
                (box.centre.y, box.centre.x, box.size.y, box.size.x),
            )
        ):
            cell, number = self._cell(family, across)
            place = number + cell.below / (cell.below + cell.above)
            threads = width * (self._threads[family] / self._periods[family])
            yarn = self._families[family].over(place, threads, along, length)
            yarn.cover *= 1 - self._moved_share(family, size)
            found.append(yarn)
        on_top = dr.select(types.Bool(back), 1 - self._warp_on_top, self._warp_on_top)
        return Yarns(found[0], found[1], (self._covers[0], self._covers[1]), on_top)

    def toned(self, albedos: tuple[FourColours, FourColours], yarns: Yarns) -> list[FourColours]:
        """Albedos of warp and weft of even yarns as a footprint shows them; see `toned`."""
        pairs = zip(albedos, (yarns.warp, yarns.weft), self._nep_albedos, strict=True)
        return [toned(family, yarn, self._layer_bound, nep) for family, yarn, nep in pairs]

    def toned_at(self, albedos: FourColours, is_warp: Mask, number: Float, x: Float, y: Float) -> FourColours:
        """Albedos of a thread of a number over the cloth as it is at a point, millimetres."""
        warp, weft = self._nep_albedos
        nep = None if warp is None else dr.select(is_warp, warp, weft)
        with dr.suspend_grad():
            yarn = self.at_thread(is_warp, number, x, y)
        return toned(albedos, yarn, self._layer_bound, nep)

    def at_thread(self, is_warp: Mask, number: Float, x: Float, y: Float) -> Yarn:
        """What a thread of a number over the cloth is at a point, millimetres."""
        warp, weft = self._families
        units = [dr.select(is_warp, a, b) for a, b in zip(warp.units, weft.units, strict=True)]
        first, key = dr.select(is_warp, warp.first, weft.first), dr.select(is_warp, warp.key, weft.key)
        process = _OfFamily(warp.integrals, first, key, units)
        return process.at(number, dr.select(is_warp, y, x))

    def place(self, centre: Vec2, size: Float | None) -> Vec2:
        """See `IrregularYarns.place`."""
        types = array_types(centre.x)
        weights = [types.Float(1) if size is None else self._moved_share(family, size) for family in range(2)]

        def move(place: tuple[Float, Float]) -> tuple[Float, Float]:
            x, y = place
            return self._across(0, x, y, weights[0]), self._across(1, y, x, weights[1])

        # One branch for both: most packets of far pictures skip it.
        is_near = (weights[0] > 0) | (weights[1] > 0)
        return types.Vector2(*masked_branch(is_near, (centre.x, centre.y), move, "irregularity: wide yarns"))

    def _moved_share(self, family: int, size: Float) -> Float:
        """Share of what `place` does to points that it does to footprints of a side, 0 to 1."""
        return fade(size, self._periods[family] / self._threads[family])

    def _across(self, family: int, across: Float, along: Float, weight: Float) -> Float:
        """A coordinate across the threads, in the draft of even yarns, moved by a share of 0 to 1."""
        types = array_types(across)
        cell, number = self._cell(family, across)
        process, side = self._families[family], dr.copysign(types.Float(1), cell.across)
        own, other = (process.at(thread, along) for thread in (number, number + side))
        # From the middle of the thread, 0, to that of its neighbour, 1.
        spacing = cell.below + cell.above
        even = minimum(cell.half_width / spacing, 0.5)
        room = minimum(even * (2 + own.cover + other.cover), 1)
        roots = [dr.sqrt(maximum(1 + yarn.thickness, 1 + LEAST_THICKNESS)) for yarn in (own, other)]
        edge = room * roots[0] * dr.rcp(roots[0] + roots[1])
        here, gap = abs(cell.across) / spacing, 1 - room
        over_gap, over_other = here - edge, here - edge - gap
        found = dr.select(
            over_gap < 0,
            here * even * dr.rcp(edge),
            dr.select(
                over_other < 0,
                dr.fma(over_gap * dr.rcp(maximum(gap, 1e-6)), 1 - 2 * even, even),
                dr.fma(over_other * dr.rcp(maximum(room - edge, 1e-6)), even, 1 - even),
            ),
        )
        return dr.fma(weight * side * spacing, found - here, across)


def toned(albedos: FourColours, yarn: Yarn, layer_bound: Float, nep_albedo: Color3 | None) -> FourColours:
    """Albedos of even yarn as the yarns of a footprint show them, still inside the energy bound; same means.

    Args:
        albedos: diffuse_reflect, diffuse_transmit, specular_reflect, specular_transmit; Color3 each.
        layer_bound: κ of `albedo.layer_albedo_bound`.
        nep_albedo: None without neps.
    """
    reflect, transmit, specular_reflect, specular_transmit = albedos
    diffuse = reflect + transmit
    left = 1 - layer_bound * maximum(specular_reflect, specular_transmit)
    slope = maximum(1 - diffuse, 0) * dr.rcp(1 + diffuse)
    # Made flatter where the lightest place has no room, so that the mean stays.
    room = (left * dr.rcp(maximum(diffuse, 1e-6)) - 1) * dr.rcp(maximum(LARGEST_TONE * slope, 1e-6))
    flat = clip(minimum(minimum(room.x, room.y), room.z), 0, 1)
    gain = dr.fma(-flat * yarn.tone, slope, 1)
    reflect, transmit = gain * reflect, gain * transmit
    if nep_albedo is not None:
        reflect = dr.fma(yarn.nep, minimum(nep_albedo, left) - reflect, reflect)
        transmit = dr.fma(yarn.nep, -transmit, transmit)
        reflect = clip(reflect, 0, maximum(left - transmit, 0))
    return reflect, transmit, specular_reflect, specular_transmit
